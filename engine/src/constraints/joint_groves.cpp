// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which trees are a grove; the rest is done by the batches of each.

#include "constraints/joint_groves.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scree {

namespace {

/// A grove is closed when it has so many joints. In smaller ones too few joints are ready at a time: a processor waits
/// for what one joint hands to the next.
constexpr size_t enoughJoints = 256;

/// What hangs together by links that move both of their bodies, as union-find over links.
class LinkParts {
public:
    explicit LinkParts(std::span<const TreeEdge> links) : m_parent(links.size()) {
        std::iota(m_parent.begin(), m_parent.end(), size_t{0});
        std::vector<std::pair<BodyIndex, size_t>> byBody;
        for (size_t i = 0; i < links.size(); ++i) {
            if (links[i].movesA) byBody.emplace_back(links[i].bodyA, i);
            if (links[i].movesB) byBody.emplace_back(links[i].bodyB, i);
        }
        std::sort(byBody.begin(), byBody.end());
        for (size_t k = 1; k < byBody.size(); ++k) {
            if (byBody[k].first == byBody[k - 1].first) Join(byBody[k - 1].second, byBody[k].second);
        }
    }
    /// The first link of the part.
    [[nodiscard]] size_t Find(size_t link) {
        while (m_parent[link] != link) link = m_parent[link] = m_parent[m_parent[link]];
        return link;
    }

private:
    void Join(size_t a, size_t b) {
        a = Find(a), b = Find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

    std::vector<size_t> m_parent;
};

}  // namespace

void JointGroves::Plan(std::span<TreeEdge> links) {
    LinkParts parts(links);
    std::vector<size_t> linksOfPart(links.size(), 0), groveOfPart(links.size(), 0);
    for (size_t i = 0; i < links.size(); ++i) ++linksOfPart[parts.Find(i)];
    m_count = 0;
    size_t joints = enoughJoints;  // of the last grove
    for (size_t i = 0; i < links.size(); ++i) {
        if (parts.Find(i) != i) continue;
        if (joints >= enoughJoints) ++m_count, joints = 0;
        groveOfPart[i] = m_count - 1;
        joints += linksOfPart[i];
    }
    std::vector<std::vector<TreeEdge>> ofGrove(m_count);
    for (size_t i = 0; i < links.size(); ++i) ofGrove[groveOfPart[parts.Find(i)]].push_back(links[i]);
    if (m_groves.size() < m_count) m_groves.resize(m_count);
    for (size_t grove = 0; grove < m_count; ++grove) {
        m_groves[grove].Plan(ofGrove[grove]);
        for (const TreeEdge& link : ofGrove[grove]) links[ToSize(link.shape)].isTree = link.isTree;
    }
}

void JointGroves::Refresh(TaskPool& pool, const BodyTable& bodies, const JointTable& joints,
                          std::span<const TreeShape> shapes, double recentScale, double compliance) {
    EnsureRows(m_scratch, ToSize(pool.GetRowCount()));
    for (JointBatchScratch& scratch : m_scratch) {
        for (const JointBatches& grove : Groves()) grove.EnsureRoom(scratch);
    }
    ForEach(pool, [&](JointBatches& grove, auto&) { grove.Refresh(bodies, joints, shapes, recentScale, compliance); });
}

bool JointGroves::IsEmpty() const { return std::ranges::all_of(Groves(), &JointBatches::IsEmpty); }

size_t JointGroves::GetMemoryBytes() const {
    size_t bytes = m_groves.capacity() * sizeof(JointBatches);
    for (const JointBatches& grove : m_groves) bytes += grove.GetMemoryBytes();
    for (const JointBatchScratch& scratch : m_scratch) bytes += sizeof scratch + scratch.GetMemoryBytes();
    return bytes;
}

void JointGroves::Factorize(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, double h,
                            bool isLoaded) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) {
        grove.Factorize(bodies, delta, h, isLoaded, scratch);
    });
}

void JointGroves::SolveBeforeMove(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) { grove.SolveBeforeMove(velocity, scratch); });
}

void JointGroves::SolveAfterMove(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) { grove.SolveAfterMove(velocity, scratch); });
}

void JointGroves::FactorizeAndStop(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                                   double h, bool isLoaded, Column<BodyIndex, Velocity>& velocity) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) {
        grove.Factorize(bodies, delta, h, isLoaded, scratch);
        grove.SolveAfterMove(velocity, scratch);
    });
}

}  // namespace scree
