// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world goes back to an image of itself: same state and same future, handles stay, bad images change nothing.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "scree/recording.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"
#include "tests/world/life.h"

namespace scree::test {
namespace {

/// A game that is played from a seed and a frame number: what it does in a frame depends on nothing else.
class Game {
public:
    explicit Game(int substeps) : m_substeps(substeps) {
        AddGround(world);
        for (int i = 0; i < 30; ++i) {
            bodies.push_back(AddBody(world, dynamicBody, {1.1f * static_cast<float>(i % 6), 0.6f + 1.1f * (i / 6)}));
            i % 2 == 0 ? AddBox(bodies.back(), 0.5f, 0.5f) : AddCircle(bodies.back(), 0.5f);
        }
        RevoluteJointDef hinge;
        hinge.Initialize(bodies[0], bodies[1], {0.5f, 0.6f});
        joint = world.CreateJoint(&hinge);
    }
    void Play(int from, int to) {
        for (int number = from; number < to; ++number) {
            std::mt19937 random(static_cast<uint32_t>(number));
            if (number % 9 == 5) AddCircle(AddBody(world, dynamicBody, {3.0f, 9.0f}), 0.4f);
            if (number % 13 == 7) {
                Body* last = world.GetBodyList();
                if (last->GetType() == dynamicBody && last->GetJointCount() == 0) world.DestroyBody(last);
            }
            if (Body* any = world.GetBodyList(); any != nullptr && any->GetType() == dynamicBody) {
                any->ApplyLinearImpulseToCenter({static_cast<float>(random() % 5) - 2.0f, 1.0f}, true);
            }
            StepWith(world, m_substeps);
        }
    }
    World world{Vec2{0.0f, -10.0f}};
    std::vector<Body*> bodies;
    Joint* joint;

private:
    int m_substeps;
};

TEST(Restore, AWorldGoesOnFromAnImageAsItDidBefore) {
    for (const int substeps : solvers) {
        for (const int workers : {1, 3}) {
            Game game(substeps);
            game.world.SetWorkers(workers);
            game.world.GetState().pool->ShareAlways();
            game.Play(0, 40);
            const std::vector<std::byte> image = SaveWorld(game.world);
            const uint64_t saved = inspect::GetStateHash(game.world);
            game.Play(40, 90);
            const uint64_t after = inspect::GetStateHash(game.world);
            for (int round = 0; round < 3; ++round) {
                ASSERT_EQ(RestoreWorld(game.world, image), SnapshotError::ok);
                EXPECT_EQ(inspect::GetStateHash(game.world), saved);
                EXPECT_EQ(SaveWorld(game.world), image);
                EXPECT_EQ(game.world.GetWorkerCount(), workers);
                game.Play(40, 90);
                ASSERT_EQ(inspect::GetStateHash(game.world), after) << substeps << ' ' << workers << ' ' << round;
            }
        }
    }
}

/// What is left of the overlap in which bodies were made is part of an image, and of the hash.
TEST(Restore, BodiesPartFromAnImageAsTheyDidBefore) {
    for (const int workers : {1, 2, 3, 8}) {
        World world(Vec2{0.0f, -10.0f});
        world.SetWorkers(workers);
        std::mt19937 random(31);
        PolygonShape shape;
        shape.SetAsBox(0.5f, 0.4f);
        for (int i = 0; i < 400; ++i) {
            BodyDef def;
            def.type = dynamicBody;
            def.position = {0.8f * static_cast<float>(i % 20) + 0.001f * static_cast<float>(random() % 100),
                            0.7f * static_cast<float>(i / 20)};
            world.CreateBody(&def)->CreateFixture(&shape, 1.0f);
        }
        const auto step = [&] { world.Step(1.0f / 60.0f, 4); };
        step(), step();
        const std::vector<std::byte> image = SaveWorld(world);
        const uint64_t saved = inspect::GetStateHash(world);
        for (int i = 0; i < 20; ++i) step();
        const uint64_t after = inspect::GetStateHash(world);
        ASSERT_EQ(RestoreWorld(world, image), SnapshotError::ok);
        EXPECT_EQ(inspect::GetStateHash(world), saved);
        for (int i = 0; i < 20; ++i) step();
        EXPECT_EQ(inspect::GetStateHash(world), after) << workers;
        static uint64_t ofOneWorker = 0;
        if (workers == 1) ofOneWorker = after;
        EXPECT_EQ(after, ofOneWorker) << workers;
    }
}

/// An image holds all that a step reads: what a world keeps beside it changes nothing.
TEST(Restore, RandomWorldsThatAreRestoredBeforeEachStepLiveOnAlike) {
    for (uint32_t seed = 0; seed < 400; ++seed) {
        Life one(seed, FeatureMode::automatic, Features::All()), other(seed, FeatureMode::automatic, Features::All());
        for (int step = 0; step < 30; ++step) {
            const Life::Program program = other.GetProgram();
            ASSERT_EQ(RestoreWorld(other.GetWorld(), SaveWorld(other.GetWorld())), SnapshotError::ok);
            other.Return(program);
            ASSERT_EQ(other.Step(), one.Step()) << "world " << seed << ", step " << step;
        }
    }
}

/// Steps that end after an event and go on in the next one, from whatever came before.
TEST(Restore, SubSteppedWorldsGoOnFromAnImage) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        World world({0.0f, -10.0f});
        world.SetSubStepping(true);
        AddGround(world);
        for (int i = 0; i < 30; ++i) {
            Body* body = AddBody(world, dynamicBody, {0.1f * static_cast<float>(random() % 100), 0.5f + 1.1f * i / 6});
            i % 3 == 0 ? AddCircle(body, 0.5f) : AddBox(body, 0.5f, 0.5f);
        }
        for (int i = 0; i < 3; ++i) {
            Body* bullet = AddBody(world, dynamicBody, {-5.0f, 0.5f + static_cast<float>(random() % 5)});
            AddCircle(bullet, 0.1f, 30.0f);
            bullet->SetBullet(true);
            bullet->SetLinearVelocity({static_cast<float>(random() % 400), 3.0f});
        }
        World other({0.0f, 0.0f});
        for (int step = 0; step < 60; ++step) {
            ASSERT_EQ(RestoreWorld(other, SaveWorld(world)), SnapshotError::ok);
            StepFor(world, 1), StepFor(other, 1);
            ASSERT_EQ(inspect::GetStateHash(other), inspect::GetStateHash(world)) << seed << ' ' << step;
        }
    }
}

