// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws. A box query visits exactly the fixtures whose stored boxes overlap, each once. A ray cast visits exactly those
// that a scan with the same box test finds, and finds the same closest one when hits clip the ray. Both hold at any
// moment between edits, whatever has been rebuilt. Fattened boxes are compared with the boxes that GetBox tells.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>

#include "broad_phase/ray_probe.h"
#include "tests/broad_phase/test_world.h"

namespace scree::test {
namespace {

class Queries : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhase, Queries, testing::ValuesIn(allKinds), KindName);

std::vector<uint32_t> Visited(BroadPhase& broadPhase, const AABB& box) {
    std::vector<uint32_t> found;
    broadPhase.Query(box, [&](uint32_t fixture) {
        found.push_back(fixture);
        return true;
    });
    std::sort(found.begin(), found.end());
    return found;
}

void CheckQuery(const TestWorld& world, BroadPhase& broadPhase, const AABB& box) {
    std::vector<uint32_t> expected;
    for (const TestFixture& fixture : world.Fixtures()) {
        if (TestOverlap(broadPhase.GetBox(fixture.fixture), box)) expected.push_back(fixture.fixture);
    }
    std::sort(expected.begin(), expected.end());
    RC_ASSERT(Visited(broadPhase, box) == expected);
}

/// Enters a box as a solid: the fraction at which the ray gets in, or −1.
float EntryFraction(const RayCastInput& input, const AABB& box) {
    float low = 0.0f, high = input.maxFraction;
    const float origin[2] = {input.p1.x, input.p1.y};
    const float d[2] = {input.p2.x - input.p1.x, input.p2.y - input.p1.y};
    const float from[2] = {box.lowerBound.x, box.lowerBound.y};
    const float to[2] = {box.upperBound.x, box.upperBound.y};
    for (int axis = 0; axis < 2; ++axis) {
        if (d[axis] == 0.0f) {
            if (origin[axis] < from[axis] || origin[axis] > to[axis]) return -1.0f;
            continue;
        }
        const float t1 = (from[axis] - origin[axis]) / d[axis];
        const float t2 = (to[axis] - origin[axis]) / d[axis];
        low = std::max(low, std::min(t1, t2));
        high = std::min(high, std::max(t1, t2));
    }
    return low <= high ? low : -1.0f;
}

/// What a box on its way along the ray may hit is what a scan with the same test finds, among it all that it does hit.
void CheckBoxCast(const TestWorld& world, BroadPhase& broadPhase, const RayCastInput& input, Vec2 halfSize) {
    std::vector<uint32_t> expected, visited;
    const broadphase::RayProbe probe(input, halfSize);
    for (const TestFixture& fixture : world.Fixtures()) {
        const AABB box = broadPhase.GetBox(fixture.fixture);
        const bool mayHit = probe.MayHitLeaf(box);
        if (mayHit) expected.push_back(fixture.fixture);
        RC_ASSERT(mayHit || EntryFraction(input, {box.lowerBound - halfSize, box.upperBound + halfSize}) < 0.0f);
    }
    std::sort(expected.begin(), expected.end());
    broadPhase.CastBox(input, halfSize, [&](const RayCastInput&, uint32_t fixture) {
        visited.push_back(fixture);
        return -1.0f;
    });
    std::sort(visited.begin(), visited.end());
    RC_ASSERT(visited == expected);
}

void CheckRay(const TestWorld& world, BroadPhase& broadPhase, const RayCastInput& input) {
    std::vector<uint32_t> expected, visited;
    const broadphase::RayProbe probe(input);
    float closest = 2.0f;
    for (const TestFixture& fixture : world.Fixtures()) {
        const AABB box = broadPhase.GetBox(fixture.fixture);
        if (probe.MayHitLeaf(box)) expected.push_back(fixture.fixture);
        const float entry = EntryFraction(input, box);
        if (entry > 0.0f) closest = std::min(closest, entry);
    }
    std::sort(expected.begin(), expected.end());
    broadPhase.RayCast(input, [&](const RayCastInput& now, uint32_t fixture) {
        RC_ASSERT(now.maxFraction == input.maxFraction);
        visited.push_back(fixture);
        return -1.0f;
    });
    std::sort(visited.begin(), visited.end());
    RC_ASSERT(visited == expected);

    float found = 2.0f;
    broadPhase.RayCast(input, [&](const RayCastInput& now, uint32_t fixture) {
        const float entry = EntryFraction(now, broadPhase.GetBox(fixture));
        if (entry <= 0.0f) return -1.0f;
        found = std::min(found, entry);
        return found;
    });
    RC_ASSERT(found == closest);
}

TEST_P(Queries, EqualALinearScanBetweenEdits) {
    EXPECT_TRUE(rc::check("queries equal a scan", [] {
        const WorldShape shape = AnyWorldShape(150);
        BroadPhaseConfig config;
        config.leafSize = *rc::gen::element(0, 0, 1, 5);
        TestWorld world(shape);
        const auto broadPhase = CreateBroadPhase(GetParam(), config);
        world.Fill(*broadPhase);
        std::vector<Pair> pairs;
        const int rounds = *rc::gen::inRange(1, 12);
        for (int round = 0; round < rounds; ++round) {
            if (*rc::gen::inRange(0, 3) == 0) broadPhase->FindPairs(pairs);
            // Few edits leave a tree in use beside them, many make it stale.
            world.Edit(*broadPhase, *rc::gen::element(0, 1, 5, 40, 200));
            world.Rest(*broadPhase, *rc::gen::element(0, 1, 50));
            CheckQuery(world, *broadPhase, world.RandomBox());
            const AABB from = world.RandomBox(), to = world.RandomBox();
            CheckRay(world, *broadPhase, {from.lowerBound, to.lowerBound, 1.0f});
            CheckRay(world, *broadPhase,
                     {from.lowerBound, {to.lowerBound.x, from.lowerBound.y}, world.Uniform(0.1f, 1.0f)});
            CheckRay(world, *broadPhase, {from.lowerBound, from.lowerBound, 1.0f});
            CheckBoxCast(world, *broadPhase, {from.GetCenter(), to.lowerBound, world.Uniform(0.1f, 1.0f)},
                         from.GetExtents());
        }
    }));
}

TEST_P(Queries, StopWhenToldTo) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    for (uint32_t i = 0; i < 50; ++i) broadPhase->Insert(i, i, Motion::dynamic, {{0.0f, 0.0f}, {1.0f, 1.0f}});
    for (int round = 0; round < 2; ++round) {
        int visits = 0;
        broadPhase->Query({{0.0f, 0.0f}, {1.0f, 1.0f}}, [&](uint32_t) { return ++visits < 3; });
        EXPECT_EQ(visits, 3);
        visits = 0;
        broadPhase->RayCast({{-1.0f, 0.5f}, {2.0f, 0.5f}, 1.0f},
                            [&](const RayCastInput&, uint32_t) { return ++visits < 3 ? -1.0f : 0.0f; });
        EXPECT_EQ(visits, 3);
        // The second round asks while one proxy is on the list of edits.
        broadPhase->Update(7, {{0.0f, 0.0f}, {1.0f, 2.0f}}, vec2Zero);
    }
}

