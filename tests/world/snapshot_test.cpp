// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A restored world is the saved one: the same hash at once and after every further step. That holds on every scene and
// with every broad phase, in the middle of edits and of sub-stepped steps. Damaged images give an error and no world.

#include "scree/snapshot.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "fixtures.h"
#include "scene_world.h"
#include "world/image.h"
#include "world/state_fields.h"

namespace scree::test {
namespace {

using Image = std::vector<std::byte>;

std::unique_ptr<World> Copy(const World& world) {
    SnapshotError error = SnapshotError::ok;
    std::unique_ptr<World> copy = LoadWorld(SaveWorld(world), &error);
    EXPECT_EQ(error, SnapshotError::ok) << GetName(error);
    return copy;
}

/// Steps both worlds and stops at the first difference.
void ExpectSameFuture(World& world, World& copy, const scenes::Scene& scene, int steps) {
    ASSERT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(copy)) << "at once";
    for (int i = 1; i <= steps; ++i) {
        StepScene(world, scene);
        StepScene(copy, scene);
        ASSERT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(copy)) << "after " << i << " steps";
    }
}

/// A small world with joints of several types, a chain, sensors, sleepers and free slots.
std::unique_ptr<World> MakeMixedWorld(BroadPhaseKind kind = BroadPhaseKind::automatic) {
    WorldDef worldDef;
    worldDef.broadPhase = kind;
    auto world = std::make_unique<World>(worldDef);
    Body* ground = AddGround(*world);
    const Vec2 points[] = {{-8.0f, 4.0f}, {-8.0f, 0.2f}, {8.0f, 0.2f}, {8.0f, 4.0f}};
    ChainShape chain;
    EXPECT_TRUE(chain.CreateChain(points, 4, {-8.0f, 5.0f}, {8.0f, 5.0f}));
    ground->CreateFixture(&chain, 0.0f);
    std::vector<Body*> bodies;
    for (int i = 0; i < 12; ++i) {
        const auto x = static_cast<float>(i % 4) * 1.1f - 2.0f;
        bodies.push_back(AddBody(*world, dynamicBody, {x, 1.0f + static_cast<float>(i / 4) * 1.1f}));
        if (i % 3 == 0) {
            const ConvexShape capsule = MakeCapsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.2f);
            bodies.back()->CreateFixture(&capsule, 1.0f);
        } else if (i % 3 == 1) {
            AddBox(bodies.back(), 0.5f, 0.4f);
        } else {
            AddCircle(bodies.back(), 0.5f);
        }
        bodies.back()->SetUserData({static_cast<uintptr_t>(100 + i)});
    }
    AddCircle(bodies[2], 0.8f, 0.0f)->SetSensor(true);
    bodies[5]->SetBullet(true);
    RevoluteJointDef hinge;
    hinge.Initialize(ground, bodies[0], bodies[0]->GetPosition());
    PrismaticJointDef slide;
    slide.Initialize(ground, bodies[1], bodies[1]->GetPosition(), {0.0f, 1.0f});
    GearJointDef gear;
    gear.joint1 = world->CreateJoint(&hinge);
    gear.joint2 = world->CreateJoint(&slide);
    gear.ratio = 0.5f;
    world->CreateJoint(&gear);
    DistanceJointDef rod;
    rod.Initialize(bodies[3], bodies[4], bodies[3]->GetPosition(), bodies[4]->GetPosition());
    Joint* removed = world->CreateJoint(&rod);
    world->CreateJoint(&rod);
    world->DestroyJoint(removed);
    world->DestroyBody(bodies[7]);
    bodies[8]->SetEnabled(false);
    return world;
}

TEST(Snapshot, EverySceneGoesOnBitForBit) {
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = scenes::Build(info.name, SmallSize(info));
        const bool large = scene.bodies.size() > 1500;
        SCOPED_TRACE(std::string(info.name));
        World world(DefOf(scene, BroadPhaseKind::automatic));
        LoadScene(world, scene);
        for (int i = 0; i < (large ? 5 : 40); ++i) StepScene(world, scene);
        const auto copy = Copy(world);
        ASSERT_NE(copy, nullptr);
        ExpectSameFuture(world, *copy, scene, large ? 10 : 60);
        if (HasFatalFailure()) return;
    }
}

