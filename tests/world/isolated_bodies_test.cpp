// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies that nothing touches are moved eight at a time. Each gets the bits that it gets alone in a world, where it
// goes the scalar way. That holds whatever its neighbours in the group are (kinematic, capped, asleep soon, with forces
// and damping).

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <initializer_list>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include "scree/scree.h"
#include "world/world_state.h"

namespace scree {
namespace {

struct Recipe {
    BodyDef body;
    bool box;
    Vec2 offset;  ///< of the shape
    Vec2 force;
    float torque;
};

std::vector<Recipe> MakeRecipes(int count) {
    std::mt19937 random(7);
    const auto uniform = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random()) / static_cast<float>(std::mt19937::max());
    };
    const auto oneIn = [&](unsigned n) { return random() % n == 0; };
    std::vector<Recipe> recipes;
    for (int i = 0; i < count; ++i) {
        Recipe r{};
        r.body.type = oneIn(40) ? kinematicBody : dynamicBody;
        r.body.position = {100.0f * static_cast<float>(i), uniform(-50.0f, 50.0f)};
        r.body.angle = uniform(-4.0f, 4.0f);
        const float speed = oneIn(30) ? 500.0f : oneIn(3) ? 0.0f : 5.0f;  // beyond the cap, at rest, ordinary
        r.body.linearVelocity = {uniform(-speed, speed), uniform(-speed, speed)};
        r.body.angularVelocity = oneIn(2) ? 0.0f : uniform(-200.0f, 200.0f);
        r.body.linearDamping = oneIn(3) ? uniform(0.0f, 3.0f) : 0.0f;
        r.body.angularDamping = oneIn(3) ? uniform(0.0f, 3.0f) : 0.0f;
        r.body.gravityScale = oneIn(4) ? 0.0f : oneIn(3) ? uniform(-2.0f, 2.0f) : 1.0f;
        r.body.fixedRotation = oneIn(10);
        r.body.allowSleep = !oneIn(5);
        r.box = oneIn(2);
        r.offset = oneIn(2) ? Vec2{uniform(-1.0f, 1.0f), uniform(-1.0f, 1.0f)} : vec2Zero;
        if (oneIn(3)) r.force = {uniform(-9.0f, 9.0f), uniform(-9.0f, 9.0f)}, r.torque = uniform(-2.0f, 2.0f);
        recipes.push_back(r);
    }
    return recipes;
}

WorldDef MakeDef(int workers) {
    WorldDef def;
    def.workerCount = workers;
    def.maxTranslation = 2.0f, def.maxRotation = 0.5f * pi;
    def.farDistance = std::numeric_limits<float>::infinity();  // one far body changes all positions of its world
    return def;
}

Body* Add(World& world, const Recipe& recipe) {
    Body* body = world.CreateBody(&recipe.body);
    PolygonShape box;
    box.SetAsBox(0.4f, 0.3f, recipe.offset, 0.2f);
    CircleShape circle;
    circle.m_radius = 0.5f, circle.m_p = recipe.offset;
    body->CreateFixture(recipe.box ? static_cast<const Shape*>(&box) : &circle, 1.0f);
    return body;
}

void Push(Body* body, const Recipe& recipe) {
    body->ApplyForceToCenter(recipe.force, false);
    body->ApplyTorque(recipe.torque, false);
}

using Bits = std::array<uint32_t, 8>;
Bits BitsOf(const Body& body) {
    const Transform& xf = body.GetTransform();
    const auto bits = [](float x) { return std::bit_cast<uint32_t>(x + 0.0f); };  // −0 counts as 0
    return {bits(xf.p.x),
            bits(xf.p.y),
            bits(xf.q.s),
            bits(body.GetAngle()),
            bits(body.GetLinearVelocity().x),
            bits(body.GetLinearVelocity().y),
            bits(body.GetAngularVelocity()),
            body.IsAwake() ? 1u : 0u};
}

