// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints in batches and sections: each body meets its joints in the order of the list, whichever threads solve them.

#include "constraints/joint_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <vector>

#include "constraints/joint_constraints.h"
#include "tests/world/random_hinges.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

/// Trees of some limbs, some of which hang on what cannot be pushed, and a large one.
class Crowd {
public:
    Crowd(uint32_t seed, int trees, int limbsOfLarge) : world(vec2Zero), m_draw(seed) {
        AddBox(m_wall = AddBody(world, staticBody, {0.0f, -50.0f}), 1.0f, 1.0f);
        for (int i = 0; i < trees; ++i) AddTree(3 + static_cast<int>(m_draw.Below(12)), m_draw.OneIn(6));
        if (limbsOfLarge > 0) AddTree(limbsOfLarge, m_draw.OneIn(2));
        for (size_t i = joints.size(); i > 1; --i)  // neighbours in the list change places
            std::swap(joints[i - 1], joints[i - 1 - m_draw.Below(static_cast<uint32_t>(std::min<size_t>(i, 40)))]);
    }
    [[nodiscard]] WorldState& State() { return world.GetState(); }
    [[nodiscard]] const JointInfo& InfoOf(JointIndex joint) { return State().joints.info[joint]; }
    [[nodiscard]] std::vector<BodyIndex> PushedBy(JointIndex joint) {
        std::vector<BodyIndex> pushed;
        for (const BodyIndex body : {InfoOf(joint).bodyA, InfoOf(joint).bodyB}) {
            if (JointLevels::IsPushed(body, State().bodies)) pushed.push_back(body);
        }
        return pushed;
    }

    World world;
    std::vector<JointIndex> joints;

private:
    void AddTree(int limbs, bool hangs) {
        std::vector<Body*> bodies;
        for (int i = 0; i < limbs; ++i) {
            bodies.push_back(AddLimb(world, {m_draw.Any(-90.0f, 90.0f), m_draw.Any(-9.0f, 9.0f)}, 3.0f, m_draw));
            if (i > 0) Join(bodies[m_draw.Below(static_cast<uint32_t>(i))], bodies.back());
        }
        if (hangs) Join(m_wall, bodies.front());
    }
    void Join(Body* a, Body* b) {
        RevoluteJointDef def;
        def.Initialize(a, b, 0.5f * (a->GetWorldCenter() + b->GetWorldCenter()));
        GiveRange(def, m_draw);
        joints.push_back(IndexOf(*world.CreateJoint(&def)));
    }

    Draws m_draw;
    Body* m_wall = nullptr;
};

/// Bodies that the joints of a part of the order push.
std::set<BodyIndex> PushedBy(Crowd& crowd, std::span<const JointIndex> order) {
    std::set<BodyIndex> bodies;
    for (const JointIndex joint : order) {
        if (IsNone(joint)) continue;
        for (const BodyIndex body : crowd.PushedBy(joint)) bodies.insert(body);
    }
    return bodies;
}

bool ShareBody(const std::set<BodyIndex>& one, const std::set<BodyIndex>& other) {
    return std::ranges::any_of(one, [&](BodyIndex body) { return other.contains(body); });
}