TEST(Snapshot, EveryBroadPhaseGoesOnBitForBit) {
    for (const char* name : {"falling-squares", "tumbler", "mixed", "bullet"}) {
        const scenes::SceneInfo* info = scenes::Find(name);
        if (info == nullptr) continue;
        const scenes::Scene scene = scenes::Build(name, SmallSize(*info));
        for (size_t kind = 0; kind < broadPhaseNames.size(); ++kind) {
            SCOPED_TRACE(std::string(name) + ", " + std::string(broadPhaseNames[kind]));
            World world(DefOf(scene, static_cast<BroadPhaseKind>(kind)));
            LoadScene(world, scene);
            for (int i = 0; i < 30; ++i) StepScene(world, scene);
            const auto copy = Copy(world);
            ASSERT_NE(copy, nullptr);
            ExpectSameFuture(world, *copy, scene, 60);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(Snapshot, GeneratedWorldsSavedInTheMiddleOfEditsGoOnBitForBit) {
    EXPECT_TRUE(rc::check("a copy made after random edits has the same future", [] {
        const auto kind =
            static_cast<BroadPhaseKind>(*rc::gen::inRange<int>(0, static_cast<int>(broadPhaseNames.size())));
        const auto world = MakeMixedWorld(kind);
        world->SetSubStepping(*rc::gen::arbitrary<bool>());
        world->SetExactDrift(*rc::gen::arbitrary<bool>());
        StepFor(*world, *rc::gen::inRange(0, 40));
        const int edits = *rc::gen::inRange(0, 5);
        for (int i = 0; i < edits; ++i) {
            Body* body = world->GetBodyList();
            for (int skip = *rc::gen::inRange(0, 8); skip > 0 && body->GetNext() != nullptr; --skip)
                body = body->GetNext();
            switch (*rc::gen::inRange(0, 6)) {
                case 0:
                    body->SetTransform({static_cast<float>(*rc::gen::inRange(-5, 5)), 3.0f}, 0.3f);
                    break;
                case 1:
                    body->ApplyLinearImpulseToCenter({30.0f, 200.0f}, true);
                    break;
                case 2:
                    world->DestroyBody(body);
                    break;
                case 3:
                    AddBox(AddBody(*world, dynamicBody, {0.0f, 6.0f}), 0.3f, 0.3f);
                    break;
                case 4:
                    body->SetType(kinematicBody);
                    break;
                default:
                    body->SetAwake(false);
                    break;
            }
        }
        const auto copy = LoadWorld(SaveWorld(*world));
        RC_ASSERT(copy != nullptr);
        for (int i = 0; i < 60; ++i) {
            RC_ASSERT(inspect::GetStateHash(*world) == inspect::GetStateHash(*copy));
            StepFor(*world, 1);
            StepFor(*copy, 1);
        }
    }));
}

TEST(Snapshot, ASubSteppedStepGoesOnWhereItStopped) {
    WorldDef def;
    def.subStepping = true;
    World world(def);
    AddGround(world);
    for (int i = 0; i < 5; ++i) {
        Body* body = AddBody(world, dynamicBody, {2.0f * static_cast<float>(i), 20.0f + static_cast<float>(i)});
        AddBox(body, 0.5f, 0.5f);
        body->SetLinearVelocity({0.0f, -300.0f});
    }
    int resumed = 0;
    for (int i = 0; i < 80; ++i) {
        resumed += world.GetState().continuousScratch.resuming ? 1 : 0;
        const auto copy = Copy(world);
        ASSERT_NE(copy, nullptr);
        const StepReport ours = StepFor(world, 1);
        const StepReport theirs = StepFor(*copy, 1);
        ASSERT_EQ(ours.continuousEventCount, theirs.continuousEventCount);
        ASSERT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*copy)) << i;
    }
    EXPECT_GT(resumed, 0) << "the case was not met";
}

/// A crowd that is parted by a step which stops at an event, and is to go on.
TEST(Snapshot, ACrowdInASubSteppedStepGoesOnWhereItStopped) {
    std::mt19937 random(5);
    const auto draw = [&random](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    int unfinished = 0;
    for (int i = 0; i < 300 && !HasFailure(); ++i) {
        WorldDef def;
        def.subStepping = true;
        def.gravity = {0.0f, -10.0f};
        def.exactDrift = i % 2 == 0;
        World world(def);
        AddBox(AddBody(world, staticBody, {0.0f, -8.0f}), 60.0f, 0.5f);
        for (int k = 0; k < 24; ++k) {
            Body* body = AddBody(world, dynamicBody, {draw(-2.0f, 2.0f), draw(-2.0f, 2.0f)});
            AddBox(body, draw(0.2f, 0.6f), draw(0.2f, 0.6f));
            if (k % 6 != 0) continue;
            body->SetTransform({draw(-6.0f, 6.0f), draw(-7.0f, 4.0f)}, 0.0f);
            body->SetLinearVelocity({draw(-300.0f, 300.0f), draw(-300.0f, 0.0f)});
        }
        world.Step(frame, 4);
        if (world.GetState().continuousScratch.resuming) ++unfinished;
        const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(world));
        ASSERT_NE(loaded, nullptr);
        for (int step = 0; step < 3; ++step) {
            world.Step(frame, 4), loaded->Step(frame, 4);
            ASSERT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world)) << "crowd " << i;
        }
    }
    EXPECT_GT(unfinished, 50);
}