/// `substeps` of the soft step; 0: sequential impulses.
StepReport Advance(World& world, int substeps) {
    constexpr float dt = 1.0f / 60.0f;
    return substeps == 0 ? world.Step(dt, 8, 3) : world.Step(dt, substeps);
}

struct GroupCase {
    int workers, substeps;
    bool isPlain;  ///< no body has damping, a gravity scale of its own or a force
};

TEST(IsolatedBodies, MoveInGroupsAsTheyDoAlone) {
    constexpr int count = 611, steps = 60;
    for (const GroupCase& the : std::initializer_list<GroupCase>{
             {1, 0, false}, {3, 0, true}, {3, 1, false}, {1, 4, false}, {3, 4, true}, {1, 7, true}, {3, 16, false}}) {
        SCOPED_TRACE(testing::Message() << the.workers << " workers, " << the.substeps << " sub-steps, "
                                        << the.isPlain);
        std::vector<Recipe> recipes = MakeRecipes(count);
        for (Recipe& recipe : recipes) {
            if (!the.isPlain) break;
            recipe.body.linearDamping = recipe.body.angularDamping = 0.0f;
            recipe.body.gravityScale = 1.0f;
            recipe.force = vec2Zero, recipe.torque = 0.0f;
        }
        World together(MakeDef(the.workers));
        together.GetState().pool->ShareAlways();
        std::vector<Body*> bodies;
        for (const Recipe& recipe : recipes) bodies.push_back(Add(together, recipe));
        std::vector<std::unique_ptr<World>> worlds;
        std::vector<Body*> loners;
        for (const Recipe& recipe : recipes) {
            worlds.push_back(std::make_unique<World>(MakeDef(1)));
            loners.push_back(Add(*worlds.back(), recipe));
        }
        int capped = 0, asleep = 0;
        for (int step = 0; step < steps; ++step) {
            for (size_t i = 0; i < bodies.size(); ++i) Push(bodies[i], recipes[i]), Push(loners[i], recipes[i]);
            const StepReport report = Advance(together, the.substeps);
            ASSERT_EQ(report.awakeBodyCount, report.isolatedBodyCount) << "nothing touches";
            int cappedAlone = 0;
            for (const auto& world : worlds) cappedAlone += Advance(*world, the.substeps).cappedCount;
            ASSERT_EQ(report.cappedCount, cappedAlone) << "step " << step;
            capped += cappedAlone;
            for (size_t i = 0; i < bodies.size(); ++i) {
                ASSERT_EQ(BitsOf(*bodies[i]), BitsOf(*loners[i])) << "body " << i << " in step " << step;
            }
        }
        for (const Body* body : bodies) asleep += body->IsAwake() ? 0 : 1;
        EXPECT_GT(capped, 10) << "the groups met capped bodies";
        EXPECT_GT(asleep, the.isPlain ? -1 : 10) << "and such that fell asleep";
    }
}

TEST(IsolatedBodies, OneThatIsNotFiniteAnyMoreStopsAndItsNeighboursGoOn) {
    for (const int substeps : {0, 4}) {
        WorldDef def = MakeDef(1);
        def.maxTranslation = std::numeric_limits<float>::infinity();
        World world(def);
        std::vector<Body*> bodies;
        for (int i = 0; i < 24; ++i) {
            Recipe recipe{};
            recipe.body.type = dynamicBody;
            recipe.body.position = {10.0f * static_cast<float>(i), 0.0f};
            bodies.push_back(Add(world, recipe));
        }
        bodies[11]->ApplyForceToCenter({3.0e38f, 0.0f}, true);  // a speed beyond all bounds
        EXPECT_EQ(Advance(world, substeps).nonFiniteCount, 1);
        EXPECT_EQ(bodies[11]->GetPosition().x, 110.0f);
        EXPECT_EQ(bodies[11]->GetLinearVelocity(), vec2Zero);
        for (size_t i = 0; i < bodies.size(); ++i) {
            if (i == 11) continue;
            EXPECT_LT(bodies[i]->GetPosition().y, 0.0f) << i;
        }
    }
}

}  // namespace
}  // namespace scree
