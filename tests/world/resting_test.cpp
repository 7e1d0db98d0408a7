// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What rests costs nothing, and changes nothing. A world whose sleepers are left aside goes on like one that looks at
// everything in every step, whatever is edited among the sleepers.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "base/index_set.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {
namespace {

using test::AddBody;
using test::AddBox;
using test::AddCircle;
using test::AddGround;

constexpr float dt = test::frame;

TEST(IndexSet, IsAnOrderedSet) {
    std::mt19937 random(7);
    for (const int range : {1, 63, 64, 65, 5000, 70000}) {
        IndexSet set;
        std::set<int> reference;
        for (int i = 0; i < 2000; ++i) {
            const int number = static_cast<int>(random() % static_cast<unsigned>(range));
            if (random() % 3 != 0) {
                EXPECT_EQ(set.Insert(number), reference.insert(number).second);
            } else {
                EXPECT_EQ(set.Erase(number), reference.erase(number) > 0);
            }
            const int end = static_cast<int>(random() % static_cast<unsigned>(2 * range));
            const auto next = reference.lower_bound(end);
            ASSERT_EQ(set.Before(end), next == reference.begin() ? -1 : *std::prev(next));
            ASSERT_EQ(set.Has(end), reference.count(end) > 0);
            ASSERT_EQ(set.Count(), static_cast<int>(reference.size()));
            const int begin = static_cast<int>(random() % static_cast<unsigned>(end + 1));
            std::vector<int> between;
            set.ForEachBetween(begin, end, [&](int found) { between.push_back(found); });
            ASSERT_EQ(between, std::vector<int>(reference.lower_bound(begin), next)) << begin << " to " << end;
        }
        std::vector<int> walked;
        set.ForEach([&](int number) { walked.push_back(number); });
        EXPECT_EQ(walked, std::vector<int>(reference.begin(), reference.end()));
        set.Clear();
        EXPECT_TRUE(set.IsEmpty() && set.Before(range) < 0);
    }
}

struct Still {
    explicit Still(int stacks, int high = 3, BroadPhaseKind kind = BroadPhaseKind::automatic) : world(Define(kind)) {
        ground = AddGround(world, 4.0f * static_cast<float>(stacks));
        for (int i = 0; i < stacks; ++i) {
            for (int k = 0; k < high; ++k) {
                Body* body = AddBody(world, dynamicBody, {2.0f * static_cast<float>(i), 0.5f + static_cast<float>(k)});
                AddBox(body, 0.5f, 0.5f);
            }
        }
    }
    static WorldDef Define(BroadPhaseKind kind) {
        WorldDef def;
        def.broadPhase = kind;
        return def;
    }
    bool Settle(int substeps) {
        for (int i = 0; i < 600; ++i) {
            if (Step(substeps).awakeBodyCount == 0) return true;
        }
        return false;
    }
    StepReport Step(int substeps) { return substeps > 0 ? world.Step(dt, substeps) : world.Step(dt, 8, 3); }

