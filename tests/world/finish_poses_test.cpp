// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Poses at the end of a step, eight at a time: the bits of the arithmetic body by body. Motions are random, with and
// without rests and caps; both instruction sets give the same.

#include "pipeline/parts/finish_poses.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "base/two_sum.h"
#include "pipeline/parts/body_motion.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {

bool FinishPosesBase(const FinishPosesTask& task, const int32_t* eight);

namespace {

using namespace test;

/// Eight bodies with random shapes, so that their centres differ from their origins.
class EightBodies {
public:
    explicit EightBodies(uint32_t seed) : m_random(seed), bodies(m_world.GetState().bodies) {
        for (int i = 0; i < 8; ++i) {
            Body* body = AddBody(m_world, dynamicBody, {Any(50.0f), Any(50.0f)});
            PolygonShape shape;
            shape.SetAsBox(0.5f, 0.4f, {Any(1.0f), Any(1.0f)}, Any(3.0f));
            body->CreateFixture(&shape, 1.0f);
            body->SetTransform(body->GetPosition(), Any(20.0f));
        }
        delta.resize(ToSize(bodies.slots.Size()));
    }
    float Any(float most) { return std::uniform_real_distribution<float>(-most, most)(m_random); }
    bool Chance(uint32_t oneIn) { return m_random() % oneIn == 0; }

    void Move(bool hasRests) {
        for (const BodyIndex b : bodies.movers) {
            bodies.position[b].aRest = hasRests && !Chance(3) ? Any(1e-8f) : 0.0f;
            bodies.NoteStart(b);
            bodies.velocity[b] = {{Any(10.0f), Any(10.0f)}, Any(5.0f), 0.0f};
            delta[b] = {{Any(0.5f), Any(0.5f)}, Chance(3) ? 0.0f : Any(0.5f), 0.0f};
        }
    }
    [[nodiscard]] FinishPosesTask Task(bool keepsRests, bool hasLimit) {
        return {&bodies.velocity.data()->v.x,
                &bodies.startPosition.data()->c.x,
                &bodies.mass.data()->invMass,
                &delta.data()->v.x,
                &bodies.position.data()->c.x,
                &bodies.transform.data()->p.x,
                keepsRests,
                hasLimit,
                0.4f,
                0.4f};
    }
    void FinishOneByOne(bool keepsRests) {
        for (const BodyIndex b : bodies.movers) {
            bodies.SetMotion(b, delta[b].v);
            const Position& start = bodies.startPosition[b];
            if (keepsRests) {
                const RoundedSum angle = TwoSum(start.a, delta[b].w + start.aRest);
                bodies.position[b].a = angle.sum, bodies.position[b].aRest = angle.rest;
            } else {
                bodies.position[b].a = start.a + delta[b].w;
            }
            delta[b] = {};
            EXPECT_FALSE(FinishPose(bodies, b));
        }
    }

private:
    std::mt19937 m_random;
    World m_world{vec2Zero};

public:
    BodyTable& bodies;
    Column<BodyIndex, Velocity> delta;
};

template <typename Rows>
bool AreSame(const Rows& a, const Rows& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0;
}

TEST(FinishPoses, GivesTheBitsOfBodyByBody) {
    const FinishPosesFunction forms[] = {&FinishPosesBase, GetFinishPoses()};
    for (uint32_t seed = 0; seed < 500 && !HasFailure(); ++seed) {
        EightBodies eight(seed);
        const bool keepsRests = seed % 2 == 0;
        eight.Move(keepsRests);
        int32_t rows[8];
        for (size_t i = 0; i < 8; ++i) rows[i] = ToInt(eight.bodies.movers.data()[i]);
        const auto position = eight.bodies.position;
        const auto transform = eight.bodies.transform;
        const auto delta = eight.delta;
        eight.FinishOneByOne(keepsRests);
        const auto expectedPosition = eight.bodies.position;
        const auto expectedTransform = eight.bodies.transform;
        for (const FinishPosesFunction finish : forms) {
            eight.bodies.position = position, eight.bodies.transform = transform, eight.delta = delta;
            ASSERT_TRUE(finish(eight.Task(keepsRests, false), rows)) << "seed " << seed;
            EXPECT_TRUE(AreSame(eight.bodies.position, expectedPosition)) << "seed " << seed;
            EXPECT_TRUE(AreSame(eight.bodies.transform, expectedTransform)) << "seed " << seed;
            for (const int32_t row : rows) EXPECT_EQ(eight.delta.data()[row].v, vec2Zero);
        }
    }
}

TEST(FinishPoses, LeavesWhatIsCappedFarOrNotFinite) {
    for (const FinishPosesFunction finish : {&FinishPosesBase, GetFinishPoses()}) {
        for (int lane = 0; lane < 8; ++lane) {
            EightBodies eight(static_cast<uint32_t>(lane));
            eight.Move(true);
            int32_t rows[8];
            for (size_t i = 0; i < 8; ++i) rows[i] = ToInt(eight.bodies.movers.data()[i]);
            for (const int32_t row : rows) eight.delta.data()[row] = {{0.1f, 0.1f}, 0.1f, 0.0f};
            const auto position = eight.bodies.position;
            const auto transform = eight.bodies.transform;
            const auto refuses = [&](const FinishPosesTask& task) {
                const bool done = finish(task, rows);
                return !done && AreSame(eight.bodies.position, position) && AreSame(eight.bodies.transform, transform);
            };
            Velocity& way = eight.delta.data()[rows[lane]];
            for (const Velocity odd : {Velocity{{0.5f, 0.0f}, 0.0f, 0.0f}, Velocity{{0.0f, 0.0f}, -0.5f, 0.0f}}) {
                way = odd;
                EXPECT_TRUE(refuses(eight.Task(true, true))) << "capped, lane " << lane;
            }
            for (const Velocity odd :
                 {Velocity{{2e9f, 0.0f}, 0.0f, 0.0f}, Velocity{{0.0f, nan}, 0.0f, 0.0f},
                  Velocity{{0.0f, 0.0f}, infinity, 0.0f}, Velocity{{0.0f, -infinity}, 0.0f, 0.0f}}) {
                way = odd;
                EXPECT_TRUE(refuses(eight.Task(true, false))) << "far or not finite, lane " << lane;
            }
            way = {};
            Velocity& v = eight.bodies.velocity.data()[rows[lane]];
            for (const float odd : {nan, infinity, -infinity, 3e9f}) {
                v = {{0.0f, odd}, 0.0f, 0.0f};
                EXPECT_TRUE(refuses(eight.Task(true, false))) << "speed, lane " << lane;
            }
        }
    }
}

}  // namespace
}  // namespace scree
