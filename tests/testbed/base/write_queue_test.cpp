// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The writing thread: everything is done, in order, one at a time; errors come back and end the work.

#include "testbed/base/write_queue.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

namespace testbed {
namespace {

TEST(WriteQueue, DoesEverythingInOrder) {
    std::vector<int> done;
    WriteQueue queue(2);
    for (int i = 0; i < 200; ++i) queue.Add([&done, i] { done.push_back(i); });
    queue.Wait();
    ASSERT_EQ(done.size(), 200u);
    for (int i = 0; i < 200; ++i) EXPECT_EQ(done[static_cast<size_t>(i)], i);
    queue.Add([&done] { done.push_back(200); });
    queue.Wait();
    EXPECT_EQ(done.size(), 201u) << "usable again after waiting";
}

TEST(WriteQueue, TheEndFinishesWhatWaits) {
    int done = 0;
    {
        WriteQueue queue(8);
        for (int i = 0; i < 8; ++i) queue.Add([&done] { ++done; });
    }
    EXPECT_EQ(done, 8);
}

TEST(WriteQueue, IsBounded) {
    std::promise<void> gate;
    std::shared_future<void> opened = gate.get_future().share();
    WriteQueue queue(2);
    for (int i = 0; i < 3; ++i) queue.Add([opened] { opened.wait(); });  // one is being done, two wait
    std::promise<void> added;
    std::future<void> fourth = added.get_future();
    std::thread adder([&] {
        queue.Add([] {});
        added.set_value();
    });
    EXPECT_EQ(fourth.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
    gate.set_value();
    adder.join();
    queue.Wait();
}

TEST(WriteQueue, TheFirstErrorComesBackAndEndsTheWork) {
    std::vector<int> done;
    WriteQueue queue(8);
    queue.Add([&done] { done.push_back(1); });
    queue.Add([] { throw std::runtime_error("disk full"); });
    EXPECT_THROW(
        {
            queue.Add([&done] { done.push_back(2); });
            queue.Wait();
        },
        std::runtime_error);
    EXPECT_THROW(queue.Add([] {}), std::runtime_error);
    EXPECT_THROW(queue.Wait(), std::runtime_error);
    EXPECT_EQ(done, (std::vector<int>{1}));
}

}  // namespace
}  // namespace testbed
