// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a pointer finds, against slow searches over all nodes and fixtures of a real tree.

#include "testbed/view/tree_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"

namespace testbed {
namespace {

Snapshot CapturePyramid(const char* engine) {
    const auto run = MakeRun(scenes::Build("pyramid", 8), MakeSpec(engine, likeBox2dPreset));
    for (int i = 0; i < 20; ++i) run->Step();
    Snapshot snapshot;
    run->Capture(snapshot);
    return snapshot;
}

bool Overlap(const Box& a, const Box& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y;
}

/// Seeded points around the pyramid.
std::vector<Vec2> MakePoints() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> x(-8, 8), y(-1, 9);
    std::vector<Vec2> points;
    for (int i = 0; i < 300; ++i) points.push_back({x(random), y(random)});
    return points;
}

class TreeQuery : public testing::TestWithParam<const char*> {};

TEST_P(TreeQuery, ATraceVisitsTheNodesThatOverlapAndReportsTheirLeaves) {
    const Snapshot s = CapturePyramid(GetParam());
    ASSERT_FALSE(s.nodes.empty());
    int mostLeaves = 0;
    for (const float size : {0.0f, 0.7f, 5.0f}) {
        for (const Vec2 p : MakePoints()) {
            const Box query{{p.x - size / 2, p.y - size / 2}, {p.x + size / 2, p.y + size / 2}};
            // A parent contains its children, so the nodes that are reached are those that overlap.
            std::set<int> expected;
            int leaves = 0;
            for (size_t i = 0; i < s.nodes.size(); ++i) {
                if (!Overlap(s.nodes[i].box, query)) continue;
                expected.insert(static_cast<int>(i));
                leaves += s.nodes[i].fixture >= 0;
            }
            const QueryTrace trace = TraceQuery(s.nodes, query);
            EXPECT_EQ(std::set<int>(trace.visited.begin(), trace.visited.end()), expected);
            EXPECT_EQ(trace.visited.size(), expected.size()) << "each once";
            EXPECT_EQ(trace.leaves, leaves);
            // The root is tested, and both children of every internal node that overlaps.
            EXPECT_EQ(trace.tested, 1 + 2 * (static_cast<int>(expected.size()) - leaves));
            mostLeaves = std::max(mostLeaves, leaves);
        }
    }
    EXPECT_GT(mostLeaves, 10);
}

TEST_P(TreeQuery, TheNodeAtAPointIsTheSmallestSelectedOne) {
    const Snapshot s = CapturePyramid(GetParam());
    const auto area = [](const Box& b) {
        return (double{b.upper.x} - double{b.lower.x}) * (double{b.upper.y} - double{b.lower.y});
    };
    int found = 0;
    for (const char* text : {"internal", "leaves", "all", "levels=1..3"}) {
        const NodeSelection selection = ParseNodeSelection(text);
        for (const Vec2 p : MakePoints()) {
            const int node = FindNodeAt(s, selection, p);
            double smallest = -1;
            for (const NodeState& n : s.nodes) {
                if (IsSelected(selection, n) && Overlap(n.box, {p, p}) && (smallest < 0 || area(n.box) < smallest)) {
                    smallest = area(n.box);
                }
            }
            ASSERT_EQ(node >= 0, smallest >= 0);
            if (node < 0) continue;
            const NodeState& n = s.nodes[static_cast<size_t>(node)];
            EXPECT_TRUE(IsSelected(selection, n));
            EXPECT_TRUE(Overlap(n.box, {p, p}));
            EXPECT_EQ(area(n.box), smallest);
            ++found;
        }
    }
    EXPECT_GT(found, 100);
}

TEST_P(TreeQuery, PathsLeadFromTheRootAndLeavesAddUp) {
    const Snapshot s = CapturePyramid(GetParam());
    for (size_t i = 0; i < s.nodes.size(); ++i) {
        const int node = static_cast<int>(i);
        const std::vector<int> path = GetPath(s.nodes, node);
        ASSERT_EQ(path.front(), 0);
        ASSERT_EQ(path.back(), node);
        EXPECT_EQ(static_cast<int>(path.size()), s.nodes[i].level + 1);
        // Walk the words of the description down from the root.
        int at = 0;
        for (const char c : DescribePath(s.nodes, node).substr(4)) {
            if (c == '1') at = s.nodes[static_cast<size_t>(at)].child1;
            if (c == '2') at = s.nodes[static_cast<size_t>(at)].child2;
        }
        EXPECT_EQ(at, node);
        const NodeState& n = s.nodes[i];
        EXPECT_EQ(CountLeaves(s.nodes, node),
                  n.child1 < 0 ? 1 : CountLeaves(s.nodes, n.child1) + CountLeaves(s.nodes, n.child2));
    }
    EXPECT_EQ(CountLeaves(s.nodes, 0), static_cast<int>(s.fixtures.size()));
    EXPECT_EQ(DescribePath(s.nodes, 0), "root");
}

TEST_P(TreeQuery, EveryBodyIsFoundAtItsCentreAndNothingBesideThem) {
    const Snapshot s = CapturePyramid(GetParam());
    int dynamicBodies = 0;
    for (const BodyState& body : s.bodies) {
        if (body.type != scenes::BodyType::dynamic) continue;
        ++dynamicBodies;
        EXPECT_EQ(FindBodyAt(s, body.position), body.index);
        const Vec2 local{0.2f, -0.1f};
        const Vec2 back = ToLocal(body, ToWorld(body, local));
        EXPECT_NEAR(back.x, local.x, 1e-5);  // floats of a few metres
        EXPECT_NEAR(back.y, local.y, 1e-5);
    }
    EXPECT_EQ(dynamicBodies, 36);
    EXPECT_EQ(FindBodyAt(s, {0, 50}), -1);
    EXPECT_EQ(FindBodyAt(s, {7.5f, 6}), -1) << "beside the pyramid";
}

INSTANTIATE_TEST_SUITE_P(Engines, TreeQuery, testing::Values("scree", "box2d"),
                         [](const auto& i) { return std::string(i.param); });

TEST(TreeQueryOfNothing, FindsNothing) {
    EXPECT_EQ(TraceQuery({}, {{0, 0}, {1, 1}}).tested, 0);
    EXPECT_EQ(FindNodeAt({}, ParseNodeSelection("all"), {0, 0}), -1);
    EXPECT_EQ(FindBodyAt({}, {0, 0}), -1);
}

}  // namespace
}  // namespace testbed
