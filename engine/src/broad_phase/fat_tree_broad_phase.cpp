// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D 2.4's broad phase strategy (b2BroadPhase and the fattening rule of b2DynamicTree). Boxes get a margin and are
// stretched ahead along their motion. Only boxes that leave their fat box are reinserted and buffered, and only those
// are queried for new pairs. The pairs of all others stay as they were, since neither of their fat boxes changed.
// Reports all pairs of overlapping FAT boxes, a superset of the tight pairs.

#include <algorithm>

#include "base/undo.h"
#include "broad_phase/algorithms.h"
#include "broad_phase/fat_tree.h"
#include "broad_phase/fixture_table.h"
#include "broad_phase/ray_probe.h"
#include "scree/settings.h"

namespace scree::broadphase {
namespace {

class FatTreeBroadPhase final : public BroadPhase {
public:
    explicit FatTreeBroadPhase(FatMargin margin) : m_margin(margin) {}

    void Insert(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) override {
        Restore(fixture, body, motion, m_margin.Fatten(box));
    }

    void Restore(uint32_t fixture, uint32_t body, Motion motion, const AABB& box) override {
        const uint32_t leaf = m_tree.CreateLeaf(ToBounds(box), {fixture, GroupOf(body, motion)});
        Undo undo([&] { m_tree.DestroyLeaf(leaf); });  // a mark without a leaf does no harm
        Buffer(leaf);
        m_leaves.Set(fixture, leaf);
        undo.Dismiss();
        ++m_count;
    }

    void CoverWay(uint32_t fixture, const AABB& way) override {
        const uint32_t leaf = m_leaves.Find(fixture);
        const Bounds kept = m_tree.Node(leaf).box;
        if (ToAabb(kept).Contains(way)) return;
        m_covered.push_back({leaf, kept});
        m_tree.Reinsert(leaf, ToBounds(way));
    }
    void CoverWays(std::span<const BoxUpdate> ways) override {
        for (const BoxUpdate& way : ways) CoverWay(way.fixture, way.box);
    }

    void Update(uint32_t fixture, const AABB& box, Vec2 displacement) override {
        EndCover();
        const uint32_t leaf = m_leaves.Find(fixture);
        const AABB fat = m_margin.Fatten(box, displacement);
        if (m_margin.Keeps(ToAabb(m_tree.Node(leaf).box), box, fat)) return;
        m_tree.Reinsert(leaf, ToBounds(fat));
        Buffer(leaf);
    }

    [[nodiscard]] bool UsesDisplacement() const override { return true; }

    void Remove(uint32_t fixture) override {
        EndCover();
        const uint32_t leaf = m_leaves.Find(fixture);
        // The mark outlives the node, so its pairs are dropped even if the node is used again before FindPairs.
        Buffer(leaf);
        m_tree.DestroyLeaf(leaf);
        m_leaves.Erase(fixture);
        --m_count;
    }

    void FindPairs(std::vector<Pair>& pairs) override {
        EndCover();
        m_stats = {};
        if (m_buffered.size() < m_tree.NodeLimit()) m_buffered.resize(m_tree.NodeLimit(), 0);
        std::erase_if(m_pairs, [this](Pair pair) { return m_buffered[pair.a] != 0 || m_buffered[pair.b] != 0; });
        for (const uint32_t leaf : m_buffer) {
            if (m_tree.IsLiveLeaf(leaf)) FindPairsOf(leaf);
        }
        for (const uint32_t leaf : m_buffer) m_buffered[leaf] = 0;
        m_buffer.clear();
        pairs.clear();
        for (const Pair pair : m_pairs) {
            const auto [a, b] = std::minmax(m_tree.Node(pair.a).id.fixture, m_tree.Node(pair.b).id.fixture);
            pairs.push_back({a, b});
        }
    }

    uint64_t Query(const AABB& box, Visitor visit) const override {
        uint64_t boxTests = 0;
        m_tree.Query(ToBounds(box), boxTests, [&](uint32_t leaf) { return visit(m_tree.Node(leaf).id.fixture); });
        return boxTests;
    }

