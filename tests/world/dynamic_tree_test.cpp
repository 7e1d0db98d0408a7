// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The stand-alone tree against a list of boxes, and against b2DynamicTree of Box2D 2.4.1 under the same calls.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <box2d/box2d.h>

#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>

#include "scree/dynamic_tree.h"
#include "scree/settings.h"

namespace scree::test {
namespace {

/// Both trees under the same random calls.
struct Twins {
    explicit Twins(unsigned seed) : random(seed) {}
    float Pick(float low, float high) { return low + (high - low) * static_cast<float>(random() % 10007u) / 10006.0f; }
    AABB PickBox() {
        const Vec2 p{Pick(-50, 50), Pick(-50, 50)};
        return {p, p + Vec2{Pick(0, 4), Pick(0, 4)}};
    }
    static b2AABB Of(const AABB& b) { return {{b.lowerBound.x, b.lowerBound.y}, {b.upperBound.x, b.upperBound.y}}; }

    void Act() {
        const unsigned choice = random() % 4;
        if (choice < 2 || ids.empty()) {
            const AABB box = PickBox();
            const int id = ours.CreateProxy(box, this);
            ids[id] = theirs.CreateProxy(Of(box), this);
            boxes[id] = box;
            return;
        }
        auto it = ids.begin();
        std::advance(it, static_cast<std::ptrdiff_t>(random() % ids.size()));
        if (choice == 2) {
            RC_ASSERT(ours.DestroyProxy(it->first));
            theirs.DestroyProxy(it->second);
            boxes.erase(it->first);
            ids.erase(it);
        } else {
            const Vec2 d{Pick(-1, 1), Pick(-1, 1)};
            AABB& box = boxes[it->first];
            box = {box.lowerBound + d, box.upperBound + d};
            RC_ASSERT(ours.MoveProxy(it->first, box, d) == theirs.MoveProxy(it->second, Of(box), {d.x, d.y}));
        }
    }
    std::set<int> Overlapping(const AABB& probe) {
        std::set<int> found;
        for (const auto& [id, box] : boxes) {
            if (TestOverlap(ours.GetFatAABB(id), probe)) found.insert(id);
        }
        return found;
    }

