// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// No thread sleeps for ever: each number wakes all that slept on the one before.

#include "base/wake_word.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace scree {
namespace {

TEST(WakeWord, EveryNumberReachesEverySleeper) {
    constexpr uint32_t rounds = 3000;
    WakeWord word;
    std::atomic<uint32_t> arrived{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i) {
        threads.emplace_back([&] {
            for (uint32_t seen = 0; seen < rounds; ++seen) {
                word.Wait(seen);
                ++arrived;
            }
        });
    }
    for (uint32_t round = 0; round < rounds; ++round) {
        while (arrived < 3 * round) std::this_thread::yield();
        EXPECT_EQ(word.Load(), round);
        word.Advance();
        word.WakeAll();
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(arrived, 3 * rounds);
}

}  // namespace
}  // namespace scree
