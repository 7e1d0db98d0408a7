// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tree figures against small trees computed by hand and against their definitions evaluated directly on random trees.

#include "testbed/jobs/overlap/tree_quality.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace testbed;

namespace {

struct Tree {
    std::vector<NodeState> nodes;
    std::vector<FixtureState> fixtures;
};

Box MakeBox(float x0, float y0, float x1, float y1) { return {{x0, y0}, {x1, y1}}; }

Box Union(const Box& a, const Box& b) {
    return MakeBox(std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y), std::max(a.upper.x, b.upper.x),
                   std::max(a.upper.y, b.upper.y));
}

FixtureState MakeFixture(const Box& tight) {
    FixtureState f{};
    f.tight = tight;
    return f;
}

/// Two unit boxes side by side with a gap of 1, tight leaves.
Tree TwoApart() {
    const Box a = MakeBox(0, 0, 1, 1), b = MakeBox(2, 0, 3, 1);
    return {{{Union(a, b), -1, 1, 2, -1, 0}, {a, 0, -1, -1, 0, 1}, {b, 0, -1, -1, 1, 1}},
            {MakeFixture(a), MakeFixture(b)}};
}

/// Two overlapping boxes below one child, a third below the other; the leaves are tight.
///   a = [0,2]×[0,2], b = [1,3]×[1,3], c = [2.5,4]×[0,4]; ab = [0,3]×[0,3]; root = [0,4]×[0,4]
Tree ThreeOverlapping() {
    const Box a = MakeBox(0, 0, 2, 2), b = MakeBox(1, 1, 3, 3), c = MakeBox(2.5f, 0, 4, 4);
    return {{{Union(Union(a, b), c), -1, 1, 4, -1, 0},
             {Union(a, b), 0, 2, 3, -1, 1},
             {a, 1, -1, -1, 0, 2},
             {b, 1, -1, -1, 1, 2},
             {c, 0, -1, -1, 2, 1}},
            {MakeFixture(a), MakeFixture(b), MakeFixture(c)}};
}

/// Builds a random tree over random boxes; leaves may be fattened, nodes come breadth first.
Tree RandomTree() {
    Tree tree;
    const int count = *rc::gen::inRange(1, 40);
    const auto number = [](int lo, int hi) { return 0.25f * static_cast<float>(*rc::gen::inRange(lo, hi)); };
    std::vector<Box> leafBoxes;
    for (int i = 0; i < count; ++i) {
        const float x = number(0, 80), y = number(0, 80), w = number(0, 20), h = number(0, 20), fat = number(0, 4);
        tree.fixtures.push_back(MakeFixture(MakeBox(x, y, x + w, y + h)));
        leafBoxes.push_back(MakeBox(x - fat, y - fat, x + w + fat, y + h + fat));
    }
    /// A node still to be split: its fixtures and its place.
    struct Part {
        std::vector<int> members;
        int parent, level;
    };
    std::vector<Part> queue{{{}, -1, 0}};
    for (int i = 0; i < count; ++i) queue[0].members.push_back(i);
    for (size_t at = 0; at < queue.size(); ++at) {
        const Part part = queue[at];
        Box box = leafBoxes[static_cast<size_t>(part.members[0])];
        for (const int m : part.members) box = Union(box, leafBoxes[static_cast<size_t>(m)]);
        NodeState node{box, part.parent, -1, -1, -1, part.level};
        if (part.members.size() == 1) {
            node.fixture = part.members[0];
        } else {
            const auto cut = *rc::gen::inRange<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(part.members.size()));
            node.child1 = static_cast<int>(queue.size());
            node.child2 = node.child1 + 1;
            const auto begin = part.members.begin();
            queue.push_back({{begin, begin + cut}, static_cast<int>(at), part.level + 1});
            queue.push_back({{begin + cut, part.members.end()}, static_cast<int>(at), part.level + 1});
        }
        tree.nodes.push_back(node);
    }
    return tree;
}