struct Counter : ContactListener {
    void BeginContact(Contact*) override { ++begun; }
    int begun = 0;
};

TEST(Restore, HandlesAndListenersStay) {
    Game game(4);
    Counter counter;
    game.world.SetContactListener(&counter);
    game.Play(0, 30);
    World& world = game.world;
    const BodyId id = world.GetId(game.bodies[4]);
    Fixture* fixture = game.bodies[4]->GetFixtureList();
    const Vec2 place = game.bodies[4]->GetPosition();
    const std::vector<std::byte> image = SaveWorld(world);
    Contact* contact = world.GetContactList();
    const ContactId contactId = world.GetId(contact);

    world.DestroyBody(game.bodies[4]);
    world.DestroyJoint(game.joint);
    Body* later = AddBody(world, dynamicBody, {50.0f, 0.0f});
    Body* latest = AddBody(world, dynamicBody, {60.0f, 0.0f});
    const BodyId laterId = world.GetId(latest);
    EXPECT_EQ(later, game.bodies[4]) << "the number was free";
    ASSERT_EQ(RestoreWorld(world, image), SnapshotError::ok);

    EXPECT_EQ(world.Find(id), game.bodies[4]);
    EXPECT_TRUE(game.bodies[4]->GetPosition() == place);
    EXPECT_EQ(game.bodies[4]->GetFixtureList(), fixture);
    EXPECT_EQ(fixture->GetBody(), game.bodies[4]);
    EXPECT_EQ(game.joint->GetBodyB(), game.bodies[1]);
    EXPECT_EQ(world.GetJointList(), game.joint);
    EXPECT_EQ(world.Find(laterId), nullptr);
    EXPECT_EQ(world.Find(contactId), nullptr);
    EXPECT_NE(world.GetContactList(), nullptr);
    EXPECT_EQ(world.Find(world.GetId(world.GetContactList())), world.GetContactList());
    ErrorLog errors(world);
    EXPECT_TRUE(latest->GetPosition() == vec2Zero);
    EXPECT_EQ(errors.count, 1);
    counter.begun = 0;
    game.Play(30, 60);
    EXPECT_GT(counter.begun, 0);
    ASSERT_EQ(RestoreWorld(world, image), SnapshotError::ok);
    EXPECT_EQ(game.joint->GetBodyA(), game.bodies[0]);
}

TEST(Restore, TakesImagesOfOtherWorlds) {
    Game small(4);
    small.Play(0, 20);
    World world({1.0f, 2.0f});
    WorldDef def;
    def.broadPhase = BroadPhaseKind::fatTree;
    World other(def);
    AddBox(AddBody(other, dynamicBody, {0.0f, 0.0f}), 1.0f, 1.0f);
    for (World* each : {&world, &other}) {
        ASSERT_EQ(RestoreWorld(*each, SaveWorld(small.world)), SnapshotError::ok);
        EXPECT_EQ(inspect::GetStateHash(*each), inspect::GetStateHash(small.world));
        each->Step(frame, 4);
    }
    small.world.Step(frame, 4);
    EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(small.world));
    EXPECT_EQ(inspect::GetStateHash(other), inspect::GetStateHash(small.world));
}

TEST(Restore, ABadImageAndABadMomentChangeNothing) {
    Game game(4);
    game.Play(0, 25);
    const std::vector<std::byte> image = SaveWorld(game.world);
    game.Play(25, 30);
    const uint64_t before = inspect::GetStateHash(game.world);
    std::vector<std::byte> bad = image;
    bad[bad.size() / 2] ^= std::byte{8};
    EXPECT_EQ(RestoreWorld(game.world, bad), SnapshotError::wrongChecksum);
    EXPECT_EQ(RestoreWorld(game.world, {}), SnapshotError::notASnapshot);
    ErrorLog errors(game.world);
    game.world.QueryAABB({{-90.0f, -9.0f}, {90.0f, 90.0f}}, [&](Fixture*) {
        EXPECT_EQ(RestoreWorld(game.world, image), SnapshotError::refused);
        return false;
    });
    Recorder recorder;
    StartRecording(game.world, recorder);
    EXPECT_EQ(RestoreWorld(game.world, image), SnapshotError::refused);
    StopRecording(game.world);
    World fixed([] {
        WorldDef def;
        def.featureMode = FeatureMode::fixed;
        def.features = {Feature::friction};
        return def;
    }());
    ErrorLog fixedErrors(fixed);
    EXPECT_EQ(RestoreWorld(fixed, image), SnapshotError::refused);
    EXPECT_EQ(fixedErrors.last.code, ErrorCode::missingFeature);
    EXPECT_EQ(errors.count, 2);
    EXPECT_EQ(fixed.GetBodyCount(), 0);
    EXPECT_EQ(inspect::GetStateHash(game.world), before);
}

}  // namespace
}  // namespace scree::test