    std::minstd_rand random;
    DynamicTree ours;
    b2DynamicTree theirs;
    std::map<int, int> ids;
    std::map<int, AABB> boxes;
};

TEST(DynamicTree, BehavesAsB2DynamicTree) {
    EXPECT_TRUE(rc::check("same fat boxes, height, balance and quality under the same calls", [] {
        Twins t(*rc::gen::inRange(1u, 100000u));
        const int actions = *rc::gen::inRange(0, 200);
        for (int i = 0; i < actions; ++i) t.Act();
        RC_ASSERT(t.ours.Validate());
        RC_ASSERT(t.ours.GetProxyCount() == static_cast<int>(t.ids.size()));
        RC_ASSERT(t.ours.GetHeight() == t.theirs.GetHeight());
        RC_ASSERT(t.ours.GetMaxBalance() == t.theirs.GetMaxBalance());
        RC_ASSERT(std::abs(t.ours.GetAreaRatio() - t.theirs.GetAreaRatio()) <=
                  1e-3f * (1.0f + t.theirs.GetAreaRatio()));
        for (const auto& [mine, other] : t.ids) {
            const AABB a = t.ours.GetFatAABB(mine);
            const b2AABB& b = t.theirs.GetFatAABB(other);
            RC_ASSERT(a.lowerBound.x == b.lowerBound.x && a.upperBound.y == b.upperBound.y);
            RC_ASSERT(t.ours.WasMoved(mine) == t.theirs.WasMoved(other));
            const bool mineStill = t.ours.GetUserData(mine) == static_cast<void*>(&t);
            RC_ASSERT(mineStill);
        }
    }));
}

TEST(DynamicTree, QueriesFindWhatAListFinds) {
    EXPECT_TRUE(rc::check("query and ray cast = list", [] {
        Twins t(*rc::gen::inRange(1u, 100000u));
        const int actions = *rc::gen::inRange(0, 150);
        for (int i = 0; i < actions; ++i) t.Act();
        if (*rc::gen::arbitrary<bool>()) t.ours.RebuildBottomUp();
        RC_ASSERT(t.ours.Validate());
        const AABB probe = t.PickBox();
        std::set<int> found;
        t.ours.Query(probe, [&](int id) { return found.insert(id).second; });
        RC_ASSERT(found == t.Overlapping(probe));
        // Every box that contains a point of the ray is visited.
        const Vec2 p1{t.Pick(-50, 50), t.Pick(-50, 50)}, p2{t.Pick(-50, 50), t.Pick(-50, 50)};
        found.clear();
        t.ours.RayCast({p1, p2, 1.0f},
                       [&](const RayCastInput& input, int id) { return found.insert(id).second, input.maxFraction; });
        for (int k = 0; k <= 50; ++k) {
            const Vec2 p = p1 + (static_cast<float>(k) / 50.0f) * (p2 - p1);
            for (const int id : t.Overlapping({p, p})) RC_ASSERT(found.count(id) == 1);
        }
    }));
}

TEST(DynamicTree, RebuildAndShiftKeepProxies) {
    Twins t(5);
    for (int i = 0; i < 120; ++i) t.Act();
    const float before = t.ours.GetAreaRatio();
    t.ours.RebuildBottomUp();
    t.theirs.RebuildBottomUp();
    EXPECT_TRUE(t.ours.Validate());
    EXPECT_LT(t.ours.GetAreaRatio(), before * 1.2f);
    EXPECT_NEAR(t.ours.GetAreaRatio(), t.theirs.GetAreaRatio(), 0.05f * before);
    t.ours.ShiftOrigin({10, -5});
    for (const auto& [id, box] : t.boxes) {
        const AABB fat = t.ours.GetFatAABB(id);
        EXPECT_TRUE(AABB({fat.lowerBound - Vec2{1e-3f, 1e-3f}, fat.upperBound + Vec2{1e-3f, 1e-3f}})
                        .Contains({box.lowerBound - Vec2{10, -5}, box.upperBound - Vec2{10, -5}}));
    }
}

TEST(DynamicTree, BadCallsChangeNothing) {
    DynamicTree tree;
    EXPECT_EQ(tree.GetHeight(), 0);
    EXPECT_EQ(tree.GetAreaRatio(), 0.0f);
    EXPECT_EQ(tree.CreateProxy({{1, 1}, {0, 0}}, nullptr), -1);
    const int id = tree.CreateProxy({{0, 0}, {1, 1}}, &tree);
    EXPECT_FALSE(tree.DestroyProxy(-1));
    EXPECT_FALSE(tree.DestroyProxy(id + 5));
    EXPECT_FALSE(tree.MoveProxy(id, {{2, 2}, {std::numeric_limits<float>::quiet_NaN(), 3}}, {0, 0}));
    EXPECT_FALSE(tree.MoveProxy(99, {{0, 0}, {1, 1}}, {0, 0}));
    EXPECT_EQ(tree.GetUserData(99), nullptr);
    EXPECT_TRUE(tree.WasMoved(id));
    tree.ClearMoved(id);
    tree.ClearMoved(99);
    EXPECT_FALSE(tree.WasMoved(id));
    EXPECT_TRUE(tree.Validate());
    EXPECT_TRUE(tree.DestroyProxy(id));
    EXPECT_FALSE(tree.DestroyProxy(id));
    EXPECT_EQ(tree.GetProxyCount(), 0);
    EXPECT_TRUE(tree.Validate());
}

TEST(DynamicTree, MarginIsWhatWasAskedOrTheDefaultWithAWord) {
    const AABB unit{{0.0f, 0.0f}, {1.0f, 1.0f}};
    for (const float margin : {0.0f, 0.5f}) {
        DynamicTree tree(margin);
        EXPECT_EQ(tree.GetFatAABB(tree.CreateProxy(unit, nullptr)).upperBound.x, 1.0f + margin);
    }
    for (const float bad : {-1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        testing::internal::CaptureStderr();
        DynamicTree tree(bad);
        EXPECT_NE(testing::internal::GetCapturedStderr().find("margin: out of range"), std::string::npos);
        EXPECT_EQ(tree.GetFatAABB(tree.CreateProxy(unit, nullptr)).upperBound.x, 1.0f + aabbExtension);
    }
}

}  // namespace
}  // namespace scree::test
