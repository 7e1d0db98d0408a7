// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Each condition finds what was put before it, at its step and with its bodies, and nothing where there is nothing.

#include "testbed/moments/conditions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/testbed/engines/scene_builder.h"

namespace testbed {
namespace {

constexpr float timeStep = 1.0f / 60.0f;

/// A scene of shapes that somebody moves by hand.
class Stage {
public:
    int Add(scenes::BodyType type, const scenes::Shape& shape, Vec2 position) {
        scenes::Body body;
        body.type = type;
        body.position = position;
        checks::AddBody(m_scene, body, shape, 1.0f);
        BodyState state{};
        state.index = static_cast<int>(m_now.bodies.size());
        state.type = type;
        state.position = position;
        state.sin = 0.0f;
        state.cos = 1.0f;
        state.awake = type != scenes::BodyType::isStatic;
        m_now.bodies.push_back(state);
        return state.index;
    }
    int AddLine(Vec2 from, Vec2 to, bool isOneSided = false) {
        scenes::Shape line;
        line.type = scenes::ShapeType::edge;
        line.vertexCount = isOneSided ? 4 : 2;
        line.vertices[0] = from;
        line.vertices[1] = to;
        line.vertices[2] = {2 * from.x - to.x, 2 * from.y - to.y};
        line.vertices[3] = {2 * to.x - from.x, 2 * to.y - from.y};
        return Add(scenes::BodyType::isStatic, line, {});
    }
    int AddBall(Vec2 position, float radius = 0.5f) {
        return Add(scenes::BodyType::dynamic, checks::MakeCircleShape(radius), position);
    }
    scenes::Scene& GetScene() { return m_scene; }
    BodyState& Body(int index) { return m_now.bodies[static_cast<std::size_t>(index)]; }
    Snapshot& Now() { return m_now; }
    /// A contact of the two bodies' first fixtures.
    void Touch(int a, int b, float separation) {
        ContactState contact{};
        contact.fixtureA = a;
        contact.fixtureB = b;
        contact.touching = true;
        contact.pointCount = 1;
        contact.separations[0] = separation;
        m_now.contacts.push_back(contact);
    }

    int unknownPairs = 0;  ///< that the engine keeps and nobody recorded
    bool flies = false;    ///< velocities are those of the ways that bodies go
    /// Shows `steps` steps, each after `move(step)`; step 0 is the start.
    std::vector<Moment> Run(std::unique_ptr<Condition> condition, int steps, const std::function<void(int)>& move) {
        Conditions conditions;
        conditions.push_back(std::move(condition));
        Watch watch(m_scene, std::move(conditions));
        for (int step = 0; step <= steps; ++step) {
            m_now.step = step;
            m_now.contacts.clear();
            const std::vector<BodyState> before = m_now.bodies;
            move(step);
            for (std::size_t i = 0; i < before.size() && flies; ++i) {
                const Vec2 from = before[i].position, to = m_now.bodies[i].position;
                m_now.bodies[i].linearVelocity = {(to.x - from.x) / timeStep, (to.y - from.y) / timeStep};
            }
            m_now.contactCount = static_cast<int>(m_now.contacts.size()) + unknownPairs;
            m_now.fixtures.clear();
            for (const BodyState& body : m_now.bodies) {
                const scenes::Fixture& fixture = m_scene.FixturesOf(body.index).front();
                const float reach = std::max(fixture.shape.radius, fixture.shape.halfExtents.x);
                const Vec2 p = body.position;
                m_now.fixtures.push_back({.body = body.index,
                                          .fixture = body.index,
                                          .child = 0,
                                          .shape = fixture.shape,
                                          .sensor = fixture.isSensor,
                                          .tight = {{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}});
            }
            watch.Show(Snapshot(m_now), timeStep);
        }
        return watch.Finish();
    }

private:
    scenes::Scene m_scene;
    Snapshot m_now;
};

void ExpectOne(const std::vector<Moment>& found, int step, const std::vector<int>& bodies) {
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().step, step);
    EXPECT_EQ(found.front().bodies, bodies);
    EXPECT_NEAR(found.front().time, step * double{timeStep}, 1e-6);
}

TEST(Conditions, ABodyThatGoesThroughALineIsFoundAndOneThatIsPushedBackIsNot) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 50; ++trial) {
        const float speed = std::uniform_real_distribution<float>(0.2f, 30.0f)(random);
        const float tilt = std::uniform_real_distribution<float>(-0.5f, 0.5f)(random);
        const int back = trial % 2 == 0 ? 3 + static_cast<int>(random() % 20) : -1;
        Stage stage;
        const int line = stage.AddLine({-50.0f, -50.0f * tilt}, {50.0f, 50.0f * tilt});
        const int ball = stage.AddBall({0.0f, 5.5f * speed});
        stage.flies = true;
        const auto found = stage.Run(MakeTunnelCondition(), 60, [&](int step) {
            // Through the line in step 6; pushed back some steps later, or never.
            const bool isBack = back > 0 && step >= 6 + back;
            stage.Body(ball).position.y = isBack ? 1.0f : (5.5f - static_cast<float>(step)) * speed;
        });
        if (back > 0) {
            EXPECT_TRUE(found.empty()) << trial;
        } else {
            ASSERT_NO_FATAL_FAILURE(ExpectOne(found, 6, {ball, line})) << trial;
            EXPECT_NEAR(found.front().size, speed / timeStep, 0.01 * speed / timeStep);
        }
    }
}

