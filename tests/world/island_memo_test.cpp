// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands of the last step that are taken again: the same as those that are searched anew in every step, whatever a
// program edits in between.

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "scree/rollback.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

/// Piles of boxes and disks with some joints; everything that is done follows from the seed.
class EditedPiles {
public:
    EditedPiles(uint32_t seed, bool forgets) : m_random(seed), m_forgets(forgets), m_moments(world, 4) {
        m_ground = AddGround(world, 60.0f);
        for (int i = 0; i < 130; ++i)
            AddSomething({static_cast<float>(i % 13) * 2.0f - 13.0f, 0.5f + static_cast<float>(i / 13)});
        for (int i = 0; i < 4; ++i) AddJoint();
        for (int i = 0; i < 3; ++i) AddFloating();
    }

    /// True if the islands are those of the step before.
    bool Step(int substeps) {
        WorldState& s = world.GetState();
        if (m_forgets) s.islandScratch = {};
        const uint64_t before = s.islands.search;
        if (substeps < 0) {
            world.Step(frame, Tolerance{.overlap = 0.01f});
        } else {
            StepWith(world, substeps);
        }
        return before != 0 && s.islands.search == before;
    }

    void Edit() {
        Body* body = AnyBody();
        switch (m_random() % 18) {
            case 0:
                return body->SetAwake(m_random() % 2 == 0), void();
            case 1:
                return body->SetEnabled(!body->IsEnabled()), void();
            case 2:
                return body->SetType(std::array{staticBody, kinematicBody, dynamicBody}[m_random() % 3]), void();
            case 3:
                return AddSomething({static_cast<float>(m_random() % 26) - 13.0f, 12.0f});
            case 4:
                return Destroy(body);
            case 5:
                return AddJoint();
            case 6:
                if (world.GetJointList() != nullptr) world.DestroyJoint(world.GetJointList());
                return;
            case 7:
                return body->SetTransform(body->GetPosition() + Vec2{0.01f, 0.0f}, 0.0f), void();
            case 8:
                return body->ApplyLinearImpulseToCenter({0.5f, 1.0f}, true), void();
            case 9:
                return body->GetFixtureList()->SetSensor(m_random() % 4 == 0), void();
            case 10:
                return m_ground->SetEnabled(m_random() % 4 != 0), void();
            case 11:
                m_moment = m_moments.Save();
                return;
            case 12:
                if (!m_moments.Has(m_moment)) return;
                EXPECT_EQ(m_moments.Restore(m_moment), SnapshotError::ok);
                return;
            case 13:
                return Exchange(body, AnyBody());
            case 14: {  // the new one has the number of the old one
                Body* oldest = nullptr;
                for (Body* one = world.GetBodyList(); one != nullptr; one = one->GetNext()) {
                    if (one->GetGravityScale() == 0.0f) oldest = one;
                }
                if (oldest != nullptr) world.DestroyBody(oldest);
                return AddFloating();
            }
            case 15: {  // another joint in place of one that never was
                const int64_t moment = m_moments.Save();
                AddJoint();
                StepWith(world, 0, 4);
                EXPECT_EQ(m_moments.Restore(moment), SnapshotError::ok);
                return AddJoint();
            }
            default:
                return inspect::SetIsolatedPath(world, m_random() % 2 == 0);
        }
    }

    World world{{0.0f, -10.0f}};

private:
    Body* AnyBody() {
        Body* body = world.GetBodyList();
        for (auto i = m_random() % static_cast<uint32_t>(world.GetBodyCount() - 1); i > 0; --i) body = body->GetNext();
        return body;
    }
    void AddSomething(Vec2 place) {
        Body* body = AddBody(world, dynamicBody, place);
        m_random() % 3 != 0 ? AddBox(body, 0.5f, 0.5f) : AddCircle(body, 0.5f);
    }
    /// Touches nothing.
    void AddFloating() {
        BodyDef def;
        def.type = dynamicBody;
        def.gravityScale = 0.0f;
        def.position = {static_cast<float>(m_random() % 400) - 200.0f, 40.0f};
        def.allowSleep = false;
        AddBox(world.CreateBody(&def), 0.5f, 0.5f);
    }
    /// Rows of contacts may come to have other bodies.
    void Exchange(Body* a, Body* b) {
        const Vec2 place = a->GetPosition();
        const float angle = a->GetAngle();
        a->SetTransform(b->GetPosition(), b->GetAngle());
        b->SetTransform(place, angle);
    }
    void AddJoint() {
        Body *a = AnyBody(), *b = AnyBody();
        if (a == b) return;
        DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition(), b->GetPosition() + Vec2{0.0f, 0.1f});
        world.CreateJoint(&def);
    }
    void Destroy(Body* body) {
        if (world.GetBodyCount() > 60) world.DestroyBody(body);
    }

    std::mt19937 m_random;
    bool m_forgets;
    Body* m_ground = nullptr;
    Rollback m_moments;
    int64_t m_moment = -1;
};

