// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of tree_quality.h. L(n) of a node n is found by climbing from n to the root. The subtree of each
// sibling on the way holds fixtures that do not belong to n. Its parts are skipped where they are apart from n. Parts
// inside n are added whole, from a sum kept per node.

#include "testbed/jobs/overlap/tree_quality.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace testbed {
namespace {

/// Length of the segment [lo, hi] inside [windowLo, windowHi].
double Common(float lo, float hi, float windowLo, float windowHi) {
    return std::max(0.0, double{std::min(hi, windowHi)} - double{std::max(lo, windowLo)});
}

bool IsWithin(float value, float lo, float hi) { return lo <= value && value <= hi; }

bool Contains(const Box& outer, const Box& inner) {
    return (outer.lower.x <= inner.lower.x) & (outer.lower.y <= inner.lower.y) & (inner.upper.x <= outer.upper.x) &
           (inner.upper.y <= outer.upper.y);
}

double OverlapArea(const Box& a, const Box& b) {
    return Common(a.lower.x, a.upper.x, b.lower.x, b.upper.x) * Common(a.lower.y, a.upper.y, b.lower.y, b.upper.y);
}

/// What a subtree holds, in pre-order, so that a walk goes through memory in order and `skip` leaves a subtree.
struct Content {
    Box box;        ///< union of the tight boxes of its fixtures (a node's own box may be fattened)
    double length;  ///< of their outlines
    int skip;       ///< first entry behind the subtree
    bool leaf;
};

class OutlineSums {
public:
    OutlineSums(std::span<const NodeState> nodes, std::span<const FixtureState> fixtures);
    /// L(n) of tree_quality.h.
    [[nodiscard]] double ForeignLength(int node) const;
    [[nodiscard]] double TotalLength() const { return m_contents.empty() ? 0.0 : m_contents[0].length; }

private:
    void PlaceInPreOrder();
    [[nodiscard]] double LengthInside(int entry, const Box& window) const;
    [[nodiscard]] const NodeState& Node(int index) const { return m_nodes[static_cast<size_t>(index)]; }

    std::span<const NodeState> m_nodes;
    std::vector<int> m_entryOf;  ///< node → entry of m_contents
    std::vector<Content> m_contents;
};

OutlineSums::OutlineSums(std::span<const NodeState> nodes, std::span<const FixtureState> fixtures)
    : m_nodes(nodes), m_entryOf(nodes.size()), m_contents(nodes.size()) {
    PlaceInPreOrder();
    for (size_t i = nodes.size(); i-- > 0;) {
        Content& content = m_contents[static_cast<size_t>(m_entryOf[i])];
        const NodeState& node = nodes[i];
        content.leaf = node.child1 < 0;
        if (content.leaf) {
            content.box = fixtures[static_cast<size_t>(node.fixture)].tight;
            content.length = Perimeter(content.box);
            continue;
        }
        const Content& c1 = m_contents[static_cast<size_t>(m_entryOf[static_cast<size_t>(node.child1)])];
        const Content& c2 = m_contents[static_cast<size_t>(m_entryOf[static_cast<size_t>(node.child2)])];
        content.box = Join(c1.box, c2.box);
        content.length = c1.length + c2.length;
    }
}

void OutlineSums::PlaceInPreOrder() {
    std::vector<int> size(m_nodes.size(), 1);
    for (size_t i = m_nodes.size(); i-- > 1;) size[static_cast<size_t>(m_nodes[i].parent)] += size[i];
    for (size_t i = 0; i < m_nodes.size(); ++i) {
        // Parents come first in `nodes`, so m_entryOf[i] is already set by the parent.
        const int entry = m_entryOf[i];
        m_contents[static_cast<size_t>(entry)].skip = entry + size[i];
        if (m_nodes[i].child1 < 0) continue;
        m_entryOf[static_cast<size_t>(m_nodes[i].child1)] = entry + 1;
        m_entryOf[static_cast<size_t>(m_nodes[i].child2)] = entry + 1 + size[static_cast<size_t>(m_nodes[i].child1)];
    }
}

double OutlineSums::LengthInside(int entry, const Box& window) const {
    const int end = m_contents[static_cast<size_t>(entry)].skip;
    double sum = 0;
    while (entry < end) {
        const Content& content = m_contents[static_cast<size_t>(entry)];
        if (!Overlaps(content.box, window)) {
            entry = content.skip;
        } else if (Contains(window, content.box)) {
            sum += content.length;
            entry = content.skip;
        } else {
            if (content.leaf) sum += OutlineInside(content.box, window);
            ++entry;
        }
    }
    return sum;
}

double OutlineSums::ForeignLength(int node) const {
    const Box& window = Node(node).box;
    double sum = 0;
    for (int at = node; Node(at).parent >= 0; at = Node(at).parent) {
        const NodeState& parent = Node(Node(at).parent);
        const int sibling = parent.child1 == at ? parent.child2 : parent.child1;
        sum += LengthInside(m_entryOf[static_cast<size_t>(sibling)], window);
    }
    return sum;
}

void MeasureHeights(std::span<const NodeState> nodes, TreeQuality& quality) {
    std::vector<int> height(nodes.size(), 0);
    for (size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].child1 < 0) continue;
        const int h1 = height[static_cast<size_t>(nodes[i].child1)];
        const int h2 = height[static_cast<size_t>(nodes[i].child2)];
        height[i] = 1 + std::max(h1, h2);
        quality.maxBalance = std::max(quality.maxBalance, std::abs(h1 - h2));
    }
    quality.height = height[0];
}

}  // namespace

double Perimeter(const Box& box) {
    return 2 * ((double{box.upper.x} - box.lower.x) + (double{box.upper.y} - box.lower.y));
}

double OutlineInside(const Box& box, const Box& window) {
    const double width = Common(box.lower.x, box.upper.x, window.lower.x, window.upper.x);
    const double height = Common(box.lower.y, box.upper.y, window.lower.y, window.upper.y);
    const int horizontals =
        IsWithin(box.lower.y, window.lower.y, window.upper.y) + IsWithin(box.upper.y, window.lower.y, window.upper.y);
    const int verticals =
        IsWithin(box.lower.x, window.lower.x, window.upper.x) + IsWithin(box.upper.x, window.lower.x, window.upper.x);
    return horizontals * width + verticals * height;
}

TreeQuality MeasureTree(std::span<const NodeState> nodes, std::span<const FixtureState> fixtures) {
    TreeQuality quality;
    if (nodes.empty()) return quality;
    quality.nodes = static_cast<int>(nodes.size());
    MeasureHeights(nodes, quality);
    const OutlineSums sums(nodes, fixtures);
    double internal = 0, leaves = 0, siblings = 0, foreign = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const bool leaf = nodes[i].child1 < 0;
        (leaf ? leaves : internal) += Perimeter(nodes[i].box);
        foreign += (leaf ? leafNodeCost : internalNodeCost) * sums.ForeignLength(static_cast<int>(i));
        if (leaf) continue;
        siblings += OverlapArea(nodes[static_cast<size_t>(nodes[i].child1)].box,
                                nodes[static_cast<size_t>(nodes[i].child2)].box);
    }
    if (const double root = Perimeter(nodes[0].box); root > 0) {
        quality.areaRatio = (internal + leaves) / root;
        quality.sahCost = (internalNodeCost * internal + leafNodeCost * leaves) / root;
    }
    if (const double root = OverlapArea(nodes[0].box, nodes[0].box); root > 0) quality.siblingOverlap = siblings / root;
    if (sums.TotalLength() > 0) quality.epo = foreign / sums.TotalLength();
    return quality;
}

}  // namespace testbed
