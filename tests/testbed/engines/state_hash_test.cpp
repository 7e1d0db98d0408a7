// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of the state hash: −0 is 0, order and awake bit count, every bit of every hashed field counts, nothing else
// does.

#include "testbed/engines/state_hash.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <vector>

using namespace testbed;

namespace {

BodyState MakeBody(float seed) {
    return {.index = 0,
            .type = scenes::BodyType::dynamic,
            .position = {seed, seed + 1.0f},
            .sin = 0.0f,
            .cos = 1.0f,
            .angle = seed + 2.0f,
            .linearVelocity = {seed + 3.0f, seed + 4.0f},
            .angularVelocity = seed + 5.0f,
            .awake = true,
            .bullet = false};
}

/// The hashed floats of a body, by number.
float& Field(BodyState& body, int field) {
    switch (field) {
        case 0:
            return body.position.x;
        case 1:
            return body.position.y;
        case 2:
            return body.angle;
        case 3:
            return body.linearVelocity.x;
        case 4:
            return body.linearVelocity.y;
        default:
            return body.angularVelocity;
    }
}

constexpr int fieldCount = 6;

}  // namespace

TEST(StateHash, NegativeZeroCountsAsZero) {
    for (int field = 0; field < fieldCount; ++field) {
        std::vector<BodyState> plus{MakeBody(1.0f)}, minus{MakeBody(1.0f)};
        Field(plus[0], field) = 0.0f;
        Field(minus[0], field) = -0.0f;
        EXPECT_EQ(HashState(plus), HashState(minus)) << "field " << field;
    }
}

TEST(StateHash, OrderCounts) {
    const std::vector<BodyState> one{MakeBody(1.0f), MakeBody(2.0f)}, other{MakeBody(2.0f), MakeBody(1.0f)};
    EXPECT_NE(HashState(one), HashState(other));
}

TEST(StateHash, CountOfBodiesCounts) {
    const std::vector<BodyState> none, one{MakeBody(0.0f)}, two{MakeBody(0.0f), MakeBody(0.0f)};
    EXPECT_NE(HashState(none), HashState(one));
    EXPECT_NE(HashState(one), HashState(two));
}

TEST(StateHash, AwakeBitCounts) {
    std::vector<BodyState> bodies{MakeBody(1.0f), MakeBody(2.0f)};
    const uint64_t awake = HashState(bodies);
    bodies[0].awake = false;
    const uint64_t firstAsleep = HashState(bodies);
    bodies[0].awake = true;
    bodies[1].awake = false;
    EXPECT_NE(awake, firstAsleep);
    EXPECT_NE(awake, HashState(bodies));
    EXPECT_NE(firstAsleep, HashState(bodies));
}

TEST(StateHash, EveryBitOfEveryFieldCounts) {
    EXPECT_TRUE(rc::check("one flipped bit changes the hash", [] {
        std::vector<BodyState> bodies;
        const int count = *rc::gen::inRange(1, 5);
        for (int i = 0; i < count; ++i)
            bodies.push_back(MakeBody(static_cast<float>(*rc::gen::inRange(-1000, 1000)) / 7.0f));
        const uint64_t before = HashState(bodies);
        float& field = Field(bodies[*rc::gen::inRange<size_t>(0, bodies.size())], *rc::gen::inRange(0, fieldCount));
        const float old = field;
        field = std::bit_cast<float>(std::bit_cast<uint32_t>(old) ^ (1u << *rc::gen::inRange(0, 32)));
        RC_PRE(!(field == 0.0f && old == 0.0f));
        RC_ASSERT(HashState(bodies) != before);
    }));
}

TEST(StateHash, DerivedFieldsDoNotCount) {
    std::vector<BodyState> bodies{MakeBody(1.0f)};
    const uint64_t before = HashState(bodies);
    bodies[0].sin = 0.5f;
    bodies[0].cos = 0.25f;
    bodies[0].bullet = true;
    EXPECT_EQ(HashState(bodies), before);
}
