// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Work for one background thread, done in the order in which it came. Files are encoded and written while the next
// picture is made; they are the same as without the thread.

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace testbed {

class WriteQueue {
public:
    /// At most `capacity` ≥ 1 jobs wait: whoever adds more waits for room, so that pictures do not fill the memory.
    explicit WriteQueue(std::size_t capacity);
    /// Finishes what waits, errors unheard: call Wait before.
    ~WriteQueue();
    WriteQueue(const WriteQueue&) = delete;
    WriteQueue& operator=(const WriteQueue&) = delete;

    /// Rethrows the first exception of an earlier job; after one, all later jobs are dropped.
    void Add(std::function<void()> job);
    /// Until everything added is done; rethrows like Add.
    void Wait();

private:
    void Work();
    void ThrowFailure();

    std::size_t m_capacity;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<std::function<void()>> m_jobs;
    bool m_isBusy = false, m_isEnding = false;
    std::exception_ptr m_failure;
    std::thread m_thread;  ///< last: it starts when all others exist
};

}  // namespace testbed