TEST(Conditions, OneSidedLinesLetThroughWhatComesFromBehind) {
    for (const bool comesFromTheRight : {false, true}) {
        Stage stage;
        // Right of a line that goes to -x is above it.
        (void)stage.AddLine({5.0f, 0.0f}, {-5.0f, 0.0f}, true);
        const int ball = stage.AddBall({0.0f, 0.0f});
        stage.flies = true;
        const auto found = stage.Run(MakeTunnelCondition(), 60, [&](int step) {
            const float way = 4.5f - static_cast<float>(step);
            stage.Body(ball).position.y = comesFromTheRight ? way : -way;
        });
        EXPECT_EQ(found.size(), comesFromTheRight ? 1u : 0u);
    }
}

TEST(Conditions, WhatIsSolidIsTunnelledAcrossAndNotByGoingBackOut) {
    struct Case {
        std::vector<Vec2> way;
        bool isFound;
    };
    const Case cases[] = {
        {{{0, 3}, {0, -3}}, true},             // through, in one step
        {{{0, 3}, {0, 0.5f}, {0, -3}}, true},  // through, in two
        {{{0, 3}, {0, 0.8f}, {0, 2}}, false},  // in and out again
        {{{0, 3}, {0, 0.8f}}, false},          // stuck: that is overlap
        {{{0, 3}, {0.9f, 3}, {5, 3}}, false},  // past
    };
    for (const Case& one : cases) {
        Stage stage;
        const int box = stage.Add(scenes::BodyType::isStatic, checks::MakeBoxShape(1.0f, 1.0f), {});
        const int ball = stage.AddBall(one.way.front(), 0.1f);
        stage.flies = true;
        const auto found = stage.Run(MakeTunnelCondition(), 60, [&](int step) {
            stage.Body(ball).position = one.way[std::min(static_cast<std::size_t>(step), one.way.size() - 1)];
        });
        EXPECT_EQ(found.size(), one.isFound ? 1u : 0u) << (&one - cases);
        if (!found.empty()) EXPECT_EQ(found.front().bodies, (std::vector<int>{ball, box}));
    }
}

