// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world that goes back to a moment goes on as it did from there, whatever happened in between; a moment holds what
// moves.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/world/allocation_counter.h"
#include "tests/world/fixtures.h"
#include "tests/world/life.h"

namespace scree::test {
namespace {

/// Steps in turn, goes astray at random, and comes back.
void ExpectReturns(uint32_t seed) {
    constexpr int steps = 30;
    Life straight(seed, FeatureMode::automatic, Features::All());
    Life other(seed, FeatureMode::automatic, Features::All());
    Rollback moments(other.GetWorld(), 4);
    std::mt19937 random(seed);
    for (int step = 0; step < steps; ++step) {
        if (random() % 3 == 0) {
            const uint64_t before = inspect::GetStateHash(other.GetWorld());
            const std::vector<std::byte> image = SaveWorld(other.GetWorld());
            const int64_t moment = moments.Save();
            const Life::Program program = other.GetProgram();
            for (uint32_t rounds = 1 + random() % 2; rounds > 0; --rounds) {
                other.Stray(random());
                for (uint32_t astray = random() % 5; astray > 0; --astray) {
                    other.Step();
                    if (random() % 4 == 0) moments.Save();
                }
                if (!moments.Has(moment)) break;
                ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
                other.Return(program);
                ASSERT_EQ(inspect::GetStateHash(other.GetWorld()), before) << "world " << seed << ", step " << step;
                ASSERT_EQ(SaveWorld(other.GetWorld()), image) << "world " << seed << ", step " << step;
            }
            if (!moments.Has(moment)) {  // forgotten: the image is the other way back
                ASSERT_EQ(RestoreWorld(other.GetWorld(), image), SnapshotError::ok);
                other.Return(program);
            }
        }
        ASSERT_EQ(other.Step(), straight.Step()) << "world " << seed << ", after step " << step;
        other.ExpectCountsHold();
    }
}

TEST(Rollback, RandomWorldsGoOnAsTheyDidFromThere) {
    for (uint32_t seed = 0; seed < 400 && !testing::Test::HasFailure(); ++seed) ExpectReturns(seed);
}

void AddHeap(World& world, int count) {
    AddGround(world);
    for (int i = 0; i < count; ++i) {
        Body* body = AddBody(world, dynamicBody, {1.05f * static_cast<float>(i % 20), 0.6f + 1.05f * (i / 20)});
        i % 3 == 0 ? AddCircle(body, 0.5f) : AddBox(body, 0.5f, 0.5f);
    }
}

/// Hashes of the steps from now on.
std::vector<uint64_t> Play(World& world, int substeps, int steps) {
    std::vector<uint64_t> hashes;
    for (int i = 0; i < steps; ++i) {
        StepWith(world, substeps);
        hashes.push_back(inspect::GetStateHash(world));
    }
    return hashes;
}

TEST(Rollback, LargeHeapsReturnWithAnyNumberOfWorkers) {
    for (const int substeps : solvers) {
        std::vector<uint64_t> ofOne;
        for (const int workers : {1, 3}) {
            World world({0.0f, -10.0f});
            world.SetWorkers(workers);
            AddHeap(world, 600);
            Rollback moments(world);
            for (int i = 0; i < 12; ++i) {
                const int64_t moment = moments.Save();
                const std::vector<uint64_t> once = Play(world, substeps, 7);
                ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
                ASSERT_EQ(Play(world, substeps, 7), once) << substeps << ' ' << workers << ' ' << i;
                if (workers == 1) ofOne.insert(ofOne.end(), once.begin(), once.end());
                EXPECT_EQ(once.back(), ofOne[static_cast<size_t>(7 * i + 6)]);
            }
        }
    }
}

TEST(Rollback, SleepersReturnToSleepAndOthersToMotion) {
    for (const int substeps : solvers) {
        World world({0.0f, -10.0f});
        AddGround(world);
        std::vector<Body*> boxes;
        for (int i = 0; i < 40; ++i) {
            boxes.push_back(AddBody(world, dynamicBody, {2.0f * static_cast<float>(i % 20), 0.5f + (i / 20)}));
            AddBox(boxes.back(), 0.5f, 0.5f);
        }
        Rollback moments(world);
        const int64_t awake = moments.Save();
        const std::vector<uint64_t> first = Play(world, substeps, 30);
        StepWith(world, substeps, 300);
        ASSERT_EQ(world.GetReport().awakeBodyCount, 0);
        const int64_t asleep = moments.Save();
        boxes[3]->ApplyLinearImpulseToCenter({40.0f, 2.0f}, true);
        const std::vector<uint64_t> pushed = Play(world, substeps, 40);
        ASSERT_EQ(moments.Restore(asleep), SnapshotError::ok);
        EXPECT_FALSE(boxes[3]->IsAwake());
        EXPECT_EQ(StepWith(world, substeps, 3).awakeBodyCount, 0);
        ASSERT_EQ(moments.Restore(asleep), SnapshotError::ok);
        boxes[3]->ApplyLinearImpulseToCenter({40.0f, 2.0f}, true);
        EXPECT_EQ(Play(world, substeps, 40), pushed);
        ASSERT_EQ(moments.Restore(awake), SnapshotError::ok);
        EXPECT_EQ(Play(world, substeps, 30), first);
    }
}

/// Continuous collision remembers what is near a body; a wall that goes back is there again.
TEST(Rollback, WallsThatMovedStopBulletsAgain) {
    for (const int substeps : solvers) {
        World world({0.0f, 0.0f});
        Body* wall = AddBody(world, staticBody, {10.0f, 0.0f});
        AddBox(wall, 0.05f, 5.0f);
        Body* ball = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddCircle(ball, 0.2f);
        ball->SetLinearVelocity({90.0f, 0.0f});
        StepWith(world, substeps);
        Rollback moments(world);
        const int64_t moment = moments.Save();
        const std::vector<uint64_t> stopped = Play(world, substeps, 20);
        EXPECT_LT(ball->GetPosition().x, 10.0f);
        for (int i = 0; i < 2; ++i) {
            ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
            wall->SetTransform({50.0f, 0.0f}, 0.0f);
            StepWith(world, substeps, 20);
            EXPECT_GT(ball->GetPosition().x, 10.0f);
            ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
            EXPECT_EQ(Play(world, substeps, 20), stopped);
        }
    }
}

TEST(Rollback, StepsThatAreNotOverGoOn) {
    World world({0.0f, -10.0f});
    world.SetSubStepping(true);
    AddHeap(world, 60);
    Body* bullet = AddBody(world, dynamicBody, {-8.0f, 1.0f});
    AddCircle(bullet, 0.1f, 30.0f);
    bullet->SetBullet(true);
    bullet->SetLinearVelocity({400.0f, 3.0f});
    Rollback moments(world);
    int resumed = 0;
    for (int i = 0; i < 40; ++i) {
        resumed += world.GetState().continuousScratch.resuming ? 1 : 0;
        const int64_t moment = moments.Save();
        const std::vector<uint64_t> once = Play(world, 0, 3);
        ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
        ASSERT_EQ(Play(world, 0, 3), once) << i;
        ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
        StepWith(world, 0);
    }
    EXPECT_GT(resumed, 2);
}

TEST(Rollback, FarWorldsAndWorldsThatBecomeFarReturn) {
    World world({0.0f, -10.0f});
    AddHeap(world, 40);
    Rollback moments(world);
    const int64_t near = moments.Save();
    const std::vector<uint64_t> once = Play(world, 4, 5);
    Body* far = world.GetBodyList();
    far->SetTransform({3.0e6f, 7.0f}, 0.3f);
    const int64_t farther = moments.Save();
    const std::vector<uint64_t> away = Play(world, 4, 5);
    ASSERT_EQ(moments.Restore(near), SnapshotError::ok);
    EXPECT_EQ(Play(world, 4, 5), once);
    ASSERT_EQ(moments.Restore(farther), SnapshotError::ok);
    EXPECT_EQ(Play(world, 4, 5), away);
}

/// A shape that a program holds may change without a call.
TEST(Rollback, ShapesThatAProgramHoldsReturn) {
    World world({0.0f, -10.0f});
    AddHeap(world, 40);
    Rollback moments(world);
    Fixture* fixture = world.GetBodyList()->GetFixtureList();
    fixture->GetShape()->m_radius = 0.02f;
    const int64_t moment = moments.Save();
    const std::vector<uint64_t> once = Play(world, 4, 10);
    fixture->GetShape()->m_radius = 0.1f;
    EXPECT_NE(Play(world, 4, 10), once);
    ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
    EXPECT_EQ(static_cast<const Fixture*>(fixture)->GetShape()->m_radius, 0.02f);
    EXPECT_EQ(Play(world, 4, 10), once);
}

TEST(Rollback, HandlesStayAndWhatWasDestroyedIsBack) {
    World world({0.0f, -10.0f});
    AddHeap(world, 40);
    Body* body = world.GetBodyList();
    const BodyId id = world.GetId(body);
    Rollback moments(world);
    const int64_t moment = moments.Save();
    const Vec2 place = body->GetPosition();
    world.DestroyBody(body);
    Body* later = AddBody(world, dynamicBody, {90.0f, 0.0f});
    Body* latest = AddBody(world, dynamicBody, {95.0f, 0.0f});
    EXPECT_EQ(later, body) << "the number was free";
    const BodyId latestId = world.GetId(latest);
    ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
    EXPECT_EQ(world.Find(id), body);
    EXPECT_TRUE(body->GetPosition() == place);
    EXPECT_EQ(world.Find(latestId), nullptr);
    EXPECT_EQ(moments.Restore(moment), SnapshotError::ok) << "a moment may be restored again";
}

/// User data belongs to the definitions: it is that of the moment.
/// Bodies sleep, and the coming step is to find the pairs of what was edited among them.
TEST(Rollback, EditsOfSleepersAreStillToBeLookedAt) {
    for (const BodyType typeOfOther : {staticBody, kinematicBody, dynamicBody}) {
        World world({0.0f, -10.0f});
        std::vector<Body*> bodies;
        for (int i = 0; i < 6; ++i) {
            BodyDef def;
            def.type = i % 2 == 0 ? dynamicBody : typeOfOther;
            def.awake = false;
            def.position = {0.5f * static_cast<float>(i), 0.0f};
            bodies.push_back(world.CreateBody(&def));
        }
        world.Step(1.0f / 60.0f, 4);  // their rows rest now
        for (Body* body : bodies) AddBox(body, 0.5f, 0.5f);
        Rollback moments(world);
        const int64_t moment = moments.Save();
        const std::vector<std::byte> image = SaveWorld(world);
        world.Step(1.0f / 60.0f, 4);
        const int contacts = world.GetContactCount();
        const uint64_t hash = inspect::GetStateHash(world);
        EXPECT_GE(contacts, 5);
        for (int round = 0; round < 2; ++round) {
            ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
            world.Step(1.0f / 60.0f, 4);
            EXPECT_EQ(world.GetContactCount(), contacts) << "from the moment, type " << int{typeOfOther};
            EXPECT_EQ(inspect::GetStateHash(world), hash) << "from the moment, type " << int{typeOfOther};
            ASSERT_EQ(RestoreWorld(world, image), SnapshotError::ok);
            world.Step(1.0f / 60.0f, 4);
            EXPECT_EQ(inspect::GetStateHash(world), hash) << "from the image, type " << int{typeOfOther};
        }
    }
}

/// The coming step is to ask another filter about what sleeps.
TEST(Rollback, AnotherFilterIsStillToBeAsked) {
    class RefuseAll final : public ContactFilter {
        bool ShouldCollide(Fixture*, Fixture*) override { return false; }
    } refuseAll;
    World world({0.0f, -10.0f});
    world.SetContactFilter(&refuseAll);
    for (int i = 0; i < 6; ++i) {
        BodyDef def;
        def.type = dynamicBody;
        def.awake = false;
        def.position = {0.5f * static_cast<float>(i), 0.0f};
        AddBox(world.CreateBody(&def), 0.5f, 0.5f);
    }
    world.Step(1.0f / 60.0f, 4);
    ASSERT_EQ(world.GetContactCount(), 0);
    world.SetContactFilter(nullptr);
    Rollback moments(world);
    const int64_t moment = moments.Save();
    world.Step(1.0f / 60.0f, 4);
    EXPECT_EQ(world.GetContactCount(), 9);
    const uint64_t hash = inspect::GetStateHash(world);
    ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
    world.Step(1.0f / 60.0f, 4);
    EXPECT_EQ(inspect::GetStateHash(world), hash);
}

TEST(Rollback, UserDataReturns) {
    World world({0.0f, -10.0f});
    AddHeap(world, 3);
    Body* body = world.GetBodyList();
    Rollback moments(world);
    body->SetUserData({7});
    const int64_t moment = moments.Save();
    body->SetUserData({8});
    body->GetFixtureList()->SetUserData({9});
    ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
    EXPECT_EQ(body->GetUserData().pointer, 7u);
    EXPECT_EQ(body->GetFixtureList()->GetUserData().pointer, 0u);
}

TEST(Rollback, JointsThatBrokeAreWholeAgain) {
    World world({0.0f, -10.0f});
    Body* ground = AddGround(world);
    Body* weight = AddBody(world, dynamicBody, {0.0f, 8.0f});
    AddBox(weight, 0.5f, 0.5f);
    DistanceJointDef rope;
    rope.Initialize(ground, weight, {0.0f, 10.0f}, {0.0f, 8.0f});
    Joint* joint = world.CreateJoint(&rope);
    joint->SetThresholds(8.0f, 8.0f, true);
    Rollback moments(world);
    const int64_t moment = moments.Save();
    const std::vector<uint64_t> once = Play(world, 4, 20);
    ASSERT_EQ(world.GetJointCount(), 0);
    ASSERT_EQ(moments.Restore(moment), SnapshotError::ok);
    EXPECT_EQ(world.GetJointList(), joint);
    EXPECT_EQ(Play(world, 4, 20), once);
}

TEST(Rollback, OldMomentsAreForgottenAndBadOnesChangeNothing) {
    World world({0.0f, -10.0f});
    AddHeap(world, 20);
    ErrorLog errors(world);
    Rollback moments(world, 3);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(moments.Save(), i);
        StepFor(world, 1);
    }
    const uint64_t before = inspect::GetStateHash(world);
    for (const int64_t bad : {-1, 0, 1, 5, 99}) {
        EXPECT_FALSE(moments.Has(bad));
        EXPECT_EQ(moments.GetBytes(bad), 0u);
        EXPECT_EQ(moments.Restore(bad), SnapshotError::refused);
    }
    EXPECT_EQ(errors.count, 5);
    EXPECT_EQ(errors.last.code, ErrorCode::outOfRange);
    world.QueryAABB({{-90.0f, -9.0f}, {90.0f, 90.0f}}, [&](Fixture*) {
        EXPECT_EQ(moments.Save(), -1);
        EXPECT_EQ(moments.Restore(4), SnapshotError::refused);
        return false;
    });
    Recorder recorder;
    StartRecording(world, recorder);
    EXPECT_EQ(moments.Restore(4), SnapshotError::refused);
    StopRecording(world);
    EXPECT_EQ(errors.count, 8);
    EXPECT_EQ(inspect::GetStateHash(world), before);
    EXPECT_EQ(moments.Restore(2), SnapshotError::ok);
    EXPECT_TRUE(moments.Has(4));
}

/// What a world may not use any more does not come back by a moment.
TEST(Rollback, FeaturesThatWereTakenAwayDoNotComeBack) {
    World world({0.0f, -10.0f});
    Body* body = AddBody(world, dynamicBody, {0.0f, 5.0f});
    AddCircle(body, 0.5f);
    Rollback moments(world);
    moments.Save();
    body->SetAngularVelocity(3.0f);
    const int64_t turning = moments.Save();
    body->SetAngularVelocity(0.0f);
    body->SetFixedRotation(true);
    const Features all = world.GetAllowedFeatures();
    ASSERT_EQ(world.SetFeatures(FeatureMode::fixed, world.GetRequiredFeatures()), ErrorCode::ok);
    ErrorLog errors(world);
    const uint64_t before = inspect::GetStateHash(world);
    EXPECT_EQ(moments.Restore(turning), SnapshotError::refused);
    EXPECT_EQ(errors.last.code, ErrorCode::missingFeature);
    EXPECT_EQ(inspect::GetStateHash(world), before);
    ASSERT_EQ(world.SetFeatures(FeatureMode::fixed, all), ErrorCode::ok);
    EXPECT_EQ(moments.Restore(turning), SnapshotError::ok);
    EXPECT_EQ(body->GetAngularVelocity(), 3.0f);
}

double BytesPerBody(const Rollback& moments, int64_t moment, int bodies) {
    return static_cast<double>(moments.GetBytes(moment)) / bodies;
}

TEST(Rollback, AMomentHoldsAtMostEightyBytesOfABodyThatMoves) {
    constexpr int count = 1000;
    for (const int substeps : solvers) {
        World world({0.0f, -10.0f});
        for (int i = 0; i < count; ++i) {
            Body* body = AddBody(world, dynamicBody, {3.0f * static_cast<float>(i % 40), 3.0f * (i / 40)}, 0.1f * i);
            AddBox(body, 0.5f, 0.5f);
            body->SetAngularVelocity(0.01f * static_cast<float>(i));
            body->SetLinearVelocity({0.001f * static_cast<float>(i), 1.0f});
        }
        Rollback moments(world);
        moments.Save();
        StepWith(world, substeps, 40);
        EXPECT_LE(BytesPerBody(moments, moments.Save(), count), 80.0) << substeps;
        EXPECT_GE(BytesPerBody(moments, moments.Save(), count), 40.0) << substeps;  // they move
    }
}

TEST(Rollback, AMomentOfASleepingLevelHoldsLittle) {
    World world({0.0f, -10.0f});
    AddHeap(world, 400);
    StepWith(world, 4, 900);
    ASSERT_EQ(world.GetReport().awakeBodyCount, 0);
    Rollback moments(world);
    moments.Save();
    EXPECT_LT(moments.GetBytes(moments.Save()), 2000u);
}

/// What came to rest long after the base was made is not in every moment for ever.
TEST(Rollback, TheBaseIsMadeAnewWhenMostThatDiffersRests) {
    World world({0.0f, -10.0f});
    AddGround(world, 5000.0f);
    for (int i = 0; i < 2500; ++i)
        AddBox(AddBody(world, dynamicBody, {1.5f * static_cast<float>(i), 1.0f}), 0.5f, 0.5f);
    Rollback moments(world);
    moments.Save();
    StepWith(world, 4, 200);
    ASSERT_EQ(world.GetReport().awakeBodyCount, 0);
    EXPECT_GT(moments.GetBytes(moments.Save()), 65536u);
    for (int i = 0; i < 100; ++i) moments.Save();
    EXPECT_LT(moments.GetBytes(moments.Save()), 4000u);
}

TEST(Rollback, WarmMomentsAllocateNothing) {
    World world({0.0f, -10.0f});
    AddHeap(world, 200);
    Rollback moments(world, 4);
    StepWith(world, 4, 30);
    const auto round = [&] {
        const int64_t moment = moments.Save();
        StepWith(world, 4, 3);
        moments.Restore(moment);
    };
    for (int i = 0; i < 10; ++i) round();
    const long before = AllocationCount();
    for (int i = 0; i < 10; ++i) round();
    EXPECT_EQ(AllocationCount(), before);
}

/// Ends between steps belong to the moment: those after it are forgotten, those before it come.
TEST(Rollback, EndsBetweenStepsAreThoseOfTheMoment) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Fixture* reporting = AddBox(AddBody(world, dynamicBody, {0.0f, 0.5f}), 0.5f, 0.5f);
    reporting->SetReports(Report::contacts);
    Body* other = AddBody(world, dynamicBody, {0.0f, 1.5f});
    AddBox(other, 0.5f, 0.5f);
    StepFor(world, 30);
    Rollback moments(world, 4);
    const int64_t before = moments.Save();
    const std::vector<std::byte> image = SaveWorld(world);
    world.DestroyBody(other);
    const int64_t after = moments.Save();
    StepFor(world, 1);
    ASSERT_EQ(world.GetEvents().contactsEnded.size(), 1u);
    ASSERT_EQ(moments.Restore(after), SnapshotError::ok);
    EXPECT_TRUE(world.GetEvents().contactsEnded.empty()) << "of a step that is yet to come";
    StepFor(world, 1);
    EXPECT_EQ(world.GetEvents().contactsEnded.size(), 1u);
    ASSERT_EQ(moments.Restore(before), SnapshotError::ok);
    StepFor(world, 1);
    EXPECT_TRUE(world.GetEvents().contactsEnded.empty()) << "both are there and touch";
    world.DestroyBody(world.GetBodyList());
    ASSERT_EQ(RestoreWorld(world, image), SnapshotError::ok);
    StepFor(world, 1);
    EXPECT_TRUE(world.GetEvents().contactsEnded.empty()) << "both are there and touch";
}

}  // namespace
}  // namespace scree::test
