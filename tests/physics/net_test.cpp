// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Nets of joints, whose direct solve would take too long: random ones hang, come to rest and stay together, the better
// the more sub-steps. Structures that are long but narrow stay exact.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"
#include "scree/snapshot.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

enum class Knot { hinge, weld, rod };

/// A net of columns × rows bodies a metre apart, hung by some of its upper row.
struct NetPlan {
    int columns, rows;
    Knot knot;
    float massRatio;  ///< of the heaviest to the lightest
    unsigned seed;
};

class Net {
public:
    explicit Net(const NetPlan& plan, int workers = 1) : world(DefFor(workers)) {
        std::mt19937 random(plan.seed);
        const auto draw = [&] { return std::uniform_real_distribution<float>(0.0f, 1.0f)(random); };
        std::vector<Body*> bodies;
        for (int i = 0; i < plan.columns * plan.rows; ++i) {
            const int column = i / plan.rows, row = i % plan.rows;
            BodyDef def;
            const bool hangs = row == 0 && (column == 0 || column == plan.columns - 1 || draw() < 0.3f);
            def.type = hangs ? staticBody : dynamicBody;
            def.position = {static_cast<float>(column), static_cast<float>(-row)};
            Body* body = world.CreateBody(&def);
            CircleShape circle;
            circle.m_radius = 0.4f;
            FixtureDef fixture;
            fixture.shape = &circle;
            fixture.density = std::pow(plan.massRatio, draw());
            fixture.filter.groupIndex = -1;
            body->CreateFixture(&fixture);
            bodies.push_back(body);
            if (row > 0) Tie(bodies[static_cast<size_t>(i - 1)], body, plan.knot);
            if (column > 0) Tie(bodies[static_cast<size_t>(i - plan.rows)], body, plan.knot);
        }
    }

    /// The widest gap of a joint, m.
    [[nodiscard]] float WidestGap() const {
        float widest = 0.0f;
        for (const Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
            const float length = (joint->GetAnchorB() - joint->GetAnchorA()).Length();
            const float wanted =
                joint->GetType() == e_distanceJoint ? static_cast<const DistanceJoint*>(joint)->GetLength() : 0.0f;
            widest = std::max(widest, std::abs(length - wanted));
        }
        return widest;
    }
    [[nodiscard]] float FastestSpeed() const {
        float fastest = 0.0f;
        for (const Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            fastest = std::max(fastest, body->GetLinearVelocity().Length());
        return fastest;
    }

    World world;

private:
    static WorldDef DefFor(int workers) {
        WorldDef def;
        def.gravity = {0.0f, -10.0f};
        def.workerCount = workers;
        return def;
    }
    void Tie(Body* a, Body* b, Knot knot) {
        const Vec2 middle = 0.5f * (a->GetPosition() + b->GetPosition());
        switch (knot) {
            case Knot::hinge: {
                RevoluteJointDef def;
                def.Initialize(a, b, middle);
                world.CreateJoint(&def);
                return;
            }
            case Knot::weld: {
                WeldJointDef def;
                def.Initialize(a, b, middle);
                world.CreateJoint(&def);
                return;
            }
            case Knot::rod: {
                DistanceJointDef def;
                def.Initialize(a, b, a->GetPosition(), b->GetPosition());
                def.minLength = def.maxLength = def.length;
                world.CreateJoint(&def);
                return;
            }
        }
    }
};

struct Hang {
    float widest = 0.0f;      ///< gap over all steps, m
    float widestEnd = 0.0f;   ///< in the last second
    float fastestEnd = 0.0f;  ///< m/s, in the last second
};
Hang HangFor(const NetPlan& plan, int seconds, int substeps) {
    Net net(plan);
    Hang hang;
    for (int i = 0; i < 60 * seconds; ++i) {
        net.world.Step(1.0f / 60.0f, substeps);
        const float gap = net.WidestGap();
        hang.widest = std::max(hang.widest, gap);
        if (i < 60 * (seconds - 1)) continue;
        hang.widestEnd = std::max(hang.widestEnd, gap);
        hang.fastestEnd = std::max(hang.fastestEnd, net.FastestSpeed());
    }
    return hang;
}

TEST(Nets, HoldTogether) {
    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    const auto between = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    for (int round = 0; round < 8; ++round) {
        const NetPlan plan{between(6, 16), between(6, 16), static_cast<Knot>(round % 3),
                           std::pow(10.0f, static_cast<float>(between(0, 100)) / 100.0f),
                           static_cast<unsigned>(random())};
        SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round) + ": " +
                     std::to_string(plan.columns) + " x " + std::to_string(plan.rows) +
                     ", masses 1:" + std::to_string(plan.massRatio) + ", knot " + std::to_string(round % 3));
        const Hang game = HangFor(plan, 8, 4), fine = HangFor(plan, 8, 8), precise = HangFor(plan, 8, 16);
        EXPECT_LT(game.widest, 0.15f);
        EXPECT_LT(fine.widest, 0.6f * game.widest);
        EXPECT_LT(precise.widest, 0.6f * fine.widest);
        EXPECT_LE(game.widestEnd, game.widest);
        if (plan.knot == Knot::rod) continue;  // cloth swings on
        for (const Hang& hang : {game, fine, precise}) EXPECT_LT(hang.fastestEnd, 0.3f);
    }
}

