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

/// A grove has no more joints, unless one tree has. In small ones too few joints are ready at a time: a processor waits
/// for what one joint hands to the next.
constexpr size_t mostJoints = 384;

/// What hangs together by links that move both of their bodies, as union-find over links.
class LinkParts {
public:
    explicit LinkParts(std::span<const TreeEdge> links) : m_parent(links.size()) {
        std::iota(m_parent.begin(), m_parent.end(), size_t{0});
        std::vector<std::pair<BodyIndex, size_t>> byBody;
        byBody.reserve(2 * links.size());
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

/// What hangs together goes where its lowest joint is.
struct LinkPart {
    JointIndex lowest = JointIndex::none;
    size_t joints = 0;
    size_t grove = 0;
};

/// Blocks of 2ᵏ numbers of joints, halved until none has too many joints.
class Blocks {
public:
    /// In the order of their lowest joints.
    explicit Blocks(std::span<LinkPart*> parts) { Divide(parts, 0, int64_t{1} << 31); }
    [[nodiscard]] std::span<const int64_t> GetBegins() const { return m_begins; }

private:
    void Divide(std::span<LinkPart*> parts, int64_t begin, int64_t size) {
        if (parts.empty()) return;
        size_t joints = 0;
        for (const LinkPart* part : parts) joints += part->joints;
        if (joints <= mostJoints || parts.size() == 1) {
            for (LinkPart* part : parts) part->grove = m_begins.size();
            m_begins.push_back(begin);
            return;
        }
        const int64_t middle = begin + size / 2;
        const auto isBelow = [&](const LinkPart* part) { return int64_t{ToInt(part->lowest)} < middle; };
        const auto below = std::ranges::partition_point(parts, isBelow) - parts.begin();
        Divide(parts.first(static_cast<size_t>(below)), begin, size / 2);
        Divide(parts.subspan(static_cast<size_t>(below)), middle, size / 2);
    }

    std::vector<int64_t> m_begins;  ///< of those that have joints
};

}  // namespace

/// Makes a grove for each of these, in their order; those that were there stay.
void JointGroves::Arrange(std::span<const int64_t> begins) {
    std::vector<Grove> groves(std::max(begins.size(), m_groves.size()));
    std::vector<uint8_t> isOld(groves.size(), 0);
    std::vector<Grove*> spare;
    size_t next = 0;
    for (size_t old = 0; old < m_groves.size(); ++old) {
        while (next < begins.size() && old < m_count && begins[next] < m_groves[old].begin) ++next;
        const bool stays = next < begins.size() && old < m_count && begins[next] == m_groves[old].begin;
        if (!stays) {
            spare.push_back(&m_groves[old]);
            continue;
        }
        isOld[next] = 1;
        groves[next] = std::move(m_groves[old]);
    }
    for (size_t i = 0; i < groves.size() && !spare.empty(); ++i) {
        if (isOld[i] != 0) continue;
        groves[i] = std::move(*spare.back());
        groves[i].links.clear();
        spare.pop_back();
    }
    for (size_t i = 0; i < begins.size(); ++i) groves[i].begin = begins[i];
    m_groves = std::move(groves);
    m_count = begins.size();
}

void JointGroves::Plan(TaskPool& pool, std::span<TreeEdge> links) {
    LinkParts parts(links);
    std::vector<LinkPart> partOf(links.size());  // by their first links
    std::vector<LinkPart*> list;
    for (size_t i = 0; i < links.size(); ++i) {
        LinkPart& part = partOf[parts.Find(i)];
        if (part.joints++ == 0) list.push_back(&part), part.lowest = links[i].joint;
        part.lowest = std::min(part.lowest, links[i].joint);
    }
    std::ranges::sort(list, {}, &LinkPart::lowest);
    const Blocks blocks(list);
    Arrange(blocks.GetBegins());

    std::vector<size_t> ends(m_count + 1, 0), order(links.size());  // links by grove
    const auto groveOf = [&](size_t link) { return partOf[parts.Find(link)].grove; };
    for (size_t i = 0; i < links.size(); ++i) ++ends[groveOf(i)];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    for (size_t i = links.size(); i-- > 0;) order[--ends[groveOf(i)]] = i;  // now they are the begins
    pool.For(static_cast<int>(m_count), 2, [&](int begin, int end, int /*worker*/) {
        for (auto i = ToSize(begin); i < ToSize(end); ++i) {
            Grove& grove = m_groves[i];
            const std::span<const size_t> own(order.begin() + static_cast<ptrdiff_t>(ends[i]), ends[i + 1] - ends[i]);
            const bool isKnown =
                std::ranges::equal(grove.links, own, [&](const TreeEdge& a, size_t b) { return a.IsLike(links[b]); });
            if (!isKnown) {
                grove.links.clear();
                std::vector<TreeEdge> planned;
                planned.reserve(own.size());
                for (const size_t link : own) planned.push_back(links[link]);
                grove.batches.Plan(planned);
                grove.links = std::move(planned);  // they are known from now on
            } else {
                for (size_t k = 0; k < own.size(); ++k) grove.links[k].shape = links[own[k]].shape;
                grove.batches.Renumber(grove.links);
            }
            for (size_t k = 0; k < own.size(); ++k) links[own[k]].isTree = grove.links[k].isTree;
        }
    });
}

void JointGroves::Refresh(TaskPool& pool, const BodyTable& bodies, const JointTable& joints, const TreeInput& input) {
    EnsureRows(m_scratch, ToSize(pool.GetRowCount()));
    for (JointBatchScratch& scratch : m_scratch) {
        for (const Grove& grove : Groves()) grove.batches.EnsureRoom(scratch);
    }
    ForEach(pool, [&](JointBatches& grove, auto&) { grove.Refresh(bodies, joints, input); });
}

bool JointGroves::IsEmpty() const {
    return std::ranges::all_of(Groves(), [](const Grove& grove) { return grove.batches.IsEmpty(); });
}

size_t JointGroves::GetMemoryBytes() const {
    size_t bytes = m_groves.capacity() * sizeof(Grove);
    for (const Grove& grove : m_groves) bytes += BytesOf(grove.links) + grove.batches.GetMemoryBytes();
    for (const JointBatchScratch& scratch : m_scratch) bytes += sizeof scratch + scratch.GetMemoryBytes();
    return bytes;
}

void JointGroves::Factorize(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                            double h) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) { grove.Factorize(bodies, delta, h, scratch); });
}

void JointGroves::SolveBeforeMove(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) { grove.SolveBeforeMove(velocity, scratch); });
}

void JointGroves::SolveAfterMove(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) { grove.SolveAfterMove(velocity, scratch); });
}

void JointGroves::FactorizeAndStop(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                                   double h, Column<BodyIndex, Velocity>& velocity) {
    ForEach(pool, [&](JointBatches& grove, JointBatchScratch& scratch) {
        grove.Factorize(bodies, delta, h, scratch);
        grove.SolveAfterMove(velocity, scratch);
    });
}

}  // namespace scree