TEST(JointLevels, KeepTheOrderOfEachBodyInGroups) {
    int grouped = 0, parted = 0, byCaller = 0;
    for (uint32_t seed = 1; seed <= 12; ++seed) {
        Crowd crowd(seed, 40 + static_cast<int>(seed) * 20, seed % 3 == 0 ? 600 : 0);
        WorldState& s = crowd.State();
        JointLevels levels;
        const std::span<const JointIndex> order = levels.SortByGroup(e_revoluteJoint, crowd.joints, s.bodies, s.joints);
        ASSERT_FALSE(order.empty());
        ASSERT_EQ(order.size() % jointBatchSize, 0u);

        // Every joint once, and those of a batch push different bodies.
        std::map<JointIndex, size_t> batchOf;
        for (size_t i = 0; i < order.size(); ++i) {
            if (IsSome(order[i])) ASSERT_TRUE(batchOf.emplace(order[i], i / jointBatchSize).second);
        }
        ASSERT_EQ(batchOf.size(), crowd.joints.size());
        std::map<BodyIndex, size_t> last;  // by body: one behind the batch of its last joint so far
        for (const JointIndex joint : crowd.joints) {
            for (const BodyIndex body : crowd.PushedBy(joint)) {
                ASSERT_GE(batchOf.at(joint), last[body]) << "a joint before one that is before it in the list";
                last[body] = batchOf.at(joint) + 1;
            }
        }

        // What threads may do at the same time pushes different bodies, and writes to no body that cannot be pushed.
        std::set<BodyIndex> ofOthers;
        size_t begin = 0;
        for (const JointSection& section : levels.GetSections()) {
            const auto own = order.subspan(begin, ToSize(section.end) * jointBatchSize - begin);
            begin += own.size();
            byCaller += section.sharing == Sharing::none ? 1 : 0;
            if (section.sharing == Sharing::none) continue;
            for (const JointIndex joint : own) {
                if (IsSome(joint)) EXPECT_EQ(crowd.PushedBy(joint).size(), 2u);
            }
            if (section.sharing == Sharing::whole) {
                ++grouped;
                const std::set<BodyIndex> bodies = PushedBy(crowd, own);
                EXPECT_FALSE(ShareBody(bodies, ofOthers));
                ofOthers.insert(bodies.begin(), bodies.end());
                continue;
            }
            ++parted;
            std::set<BodyIndex> before;
            for (size_t i = 0; i < own.size(); i += jointBatchSize) {
                const std::set<BodyIndex> bodies = PushedBy(crowd, own.subspan(i, jointBatchSize));
                EXPECT_FALSE(ShareBody(bodies, before));
                before.insert(bodies.begin(), bodies.end());
            }
        }
        EXPECT_EQ(begin, order.size());
    }
    EXPECT_GT(grouped, 20);
    EXPECT_GT(parted, 10);
    EXPECT_GT(byCaller, 10);
}

/// All that a sub-step does with them.
void Solve(Crowd& crowd, TaskPool& pool) {
    WorldState& s = crowd.State();
    const JointStep step{1.0f / 480.0f, 240.0f, 1.0f, 0.005f};
    JointLanes<RevoluteRow> lanes;
    lanes.Plan(crowd.joints, s.bodies, s.joints, pool);
    ASSERT_EQ(lanes.CountJoints(), crowd.joints.size());
    for (int i = 0; i < 3; ++i) {
        lanes.Prepare(step, s.bodies, pool);
        lanes.WarmStart(step, s.bodies, pool);
        lanes.Solve(step, s.bodies, pool);
        lanes.SolvePositionsAndWarmStart(step, s.bodies, s.joints.Store<RevoluteRow>().rows, pool);
        lanes.Solve(step, s.bodies, pool);
    }
}

TEST(JointLevels, GiveSeveralThreadsTheBitsOfOne) {
    for (uint32_t seed = 1; seed <= 6; ++seed) {
        Crowd one(seed, 160, seed % 2 == 0 ? 500 : 0), other(seed, 160, seed % 2 == 0 ? 500 : 0);
        TaskPool alone(1, TaskCallbacks{}), several(2 + static_cast<int>(seed % 3), TaskCallbacks{});
        several.ShareAlways();
        Solve(one, alone);
        several.Begin();
        Solve(other, several);
        several.End();
        const BodyTable &a = one.State().bodies, &b = other.State().bodies;
        ASSERT_EQ(std::memcmp(a.velocity.data(), b.velocity.data(), a.velocity.size() * sizeof(Velocity)), 0) << seed;
        ASSERT_EQ(std::memcmp(a.position.data(), b.position.data(), a.position.size() * sizeof(Position)), 0) << seed;
    }
}

}  // namespace
}  // namespace scree::test
