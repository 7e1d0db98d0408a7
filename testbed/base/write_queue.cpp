// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One mutex, one condition: jobs take milliseconds, so who wakes whom does not matter.

#include "testbed/base/write_queue.h"

#include <utility>

namespace testbed {

WriteQueue::WriteQueue(std::size_t capacity) : m_capacity(capacity), m_thread([this] { Work(); }) {}

WriteQueue::~WriteQueue() {
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void WriteQueue::Work() {
    std::unique_lock lock(m_mutex);
    while (true) {
        m_changed.wait(lock, [this] { return m_isEnding || !m_jobs.empty(); });
        if (m_jobs.empty()) return;
        std::function<void()> job = std::move(m_jobs.front());
        m_jobs.pop_front();
        m_isBusy = true;
        const bool isDropped = m_failure != nullptr;
        lock.unlock();
        m_changed.notify_all();  // there is room: whoever adds need not wait for this job's end
        std::exception_ptr failure;
        try {
            if (!isDropped) job();
        } catch (...) {
            failure = std::current_exception();
        }
        job = nullptr;  // its picture goes before the lock is taken
        lock.lock();
        if (failure) m_failure = failure;
        m_isBusy = false;
        m_changed.notify_all();
    }
}

void WriteQueue::ThrowFailure() {
    if (m_failure) std::rethrow_exception(m_failure);
}

void WriteQueue::Add(std::function<void()> job) {
    {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return m_jobs.size() < m_capacity; });
        ThrowFailure();
        m_jobs.push_back(std::move(job));
    }
    m_changed.notify_all();
}

void WriteQueue::Wait() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_jobs.empty() && !m_isBusy; });
    ThrowFailure();
}

}  // namespace testbed