/// Boxes in a row, a ray along it: the first hit ends the walk before the far ones are met.
TEST_P(Queries, RaysMeetNearBoxesFirst) {
    EXPECT_TRUE(rc::check("near boxes first", [] {
        const auto count = *rc::gen::inRange(200u, 1000u);
        const float angle = static_cast<float>(*rc::gen::inRange(0, 629)) * 0.01f;
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        const auto broadPhase = CreateBroadPhase(GetParam());
        std::vector<uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::shuffle(order.begin(), order.end(), std::mt19937(*rc::gen::arbitrary<uint32_t>()));
        const Motion motion = *rc::gen::element(Motion::dynamic, Motion::isStatic);
        for (const uint32_t i : order) {
            const Vec2 centre = 2.0f * static_cast<float>(i + 1) * direction;
            broadPhase->Insert(i, i, motion, {centre - Vec2{0.5f, 0.5f}, centre + Vec2{0.5f, 0.5f}});
        }
        broadPhase->PrepareQueries();
        const float length = 2.0f * static_cast<float>(count + 1);
        const auto leaf = static_cast<uint32_t>(broadPhase->GetLeafSize());
        const auto depth = static_cast<uint32_t>(std::bit_width(count));
        // Nodes of the tree that is never rebuilt overlap: for one ray nothing bounds what it meets besides.
        const bool isRebuilt = GetParam() != BroadPhaseKind::fatTree;
        constexpr uint32_t rays = 16;
        uint32_t allVisits = 0;
        for (uint32_t ray = 0; ray < rays; ++ray) {
            const auto first = *rc::gen::inRange(0u, count);
            const Vec2 start = (2.0f * static_cast<float>(first) + 1.0f) * direction;
            uint32_t visits = 0, hit = count;
            const uint64_t boxTests = broadPhase->RayCast(
                {start, start + length * direction, 1.0f}, [&](const RayCastInput& now, uint32_t i) {
                    ++visits;
                    const float entry = EntryFraction(now, broadPhase->GetBox(i));
                    if (entry <= 0.0f) return -1.0f;
                    hit = i;
                    return entry;
                });
            RC_ASSERT(hit == first);
            if (leaf == 0) continue;  // a scan has no order
            RC_ASSERT(!isRebuilt || visits <= 2 * leaf);
            RC_ASSERT(!isRebuilt || boxTests <= 2 * leaf + 8 * depth);
            allVisits += visits;
        }
        RC_ASSERT(allVisits <= rays * std::max(2 * leaf, depth));
    }));
}

