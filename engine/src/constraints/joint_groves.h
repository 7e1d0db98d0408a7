// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Trees of joints in groves: each is solved by itself, so that threads share them, and one that is worked on stays in
// the cache. Trees of one grove are iterated together. So which trees are a grove follows from the numbers of their
// joints alone, and where a tree comes, goes, falls asleep or wakes, other groves stay what they were.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/task_pool.h"
#include "constraints/joint_batches.h"

namespace scree {

class JointGroves {
public:
    /// As of JointBatches. The links of one tree are in one grove, in their order. Plans only groves whose links are
    /// others than at the last call.
    void Plan(TaskPool& pool, std::span<TreeEdge> links);
    void Refresh(TaskPool& pool, const BodyTable& bodies, const JointTable& joints, const TreeInput& input);
    [[nodiscard]] bool IsEmpty() const;
    [[nodiscard]] size_t GetMemoryBytes() const;

    // As of JointTree, shared by the workers of the pool.
    void Factorize(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, double h);
    void SolveBeforeMove(TaskPool& pool, Column<BodyIndex, Velocity>& velocity);
    void SolveAfterMove(TaskPool& pool, Column<BodyIndex, Velocity>& velocity);
    void FactorizeAndStop(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, double h,
                          Column<BodyIndex, Velocity>& velocity);

    /// Calls visit(const TreeResult&) for each joint.
    template <typename Visit>
    void ForEachResult(Visit&& visit) const {
        for (const Grove& grove : Groves()) grove.batches.ForEachResult(visit);
    }
    /// The same on the workers of the pool.
    template <typename Visit>
    void ForEachResult(TaskPool& pool, Visit&& visit) const {
        pool.For(static_cast<int>(m_count), 2, [&](int begin, int end, int) {
            for (int i = begin; i < end; ++i) m_groves[ToSize(i)].batches.ForEachResult(visit);
        });
    }

private:
    struct Grove {
        int64_t begin = 0;            ///< of the numbers of joints that it is for
        std::vector<TreeEdge> links;  ///< as they were planned
        JointBatches batches;
    };
    [[nodiscard]] std::span<const Grove> Groves() const { return std::span(m_groves).first(m_count); }
    void Arrange(std::span<const int64_t> begins);
    template <typename Visit>
    void ForEach(TaskPool& pool, Visit&& visit) {
        pool.For(static_cast<int>(m_count), 2, [&](int begin, int end, int worker) {
            for (int i = begin; i < end; ++i) visit(m_groves[ToSize(i)].batches, m_scratch[ToSize(worker)]);
        });
    }

    std::vector<Grove> m_groves;  ///< some spare ones at the end keep their memory
    size_t m_count = 0;
    std::vector<JointBatchScratch> m_scratch;  ///< of each worker
};

}  // namespace scree
