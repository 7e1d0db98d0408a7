// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of loop_meter.h.

#include "testbed/engines/loop_meter.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <stdexcept>

namespace testbed {

namespace {

/// As the engine's own threads have it (engine/src/base/task_pool.cpp).
constexpr int tasksPerCore = 4;

}  // namespace

double LoopTimes::GetWork() const { return std::accumulate(tasks.begin(), tasks.end(), 0.0); }

double LoopTimes::GetSpan(int cores) const {
    double span = 0.0;
    std::size_t begin = 0;
    for (const int end : ends) {
        span += DealToCores(std::span(tasks).subspan(begin, static_cast<std::size_t>(end) - begin), cores);
        begin = static_cast<std::size_t>(end);
    }
    return span;
}

void LoopTimes::TakeLeast(const LoopTimes& other) {
    if (ends != other.ends) throw std::logic_error("a repeated step has other loops");
    std::ranges::transform(tasks, other.tasks, tasks.begin(), [](double a, double b) { return std::min(a, b); });
}

double DealToCores(std::span<const double> tasks, int cores) {
    std::priority_queue<double, std::vector<double>, std::greater<>> freeAt;
    for (int core = 0; core < cores; ++core) freeAt.push(0.0);
    double last = 0.0;
    for (const double task : tasks) {
        const double end = freeAt.top() + task;
        freeAt.pop();
        freeAt.push(end);
        last = std::max(last, end);
    }
    return last;
}

scree::TaskCallbacks LoopMeter::GetCallbacks() {
    return {.enqueue = [](void (*task)(void*), void* taskContext, void* meter) -> void* {
                static_cast<LoopMeter*>(meter)->Run(task, taskContext);
                return meter;  // to be told when the caller is done with its own task
            },
            .finish = [](void* /*handle*/, void* meter) { static_cast<LoopMeter*>(meter)->EndLoop(); },
            .context = this,
            .tasksPerWorker = tasksPerCore};
}

void LoopMeter::Run(void (*task)(void*), void* taskContext) {
    // What the meter itself takes is a task's, or it would seem to be what no loop has.
    if (IsBetweenLoops()) m_last = Clock::now();
    task(taskContext);
    EndTask();
}

void LoopMeter::EndTask() {
    const Clock::time_point now = Clock::now();
    m_times.tasks.push_back(std::chrono::duration<double, std::milli>(now - m_last).count());
    m_last = now;
}

bool LoopMeter::IsBetweenLoops() const {
    return static_cast<int>(m_times.tasks.size()) == (m_times.ends.empty() ? 0 : m_times.ends.back());
}

void LoopMeter::EndLoop() {
    if (IsBetweenLoops()) return;  // it waits for the other tasks of the same loop
    EndTask();
    m_times.ends.push_back(static_cast<int>(m_times.tasks.size()));
}

}  // namespace testbed
