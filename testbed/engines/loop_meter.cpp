// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of loop_meter.h.

#include "testbed/engines/loop_meter.h"

#include <algorithm>
#include <numeric>

namespace testbed {

scree::TaskCallbacks LoopMeter::GetCallbacks() {
    return {.enqueue = [](void (*task)(void*), void* taskContext, void* meter) -> void* {
                static_cast<LoopMeter*>(meter)->Run(task, taskContext);
                return meter;  // to be told when the caller is done with its own task
            },
            .finish = [](void* /*handle*/, void* meter) { static_cast<LoopMeter*>(meter)->EndLoop(); },
            .context = this};
}

void LoopMeter::Run(void (*task)(void*), void* taskContext) {
    const Clock::time_point begin = Clock::now();
    task(taskContext);
    m_last = Clock::now();
    m_tasks.push_back(std::chrono::duration<double, std::milli>(m_last - begin).count());
}

void LoopMeter::EndLoop() {
    if (m_tasks.empty()) return;  // it waits for the other tasks of the same loop
    m_tasks.push_back(std::chrono::duration<double, std::milli>(Clock::now() - m_last).count());
    ++m_times.loops;
    m_times.work += std::accumulate(m_tasks.begin(), m_tasks.end(), 0.0);
    m_times.span += *std::max_element(m_tasks.begin(), m_tasks.end());
    m_tasks.clear();
}

}  // namespace testbed