/// Boxes of the fat tree depend on those of the step before. Far from the origin what rests and cannot be hit makes
/// boxes cover the ways of others, if it is known to rest. That is to change none.
TEST(Snapshot, OfAFatTreeWithDisabledTargetsGoesOnBitForBit) {
    WorldDef def;
    def.broadPhase = BroadPhaseKind::fatTree;
    World world(def);
    for (int i = 0; i < 3; ++i) {
        Body* target = AddBody(world, kinematicBody, {static_cast<float>(i), 0.0f});
        AddBox(target, 0.3f, 0.3f);
        target->SetEnabled(false);
        target->SetAwake(false);
    }
    Body* body = AddBody(world, dynamicBody, {1e6f, 0.0f});
    AddBox(body, 0.5f, 0.5f);
    for (int step = 0; step < 10; ++step) {
        body->SetLinearVelocity({0.0f, step % 2 == 0 ? 20.0f : -20.0f});
        const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(world));
        ASSERT_NE(loaded, nullptr);
        StepWith(world, 4), StepWith(*loaded, 4);
        ASSERT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world)) << "step " << step;
    }
}

TEST(Snapshot, ACopyGivesTheSameBytes) {
    const auto world = MakeMixedWorld();
    StepFor(*world, 30);
    const Image image = SaveWorld(*world);
    EXPECT_EQ(image, SaveWorld(*LoadWorld(image)));
}

TEST(Snapshot, ObjectsKeepTheirIndicesIdsListsAndUserData) {
    const auto world = MakeMixedWorld();
    StepFor(*world, 10);
    const auto copy = Copy(*world);
    ASSERT_NE(copy, nullptr);
    Body* theirs = copy->GetBodyList();
    for (Body* ours = world->GetBodyList(); ours != nullptr; ours = ours->GetNext(), theirs = theirs->GetNext()) {
        ASSERT_NE(theirs, nullptr);
        EXPECT_EQ(ours->GetIndex(), theirs->GetIndex());
        EXPECT_EQ(world->GetId(ours), copy->GetId(theirs));
        EXPECT_EQ(ours->GetUserData().pointer, theirs->GetUserData().pointer);
        EXPECT_EQ(theirs->GetWorld(), copy.get());
        EXPECT_EQ(ours->GetJointCount(), theirs->GetJointCount());
        EXPECT_EQ(ours->GetContactCount(), theirs->GetContactCount());
    }
    EXPECT_EQ(theirs, nullptr);
    Joint* joint = copy->GetJointList();
    for (Joint* ours = world->GetJointList(); ours != nullptr; ours = ours->GetNext(), joint = joint->GetNext()) {
        ASSERT_NE(joint, nullptr);
        EXPECT_EQ(ours->GetIndex(), joint->GetIndex());
        EXPECT_EQ(ours->GetType(), joint->GetType());
    }
    EXPECT_EQ(world->GetContactCount(), copy->GetContactCount());
    // What is made next gets the same numbers in both.
    EXPECT_EQ(AddBody(*world, dynamicBody, {0.0f, 9.0f})->GetIndex(),
              AddBody(*copy, dynamicBody, {0.0f, 9.0f})->GetIndex());
}