/// Length of a segment inside a window, by clipping its two ends; axis-aligned segments only.
double SegmentInside(Vec2 p, Vec2 q, const Box& w) {
    const double x0 = std::max(std::min(p.x, q.x), w.lower.x), x1 = std::min(std::max(p.x, q.x), w.upper.x);
    const double y0 = std::max(std::min(p.y, q.y), w.lower.y), y1 = std::min(std::max(p.y, q.y), w.upper.y);
    return x0 > x1 || y0 > y1 ? 0.0 : (x1 - x0) + (y1 - y0);
}

double OutlineBySegments(const Box& b, const Box& w) {
    const Vec2 corners[4] = {b.lower, {b.upper.x, b.lower.y}, b.upper, {b.lower.x, b.upper.y}};
    double sum = 0;
    for (int k = 0; k < 4; ++k) sum += SegmentInside(corners[k], corners[(k + 1) % 4], w);
    return sum;
}

bool IsBelow(const Tree& tree, int node, int ancestor) {
    while (node >= 0 && node != ancestor) node = tree.nodes[static_cast<size_t>(node)].parent;
    return node >= 0;
}

/// The definition of epo, every node against every leaf.
double EpoByDefinition(const Tree& tree) {
    double foreign = 0, total = 0;
    for (const FixtureState& f : tree.fixtures) total += Perimeter(f.tight);
    for (int i = 0; i < static_cast<int>(tree.nodes.size()); ++i) {
        const NodeState& n = tree.nodes[static_cast<size_t>(i)];
        const double cost = n.child1 < 0 ? leafNodeCost : internalNodeCost;
        for (int j = 0; j < static_cast<int>(tree.nodes.size()); ++j) {
            const NodeState& leaf = tree.nodes[static_cast<size_t>(j)];
            if (leaf.fixture < 0 || IsBelow(tree, j, i)) continue;
            foreign += cost * OutlineBySegments(tree.fixtures[static_cast<size_t>(leaf.fixture)].tight, n.box);
        }
    }
    return total > 0 ? foreign / total : 0;
}

int HeightByRecursion(const Tree& tree, int node) {
    const NodeState& n = tree.nodes[static_cast<size_t>(node)];
    return n.child1 < 0 ? 0 : 1 + std::max(HeightByRecursion(tree, n.child1), HeightByRecursion(tree, n.child2));
}

double AreaOfIntersection(const Box& a, const Box& b) {
    const double w = std::min(a.upper.x, b.upper.x) - double{std::max(a.lower.x, b.lower.x)};
    const double h = std::min(a.upper.y, b.upper.y) - double{std::max(a.lower.y, b.lower.y)};
    return w > 0 && h > 0 ? w * h : 0;
}

}  // namespace

TEST(TreeQuality, NothingOfAnEmptyTree) {
    const TreeQuality q = MeasureTree({}, {});
    EXPECT_EQ(q.nodes, 0);
    EXPECT_EQ(q.height, 0);
    EXPECT_EQ(q.areaRatio, 0.0);
    EXPECT_EQ(q.epo, 0.0);
}

TEST(TreeQuality, ASingleLeafIsItsOwnRoot) {
    const Box box = MakeBox(1, 2, 3, 5);
    const std::vector<NodeState> nodes{{box, -1, -1, -1, 0, 0}};
    const std::vector<FixtureState> fixtures{MakeFixture(box)};
    const TreeQuality q = MeasureTree(nodes, fixtures);
    EXPECT_EQ(q.nodes, 1);
    EXPECT_EQ(q.height, 0);
    EXPECT_DOUBLE_EQ(q.areaRatio, 1.0);
    EXPECT_DOUBLE_EQ(q.sahCost, leafNodeCost);
    EXPECT_EQ(q.siblingOverlap, 0.0);
    EXPECT_EQ(q.epo, 0.0);
}

