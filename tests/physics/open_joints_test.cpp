// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Structures whose joints are made a little open, as in levels whose numbers were rounded or drawn by hand. They close
// and stay in one piece, whatever hangs on them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "scree/scree.h"

namespace scree::test {
namespace {

struct OpenPlan {
    int links;
    bool isLadder;    ///< two chains with rods between them, else one
    bool isVertical;  ///< hangs straight down, else out from the wall
    float load;       ///< mass of the last links, in those of others
    float offset;     ///< of anchors and rods, m
    unsigned seed;
};

class OpenStructure {
public:
    explicit OpenStructure(const OpenPlan& plan) : world(Vec2{0.0f, -10.0f}), m_plan(plan), m_random(plan.seed) {
        BodyDef def;
        Body* wall = world.CreateBody(&def);
        std::vector<Body*> last(plan.isLadder ? 2 : 1, wall);
        for (int i = 0; i < plan.links; ++i) {
            for (size_t row = 0; row < last.size(); ++row) {
                const auto along = static_cast<float>(i), across = -static_cast<float>(row);
                Body* link = AddLink(At(along + 0.5f, across), i == plan.links - 1 ? plan.load : 1.0f);
                RevoluteJointDef joint;
                joint.Initialize(last[row], link, At(along, across));
                joint.localAnchorA += Vec2{Draw(), Draw()};
                world.CreateJoint(&joint);
                last[row] = link;
            }
            if (!plan.isLadder) continue;
            DistanceJointDef rod;
            rod.Initialize(last[0], last[1], last[0]->GetPosition(), last[1]->GetPosition());
            rod.minLength = rod.maxLength = rod.length + Draw();
            world.CreateJoint(&rod);
        }
    }
    /// The widest gap of a joint in some steps, m.
    float Step(int steps, int substeps) {
        float gap = 0.0f;
        for (int i = 0; i < steps; ++i) {
            world.Step(1.0f / 60.0f, substeps);
            gap = std::max(gap, world.MeasureErrors().jointGap);
        }
        return gap;
    }

    [[nodiscard]] Body* GetLink(size_t number) {
        Body* body = world.GetBodyList();
        for (size_t i = 0; i < number; ++i) body = body->GetNext();
        return body;
    }

    World world;

private:
    [[nodiscard]] Vec2 At(float along, float across) const {
        return m_plan.isVertical ? Vec2{across, -along} : Vec2{along, across};
    }
    float Draw() { return std::uniform_real_distribution<float>(-m_plan.offset, m_plan.offset)(m_random); }
    Body* AddLink(Vec2 position, float density) {
        BodyDef def;
        def.type = dynamicBody;
        def.position = position;
        Body* body = world.CreateBody(&def);
        PolygonShape box;
        m_plan.isVertical ? box.SetAsBox(0.125f, 0.5f) : box.SetAsBox(0.5f, 0.125f);
        FixtureDef fixture;
        fixture.shape = &box;
        fixture.density = density;
        fixture.filter.groupIndex = -1;
        body->CreateFixture(&fixture);
        return body;
    }

    const OpenPlan m_plan;
    std::mt19937 m_random;
};

TEST(OpenJoints, CloseUnderLoadsWithoutBeingThrown) {
    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    const auto draw = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    for (int round = 0; round < 24; ++round) {
        const OpenPlan plan{static_cast<int>(8 + random() % 13), round % 2 == 1,    round % 4 >= 2,
                            std::pow(10.0f, draw(0.0f, 3.0f)),   draw(0.0f, 0.03f), static_cast<unsigned>(random())};
        for (const int substeps : {4, 8, 16}) {
            OpenStructure structure(plan);
            EXPECT_LT(structure.Step(240, substeps), 0.3f)
                << "seed " << seed << ", round " << round << ", " << substeps << " sub-steps";
            EXPECT_LT(structure.Step(60, substeps), 0.1f)
                << "seed " << seed << ", round " << round << ", " << substeps << " sub-steps";
        }
    }
}

/// A link that a game puts elsewhere is brought back, or the rest after it.
TEST(OpenJoints, CatchALinkThatWasMoved) {
    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    const auto draw = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    for (int round = 0; round < 24; ++round) {
        const OpenPlan plan{static_cast<int>(8 + random() % 13), false, round % 2 == 1,
                            std::pow(10.0f, draw(0.0f, 3.0f)),   0.0f,  static_cast<unsigned>(random())};
        const int substeps = round % 4 < 2 ? 4 : 16;
        OpenStructure structure(plan);
        structure.Step(30, substeps);
        Body* link = structure.GetLink(random() % static_cast<unsigned>(plan.links));
        link->SetTransform(link->GetPosition() + Vec2{draw(-3.0f, 3.0f), draw(-3.0f, 3.0f)}, link->GetAngle());
        structure.Step(1, substeps);
        EXPECT_LT(structure.Step(120, substeps), 3.0f) << "seed " << seed << ", round " << round;
        EXPECT_LT(structure.Step(60, substeps), 0.3f) << "seed " << seed << ", round " << round;
    }
}

/// What gives way in one tree is none of another's business. A sound chain whirls as it does alone, beside open ones
/// that would explode if they did not give way.
TEST(OpenJoints, LeaveOtherTreesAlone) {
    const auto gapsBeside = [](int open) {
        World world(Vec2{0.0f, -10.0f});
        BodyDef wallDef;
        Body* wall = world.CreateBody(&wallDef);
        std::mt19937 random(11);
        const auto hang = [&](float height, float offset, float spin) {
            Body* last = wall;
            std::vector<const Joint*> joints;
            constexpr int links = 12;
            for (int i = 0; i < links; ++i) {
                BodyDef def;
                def.type = dynamicBody;
                def.position = {static_cast<float>(i) + 0.5f, height};
                def.linearVelocity = {0.0f, spin * def.position.x};
                def.angularVelocity = spin;
                Body* link = world.CreateBody(&def);
                PolygonShape box;
                box.SetAsBox(0.5f, 0.125f);
                FixtureDef fixture;
                fixture.shape = &box;
                fixture.density = i == links - 1 ? 500.0f : 1.0f;
                fixture.filter.groupIndex = -1;
                link->CreateFixture(&fixture);
                RevoluteJointDef joint;
                joint.Initialize(last, link, {static_cast<float>(i), height});
                std::uniform_real_distribution<float> draw(-offset, offset);
                if (offset > 0.0f) joint.localAnchorA += Vec2{draw(random), draw(random)};
                joints.push_back(world.CreateJoint(&joint));
                last = link;
            }
            return joints;
        };
        const std::vector<const Joint*> sound = hang(0.0f, 0.0f, 8.0f);
        for (int i = 1; i <= open; ++i) hang(100.0f * static_cast<float>(i), 0.03f, 0.0f);
        std::vector<float> gaps;
        for (int i = 0; i < 60; ++i) {
            world.Step(1.0f / 60.0f, 4);
            float widest = 0.0f;
            for (const Joint* joint : sound)
                widest = std::max(widest, (joint->GetAnchorB() - joint->GetAnchorA()).Length());
            gaps.push_back(widest);
        }
        return gaps;
    };
    const std::vector<float> alone = gapsBeside(0), beside = gapsBeside(12);
    for (size_t i = 0; i < alone.size(); ++i) EXPECT_NEAR(alone[i], beside[i], 1e-5f) << i;
}

}  // namespace
}  // namespace scree::test
