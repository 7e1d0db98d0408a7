// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One pass of a contact kernel over all blocks, on the workers: colour by colour, since the blocks of one colour push
// different bodies. Colours with few blocks stay on the caller.

#pragma once

#include "base/task_pool.h"
#include "constraints/contact_block.h"
#include "scree/math.h"

namespace scree {

/// Fewer blocks than this in a colour are not worth waking the workers' attention.
inline constexpr int leastBlocks = 32;

/// Calls pass(task, worker) with tasks that cover all ranges in order.
template <typename Pass>
void RunKernel(TaskPool& pool, const KernelTask& task, Pass&& pass) {
    const auto isLarge = [&](int range) { return task.ranges[range].end - task.ranges[range].begin >= leastBlocks; };
    const bool serial = pool.GetWorkerCount() == 1;
    for (int begin = 0; begin < task.rangeCount;) {
        int end = begin;
        while (end < task.rangeCount && (serial || !isLarge(end))) ++end;
        if (end > begin) {
            KernelTask part = task;
            part.ranges += begin;
            part.rangeCount = end - begin;
            pass(part, 0);
            begin = end;
            continue;
        }
        const BlockRange range = task.ranges[begin++];
        pool.For(range.end - range.begin, leastBlocks, [&](int from, int to, int worker) {
            const BlockRange own{range.begin + from, range.begin + to, range.kind};
            KernelTask part = task;
            part.ranges = &own;
            part.rangeCount = 1;
            pass(part, worker);
        });
    }
}
inline void RunKernel(TaskPool& pool, const KernelTask& task, void (*kernel)(const KernelTask&)) {
    RunKernel(pool, task, [kernel](const KernelTask& part, int) { kernel(part); });
}

/// The smallest separation of a pass of pushApart.
inline float RunPushApart(TaskPool& pool, const KernelTask& task, const ContactKernels& kernels, float share) {
    float smallest[maxWorkers];
    for (float& s : smallest) s = 1.0f;
    RunKernel(pool, task, [&](const KernelTask& part, int worker) {
        smallest[worker] = Min(smallest[worker], kernels.pushApart(part, share));
    });
    float least = smallest[0];
    for (const float s : smallest) least = Min(least, s);
    return least;
}

/// A pass of part.
inline float RunPart(TaskPool& pool, const KernelTask& task, const ContactKernels& kernels, const Parting& parting) {
    float lacking[maxWorkers] = {};
    RunKernel(pool, task, [&](const KernelTask& part, int worker) {
        lacking[worker] = Max(lacking[worker], kernels.part(part, parting));
    });
    float largest = 0.0f;
    for (const float one : lacking) largest = Max(largest, one);
    return largest;
}

/// A pass of bounce: true if a contact bounces.
inline bool RunBounce(TaskPool& pool, const KernelTask& task, const ContactKernels& kernels) {
    bool bounced[maxWorkers] = {};
    RunKernel(pool, task,
              [&](const KernelTask& part, int worker) { bounced[worker] = kernels.bounce(part) || bounced[worker]; });
    bool any = false;
    for (const bool b : bounced) any = any || b;
    return any;
}

}  // namespace scree
