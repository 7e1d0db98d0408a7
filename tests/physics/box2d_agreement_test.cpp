// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Beside Box2D 2.4.1 at the same setting: the same bodies touch, come to rest at the same places and fall asleep
// together.

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// The same bodies in both engines.
class Twin {
public:
    Twin() : box2d(b2Vec2(0.0f, -10.0f)), scree(MakeDef()) {
        box2d.SetContinuousPhysics(false);
        b2BodyDef groundDef;
        b2EdgeShape edge;
        edge.SetTwoSided(b2Vec2(-50, 0), b2Vec2(50, 0));
        box2d.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
        AddGround(scree, 50.0f);
    }

    void Add(float x, float y, float angle, bool circle, float size) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position.Set(x, y);
        def.angle = angle;
        theirs.push_back(box2d.CreateBody(&def));
        ours.push_back(AddBody(scree, dynamicBody, {x, y}, angle));
        if (circle) {
            b2CircleShape shape;
            shape.m_radius = size;
            theirs.back()->CreateFixture(&shape, 1.0f);
            AddCircle(ours.back(), size);
        } else {
            b2PolygonShape shape;
            shape.SetAsBox(size, size);
            theirs.back()->CreateFixture(&shape, 1.0f);
            AddBox(ours.back(), size, size);
        }
    }

    void Step(int steps) {
        for (int i = 0; i < steps; ++i) {
            box2d.Step(1.0f / 60.0f, 8, 3);
            scree.Step(1.0f / 60.0f, 8, 3);
        }
    }

    [[nodiscard]] float WorstDistance() const {
        float worst = 0.0f;
        for (size_t i = 0; i < ours.size(); ++i) {
            const b2Vec2 p = theirs[i]->GetPosition();
            worst = Max(worst, Distance(ours[i]->GetPosition(), {p.x, p.y}));
        }
        return worst;
    }

    b2World box2d;
    World scree;
    std::vector<b2Body*> theirs;
    std::vector<Body*> ours;

private:
    static WorldDef MakeDef() {
        WorldDef def;
        def.maxTranslation = maxTranslation;
        def.maxRotation = maxRotation;
        def.continuousPhysics = false;
        return def;
    }
};

TEST(Box2dAgreement, FreeFallIsTheSameBitForBit) {
    Twin twin;
    for (int i = 0; i < 20; ++i)
        twin.Add(3.0f * static_cast<float>(i) - 30.0f, 40.0f + static_cast<float>(i), 0.1f * static_cast<float>(i),
                 i % 2 == 0, 0.5f);
    twin.Step(100);
    EXPECT_EQ(twin.WorstDistance(), 0.0f);
}

TEST(Box2dAgreement, SingleBodiesRestWithinAMillimetre) {
    Twin twin;
    for (int i = 0; i < 9; ++i)
        twin.Add(4.0f * static_cast<float>(i) - 16.0f, 1.0f + 0.3f * static_cast<float>(i), 0.0f, i % 2 == 0,
                 0.3f + 0.05f * static_cast<float>(i));
    twin.Step(300);
    EXPECT_LT(twin.WorstDistance(), 1e-3f);
    for (size_t i = 0; i < twin.ours.size(); ++i) EXPECT_EQ(twin.ours[i]->IsAwake(), twin.theirs[i]->IsAwake()) << i;
}

TEST(Box2dAgreement, TippedBoxesComeToRestOnTheSameFace) {
    Twin twin;
    for (int i = 0; i < 8; ++i)
        twin.Add(5.0f * static_cast<float>(i) - 18.0f, 1.5f, 0.3f + 0.05f * static_cast<float>(i), false, 0.5f);
    twin.Step(400);
    EXPECT_LT(twin.WorstDistance(), 2e-3f);  // the tumble amplifies the last bits of the manifolds
    for (size_t i = 0; i < twin.ours.size(); ++i)
        EXPECT_NEAR(twin.ours[i]->GetAngle(), twin.theirs[i]->GetAngle(), 2e-3f);
}

TEST(Box2dAgreement, StacksStandAtTheSameHeights) {
    Twin twin;
    for (int column = 0; column < 4; ++column) {
        for (int i = 0; i <= 2 * column; ++i)
            twin.Add(5.0f * static_cast<float>(column) - 8.0f, 0.51f + 1.02f * static_cast<float>(i), 0.0f, false,
                     0.5f);
    }
    twin.Step(600);
    EXPECT_LT(twin.WorstDistance(), 5e-3f);  // one linearSlop: the solvers' orders differ inside a stack
    for (size_t i = 0; i < twin.ours.size(); ++i) EXPECT_EQ(twin.ours[i]->IsAwake(), twin.theirs[i]->IsAwake()) << i;
}

TEST(Box2dAgreement, ARodPendulumSwingsAsInBox2d) {
    // 1 × 0.1 rod on its end, released at 90°.
    b2World theirs(b2Vec2(0, -10));
    b2BodyDef pivotDef, rodDef;
    rodDef.type = b2_dynamicBody;
    rodDef.position.Set(0.5f, 0);
    b2Body* theirRod = theirs.CreateBody(&rodDef);
    b2PolygonShape theirShape;
    theirShape.SetAsBox(0.5f, 0.05f);
    theirRod->CreateFixture(&theirShape, 1.0f);
    b2RevoluteJointDef theirDef;
    theirDef.Initialize(theirs.CreateBody(&pivotDef), theirRod, b2Vec2(0, 0));
    auto* theirJoint = static_cast<b2RevoluteJoint*>(theirs.CreateJoint(&theirDef));

    World ours({0.0f, -10.0f});
    Body* ourRod = AddBody(ours, dynamicBody, {0.5f, 0});
    AddBox(ourRod, 0.5f, 0.05f);
    RevoluteJointDef ourDef;
    ourDef.Initialize(AddBody(ours, staticBody, {0, 0}), ourRod, {0, 0});
    auto* ourJoint = static_cast<RevoluteJoint*>(ours.CreateJoint(&ourDef));

    theirs.SetAllowSleeping(false);
    ours.SetAllowSleeping(false);
    for (int i = 0; i < 600; ++i) {
        theirs.Step(1.0f / 60.0f, 8, 3);
        ours.Step(1.0f / 60.0f, 8, 3);
        ASSERT_NEAR(ourJoint->GetJointAngle(), theirJoint->GetJointAngle(), 1e-4) << "step " << i;
        ASSERT_LT(Distance(ourJoint->GetAnchorA(), ourJoint->GetAnchorB()), linearSlop);
    }
}

}  // namespace
}  // namespace scree::test