    uint64_t CastBox(const RayCastInput& path, Vec2 halfSize, RayVisitor visit) const override {
        uint64_t boxTests = 0;
        RayProbe ray(path, halfSize);
        m_tree.RayCast(ray, boxTests, [&](uint32_t leaf) { return ray.Visit(visit, m_tree.Node(leaf).id.fixture); });
        return boxTests;
    }

    [[nodiscard]] AABB GetBox(uint32_t fixture) const override {
        return ToAabb(m_tree.Node(m_leaves.Find(fixture)).box);
    }
    [[nodiscard]] int GetProxyCount() const override { return m_count; }
    [[nodiscard]] int GetLeafSize() const override { return 1; }
    [[nodiscard]] BroadPhaseStats GetStats() const override { return m_stats; }
    [[nodiscard]] size_t GetMemoryBytes() const override {
        return m_tree.GetMemoryBytes() + m_leaves.GetMemoryBytes() + m_buffered.capacity() +
               m_buffer.capacity() * sizeof(uint32_t) + m_pairs.capacity() * sizeof(Pair) +
               m_covered.capacity() * sizeof(CoveredLeaf);
    }

    void GetNodes(std::vector<BvhNode>& nodes) override {
        nodes.clear();
        if (m_tree.Root() == noNode) return;
        struct Task {
            uint32_t node;
            int32_t parent;
        };
        std::vector<Task> tasks{{m_tree.Root(), -1}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            const FatNode& node = m_tree.Node(task.node);
            const auto index = static_cast<int32_t>(nodes.size());
            BvhNode out;
            out.box = ToAabb(node.box);
            out.parent = task.parent;
            if (task.parent >= 0) {
                BvhNode& parent = nodes[static_cast<size_t>(task.parent)];
                (parent.child1 < 0 ? parent.child1 : parent.child2) = index;
                out.level = parent.level + 1;
            }
            if (node.IsLeaf()) {
                out.fixture = static_cast<int32_t>(node.id.fixture);
            } else {
                tasks.push_back({node.child2, index});
                tasks.push_back({node.child1, index});
            }
            nodes.push_back(out);
        }
    }

private:
    /// What a leaf had before it covered a way.
    struct CoveredLeaf {
        uint32_t leaf;
        Bounds kept;
    };
    void EndCover() {
        for (; !m_covered.empty(); m_covered.pop_back()) m_tree.Reinsert(m_covered.back().leaf, m_covered.back().kept);
    }

    void Buffer(uint32_t leaf) {
        if (leaf >= m_buffered.size()) m_buffered.resize(std::max<size_t>(leaf + 1, 2 * m_buffered.size()), 0);
        if (m_buffered[leaf] != 0) return;
        m_buffer.push_back(leaf);
        m_buffered[leaf] = 1;
    }

    void FindPairsOf(uint32_t leaf) {
        const uint32_t group = m_tree.Node(leaf).id.group;
        ++m_stats.rebuiltProxies;
        m_tree.Query(m_tree.Node(leaf).box, m_stats.boxTests, [&](uint32_t other) {
            // Of two buffered leaves the one with the larger index reports the pair.
            const bool reportedByOther = m_buffered[other] != 0 && other >= leaf;
            if (!reportedByOther && m_tree.Node(other).id.group != group) m_pairs.push_back({leaf, other});
            return true;
        });
    }

    FatMargin m_margin;
    FatTree m_tree;
    FixtureTable m_leaves;
    std::vector<uint8_t> m_buffered;     ///< per node: in m_buffer
    std::vector<uint32_t> m_buffer;      ///< nodes whose leaf was inserted, moved or removed since the last FindPairs
    std::vector<Pair> m_pairs;           ///< current pairs, by node
    std::vector<CoveredLeaf> m_covered;  ///< since the last update, some of them twice
    BroadPhaseStats m_stats;
    int m_count = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> MakeFatTree(const BroadPhaseConfig& config) {
    return std::make_unique<FatTreeBroadPhase>(FatMargin{aabbExtension * config.lengthScale});
}

}  // namespace scree::broadphase
