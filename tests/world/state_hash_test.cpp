// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Equal hashes mean equal futures: whatever a later step or call would read is in the hash, also where poses and
// velocities do not tell of it yet. What changes no result is not in it.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "fixtures.h"
#include "world/image.h"
#include "world/record.h"

namespace scree::test {
namespace {

using inspect::GetStateHash;
using Edit = std::function<void(World&)>;

uint64_t HashOf(const WorldDef& def) {
    const World world(def);
    return GetStateHash(world);
}

/// The body made so many bodies ago.
Body* Newest(World& world, int before = 0) {
    Body* body = world.GetBodyList();
    for (; before > 0; --before) body = body->GetNext();
    return body;
}

/// Movers in a row above the ground, far apart, the ends of two pairs joined.
std::unique_ptr<World> MakeRow(int movers) {
    auto world = std::make_unique<World>(Vec2{0.0f, -10.0f});
    AddGround(*world);
    for (int i = 0; i < movers; ++i) {
        Body* body = AddBody(*world, dynamicBody, {4.0f * static_cast<float>(i), 3.0f});
        i % 2 == 0 ? AddBox(body, 0.5f, 0.5f) : AddCircle(body, 0.5f);
    }
    for (const int first : {0, 2}) {
        DistanceJointDef rope;
        rope.Initialize(Newest(*world, first), Newest(*world, first + 1), Newest(*world, first)->GetPosition(),
                        Newest(*world, first + 1)->GetPosition());
        world->CreateJoint(&rope);
    }
    return world;
}

TEST(StateHash, SeesAShapeBeforeAnythingTouchesIt) {
    EXPECT_TRUE(rc::check("disks of one mass and other radii", [] {
        const auto radius = [] { return 0.1f * static_cast<float>(*rc::gen::inRange(1, 30)); };
        const float radii[] = {radius(), radius()};
        uint64_t hashes[2];
        for (int i = 0; i < 2; ++i) {
            World world(Vec2{0.0f, -10.0f});
            AddGround(world);
            Body* body = AddBody(world, dynamicBody, {0.0f, 50.0f});
            AddCircle(body, radii[i], 0.0f);
            const MassData mass{2.0f, {0.0f, 0.0f}, 1.0f};
            body->SetMassData(&mass);
            StepFor(world, 5);
            hashes[i] = GetStateHash(world);
        }
        RC_ASSERT((radii[0] == radii[1]) == (hashes[0] == hashes[1]));
    }));
}

TEST(StateHash, SeesEverySettingThatChangesResults) {
    const std::vector<std::function<void(WorldDef&)>> settings = {
        [](WorldDef& def) { def.gravity.x = 1.0f; },
        [](WorldDef& def) { def.gravity.y = -9.0f; },
        [](WorldDef& def) { def.broadPhase = BroadPhaseKind::fatTree; },
        [](WorldDef& def) { def.allowSleep = false; },
        [](WorldDef& def) { def.warmStarting = false; },
        [](WorldDef& def) { def.maxTranslation = 2.0f; },
        [](WorldDef& def) { def.maxRotation = 2.0f; },
        [](WorldDef& def) { def.continuousPhysics = false; },
        [](WorldDef& def) { def.subStepping = true; },
        [](WorldDef& def) { def.exactDrift = true; },
        [](WorldDef& def) { def.lengthScale = 0.5f; },
        [](WorldDef& def) { def.farDistance = 100.0f; },
        [](WorldDef& def) { def.solver = SolverKind::softStep; },
        [](WorldDef& def) { def.softStep.contactHertz = 12.0f; },
        [](WorldDef& def) { def.softStep.contactDampingRatio = 5.0f; },
        [](WorldDef& def) { def.softStep.contactPushSpeed = 3.0f; },
    };
    for (size_t i = 0; i < settings.size(); ++i) {
        WorldDef def;
        settings[i](def);
        EXPECT_NE(HashOf(def), HashOf({})) << "setting " << i;
    }
}

TEST(StateHash, DoesNotSeeWhatChangesNoResult) {
    const std::vector<std::function<void(WorldDef&)>> settings = {
        [](WorldDef& def) { def.broadPhase = BroadPhaseKind::keys; },
        [](WorldDef& def) { def.broadPhase = BroadPhaseKind::sweepAndPrune; },
        [](WorldDef& def) { def.staticShareThreshold = 0.5f; },
        [](WorldDef& def) { def.workerCount = 3; },
        [](WorldDef& def) { def.featureMode = FeatureMode::full; },
    };
    for (size_t i = 0; i < settings.size(); ++i) {
        WorldDef def;
        settings[i](def);
        EXPECT_EQ(HashOf(def), HashOf({})) << "setting " << i;
    }
    const auto world = MakeRow(4);
    const uint64_t before = GetStateHash(*world);
    Newest(*world)->SetUserData({7});
    Newest(*world)->GetFixtureList()->SetUserData({7});
    world->GetJointList()->SetUserData({7});
    EXPECT_EQ(GetStateHash(*world), before) << "user data";
}

TEST(StateHash, SeesTheOrderOfMoversOfJointsAndOfFreeNumbers) {
    const auto make = [](std::initializer_list<int> destroyed, bool again) {
        auto world = MakeRow(6);
        std::vector<Body*> bodies;
        for (Body* body = world->GetBodyList(); body != nullptr; body = body->GetNext()) bodies.push_back(body);
        for (const int i : destroyed) world->DestroyBody(bodies[static_cast<size_t>(i)]);
        for (size_t i = 0; again && i < destroyed.size(); ++i) AddBody(*world, dynamicBody, {-5.0f, 5.0f});
        return GetStateHash(*world);
    };
    EXPECT_NE(make({4, 5}, false), make({5, 4}, false)) << "free numbers";
    EXPECT_NE(make({4, 5}, true), make({5, 4}, true)) << "the list of bodies";
    EXPECT_EQ(make({4, 5}, true), make({4, 5}, true));
    const auto remake = [](int which) {
        auto world = MakeRow(4);
        Joint* joint = world->GetJointList();
        if (which == 1) joint = joint->GetNext();
        auto* rope = static_cast<DistanceJoint*>(joint);
        DistanceJointDef def;
        def.bodyA = rope->GetBodyA();
        def.bodyB = rope->GetBodyB();
        def.localAnchorA = rope->GetLocalAnchorA();
        def.localAnchorB = rope->GetLocalAnchorB();
        def.length = rope->GetLength();
        def.minLength = rope->GetMinLength();
        def.maxLength = rope->GetMaxLength();
        world->DestroyJoint(joint);
        world->CreateJoint(&def);
        return GetStateHash(*world);
    };
    EXPECT_NE(remake(0), remake(1)) << "the list of joints";
}

TEST(StateHash, SeesEveryEditOfARandomWorld) {
    // Each changes one thing that a later step or call reads.
    const std::vector<Edit> edits = {
        [](World& w) { Newest(w)->SetLinearDamping(0.25f); },
        [](World& w) { Newest(w)->SetAngularDamping(0.25f); },
        [](World& w) { Newest(w)->SetGravityScale(0.25f); },
        [](World& w) { Newest(w)->ApplyTorque(3.0f, true); },
        [](World& w) { Newest(w)->SetBullet(true); },
        [](World& w) { Newest(w)->SetMotionLocks({.x = true}); },
        [](World& w) { w.GetJointList()->SetThresholds(5.0f, 7.0f, true); },
        [](World& w) { Newest(w)->SetSleepingAllowed(false); },
        [](World& w) { Newest(w)->GetFixtureList()->SetFriction(0.9f); },
        [](World& w) { Newest(w)->GetFixtureList()->SetRestitution(0.9f); },
        [](World& w) { Newest(w)->GetFixtureList()->SetRestitutionThreshold(0.9f); },
        [](World& w) { Newest(w)->GetFixtureList()->SetTangentSpeed(0.9f); },
        [](World& w) { Newest(w)->GetFixtureList()->SetRollingResistance(0.9f); },
        [](World& w) { Newest(w)->GetFixtureList()->SetMixRules(MixRule::minimum, MixRule::standard); },
        [](World& w) { Newest(w)->GetFixtureList()->SetDensity(0.9f); },
        [](World& w) { Newest(w)->GetFixtureList()->SetSensor(true); },
        [](World& w) {
            Newest(w)->GetFixtureList()->SetFilterData({.categoryBits = 2, .maskBits = 1, .groupIndex = 3});
        },
        [](World& w) { Newest(w)->GetFixtureList()->GetShape()->m_radius += 0.125f; },
        [](World& w) { static_cast<DistanceJoint*>(w.GetJointList())->SetStiffness(3.0f); },
        [](World& w) { w.SetAutoClearForces(false); },
        [](World& w) {
            w.DestroyBody(AddBody(w, staticBody, {0.0f, 0.0f}));
        },  // its number was given back once
    };
    EXPECT_TRUE(rc::check("an edit shows", [&] {
        const auto world = MakeRow(*rc::gen::inRange(4, 9));
        StepFor(*world, *rc::gen::inRange(0, 40));
        const uint64_t before = GetStateHash(*world);
        RC_ASSERT(GetStateHash(*world) == before);
        (*rc::gen::elementOf(edits))(*world);
        RC_ASSERT(GetStateHash(*world) != before);
    }));
}

TEST(StateHash, SeesHowFarASubSteppedStepHasCome) {
    WorldDef def;
    def.subStepping = true;
    World world(def);
    AddGround(world);
    for (int i = 0; i < 5; ++i) {
        Body* body = AddBody(world, dynamicBody, {2.0f * static_cast<float>(i), 20.0f + static_cast<float>(i)});
        AddBox(body, 0.5f, 0.5f);
        body->SetLinearVelocity({0.0f, -300.0f});
    }
    ContinuousScratch& scratch = world.GetState().continuousScratch;
    for (int i = 0; i < 20 && !scratch.resuming; ++i) StepFor(world, 1);
    ASSERT_TRUE(scratch.resuming);
    const uint64_t before = GetStateHash(world);
    const auto stopped = std::find_if(scratch.alpha.begin(), scratch.alpha.end(), [](float a) { return a > 0.0f; });
    ASSERT_NE(stopped, scratch.alpha.end());
    *stopped *= 0.5f;
    EXPECT_NE(GetStateHash(world), before);
    scratch.resuming = false;
    EXPECT_NE(GetStateHash(world), before);
}

/// Counts what a list of fields names.
struct Counter {
    size_t bytes = 0;