/// Masses 1 : 1000 are more than rows solved in turn can hold closed; they must stay in one piece all the same.
TEST(Nets, OfVeryUnequalMassesDoNotExplode) {
    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    const auto between = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    for (int round = 0; round < 6; ++round) {
        const NetPlan plan{between(6, 12), between(6, 12), static_cast<Knot>(round % 3), 1000.0f,
                           static_cast<unsigned>(random())};
        SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
        for (const int substeps : {4, 16}) {
            const Hang hang = HangFor(plan, 6, substeps);
            EXPECT_LT(hang.widest, substeps == 4 ? 4.0f : 0.5f);
            EXPECT_LT(hang.fastestEnd, 30.0f);
        }
    }
}

/// Light bodies among heavy ones swung up. Each step began with the mean impulses of the last one, which made both nets
/// do so: one at 16 and one at 32 sub-steps. A weld's turning was solved apart from its anchors, which made the second
/// do so at any number.
TEST(Nets, OfWeldsComeToRestInStepsOfAnyLength) {
    for (const NetPlan& plan :
         {NetPlan{11, 10, Knot::weld, 1000.0f, 3984282833u}, NetPlan{9, 12, Knot::weld, 1000.0f, 4228248112u}}) {
        for (const int substeps : {1, 4, 16, 32}) {
            Net net(plan);
            const float dt = static_cast<float>(substeps) / 960.0f;
            for (int i = 0; i < 6 * 960 / substeps; ++i) {
                net.world.Step(dt, substeps);
                ASSERT_LT(net.WidestGap(), 0.01f) << substeps << " sub-steps, step " << i;
            }
            EXPECT_LT(net.FastestSpeed(), 0.05f) << substeps;
        }
    }
}

/// A step of n sub-steps is n steps of one: no part of the solution waits for the end of a step.
TEST(Nets, GoAlikeInOneStepAndInMany) {
    std::mt19937 random(std::random_device{}());
    std::normal_distribution<float> normal;
    for (const Knot knot : {Knot::hinge, Knot::weld, Knot::rod}) {
        const NetPlan plan{9, 8, knot, 30.0f, static_cast<unsigned>(random())};
        Net one(plan), many(plan);
        constexpr float h = 1.0f / 960.0f;
        for (int i = 0; i < 200; ++i) one.world.Step(h, 1), many.world.Step(h, 1);
        Body* of = many.world.GetBodyList();
        for (Body* body = one.world.GetBodyList(); body != nullptr; body = body->GetNext(), of = of->GetNext()) {
            if (body->GetType() != dynamicBody) continue;
            const Vec2 kick{normal(random), normal(random)};
            body->SetLinearVelocity(body->GetLinearVelocity() + kick);
            of->SetLinearVelocity(body->GetLinearVelocity());
        }
        constexpr int substeps = 12;
        one.world.Step(substeps * h, substeps);
        for (int i = 0; i < substeps; ++i) many.world.Step(h, 1);
        of = many.world.GetBodyList();
        for (Body* body = one.world.GetBodyList(); body != nullptr; body = body->GetNext(), of = of->GetNext()) {
            EXPECT_LT((body->GetLinearVelocity() - of->GetLinearVelocity()).Length(), 1e-3f) << plan.seed;
            EXPECT_LT(std::abs(body->GetAngularVelocity() - of->GetAngularVelocity()), 5e-3f) << plan.seed;
        }
    }
}