TEST(Snapshot, IsRefusedWhileTheWorldIsLocked) {
    const auto world = MakeMixedWorld();
    ErrorLog errors(*world);
    StepFor(*world, 1);
    size_t bytes = 1;
    world->QueryAABB(AABB{{-10.0f, -10.0f}, {10.0f, 10.0f}}, [&](Fixture*) {
        bytes = SaveWorld(*world).size();
        return false;
    });
    EXPECT_EQ(bytes, 0u);
    EXPECT_EQ(errors.last.code, ErrorCode::locked);
}

TEST(Snapshot, AnImageCutAnywhereOrLengthenedGivesAnError) {
    const auto world = MakeMixedWorld();
    StepFor(*world, 20);
    Image image = SaveWorld(*world);
    for (size_t length = 0; length < image.size(); ++length) {
        SnapshotError error = SnapshotError::ok;
        ASSERT_EQ(LoadWorld(std::span(image).first(length), &error), nullptr) << length;
        ASSERT_EQ(error, length == 0 ? SnapshotError::notASnapshot : SnapshotError::wrongSize) << length;
    }
    image.push_back(std::byte{0});
    SnapshotError error = SnapshotError::ok;
    EXPECT_EQ(LoadWorld(image, &error), nullptr);
    EXPECT_EQ(error, SnapshotError::wrongSize);
}

TEST(Snapshot, AnyFlippedByteGivesAnError) {
    const auto world = MakeMixedWorld();
    StepFor(*world, 20);
    Image image = SaveWorld(*world);
    for (size_t i = 0; i < image.size(); ++i) {
        image[i] ^= static_cast<std::byte>(1u << (i % 8));
        SnapshotError error = SnapshotError::ok;
        ASSERT_EQ(LoadWorld(image, &error), nullptr) << i;
        const SnapshotError expected = i < 8    ? SnapshotError::notASnapshot
                                       : i < 12 ? SnapshotError::wrongVersion
                                       : i < 16 ? SnapshotError::notASnapshot
                                       : i < 24 ? SnapshotError::wrongSize
                                                : SnapshotError::wrongChecksum;
        ASSERT_EQ(error, expected) << i;
        image[i] ^= static_cast<std::byte>(1u << (i % 8));
    }
    EXPECT_NE(LoadWorld(image), nullptr);
}

TEST(Snapshot, AfterAShiftThatMakesBoxesTouchALoadedWorldGoesOnAlike) {
    // Far away numbers are coarse: bodies that lay apart overlap. Their contacts were found a step later than those of
    // bodies that the program had edited, in a world that was loaded before that step at once with them.
    std::mt19937 random(20);
    const auto uniform = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    for (int round = 0; round < 10; ++round) {
        World world({0.0f, -10.0f});
        for (int i = 0; i < 20; ++i) {
            AddBox(AddBody(world, dynamicBody, {uniform(-20.0f, 20.0f), uniform(-20.0f, 20.0f)}), 0.3f, 0.3f);
        }
        StepFor(world, 1);
        ASSERT_EQ(world.ShiftOrigin({uniform(1e8f, 1e9f), 0.0f}), ErrorCode::ok);
        AddBox(AddBody(world, dynamicBody, world.GetBodyList()->GetPosition()), 0.5f, 0.5f);
        const auto loaded = Copy(world);
        for (int i = 0; i < 2; ++i) world.Step(1.0f / 60.0f, 4), loaded->Step(1.0f / 60.0f, 4);
        EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world)) << round;
    }
}