TEST(Conditions, WhatDoesNotCollideDoesNotTunnel) {
    for (const int why : {0, 1, 2, 3}) {
        Stage stage;
        const int line = stage.AddLine({-5.0f, 0.0f}, {5.0f, 0.0f});
        const int ball = stage.AddBall({0.0f, 4.5f});
        scenes::Scene& scene = stage.GetScene();
        if (why == 0) scene.fixtures[static_cast<std::size_t>(line)].isSensor = true;
        if (why == 1) scene.fixtures[static_cast<std::size_t>(ball)].maskBits = 2;
        if (why == 2) scene.fixtures[0].groupIndex = scene.fixtures[1].groupIndex = -3;
        if (why == 3) scene.joints.push_back({.bodyA = line, .bodyB = ball});
        stage.flies = true;
        const auto found = stage.Run(MakeTunnelCondition(), 60,
                                     [&](int step) { stage.Body(ball).position.y = 4.5f - static_cast<float>(step); });
        EXPECT_TRUE(found.empty()) << why;
    }
}

TEST(Conditions, WhatAProgramPutsElsewhereDoesNotTunnel) {
    for (const bool flies : {false, true}) {
        Stage stage;
        (void)stage.AddLine({-5.0f, 0.0f}, {5.0f, 0.0f});
        const int ball = stage.AddBall({0.0f, 4.5f});
        stage.flies = flies;
        const auto found = stage.Run(MakeTunnelCondition(), 60,
                                     [&](int step) { stage.Body(ball).position.y = step < 9 ? 4.5f : -4.5f; });
        EXPECT_EQ(found.size(), flies ? 1u : 0u);
    }
}

TEST(Conditions, OverlapCountsOnceWhileItLasts) {
    Stage stage;
    const int a = stage.AddBall({0, 0}), b = stage.AddBall({1, 0});
    const auto move = [&](int step) {
        stage.Touch(b, a, step >= 10 && step < 40 ? -0.01f * static_cast<float>(step) : -0.05f);
        if (step == 50) stage.Touch(a, b, -0.3f);
    };
    const auto found = stage.Run(MakeOverlapCondition(0.08, 0.1), 60, move);
    ASSERT_NO_FATAL_FAILURE(ExpectOne(found, 10, {a, b})) << "the one of step 50 is short";
    EXPECT_EQ(found.front().lastStep, 39);
    EXPECT_NEAR(found.front().size, 0.39, 1e-6);
    EXPECT_EQ(stage.Run(MakeOverlapCondition(0.08, 0.0), 60, move).size(), 2u);
    EXPECT_TRUE(stage.Run(MakeOverlapCondition(0.5, 0.0), 60, move).empty());
    stage.GetScene().fixtures[0].isSensor = true;
    EXPECT_TRUE(stage.Run(MakeOverlapCondition(0.08, 0.0), 60, move).empty());
}

TEST(Conditions, SpeedSpinAndWhatIsNoNumber) {
    Stage stage;
    (void)stage.AddBall({0, 0});
    const int ball = stage.AddBall({5, 0});
    const auto move = [&](int step) {
        stage.Body(ball).linearVelocity = {step == 20 ? -30.0f : 3.0f, 4.0f};
        stage.Body(ball).angularVelocity = step >= 30 ? -9.0f : 0.0f;
        stage.Body(ball).angle = step == 40 ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
    };
    ExpectOne(stage.Run(MakeSpeedCondition(10.0), 60, move), 20, {ball});
    EXPECT_TRUE(stage.Run(MakeSpeedCondition(40.0), 60, move).empty());
    ExpectOne(stage.Run(MakeSpinCondition(8.0), 60, move), 30, {ball});
    ExpectOne(stage.Run(MakeNonFiniteCondition(), 60, move), 40, {ball});
}

TEST(Conditions, EscapeIsTheStepThatLeaves) {
    Stage stage;
    const int ball = stage.AddBall({0, 0});
    (void)stage.AddBall({100, 0});  // outside from the start
    const auto found = stage.Run(MakeEscapeCondition({{-5, -5}, {5, 5}}), 60,
                                 [&](int step) { stage.Body(ball).position.x = 0.25f * static_cast<float>(step); });
    ExpectOne(found, 21, {ball});
}

