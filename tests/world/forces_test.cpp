// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Explosions and wind: directions, strengths and laws; bad input changes nothing.

#include "scree/forces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

TEST(Explode, PushesAwayByWidthAndFallsOff) {
    World world({0.0f, 0.0f});
    constexpr float distances[] = {2.0f, 5.0f, 8.0f, 12.0f};
    Body* bodies[4];
    for (int i = 0; i < 4; ++i) {
        bodies[i] = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddCircle(bodies[i], 0.5f);
        const float angle = 1.3f * static_cast<float>(i);
        bodies[i]->SetTransform({distances[i] * std::cos(angle), distances[i] * std::sin(angle)}, 0.0f);
    }
    Body* wall = AddBody(world, staticBody, {1.0f, 1.0f});
    AddBox(wall, 0.2f, 0.2f);
    StepFor(world, 1);
    ExplosionDef def;
    def.radius = 4.0f;
    def.falloff = 6.0f;
    def.impulsePerWidth = 3.0f;
    ASSERT_EQ(Explode(world, def), ErrorCode::ok);
    for (int i = 0; i < 4; ++i) {
        const float surface = distances[i] - 0.5f;
        const float strength = surface <= 4.0f ? 1.0f : std::max(0.0f, (10.0f - surface) / 6.0f);
        const Vec2 away = bodies[i]->GetPosition();
        const Vec2 push = bodies[i]->GetMass() * bodies[i]->GetLinearVelocity();
        EXPECT_NEAR(push.Length(), strength * 3.0f * 1.0f, 0.02f) << i;  // 1 m wide
        EXPECT_NEAR(Dot(push, away), push.Length() * away.Length(), 1e-3f) << i;
    }
    def.impulsePerWidth = -3.0f;
    ASSERT_EQ(Explode(world, def), ErrorCode::ok);
    for (const Body* body : bodies) EXPECT_NEAR(body->GetLinearVelocity().Length(), 0.0f, 1e-3f);
}

TEST(Explode, WakesAndReachesWhatTheFilterSees) {
    World world({0.0f, 0.0f});
    Body* seen = AddBody(world, dynamicBody, {1.0f, 0.0f});
    Body* unseen = AddBody(world, dynamicBody, {-1.0f, 0.0f});
    AddBox(seen, 0.2f, 0.2f)->SetFilterData({.categoryBits = uint64_t{1} << 33});
    AddBox(unseen, 0.2f, 0.2f);
    StepFor(world, 1);
    seen->SetAwake(false);
    ExplosionDef def;
    def.radius = 5.0f;
    def.impulsePerWidth = 1.0f;
    def.filter.maskBits = uint64_t{1} << 33;
    ASSERT_EQ(Explode(world, def), ErrorCode::ok);
    EXPECT_TRUE(seen->IsAwake());
    EXPECT_GT(seen->GetLinearVelocity().x, 0.0f);
    EXPECT_EQ(unseen->GetLinearVelocity().x, 0.0f);
    ErrorLog errors(world);
    def.radius = -1.0f;
    EXPECT_EQ(Explode(world, def), ErrorCode::outOfRange);
    def.radius = 1.0f;
    def.position = {nan, 0.0f};
    EXPECT_EQ(Explode(world, def), ErrorCode::nonFinite);
    EXPECT_EQ(errors.count, 2);
}

/// A plate across the wind feels density · area · speed², and one along it feels next to nothing; a plate at an angle
/// is lifted across the wind.
TEST(Wind, PressesBySineSquare) {
    for (const float angle : {0.0f, 0.5f * pi, 0.25f * pi}) {
        World world({0.0f, 0.0f});
        Body* plate = AddBody(world, dynamicBody, {0.0f, 0.0f}, angle);
        Fixture* fixture = AddBox(plate, 0.005f, 1.0f, 100.0f);
        WindDef wind;
        wind.velocity = {10.0f, 0.0f};
        wind.density = 1.2f;
        ASSERT_EQ(ApplyWind(fixture, wind), ErrorCode::ok);
        StepFor(world, 1);
        const Vec2 force = (60.0f * plate->GetMass()) * plate->GetLinearVelocity();
        const float normal = std::cos(angle), pressure = 1.2f * 2.0f * 100.0f * normal * normal;
        EXPECT_NEAR(force.x, pressure * normal, 0.02f * 240.0f) << angle;
        EXPECT_NEAR(force.y, pressure * std::sin(angle), 0.02f * 240.0f) << angle;
        EXPECT_NEAR(plate->GetAngularVelocity(), 0.0f, 1e-3f);
    }
}

/// A body in the wind comes to its speed, and is not pushed once it has it.
TEST(Wind, DragsADiskToItsOwnSpeed) {
    World world({0.0f, 0.0f});
    Body* disk = AddBody(world, dynamicBody, {0.0f, 0.0f});
    Fixture* fixture = AddCircle(disk, 0.5f, 0.2f);
    WindDef wind;
    wind.velocity = {4.0f, 1.0f};
    for (int i = 0; i < 3000; ++i) {
        ASSERT_EQ(ApplyWind(fixture, wind), ErrorCode::ok);
        StepFor(world, 1);
    }
    EXPECT_NEAR(disk->GetLinearVelocity().x, 4.0f, 0.1f);
    EXPECT_NEAR(disk->GetLinearVelocity().y, 1.0f, 0.1f);
    EXPECT_NEAR(disk->GetAngularVelocity(), 0.0f, 1e-2f);
    disk->SetAwake(false);
    EXPECT_EQ(ApplyWind(fixture, wind), ErrorCode::ok);
    EXPECT_FALSE(disk->IsAwake());
    wind.density = -1.0f;
    ErrorLog errors(world);
    EXPECT_EQ(ApplyWind(fixture, wind), ErrorCode::outOfRange);
    EXPECT_EQ(ApplyWind(nullptr, wind), ErrorCode::nullArgument);
}

}  // namespace
}  // namespace scree::test