TEST(TreeQuality, TwoBoxesApartByHand) {
    const Tree tree = TwoApart();
    const TreeQuality q = MeasureTree(tree.nodes, tree.fixtures);
    EXPECT_EQ(q.nodes, 3);
    EXPECT_EQ(q.height, 1);
    EXPECT_EQ(q.maxBalance, 0);
    // Perimeters: root 8, leaves 4 each.
    EXPECT_DOUBLE_EQ(q.areaRatio, 16.0 / 8.0);
    EXPECT_DOUBLE_EQ(q.sahCost, (1.2 * 8.0 + 8.0) / 8.0);
    EXPECT_EQ(q.siblingOverlap, 0.0);
    EXPECT_EQ(q.epo, 0.0);
}

TEST(TreeQuality, ThreeOverlappingBoxesByHand) {
    const Tree tree = ThreeOverlapping();
    const TreeQuality q = MeasureTree(tree.nodes, tree.fixtures);
    EXPECT_EQ(q.nodes, 5);
    EXPECT_EQ(q.height, 2);
    EXPECT_EQ(q.maxBalance, 1);
    // Perimeters: root 16, ab 12, a 8, b 8, c 11.
    EXPECT_DOUBLE_EQ(q.areaRatio, 55.0 / 16.0);
    EXPECT_DOUBLE_EQ(q.sahCost, (1.2 * 28.0 + 27.0) / 16.0);
    // a∩b = 1×1; ab∩c = 0.5×3; the root's area is 16.
    EXPECT_DOUBLE_EQ(q.siblingOverlap, (1.0 + 1.5) / 16.0);
    // Outlines. Inside a of b: 1 + 1 (its lower and left sides), of c: none. Inside b of a: 1 + 1, of c: its left side
    // over y 1…3, 2. Inside ab of c: its left side over y 0…3 and its lower side over x 2.5…3, 3.5. Inside c of a: none
    // (a ends at x = 2), of b: its right side (2), its lower and upper sides over x 2.5…3 (0.5 each), 3.
    EXPECT_DOUBLE_EQ(q.epo, (1.2 * 3.5 + 2.0 + (2.0 + 2.0) + 3.0) / 27.0);
}

TEST(TreeQuality, ARootOfNoExtentGivesZeroRatios) {
    const Box point = MakeBox(1, 1, 1, 1);
    const Tree tree{{{point, -1, 1, 2, -1, 0}, {point, 0, -1, -1, 0, 1}, {point, 0, -1, -1, 1, 1}},
                    {MakeFixture(point), MakeFixture(point)}};
    const TreeQuality q = MeasureTree(tree.nodes, tree.fixtures);
    EXPECT_EQ(q.areaRatio, 0.0);
    EXPECT_EQ(q.sahCost, 0.0);
    EXPECT_EQ(q.siblingOverlap, 0.0);
    EXPECT_EQ(q.epo, 0.0);
}

TEST(TreeQuality, EqualsTheDefinitionsOnRandomTrees) {
    EXPECT_TRUE(rc::check("height, area ratio, overlap, epo by brute force", [] {
        const Tree tree = RandomTree();
        const TreeQuality q = MeasureTree(tree.nodes, tree.fixtures);
        double perimeters = 0, overlaps = 0;
        for (const NodeState& n : tree.nodes) {
            perimeters += Perimeter(n.box);
            if (n.child1 < 0) continue;
            overlaps += AreaOfIntersection(tree.nodes[static_cast<size_t>(n.child1)].box,
                                           tree.nodes[static_cast<size_t>(n.child2)].box);
        }
        RC_ASSERT(q.height == HeightByRecursion(tree, 0));
        const Box& root = tree.nodes[0].box;
        const double rootArea = AreaOfIntersection(root, root);
        // Sums of quarters are exact in double; only the divisions and the factor 1.2 round.
        if (Perimeter(root) > 0) RC_ASSERT(std::abs(q.areaRatio - perimeters / Perimeter(root)) < 1e-12 * perimeters);
        if (rootArea > 0) RC_ASSERT(std::abs(q.siblingOverlap - overlaps / rootArea) <= 1e-12 * overlaps);
        const double epo = EpoByDefinition(tree);
        RC_ASSERT(std::abs(q.epo - epo) <= 1e-10 * (1.0 + epo));
    }));
}