/// Bodies on joints that slept, and are woken on the way by what hits them, do not remember how they began an earlier
/// step.
TEST(Snapshot, WhatAnEventWakesGoesOnAlike) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto between = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    for (int round = 0; round < 300; ++round) {
        World world({0.0f, -10.0f});
        Body* ground = AddGround(world);
        std::vector<Body*> chain;
        for (int i = 0; i < 4; ++i) {
            Body* body = AddBody(world, dynamicBody, {static_cast<float>(i), 6.0f});
            AddBox(body, 0.4f, 0.1f);
            RevoluteJointDef hinge;
            hinge.Initialize(i == 0 ? ground : chain.back(), body, {static_cast<float>(i) - 0.5f, 6.0f});
            world.CreateJoint(&hinge);
            chain.push_back(body);
        }
        for (int i = 0; i < 20; ++i) world.Step(frame, 4);
        if (round % 4 < 2) {
            for (Body* body : chain) body->SetAwake(false);
        }
        for (int i = 0; i < 6; ++i) {
            const Vec2 target = chain[random() % chain.size()]->GetPosition();
            const Vec2 away{between(-3.0f, 3.0f), between(2.0f, 4.0f)};
            Body* shot = AddBody(world, i % 2 == 0 ? dynamicBody : kinematicBody, target + away);
            AddCircle(shot, 0.1f, 2.0f);
            shot->SetBullet(true);
            shot->SetLinearVelocity(between(60.0f, 200.0f) * -1.0f * away);
        }
        for (int i = 0; i < 3; ++i) {
            const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(world));
            ASSERT_NE(loaded, nullptr);
            world.Step(frame, 4), loaded->Step(frame, 4);
            ASSERT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(world)) << "round " << round;
        }
    }
}

TEST(Snapshot, OfAMachineOfTheOtherByteOrderIsToldApart) {
    Image image = SaveWorld(*MakeMixedWorld());
    std::reverse(image.begin() + 8, image.begin() + 12);   // the version
    std::reverse(image.begin() + 12, image.begin() + 16);  // the mark of the order
    SnapshotError error = SnapshotError::ok;
    EXPECT_EQ(LoadWorld(image, &error), nullptr);
    EXPECT_EQ(error, SnapshotError::wrongByteOrder);
    EXPECT_STREQ(GetName(error), "wrong byte order");
}

/// Puts the right checksum on changed content, as a forger would.
void Sign(Image& image) {
    const uint64_t sum = ChecksumOf(std::span(image).subspan(32));
    std::memcpy(image.data() + 24, &sum, sizeof(sum));
}