    template <typename... T>
    void operator()(const T&...) {
        ((bytes += sizeof(T)), ...);
    }
    template <typename Table, typename... Columns>
    void Rows(const Table&, const Columns&... columns) {
        (*this)(columns...);
    }
    template <typename... T>
    void Stored(const T&... values) {
        (*this)(values...);
    }
    template <typename... T>
    void Hashed(const T&...) {}
    template <typename... T>
    void LeftOut(const T&... values) {
        (*this)(values...);
    }
};

template <typename T>
void ExpectWhole(size_t padding = 0) {
    const T object{};
    Counter counter;
    Fields(object, counter);
    EXPECT_EQ(counter.bytes + padding, sizeof(T)) << typeid(T).name();
}

TEST(FieldList, VisitsEveryMemberThatItNames) {
    ExpectWhole<Velocity>();
    ExpectWhole<Position>();
    ExpectWhole<PositionRest>();
    ExpectWhole<MassRow>();
    ExpectWhole<ForceRow>();
    ExpectWhole<MotionRow>();
    ExpectWhole<BodyDemand>();
    ExpectWhole<BodyInfo>();
    ExpectWhole<Filter>(4);    // behind `groupIndex`
    ExpectWhole<Material>(2);  // behind the rules
    ExpectWhole<ContactPair>();
    ExpectWhole<ContactMaterial>();
    ExpectWhole<JointLink>();
    ExpectWhole<GearSide>(3);    // behind `slides`
    ExpectWhole<LimitState>(3);  // behind `enabled`
    ExpectWhole<MotorState>(3);
    ExpectWhole<SpringState>(3);
    ExpectWhole<RevoluteRow>();
    ExpectWhole<PrismaticRow>();
    ExpectWhole<WheelRow>();
    ExpectWhole<DistanceRow>();
    ExpectWhole<PulleyRow>();
    ExpectWhole<MouseRow>();
    ExpectWhole<GearRow>();
    ExpectWhole<WeldRow>();
    ExpectWhole<FrictionRow>();
    ExpectWhole<MotorRow>();
    ExpectWhole<Tolerance>();
}

TEST(FieldList, FindsTheSizeOfAClassWithTheMembersThatItAdds) {
    struct Base {
        virtual ~Base() = default;
        int number = 0;
        bool flag = false;
    };
    struct InTheTail : Base {
        bool other = false;
    };
    struct Behind : Base {
        double length = 0.0;
        char letter = 0;
    };
    EXPECT_EQ((SizeWith<Base, bool>()), sizeof(InTheTail));
    EXPECT_EQ((SizeWith<Base, double, char>()), sizeof(Behind));
    EXPECT_LT((SizeWith<Base, double>()), sizeof(Behind));
}

}  // namespace
}  // namespace scree::test