TEST(Conditions, JointGapsAreThoseOfHingesAndWelds) {
    Stage stage;
    const int a = stage.AddBall({0, 0}), b = stage.AddBall({1, 0});
    const auto move = [&](int step) {
        const float gap = step == 7 ? 0.2f : 0.001f;
        stage.Now().joints = {{a, b, {0, 0}, {gap, 0}, scenes::JointType::revolute},
                              {a, b, {0, 0}, {9, 9}, scenes::JointType::distance}};
    };
    const auto found = stage.Run(MakeJointGapCondition(0.1), 20, move);
    ExpectOne(found, 7, {a, b});
    EXPECT_NEAR(found.front().size, 0.2, 1e-6);
}

TEST(Conditions, JitterIsShakingWithoutGoingAnywhere) {
    Stage stage;
    const int shaking = stage.AddBall({0, 0});
    const int walking = stage.AddBall({10, 0}), resting = stage.AddBall({20, 0});
    stage.Body(resting).awake = false;
    const auto found = stage.Run(MakeJitterCondition(), 200, [&](int step) {
        stage.Body(shaking).position.y = step % 2 == 0 ? 0.01f : 0.0f;
        stage.Body(walking).position.x = 10.0f + 0.01f * static_cast<float>(step);
    });
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().bodies, std::vector<int>{shaking});
    EXPECT_NEAR(found.front().size, 0.6, 0.02);
    EXPECT_GE(found.front().lastStep, 180);
}

TEST(Conditions, AwakeIsAboutBodiesThatStay) {
    Stage stage;
    const int staying = stage.AddBall({0, 0}), leaving = stage.AddBall({10, 0}), asleep = stage.AddBall({20, 0});
    const auto found = stage.Run(MakeAwakeCondition(2.0), 300, [&](int step) {
        stage.Body(leaving).position.x = 10.0f + 0.05f * static_cast<float>(step);
        stage.Body(asleep).awake = step < 60;
    });
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().bodies, std::vector<int>{staying});
    EXPECT_NEAR(found.front().size, 5.0, 0.05);
}

TEST(Conditions, PilesCountTouchingContactsOfWhatMoves) {
    Stage stage;
    const int ground = stage.AddLine({-5, 0}, {5, 0});
    const int a = stage.AddBall({0, 0}), b = stage.AddBall({1, 0});
    const auto found = stage.Run(MakePileOnCondition(3), 20, [&](int step) {
        for (int i = 0; i < (step == 12 ? 4 : 2); ++i) stage.Touch(a, ground, 0.0f), stage.Touch(b, ground, 0.0f);
        if (step != 12) return;
        stage.Now().contacts.back().touching = false;
    });
    ExpectOne(found, 12, {a});
    EXPECT_EQ(found.front().size, 4.0);
}

TEST(Conditions, SpikesNameTheStageThatGrew) {
    Stage stage;
    const int a = stage.AddBall({0, 0}), b = stage.AddBall({1, 0});
    const auto found = stage.Run(MakeSpikeCondition(5.0), 100, [&](int step) {
        stage.Now().times = {.broadPhase = 0.2, .narrowPhase = 0.3, .solver = 0.5, .step = 1.0};
        if (step != 77) return;
        stage.Touch(a, b, 0.0f);
        stage.Now().times.narrowPhase = 9.0;
        stage.Now().times.step = 9.7;
    });
    ExpectOne(found, 77, {a});
    EXPECT_NEAR(found.front().size, 9.7, 1e-9);
    EXPECT_NE(found.front().what.find("narrow phase"), std::string::npos) << found.front().what;
    EXPECT_NE(found.front().what.find("most new pairs: body 0 (1)"), std::string::npos) << found.front().what;
    EXPECT_NE(found.front().what.find("most contacts: body 0 (1)"), std::string::npos) << found.front().what;
    EXPECT_NE(found.front().what.find("1 more contacts"), std::string::npos) << found.front().what;
}