    World world;
    Body* ground;
};

TEST(Resting, SleepersAreNotLookedAt) {
    for (const int substeps : {0, 4}) {
        for (const int stacks : {20, 200}) {
            Still still(stacks);
            ASSERT_TRUE(still.Settle(substeps));
            const StepReport report = still.Step(substeps);
            EXPECT_EQ(report.touchingCount, 3 * stacks);
            EXPECT_EQ(report.contactCount, 3 * stacks);
            EXPECT_EQ(inspect::GetListedCount(still.world), 0);
            EXPECT_EQ(inspect::GetActiveContactCount(still.world), 0);
        }
    }
}

/// What a body that hits a sleeper finds: everything that it touches wakes and goes on.
TEST(Resting, ABlowWakesTheStackItHits) {
    for (const int substeps : {0, 4}) {
        Still still(50, 5);
        ASSERT_TRUE(still.Settle(substeps));
        Body* ball = AddBody(still.world, dynamicBody, {-3.0f, 2.5f});
        AddCircle(ball, 0.4f, 5.0f);
        ball->SetLinearVelocity({20.0f, 0.0f});
        int most = 0;
        for (int i = 0; i < 60; ++i) most = std::max(most, still.Step(substeps).awakeBodyCount);
        EXPECT_GE(most, 6);
        EXPECT_LE(most, 150);
        EXPECT_LE(inspect::GetListedCount(still.world), 150);
    }
}

/// Lists of what is awake are made by several threads where it is many, and part of the world rests.
TEST(Resting, ManyAwakeBesideSleepersAreListedTheSameByAnyNumberOfWorkers) {
    for (const int substeps : {0, 4}) {
        std::mt19937 random(std::random_device{}());
        const unsigned seed = random();
        SCOPED_TRACE("seed " + std::to_string(seed));
        const int stacks = 500 + static_cast<int>(seed % 100);
        Still alone(stacks), together(stacks);
        together.world.SetWorkers(3);
        together.world.GetState().pool->ShareAlways();
        ASSERT_TRUE(alone.Settle(substeps) && together.Settle(substeps));
        int busy = 0, restedBesideMany = 0;
        for (int round = 0; round < 2; ++round) {
            const unsigned pushes = random();
            for (Still* still : {&alone, &together}) {
                std::mt19937 push(pushes);
                for (Body* body = still->world.GetBodyList(); body != nullptr; body = body->GetNext()) {
                    const unsigned draw = push();
                    if (draw % 10 < 7) body->SetLinearVelocity({0.1f * static_cast<float>(draw / 16 % 8), 0.0f});
                }
            }
            for (int step = 0; step < 60; ++step) {
                const ContactTable& contacts = alone.world.GetState().contacts;
                const int activeBefore = contacts.active.Count(), restingBefore = contacts.RestingCount();
                alone.Step(substeps);
                together.Step(substeps);
                ASSERT_EQ(inspect::GetStateHash(together.world), inspect::GetStateHash(alone.world)) << "step " << step;
                const bool areMany = activeBefore > 1024;
                busy += areMany && restingBefore > 0 ? 1 : 0;
                restedBesideMany += areMany && contacts.RestingCount() > restingBefore ? 1 : 0;
            }
        }
        EXPECT_GT(busy, 10);
        EXPECT_GT(restedBesideMany, 0);
    }
}

/// Random edits of a small world in which most bodies sleep most of the time.
class Edits {
public:
    Edits(unsigned seed, BroadPhaseKind kind, int substeps)
        : m_random(seed), m_substeps(substeps), m_still(12, 3, kind) {
        for (int i = 0; i < 3; ++i) AddStatic();
        m_lift = AddBody(m_still.world, kinematicBody, {4.0f, 6.0f});
        AddBox(m_lift, 1.0f, 0.2f);
        m_lift->SetLinearVelocity({0.0f, -0.2f});
    }

    /// Some edits, the same for the same seed.
    void Prepare() {
        const unsigned edits = m_random() % 8 == 0 ? m_random() % 5 : m_random() % 3 == 0 ? 1 : 0;
        for (unsigned i = 0; i < edits; ++i) Edit();
    }
    /// Nothing rests any more, and no pairs are known.
    void LookAtEverything() {
        WorldState& s = m_still.world.GetState();
        for (const BodyIndex body : s.bodies.movers) s.bodies.List(body);
        for (const ContactIndex contact : s.contacts.Rows()) s.contacts.Rouse(contact);
        s.contacts.mustMatch = true;
        s.edited.AddAll();
    }
    /// What touches is asked for by a filter of the program, once for each pair that begins.
    void UseFilter() {
        m_filters = true;
        m_still.world.SetContactFilter(&m_filter);
    }
    [[nodiscard]] int GetFilterCalls() const { return m_filter.calls; }
    /// Kinematic bodies on their ways through the stacks.
    void AddLifts(int count) {
        for (int i = 0; i < count; ++i) {
            Body* lift = AddBody(m_still.world, kinematicBody, Place() + Vec2{0.0f, 4.0f});
            AddBox(lift, 0.3f, 0.1f);
            lift->SetLinearVelocity({Random(-0.1f, 0.1f), Random(-1.0f, 0.1f)});
        }
    }
    void StopLift() { Check(m_lift->SetLinearVelocity(vec2Zero)); }
    StepReport Step() { return m_still.Step(m_substeps); }
    StepReport Step(int substeps) { return m_still.Step(substeps); }
    World& GetWorld() { return m_still.world; }

