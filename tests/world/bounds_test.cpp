// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is finite and still too large is refused, so that no sum or product of a step becomes infinite. Such are shapes
// whose inertia would be, although their mass is not, and shifts of the origin that lose the bodies.

#include <gtest/gtest.h>

#include <cmath>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace scree {
namespace {

void Keep(const Error& error, void* context) { *static_cast<Error*>(context) = error; }

TEST(Bounds, AShapeOfInfiniteInertiaIsRefused) {
    World world(Vec2{0.0f, 0.0f});
    Error last{};
    world.SetErrorHandler(Keep, &last);
    BodyDef def;
    def.type = dynamicBody;
    Body* body = world.CreateBody(&def);
    const uint64_t before = inspect::GetStateHash(world);
    for (const float side : {1e13f, 1e15f, 9e17f}) {
        PolygonShape sliver;
        const Vec2 points[] = {{-side, -7.0f}, {8.0f, -2.0f}, {8.0f, -11.0f}};
        ASSERT_TRUE(sliver.Set(points, 3));
        EXPECT_EQ(body->CreateFixture(&sliver, 1.0f), nullptr) << side;
        EXPECT_EQ(last.code, ErrorCode::outOfRange) << side;
        EXPECT_EQ(inspect::GetStateHash(world), before);
    }
    PolygonShape box;
    box.SetAsBox(1e6f, 1e6f);
    EXPECT_NE(body->CreateFixture(&box, 1.0f), nullptr);
    EXPECT_TRUE(std::isfinite(body->GetInertia()));
}

TEST(Bounds, AShiftThatLosesABodyIsRefused) {
    World world(Vec2{0.0f, 0.0f});
    Error last{};
    world.SetErrorHandler(Keep, &last);
    BodyDef def;
    def.type = dynamicBody;
    def.position = {3.0f, 4.0f};
    Body* body = world.CreateBody(&def);
    EXPECT_EQ(world.ShiftOrigin({0.0f, 3.4e38f}), ErrorCode::outOfRange);
    EXPECT_EQ(body->GetPosition(), (Vec2{3.0f, 4.0f}));
    EXPECT_EQ(world.ShiftOrigin({-6e17f, 0.0f}), ErrorCode::ok);
    const uint64_t before = inspect::GetStateHash(world);
    EXPECT_EQ(world.ShiftOrigin({-6e17f, 0.0f}), ErrorCode::outOfRange);
    EXPECT_EQ(inspect::GetStateHash(world), before);
    EXPECT_NE(LoadWorld(SaveWorld(world)), nullptr);
}

}  // namespace
}  // namespace scree
