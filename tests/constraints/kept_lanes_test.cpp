// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Lanes of joints keep their places from step to step. After any change of the joints or their bodies they give the
// bits of lanes that are made anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

#include "constraints/joint_constraints.h"
#include "tests/world/random_hinges.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

/// Hinges and wheels at random between some bodies, so that many meet in one.
class Gear {
public:
    explicit Gear(uint32_t seed) : world(vec2Zero), m_draw(seed) {
        for (int i = 0; i < 60; ++i) {
            bodies.push_back(AddLimb(world, {m_draw.Any(-9.0f, 9.0f), m_draw.Any(-9.0f, 9.0f)}, 3.0f, m_draw));
            if (m_draw.OneIn(10)) bodies.back()->SetType(staticBody);
        }
        for (int i = 0; i < 240; ++i) Add(i % 8 == 0);
    }

    [[nodiscard]] WorldState& State() { return world.GetState(); }

    /// One that may matter to where a joint is in the lanes, and where it does not.
    void Change(int kind) {
        Body* body = Any(bodies);
        switch (kind) {
            case 0:
                body->SetType(body->GetType() == dynamicBody ? staticBody : dynamicBody);
                break;
            case 1:  // too far for lanes, and back
                m_turned = m_turned == nullptr ? body : m_turned;
                ASSERT_EQ(m_turned->SetTransform(m_turned->GetPosition(), m_isFar ? 0.0f : 1.0e9f), ErrorCode::ok);
                if (m_isFar) m_turned = nullptr;
                m_isFar = !m_isFar;
                break;
            case 2:  // another one at the same number, of one of both types
                Replace();
                break;
            case 3:
                std::swap(joints[m_draw.Below(Count())], joints[m_draw.Below(Count())]);
                break;
            case 4:
                m_left.push_back(joints.back());
                joints.pop_back();
                break;
            case 5:
                if (m_left.empty()) break;
                joints.push_back(m_left.back());
                m_left.pop_back();
                break;
            case 6: {
                MassData mass;
                body->GetMassData(&mass);
                mass.mass *= 1.5f, mass.I *= 1.2f;
                (void)body->SetMassData(&mass);
                break;
            }
            default:
                break;
        }
    }

    World world;
    std::vector<Body*> bodies;
    std::vector<JointIndex> joints;

private:
    template <typename T>
    T& Any(std::vector<T>& list) {
        return list[m_draw.Below(static_cast<uint32_t>(list.size()))];
    }
    uint32_t Count() const { return static_cast<uint32_t>(joints.size()); }

    JointIndex Make(bool isWheel) {
        Body *a = Any(bodies), *b = Any(bodies);
        while (a == b || (a->GetType() == staticBody && b->GetType() == staticBody)) a = Any(bodies), b = Any(bodies);
        return Make(a, b, isWheel);
    }
    JointIndex Make(Body* a, Body* b, bool isWheel) {
        const Vec2 anchor = 0.5f * (a->GetWorldCenter() + b->GetWorldCenter());
        if (isWheel) {
            WheelJointDef def;
            def.Initialize(a, b, anchor, {0.0f, 1.0f});
            def.stiffness = 30.0f, def.damping = 1.0f;
            return IndexOf(*world.CreateJoint(&def));
        }
        RevoluteJointDef def;
        def.Initialize(a, b, anchor);
        GiveRange(def, m_draw);
        return IndexOf(*world.CreateJoint(&def));
    }
    void Add(bool isWheel) { joints.push_back(Make(isWheel)); }
    bool IsWheel(JointIndex joint) { return State().joints.info[joint].type == e_wheelJoint; }
    void Replace(JointIndex joint, bool isWheel) {
        Joint* old = State().joints.handles[joint];
        Body *a = old->GetBodyA(), *b = old->GetBodyB();
        world.DestroyJoint(old);
        ASSERT_EQ(m_draw.OneIn(2) ? Make(a, b, isWheel) : Make(isWheel), joint);
    }
    void Replace() {
        const JointIndex joint = Any(joints);
        const bool wasWheel = IsWheel(joint);
        Replace(joint, m_draw.OneIn(2) != wasWheel);
        if (IsWheel(joint) == wasWheel || m_draw.OneIn(2)) return;
        // And as many of each type as before.
        const auto other =
            std::ranges::find_if(joints, [&](JointIndex one) { return one != joint && IsWheel(one) != wasWheel; });
        if (other != joints.end()) Replace(*other, wasWheel);
    }

    Draws m_draw;
    std::vector<JointIndex> m_left;
    Body* m_turned = nullptr;
    bool m_isFar = false;
};

/// Plans, and solves some times from the velocities that the bodies have, which stay. Returns those that come of it.
template <typename Row>
Column<BodyIndex, Velocity> Solve(JointLanes<Row>& lanes, Gear& gear, TaskPool& pool) {
    WorldState& s = gear.State();
    const Column<BodyIndex, Velocity> before = s.bodies.velocity;
    const JointStep step{1.0f / 480.0f, 240.0f, 1.0f, 0.005f};
    lanes.Plan(gear.joints, s.bodies, s.joints, pool);
    if (!lanes.IsEmpty()) {
        lanes.Prepare(step, s.bodies, pool);
        lanes.WarmStart(step, s.bodies, pool);
        for (int i = 0; i < 3; ++i) lanes.Solve(step, s.bodies, pool);
    }
    Column<BodyIndex, Velocity> after = before;
    std::swap(after, s.bodies.velocity);
    return after;
}

template <typename Row>
void ExpectThemLikeNewOnes(int leastInLanes) {
    int inLanes = 0;
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        Gear gear(seed);
        std::mt19937 random(seed);
        JointLanes<Row> kept;
        TaskPool alone(1, TaskCallbacks{}), several(3, TaskCallbacks{});
        several.ShareAlways();
        for (int round = 0; round < 150; ++round) {
            if (round % 2 == 0) gear.Change(static_cast<int>(random() % 8));
            const bool isShared = random() % 2 == 0;
            if (isShared) several.Begin();
            const Column<BodyIndex, Velocity> one = Solve(kept, gear, isShared ? several : alone);
            if (isShared) several.End();
            JointLanes<Row> fresh;
            const Column<BodyIndex, Velocity> other = Solve(fresh, gear, alone);
            ASSERT_EQ(kept.IsEmpty(), fresh.IsEmpty()) << seed << ' ' << round;
            ASSERT_EQ(kept.IsEmpty() ? 0u : kept.CountJoints(), fresh.IsEmpty() ? 0u : fresh.CountJoints());
            ASSERT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(Velocity)), 0) << seed << ' ' << round;
            inLanes += kept.IsEmpty() ? 0 : 1;
        }
    }
    EXPECT_GT(inLanes, leastInLanes);
}

TEST(KeptLanes, OfRevoluteJointsAreLikeNewOnes) { ExpectThemLikeNewOnes<RevoluteRow>(400); }

}  // namespace
}  // namespace scree::test
