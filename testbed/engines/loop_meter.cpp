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

std::span<const double> LoopTimes::TasksOf(int loop) const {
    const int begin = loop == 0 ? 0 : ends[static_cast<std::size_t>(loop) - 1];
    return std::span(tasks).subspan(static_cast<std::size_t>(begin),
                                    static_cast<std::size_t>(ends[static_cast<std::size_t>(loop)] - begin));
}

std::span<const PartTime> LoopTimes::PartsOf(int loop) const {
    const int begin = loop == 0 ? 0 : partEnds[static_cast<std::size_t>(loop) - 1];
    return std::span(parts).subspan(static_cast<std::size_t>(begin),
                                    static_cast<std::size_t>(partEnds[static_cast<std::size_t>(loop)] - begin));
}

double LoopTimes::GetElapsed() const { return std::accumulate(tasks.begin(), tasks.end(), 0.0); }

double LoopTimes::GetWork() const {
    double work = 0.0;
    for (int loop = 0; loop < CountLoops(); ++loop) {
        for (const PartTime& part : PartsOf(loop)) work += part.ms;
        if (!PartsOf(loop).empty()) continue;
        for (const double task : TasksOf(loop)) work += task;
    }
    return work;
}

double LoopTimes::GetSpan(int cores) const {
    double span = 0.0;
    for (int loop = 0; loop < CountLoops(); ++loop)
        span += PartsOf(loop).empty() ? DealToCores(TasksOf(loop), cores) : FollowChains(PartsOf(loop), cores);
    return span;
}

void LoopTimes::TakeLeast(const LoopTimes& other) {
    const auto isSame = [](const PartTime& a, const PartTime& b) { return a.chain == b.chain && a.after == b.after; };
    if (ends != other.ends || partEnds != other.partEnds || !std::ranges::equal(parts, other.parts, isSame))
        throw std::logic_error("a repeated step has other loops");
    std::ranges::transform(tasks, other.tasks, tasks.begin(), [](double a, double b) { return std::min(a, b); });
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].ms = std::min(parts[i].ms, other.parts[i].ms);
}

double FollowChains(std::span<const PartTime> parts, int cores) {
    std::vector<std::vector<double>> ended;  // by chain and part
    std::vector<double> freeAt(static_cast<std::size_t>(cores));
    double last = 0.0;
    for (const PartTime& part : parts) {
        const auto chain = static_cast<std::size_t>(part.chain);
        ended.resize(std::max(ended.size(), part.after.size()));
        double& free = freeAt[chain % freeAt.size()];
        double start = free;
        for (std::size_t other = 0; other < part.after.size(); ++other) {
            const int count = part.after[other];
            if (count == 0 || other % freeAt.size() == chain % freeAt.size()) continue;
            start = std::max(start, ended[other].at(static_cast<std::size_t>(count) - 1) + handoverMs);
        }
        free = start + part.ms;
        ended[chain].push_back(free);
        last = std::max(last, free);
    }
    return last;
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
            .tasksPerWorker = tasksPerCore,
            .part = [](const scree::TaskPart& part, bool isDone,
                       void* meter) { static_cast<LoopMeter*>(meter)->NotePart(part, isDone); }};
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
    m_times.partEnds.push_back(static_cast<int>(m_times.parts.size()));
}

void LoopMeter::NotePart(const scree::TaskPart& part, bool isDone) {
    if (!isDone) {
        m_times.parts.push_back({part.chain, 0.0, std::vector<int>(part.after, part.after + part.chainCount)});
        m_partBegan = Clock::now();
        return;
    }
    m_times.parts.back().ms = std::chrono::duration<double, std::milli>(Clock::now() - m_partBegan).count();
}

}  // namespace testbed