    /// Contacts are those of a search that compares everything with everything; one that has just ended may wait for
    /// its EndContact.
    void ComparePairs() {
        World& world = m_still.world;
        std::set<std::pair<Fixture*, Fixture*>> contacts;
        for (Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            contacts.insert(std::minmax(c->GetFixtureA(), c->GetFixtureB()));
        }
        std::vector<Fixture*> fixtures;
        for (Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            if (!body->IsEnabled()) continue;
            for (Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) fixtures.push_back(f);
        }
        for (size_t i = 0; i < fixtures.size(); ++i) {
            for (size_t k = i + 1; k < fixtures.size(); ++k) {
                const std::pair<Fixture*, Fixture*> pair = std::minmax(fixtures[i], fixtures[k]);
                if (MayHave(*pair.first, *pair.second) && TestOverlap(pair.first->GetAABB(), pair.second->GetAABB())) {
                    ASSERT_TRUE(contacts.count(pair) > 0)
                        << "no contact of fixtures " << pair.first->GetIndex() << " and " << pair.second->GetIndex();
                    contacts.erase(pair);
                }
            }
        }
        for (const auto& [a, b] : contacts) {
            const ContactTable& table = world.GetState().contacts;
            const ContactIndex row = table.Find(IndexOf(*a), IndexOf(*b));
            ASSERT_FALSE(table.Has(row, ContactFlag::marked))
                << "a contact of fixtures " << a->GetIndex() << " and " << b->GetIndex();
        }
    }

private:
    float Random(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    Vec2 Place() { return {Random(-4.0f, 28.0f), Random(0.2f, 6.0f)}; }

    void AddStatic() {
        Body* body = AddBody(m_still.world, staticBody, Place());
        AddBox(body, 0.4f, 0.1f);
    }

    /// Refuses a tenth of all pairs, none of them with the ground, and counts what it is asked.
    struct PickyFilter : ContactFilter {
        int calls = 0;
        bool ShouldCollide(Fixture* a, Fixture* b) override {
            ++calls;
            return !Refuses(*a, *b) && ContactFilter::ShouldCollide(a, b);
        }
        static bool Refuses(Fixture& a, Fixture& b) {
            const bool isGround = a.GetIndex() == 0 || b.GetIndex() == 0;
            return !isGround && 7 * (a.GetIndex() + b.GetIndex()) % 10 == 3;
        }
    };

    Body* Any() {
        std::vector<Body*> bodies;
        for (Body* body = m_still.world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            if (body != m_still.ground) bodies.push_back(body);
        }
        return bodies[m_random() % bodies.size()];
    }

    void Edit() {
        Body* body = Any();
        switch (m_random() % 18) {
            case 0:
                return Check(body->SetTransform(Place(), Random(-1.0f, 1.0f)));
            case 1:
                return Check(body->SetTransform(body->GetPosition() + Vec2{Random(-0.1f, 0.1f), 0.0f}, 0.0f));
            case 2:
                return Check(body->SetAwake(true));
            case 3:
                return Check(body->SetAwake(false));
            case 4: {
                BodyDef def;
                def.type = static_cast<BodyType>(m_random() % 3);
                def.position = Place();
                def.awake = m_random() % 3 != 0;
                Body* fresh = m_still.world.CreateBody(&def);
                m_random() % 2 == 0 ? AddBox(fresh, 0.4f, 0.3f) : AddCircle(fresh, 0.4f);
                return;
            }
            case 5:
                if (m_still.world.GetBodyCount() < 20) return;
                return Check(m_still.world.DestroyBody(body));
            case 6:
                return Check(body->SetType(static_cast<BodyType>(m_random() % 3)));
            case 7:
                return Check(body->SetEnabled(!body->IsEnabled()));
            case 8:
                if (Fixture* fixture = body->GetFixtureList()) {
                    Filter filter = fixture->GetFilterData();
                    filter.groupIndex = static_cast<int16_t>(m_random() % 3) - 1;
                    Check(fixture->SetFilterData(filter));
                }
                return;
            case 9:
                AddCircle(body, Random(0.1f, 0.6f));
                return;
            case 10:
                if (Fixture* fixture = body->GetFixtureList()) Check(body->DestroyFixture(fixture));
                return;
            case 11:
                return Check(body->SetLinearVelocity({Random(-3.0f, 3.0f), Random(-3.0f, 3.0f)}));
            case 12: {
                Body* other = Any();
                if (other == body || m_still.world.GetJointCount() > 6) return;
                RevoluteJointDef def;
                def.Initialize(body, other, body->GetPosition());
                def.collideConnected = m_random() % 2 == 0;
                m_still.world.CreateJoint(&def);
                return;
            }
            case 13:
                if (Joint* joint = m_still.world.GetJointList()) Check(m_still.world.DestroyJoint(joint));
                return;
            case 14:
                if (Fixture* fixture = body->GetFixtureList()) Check(fixture->SetSensor(m_random() % 4 == 0));
                return;
            case 15:
                return Check(m_still.ground->SetTransform({0.0f, Random(-0.05f, 0.0f)}, 0.0f));
            case 16:
                if (m_random() % 4 == 0) Check(m_still.world.ShiftOrigin({Random(-0.1f, 0.1f), 0.0f}));
                return;
            default:
                body->ApplyLinearImpulse({Random(-1.0f, 1.0f), 1.0f}, body->GetWorldCenter(), true);
        }
    }
    static void Check(ErrorCode code) { EXPECT_EQ(code, ErrorCode::ok); }

    bool MayHave(Fixture& a, Fixture& b) {
        Body* bodyA = a.GetBody();
        Body* bodyB = b.GetBody();
        if (bodyA == bodyB || (bodyA->GetType() != dynamicBody && bodyB->GetType() != dynamicBody)) return false;
        const int group = a.GetFilterData().groupIndex;
        if (group != 0 && group == b.GetFilterData().groupIndex && group < 0) return false;
        if (m_filters && m_filter.Refuses(a, b)) return false;
        bool joined = false;
        bodyA->VisitJoints([&](Joint* joint) {
            const bool holdsB = joint->GetBodyA() == bodyB || joint->GetBodyB() == bodyB;
            joined = joined || (holdsB && !joint->GetCollideConnected());
            return true;
        });
        return !joined;
    }

    std::mt19937 m_random;
    int m_substeps;
    PickyFilter m_filter;
    bool m_filters = false;
    Still m_still;
    Body* m_lift;  ///< until an edit destroys it
};

/// Whether bodies rest changes no bit, and every pair is found.
TEST(Resting, AWorldAtRestGoesOnLikeOneThatLooksAtEverything) {
    int restingSteps = 0;
    unsigned seed = 1;
    for (const BroadPhaseKind kind : {BroadPhaseKind::automatic, BroadPhaseKind::fatTree, BroadPhaseKind::unified,
                                      BroadPhaseKind::sweepAndPrune, BroadPhaseKind::bvhSah}) {
        const int worlds = kind == BroadPhaseKind::automatic ? 15 : 3;
        for (int i = 0; i < worlds; ++i, ++seed) {
            const int substeps = i % 3 == 2 ? 4 : 0;
            Edits rests(seed, kind, substeps), looks(seed, kind, substeps);
            if (i >= 12) rests.UseFilter(), looks.UseFilter();
            for (int step = 0; step < 300; ++step) {
                rests.Prepare();
                looks.Prepare();
                looks.LookAtEverything();
                const StepReport own = rests.Step(), other = looks.Step();
                ASSERT_EQ(inspect::GetStateHash(rests.GetWorld()), inspect::GetStateHash(looks.GetWorld()))
                    << "seed " << seed << ", step " << step;
                ASSERT_EQ(own.touchingCount, other.touchingCount);
                ASSERT_EQ(own.contactCount, other.contactCount);
                ASSERT_EQ(own.awakeBodyCount, other.awakeBodyCount);
                ASSERT_EQ(rests.GetFilterCalls(), looks.GetFilterCalls()) << "seed " << seed << ", step " << step;
                ASSERT_NO_FATAL_FAILURE(rests.ComparePairs()) << "seed " << seed << ", step " << step;
                restingSteps += inspect::GetListedCount(rests.GetWorld()) * 2 < rests.GetWorld().GetBodyCount() ? 1 : 0;
            }
        }
    }
    EXPECT_GE(restingSteps, 500) << "the worlds hardly rest";
}

/// A step in which nothing is awake passes its stages over, whatever solver the last one had. Neither that nor what
/// kinematic bodies find among sleepers changes a bit.
TEST(Resting, AStepWithNothingAwakeGoesOnLikeOneThatLooksAtEverything) {
    int stillSteps = 0, liftedSteps = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const int lifts = seed % 3 == 0 ? 40 : seed % 3 == 1 ? 5 : 0;
        Edits rests(seed, BroadPhaseKind::automatic, 4), looks(seed, BroadPhaseKind::automatic, 4);
        rests.AddLifts(lifts), looks.AddLifts(lifts);
        if (lifts == 0) rests.StopLift(), looks.StopLift();
        std::mt19937 random(seed);
        int substeps = 4;
        for (int step = 0; step < 300; ++step) {
            const bool isCalm = lifts > 0 ? step < 100 : random() % 64 != 0 && step % 150 < 130;
            if (!isCalm) rests.Prepare(), looks.Prepare();
            looks.LookAtEverything();
            if (random() % 16 == 0) substeps = random() % 3 == 0 ? 0 : random() % 2 == 0 ? 4 : 7;
            if (random() % 32 == 0) (void)rests.GetWorld().Step(0.0f, 4), (void)looks.GetWorld().Step(0.0f, 4);
            looks.LookAtEverything();
            const StepReport own = rests.Step(substeps), other = looks.Step(substeps);
            ASSERT_EQ(inspect::GetStateHash(rests.GetWorld()), inspect::GetStateHash(looks.GetWorld()))
                << "seed " << seed << ", step " << step;
            ASSERT_EQ(own.touchingCount, other.touchingCount);
            ASSERT_EQ(own.contactCount, other.contactCount);
            ASSERT_EQ(own.awakeBodyCount, other.awakeBodyCount);
            ASSERT_EQ(own.continuousEventCount, other.continuousEventCount);
            ASSERT_EQ(own.substeps, other.substeps);
            ASSERT_NO_FATAL_FAILURE(rests.ComparePairs()) << "seed " << seed << ", step " << step;
            stillSteps += own.awakeBodyCount == 0 && inspect::GetListedCount(rests.GetWorld()) == 0 ? 1 : 0;
            liftedSteps += own.awakeBodyCount == lifts + 1 ? 1 : 0;
        }
    }
    EXPECT_GE(stillSteps, 50) << "the worlds hardly rest";
    EXPECT_GE(liftedSteps, 50) << "lifts hardly move alone";
}

/// An edit of a sleeper lets nobody wake or be looked at.
TEST(Resting, ASleeperThatIsMovedStaysAsleep) {
    for (const int movers : {1, 30}) {
        Still still(40);
        std::vector<Body*> moved;
        for (int i = 0; i < movers; ++i) {
            moved.push_back(AddBody(still.world, kinematicBody, {2.0f * static_cast<float>(i), 20.0f}));
            AddBox(moved.back(), 0.5f, 0.1f);
        }
        ASSERT_TRUE(still.Settle(4));
        for (int step = 0; step < 40; ++step) {
            for (Body* body : moved) {
                EXPECT_EQ(body->SetTransform(body->GetPosition() + Vec2{0.1f, 0.0f}, 0.0f), ErrorCode::ok);
            }
            const StepReport report = still.Step(4);
            EXPECT_EQ(report.awakeBodyCount, 0);
            EXPECT_EQ(inspect::GetListedCount(still.world), 0);
            EXPECT_EQ(inspect::GetActiveContactCount(still.world), 0);
        }
    }
}

/// What rests is not saved: a restored world looks at everything, and goes on in the same way.
TEST(Resting, ARestoredWorldGoesOnInTheSameWay) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Edits edits(seed, BroadPhaseKind::automatic, 0);
        for (int step = 0; step < 200; ++step) {
            edits.Prepare();
            const std::unique_ptr<World> restored = LoadWorld(SaveWorld(edits.GetWorld()));
            ASSERT_NE(restored, nullptr);
            const StepReport own = edits.Step(), other = restored->Step(dt, 8, 3);
            ASSERT_EQ(inspect::GetStateHash(edits.GetWorld()), inspect::GetStateHash(*restored))
                << "seed " << seed << ", step " << step;
            ASSERT_EQ(own.touchingCount, other.touchingCount);
        }
    }
}

}  // namespace
}  // namespace scree
