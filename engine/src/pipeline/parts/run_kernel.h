// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Passes of a contact kernel over all blocks, on the workers: in chains (chain_run.h), or colour by colour, since the
// blocks of one colour push different bodies. Colours with few blocks stay on the caller.

#pragma once

#include "base/task_pool.h"
#include "constraints/contact_block.h"
#include "pipeline/parts/chain_run.h"
#include "scree/math.h"

namespace scree {

/// Fewer blocks than this in a colour are not worth a shared loop. A block takes some 25 ns, and the end of a loop 0.5
/// to 1 µs. With few workers what one core wrote has to reach the other besides.
inline int LeastBlocks(const TaskPool& pool) {
    constexpr int ofWide = 64, ofFew = 128, ofTests = 4;
    if (pool.SharesAlways()) return ofTests;
    return pool.IsWide() ? ofWide : ofFew;
}

/// The end of the ranges of one colour that begin at `begin`: they are independent of each other.
inline int EndOfColour(const KernelTask& task, int begin) {
    int end = begin + 1;
    while (end < task.rangeCount && task.ranges[end].colour == task.ranges[begin].colour) ++end;
    return end;
}

/// The blocks [begin, end) of a task whose ranges are those of one colour.
template <typename Pass>
void RunBlocks(const KernelTask& task, int begin, int end, int worker, Pass&& pass) {
    for (int i = 0; i < task.rangeCount; ++i) {
        const BlockRange& range = task.ranges[i];
        const BlockRange own{range.begin > begin ? range.begin : begin, range.end < end ? range.end : end, range.kind,
                             range.colour};
        if (own.begin >= own.end) continue;
        KernelTask part = task;
        part.ranges = &own;
        part.rangeCount = 1;
        pass(part, worker);
    }
}

/// One pass, colour by colour.
template <typename Pass>
void RunPass(TaskPool& pool, const KernelTask& task, Pass&& pass) {
    if (!pool.IsOpen()) return pass(task, 0);
    const auto run = [&](int begin, int end) {  // ranges
        KernelTask part = task;
        part.ranges += begin;
        part.rangeCount = end - begin;
        return part;
    };
    const int leastBlocks = LeastBlocks(pool);
    const auto isLarge = [&](int begin, int end) {
        return task.ranges[end - 1].end - task.ranges[begin].begin >= leastBlocks;
    };
    int small = 0;  // where the small colours begin that nobody has run yet
    for (int begin = 0, end = 0; begin < task.rangeCount; begin = end) {
        end = EndOfColour(task, begin);
        if (!isLarge(begin, end)) continue;
        if (small < begin) pass(run(small, begin), 0);
        small = end;
        const KernelTask colour = run(begin, end);
        const int first = colour.ranges[0].begin;
        pool.For(task.ranges[end - 1].end - first, leastBlocks,
                 [&](int from, int to, int worker) { RunBlocks(colour, first + from, first + to, worker, pass); });
    }
    if (small < task.rangeCount) pass(run(small, task.rangeCount), 0);
}

/// Passes that are over with the blocks.
template <typename Pass>
struct BlocksAlone {
    static constexpr bool hasBodies = false;
    Pass& pass;
    void RunBlocks(const KernelTask& part, int /*pass*/, int worker) const { pass(part, worker); }
    void RunBodies(int /*chain*/, int /*pass*/) const {}
};

/// Calls pass(task, worker) with tasks that cover all ranges in order, as often as told.
template <typename Pass>
void RunKernel(TaskPool& pool, const KernelTask& task, Pass&& pass, int passes = 1) {
    if (task.chains != nullptr && pool.KeepsPace()) return RunChains(pool, task, passes, BlocksAlone<Pass>{pass});
    for (int i = 0; i < passes; ++i) RunPass(pool, task, pass);
}
inline void RunKernel(TaskPool& pool, const KernelTask& task, void (*kernel)(const KernelTask&), int passes = 1) {
    RunKernel(
        pool, task, [kernel](const KernelTask& part, int) { kernel(part); }, passes);
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