/// Workers share joints that have no body in common, so the order of all others is the same.
TEST(Nets, AreTheSameWithAnyNumberOfThreads) {
    std::mt19937 random(std::random_device{}());
    for (const Knot knot : {Knot::hinge, Knot::weld, Knot::rod}) {
        const NetPlan plan{70, 60, knot, 10.0f, static_cast<unsigned>(random())};
        Net one(plan);
        for (int i = 0; i < 20; ++i) one.world.Step(1.0f / 60.0f, 4);
        for (const int workers : {2, 3, 8}) {
            Net shared(plan, workers);
            for (int i = 0; i < 20; ++i) shared.world.Step(1.0f / 60.0f, 4);
            EXPECT_EQ(inspect::GetStateHash(shared.world), inspect::GetStateHash(one.world))
                << workers << " workers, seed " << plan.seed;
        }
    }
}

/// More joints on one body than there are colours for: those left over are solved one after the other.
TEST(Nets, WithAHubHold) {
    constexpr int spokes = 150;
    uint64_t hash = 0;
    for (const int workers : {1, 3}) {
        WorldDef worldDef;
        worldDef.gravity = {0.0f, -10.0f};
        worldDef.workerCount = workers;
        World world(worldDef);
        world.GetState().pool->ShareAlways();
        BodyDef def;
        Body* ground = world.CreateBody(&def);
        def.type = dynamicBody;
        const auto make = [&](Vec2 at, float radius) {
            def.position = at;
            Body* body = world.CreateBody(&def);
            CircleShape circle;
            circle.m_radius = radius;
            FixtureDef fixture;
            fixture.shape = &circle;
            fixture.density = 1.0f;
            fixture.filter.groupIndex = -1;
            body->CreateFixture(&fixture);
            return body;
        };
        const auto tie = [&](Body* a, Body* b, Vec2 at) {
            RevoluteJointDef joint;
            joint.Initialize(a, b, at);
            world.CreateJoint(&joint);
        };
        Body* hub = make({0.0f, 0.0f}, 5.0f);
        tie(ground, hub, {0.0f, 0.0f});
        std::vector<Body*> rim;
        for (int i = 0; i < spokes; ++i) {
            const float angle = 2.0f * pi * static_cast<float>(i) / spokes;
            const Vec2 out{std::cos(angle), std::sin(angle)};
            rim.push_back(make(7.0f * out, 0.3f));
            tie(hub, rim.back(), 6.0f * out);
            if (i == 0) continue;
            Body* last = rim[static_cast<size_t>(i - 1)];
            tie(last, rim.back(), 0.5f * (last->GetPosition() + rim.back()->GetPosition()));
        }
        float widest = 0.0f;
        for (int i = 0; i < 120; ++i) {
            world.Step(1.0f / 60.0f, 8);
            for (const Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
                widest = std::max(widest, (joint->GetAnchorB() - joint->GetAnchorA()).Length());
        }
        EXPECT_LT(widest, 0.15f) << workers;
        if (workers == 1) hash = inspect::GetStateHash(world);
        EXPECT_EQ(inspect::GetStateHash(world), hash) << workers;
    }
}

/// Beams of welded bodies, two rows deep: what the joints at the wall report holds the weight of the rest and its
/// moment.
TEST(Nets, ReportWhatTheyHold) {
    std::mt19937 random(std::random_device{}());
    const auto between = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    for (int round = 0; round < 4; ++round) {
        const int length = between(3, 6), depth = between(9, 14);
        World world(Vec2{0.0f, -10.0f});
        BodyDef wallDef;
        Body* wall = world.CreateBody(&wallDef);
        std::vector<Body*> bodies;
        float weight = 0.0f, moment = 0.0f;  // about the origin
        const auto tie = [&](Body* a, Body* b, Vec2 at) {
            WeldJointDef def;
            def.Initialize(a, b, at);
            return world.CreateJoint(&def);
        };
        std::vector<Joint*> held;
        for (int i = 0; i < length * depth; ++i) {
            const int column = i / depth, row = i % depth;
            BodyDef def;
            def.type = dynamicBody;
            def.position = {static_cast<float>(column + 1), static_cast<float>(-row)};
            Body* body = world.CreateBody(&def);
            CircleShape circle;
            circle.m_radius = 0.4f;
            FixtureDef fixture;
            fixture.shape = &circle;
            fixture.density = static_cast<float>(between(1, 3));
            fixture.filter.groupIndex = -1;
            body->CreateFixture(&fixture);
            weight += 10.0f * body->GetMass();
            moment += 10.0f * body->GetMass() * def.position.x;
            bodies.push_back(body);
            const Vec2 here = def.position;
            if (row > 0) tie(bodies[static_cast<size_t>(i - 1)], body, here + Vec2{0.0f, 0.5f});
            Body* left = column > 0 ? bodies[static_cast<size_t>(i - depth)] : wall;
            Joint* joint = tie(left, body, here - Vec2{0.5f, 0.0f});
            if (column == 0) held.push_back(joint);
        }
        for (int i = 0; i < 600; ++i) world.Step(1.0f / 60.0f, 8);
        // On B, as GetReactionForce says.
        Vec2 force{0.0f, 0.0f};
        float torque = 0.0f, turning = 0.0f;
        for (Joint* joint : held) {
            const Vec2 pull = joint->GetReactionForce(60.0f);
            force += pull;
            torque += Cross(joint->GetAnchorB(), pull) + joint->GetReactionTorque(60.0f);
            turning = std::max(turning, std::abs(joint->GetReactionTorque(60.0f)));
        }
        EXPECT_NEAR(force.x, 0.0f, 0.02f * weight);
        EXPECT_NEAR(force.y, weight, 0.02f * weight);
        EXPECT_NEAR(torque, moment, 0.02f * moment);
        EXPECT_GT(turning, 0.0f);
    }
}

/// What rows start from is in the image: a loaded net goes on as the saved one.
TEST(Nets, GoOnAlikeAfterLoading) {
    for (const Knot knot : {Knot::hinge, Knot::weld, Knot::rod}) {
        Net net({9, 8, knot, 3.0f, 11u});
        for (int i = 0; i < 40; ++i) net.world.Step(1.0f / 60.0f, 4);
        const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(net.world));
        ASSERT_NE(loaded, nullptr);
        for (int i = 0; i < 40; ++i) {
            net.world.Step(1.0f / 60.0f, 4);
            loaded->Step(1.0f / 60.0f, 4);
            ASSERT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(net.world)) << i;
        }
    }
}

/// Joints that go change the plan: cutting a net to pieces leaves each of them held.
TEST(Nets, CutToPiecesAreHeldOn) {
    Net net({12, 12, Knot::hinge, 1.0f, 5u});
    std::mt19937 random(5);
    for (int i = 0; i < 240; ++i) {
        if (i % 2 == 0 && net.world.GetJointCount() > 20) {
            Joint* joint = net.world.GetJointList();
            for (auto skip = random() % static_cast<unsigned>(net.world.GetJointCount()); skip > 0; --skip)
                joint = joint->GetNext();
            net.world.DestroyJoint(joint);
        }
        net.world.Step(1.0f / 60.0f, 4);
        ASSERT_LT(net.WidestGap(), 0.15f) << i;
    }
}

}  // namespace
}  // namespace scree::test