TEST(Snapshot, AForgedImageGivesAnErrorOrAWorldThatCanBeUsed) {
    // Under the address and undefined-behaviour sanitizers this is the proof that no index is believed unchecked.
    const auto world = MakeMixedWorld();
    StepFor(*world, 20);
    const Image original = SaveWorld(*world);
    uint32_t random = 12345;
    const auto next = [&random] { return random = random * 1664525u + 1013904223u, random >> 8; };
    int refused = 0, accepted = 0;
    for (size_t round = 0; round < 4000; ++round) {
        Image image = original;
        // Every fourth byte in turn is set to something that an index or a count likes least.
        const size_t at = 32 + (next() % (image.size() - 36));
        const uint32_t values[] = {0xFFFFFFFFu, 0x7FFFFFFFu, 0u, 1u, next(), next() % 40u};
        const uint32_t value = values[round % 6];
        std::memcpy(image.data() + at, &value, round % 3 == 0 ? 1 : 4);
        Sign(image);
        SnapshotError error = SnapshotError::ok;
        const auto forged = LoadWorld(image, &error);
        EXPECT_EQ(forged == nullptr, error != SnapshotError::ok);
        if (forged == nullptr) {
            ++refused;
            continue;
        }
        ++accepted;
        ErrorLog errors(*forged);
        StepFor(*forged, 2);
        while (Body* body = forged->GetBodyList()) forged->DestroyBody(body);
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(accepted, 0);
}

/// The image with every place where a number stands set to another one.
Image WithNumber(Image image, float from, float to) {
    for (size_t at = 32; at + sizeof from <= image.size(); ++at) {
        if (std::memcmp(image.data() + at, &from, sizeof from) == 0) std::memcpy(image.data() + at, &to, sizeof to);
    }
    Sign(image);
    return image;
}

/// A world of one capsule, or of one circle.
Image ImageOfRound(bool isCapsule, float radius) {
    World world(Vec2{0.0f, -10.0f});
    Body* body = AddBody(world, dynamicBody, {1.0f, 2.0f});
    const ConvexShape capsule = MakeCapsule({-0.3f, 0.0f}, {0.3f, 0.0f}, radius);
    isCapsule ? body->CreateFixture(&capsule, 0.0f) : AddCircle(body, radius, 0.0f);
    return SaveWorld(world);
}

TEST(Snapshot, AShapeThatNoFixtureTakesIsRefused) {
    EXPECT_TRUE(rc::check("an image whose radius is damaged", [] {
        const bool isCapsule = *rc::gen::arbitrary<bool>();
        const float radius = static_cast<float>(*rc::gen::inRange(101, 999)) / 1009.0f;
        const Image sound = ImageOfRound(isCapsule, radius);
        RC_ASSERT(LoadWorld(WithNumber(sound, radius, radius * 1.5f)) != nullptr);
        const float bad =
            *rc::gen::element(-radius, -2e34f, 2e34f, std::nanf(""), std::numeric_limits<float>::infinity());
        SnapshotError error = SnapshotError::ok;
        RC_ASSERT(LoadWorld(WithNumber(sound, radius, bad), &error) == nullptr);
        RC_ASSERT(error == SnapshotError::badContent);
    }));
}

TEST(Snapshot, AMassThatNoBodyHasIsRefused) {
    EXPECT_TRUE(rc::check("an image whose centre of mass, mass or damping is damaged", [] {
        World world(Vec2{0.0f, -10.0f});
        Body* body = AddBody(world, dynamicBody, {1.0f, 2.0f});
        AddBox(body, 0.5f, 0.5f, 1.0f);
        BodyTable& bodies = world.GetState().bodies;
        const BodyIndex row{body->GetIndex()};
        const auto others = *rc::gen::arbitrary<bool>();
        float* const fields[] = {&bodies.mass[row].localCenter.x,   &bodies.mass[row].localCenter.y,
                                 &bodies.mass[row].invMass,         &bodies.mass[row].invI,
                                 &bodies.motion[row].mass,          &bodies.info[row].inertia,
                                 &bodies.motion[row].linearDamping, &bodies.motion[row].angularDamping,
                                 &bodies.motion[row].gravityScale};
        float& field = *fields[*rc::gen::inRange<size_t>(0, others ? 2 : std::size(fields))];
        SnapshotError error = SnapshotError::ok;
        const auto isTaken = [&] { return LoadWorld(SaveWorld(world), &error) != nullptr; };
        RC_ASSERT(isTaken());
        field = -std::numeric_limits<float>::infinity();
        RC_ASSERT(!isTaken());
        RC_ASSERT(error == SnapshotError::badContent);
    }));
}

TEST(Snapshot, EveryShapeOfAFixtureCanBeSaved) {
    for (int type = 0; type < Shape::e_typeCount; ++type) {
        EXPECT_TRUE(WithShapeType(static_cast<Shape::Type>(type), [](auto) {})) << type;
    }
}

TEST(Snapshot, AFieldAddedToTheStateIsAddedToTheImage) {
    // A size that changed means a new field: list it in state_fields.h, raise snapshotVersion, then correct the number.
    // Workers, tasks and features are the host's and stay out.
    EXPECT_EQ(sizeof(WorldDef) - sizeof(TaskCallbacks), 72u);
    EXPECT_EQ(sizeof(BodyInfo), 32u);
    EXPECT_EQ(sizeof(BodyDemand), 20u);
    EXPECT_EQ(sizeof(FixtureInfo), 32u);
    EXPECT_EQ(sizeof(ContactPair), 16u);
    EXPECT_EQ(sizeof(Manifold), 60u);
    EXPECT_EQ(sizeof(JointInfo), 64u);
}

}  // namespace
}  // namespace scree::test