/// `keeps`: islands are searched, and those of before taken again.
void ExpectSameLives(int substeps, bool keeps = true) {
    int taken = 0, searched = 0, found = 0, asleep = 0;
    for (uint32_t seed = 0; seed < 25; ++seed) {
        EditedPiles remembering(seed, false), forgetting(seed, true);
        std::mt19937 random(1000 + seed);
        const uint32_t rest = 4 + random() % 30;  // steps between edits
        for (int step = 0; step < 240; ++step) {
            const bool edits = step > 60 && random() % rest == 0;
            for (uint32_t i = edits ? 1 + random() % 2 : 0; i > 0; --i) remembering.Edit(), forgetting.Edit();
            (remembering.Step(substeps) ? taken : searched) += 1;
            ASSERT_FALSE(forgetting.Step(substeps));
            const WorldState &a = remembering.world.GetState(), &b = forgetting.world.GetState();
            ASSERT_EQ(a.islands.bodies, b.islands.bodies) << "world " << seed << ", step " << step;
            ASSERT_EQ(a.islands.contacts, b.islands.contacts) << "world " << seed << ", step " << step;
            ASSERT_EQ(a.islands.joints, b.islands.joints) << "world " << seed << ", step " << step;
            ASSERT_EQ(a.islands.isolated, b.islands.isolated) << "world " << seed << ", step " << step;
            ASSERT_EQ(inspect::GetStateHash(remembering.world), inspect::GetStateHash(forgetting.world))
                << "world " << seed << ", step " << step;
            found += static_cast<int>(a.islands.islands.size());
            asleep += remembering.world.GetBodyCount() - remembering.world.GetReport().awakeBodyCount - 1;
        }
    }
    EXPECT_GT(searched, 500);
    EXPECT_GT(found, 100);
    EXPECT_GT(asleep, 1000);  // body-steps
    if (keeps) {
        EXPECT_GT(taken, 500);
    } else {
        EXPECT_EQ(taken, 0);
    }
}

TEST(IslandMemo, AsksForAllThatASearchReads) {
    World world({0.0f, -10.0f});
    AddGround(world);
    for (int i = 0; i < 80; ++i)
        AddBox(AddBody(world, dynamicBody, {2.0f * static_cast<float>(i) - 80.0f, 0.5f}), 0.5f, 0.5f);
    StepFor(world, 3);
    WorldState& s = world.GetState();
    std::vector<ContactIndex> rows;
    for (const ContactIndex contact : s.contacts.Rows()) rows.push_back(contact);
    ASSERT_GE(rows.size(), 64u);
    IslandMemo memo;
    IslandTable islands;
    bool isApart = true;
    const auto isAnswered = [&] {
        return memo.IsAnswered({*s.pool, s.contacts, s.joints, s.bodies, rows, isApart}, islands);
    };
    const auto ask = [&] {
        for (int i = 0; i < 2; ++i) {  // contacts that were the same once are kept in mind
            EXPECT_FALSE(isAnswered());
            memo.Stamp(islands);
        }
    };
    ask();
    const auto expectAsked = [&](const char* what, auto&& change, auto&& changeBack) {
        EXPECT_TRUE(isAnswered()) << "before " << what;
        change();
        EXPECT_FALSE(isAnswered()) << what;
        memo.Stamp(islands);
        changeBack();
        EXPECT_FALSE(isAnswered()) << "back from " << what;
        memo.Stamp(islands);
    };
    Body *first = &s.bodies.handles[s.bodies.movers[MoverRow{0}]], *second = first->GetWorld()->GetBodyList();
    const auto swapEnds = [&] { std::swap(s.contacts.pair[rows[3]].bodyB, s.contacts.pair[rows[7]].bodyB); };
    expectAsked("bodies of contacts", swapEnds, swapEnds);
    expectAsked(
        "sleep", [&] { first->SetAwake(false); }, [&] { first->SetAwake(true); });
    const auto toggle = [&] { isApart = !isApart; };
    expectAsked("where isolated bodies go", toggle, toggle);
    Joint* joint = nullptr;
    const auto join = [&] {
        WeldJointDef def;
        def.Initialize(first, second, vec2Zero);
        joint = world.CreateJoint(&def);
    };
    expectAsked("a joint", join, [&] { world.DestroyJoint(joint); });
    const auto makeOther = [&] {  // a mover in place of another: no flag and no contact tells
        Body* floating = AddBody(world, dynamicBody, {0.0f, 90.0f});
        world.DestroyBody(floating);
    };
    const auto addBody = [&] { AddBody(world, dynamicBody, {0.0f, 90.0f}); };
    expectAsked("a body", addBody, [&] { world.DestroyBody(world.GetBodyList()); });
    makeOther();
    EXPECT_TRUE(isAnswered()) << "all is as it was";
    rows.pop_back();
    EXPECT_FALSE(isAnswered()) << "contacts";
    rows.resize(63);
    ask();
    EXPECT_FALSE(isAnswered()) << "too few to be worth while";
}

TEST(IslandMemo, KeepsTheIslandsOfSequentialImpulses) { ExpectSameLives(0); }
TEST(IslandMemo, IsNotNeededByTheSoftStep) { ExpectSameLives(4, false); }
TEST(IslandMemo, KeepsTheIslandsOfTolerances) { ExpectSameLives(-1); }

}  // namespace
}  // namespace scree::test