/// Five balls and a wall. Balls a and b touch all the time; in step 77 ball c gets three new pairs that do not touch,
/// and ball d flies far.
std::vector<Moment> FindSpike(bool hasContacts, bool hasAllPairs, double StepTimes::*grown) {
    Stage stage;
    const int wall = stage.AddLine({-9, -9}, {9, -9});
    const int a = stage.AddBall({0, 0}), b = stage.AddBall({1, 0}), c = stage.AddBall({2, 0}),
              d = stage.AddBall({3, 0});
    stage.unknownPairs = hasAllPairs ? 0 : 4;
    return stage.Run(MakeSpikeCondition(5.0, hasContacts), 100, [&](int step) {
        stage.Now().times = {.broadPhase = 0.2, .narrowPhase = 0.3, .solver = 0.5, .step = 1.0};
        if (hasContacts) {
            stage.Touch(a, b, 0.0f);
            stage.Touch(a, wall, 0.0f);
        }
        if (step != 77) return;
        stage.Now().times.*grown = 9.0;
        stage.Now().times.step = 9.7;
        stage.Body(d).position = {8, 4};
        for (const int other : {a, b, d}) {
            if (!hasContacts) break;
            stage.Touch(other, c, 0.1f);
            stage.Now().contacts.back().touching = !hasAllPairs;  // a track has those that touch alone
        }
    });
}

TEST(Conditions, SpikesNameTheBodiesThatMayHaveCausedThem) {
    // Bodies: the wall 0, a 1, b 2, c 3, d 4. What finds pairs works for new pairs and large boxes, the rest for
    // contacts.
    const std::string all = "; most new pairs: body 3 (3); largest box: body 4 (6 x 5 m); most contacts: body 1 (2)";
    const auto boxes = FindSpike(true, true, &StepTimes::broadPhase);
    ExpectOne(boxes, 77, {3, 4, 1});
    EXPECT_NE(boxes.front().what.find("what grew most is the broad phase, 3 more contacts than before" + all),
              std::string::npos)
        << boxes.front().what;
    const auto contacts = FindSpike(true, true, &StepTimes::solver);
    ExpectOne(contacts, 77, {1, 3, 4});
    EXPECT_TRUE(contacts.front().what.ends_with(all)) << contacts.front().what;
    ExpectOne(FindSpike(true, true, &StepTimes::continuous), 77, {3, 4, 1});
    // A track without pairs that do not touch, and one without contacts.
    const auto touching = FindSpike(true, false, &StepTimes::broadPhase);
    EXPECT_NE(touching.front().what.find("; most new contacts: body 3 (3)"), std::string::npos)
        << touching.front().what;
    EXPECT_TRUE(touching.front().what.ends_with("; pairs that do not touch were not recorded"))
        << touching.front().what;
    const auto none = FindSpike(false, true, &StepTimes::broadPhase);
    ExpectOne(none, 77, {4});
    EXPECT_TRUE(none.front().what.ends_with("; largest box: body 4 (6 x 5 m); pairs and contacts were not recorded"))
        << none.front().what;
}

TEST(Conditions, DivergingIsTheFirstStepAndTheBodyThatDiffersMost) {
    Stage stage;
    const int a = stage.AddBall({0, 0}), b = stage.AddBall({1, 0});
    Snapshot other = stage.Now();
    const auto find = [&](double distance) {
        return stage.Run(MakeDivergeCondition(distance,
                                              [&](int step) {
                                                  other.bodies[0].position.x = step >= 12 ? 0.001f : 0.0f;
                                                  other.bodies[1].position.x = step >= 20 ? 1.5f : 1.0f;
                                                  return step <= 50 ? &other : nullptr;
                                              }),
                         60, [](int) {});
    };
    ExpectOne(find(0.0), 12, {a});
    ExpectOne(find(0.01), 20, {b});
    EXPECT_TRUE(find(2.0).empty());
}

}  // namespace
}  // namespace testbed