/// A box that crosses a field of n × n boxes on a diagonal meets some n of them, not all in the box around its way.
TEST_P(Queries, ACastAcrossAFieldMeetsALine) {
    EXPECT_TRUE(rc::check("a line of boxes", [] {
        const auto n = *rc::gen::inRange(30u, 60u);
        const Motion motion = *rc::gen::element(Motion::dynamic, Motion::isStatic);
        const auto broadPhase = CreateBroadPhase(GetParam());
        for (uint32_t i = 0; i < n * n; ++i) {
            const Vec2 low{static_cast<float>(i % n), static_cast<float>(i / n)};
            broadPhase->Insert(i, i, motion, {low, low + Vec2{0.5f, 0.5f}});
        }
        broadPhase->PrepareQueries();
        const float side = static_cast<float>(n), half = 0.1f * static_cast<float>(*rc::gen::inRange(0, 8));
        uint32_t visits = 0;
        const uint64_t boxTests =
            broadPhase->CastBox({{0.0f, side}, {side, 0.0f}, 1.0f}, {half, half}, [&](const RayCastInput&, uint32_t) {
                ++visits;
                return -1.0f;
            });
        RC_ASSERT(visits >= n - 1);
        RC_ASSERT(visits <= 5 * n);
        RC_ASSERT(broadPhase->GetLeafSize() == 0 || boxTests <= 40 * n);
    }));
}

/// A fixture that leaves one part of the proxies for the other must not be met in both.
TEST_P(Queries, ChangeOfMotionTypeIsSeenOnce) {
    const auto broadPhase = CreateBroadPhase(GetParam());
    const AABB box{{0.0f, 0.0f}, {1.0f, 1.0f}};
    const AABB far{{50.0f, 0.0f}, {51.0f, 1.0f}};
    broadPhase->Insert(0, 0, Motion::dynamic, box);
    for (uint32_t i = 1; i < 400; ++i) broadPhase->Insert(i, i, i % 2 == 0 ? Motion::dynamic : Motion::isStatic, far);
    std::vector<Pair> pairs;
    broadPhase->FindPairs(pairs);
    for (int round = 0; round < 6; ++round) {
        broadPhase->Remove(0);
        EXPECT_TRUE(Visited(*broadPhase, box).empty());
        broadPhase->Insert(0, 0, round % 2 == 0 ? Motion::isStatic : Motion::dynamic, box);
        EXPECT_EQ(Visited(*broadPhase, box), std::vector<uint32_t>{0});
        // Enough edits of statics alone to make only their tree stale.
        for (int i = 0; i < 300; ++i) {
            broadPhase->Remove(1 + 2 * static_cast<uint32_t>(i % 150));
            broadPhase->Insert(1 + 2 * static_cast<uint32_t>(i % 150), 1, Motion::isStatic, far);
        }
        EXPECT_EQ(Visited(*broadPhase, box), std::vector<uint32_t>{0});
    }
}

/// Every static fixture in the box is visited, once, whatever the share of statics and the edits since the last pairs.
TEST_P(Queries, StaticQueriesFindEveryStatic) {
    for (const uint32_t oneIn : {2u, 20u}) {  // above and below the share that gets a tree of its own
        const auto broadPhase = CreateBroadPhase(GetParam());
        const auto boxOf = [](uint32_t i, float shift) {
            const Vec2 p{static_cast<float>(i % 40) + shift, static_cast<float>(i / 40)};
            return AABB{p, p + Vec2{0.6f, 0.6f}};
        };
        std::vector<float> shift(1200, 0.0f);
        for (uint32_t i = 0; i < 1200; ++i) {
            broadPhase->Insert(i, i, i % oneIn == 0 ? Motion::isStatic : Motion::dynamic, boxOf(i, 0.0f));
        }
        std::vector<Pair> pairs;
        for (int round = 0; round < 4; ++round) {
            if (round == 2) broadPhase->FindPairs(pairs);
            for (uint32_t i = 0; i < 1200; i += 7) broadPhase->Update(i, boxOf(i, shift[i] += 0.2f), vec2Zero);
            for (const float x : {-1.0f, 3.2f, 17.0f, 38.5f}) {
                const AABB box{{x, 4.3f}, {x + 2.5f, 11.1f}};
                std::vector<uint32_t> expected, found;
                if (round % 2 == 1) broadPhase->PrepareStatic();
                for (uint32_t i = 0; i < 1200; i += oneIn) {
                    if (TestOverlap(boxOf(i, shift[i]), box)) expected.push_back(i);
                }
                broadPhase->QueryStatic(box, [&](uint32_t fixture) {
                    if (fixture % oneIn == 0) found.push_back(fixture);
                    return true;
                });
                // The fattened tree may visit more.
                std::sort(found.begin(), found.end());
                EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end());
                EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
                if (GetParam() != BroadPhaseKind::fatTree) {
                    EXPECT_EQ(found, expected);
                }
            }
        }
    }
}

}  // namespace
}  // namespace scree::test
