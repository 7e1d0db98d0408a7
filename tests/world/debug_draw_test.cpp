// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// DebugDraw makes the calls that Box2D 2.4.1 makes: the same kinds, places, sizes and colours.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/world/engines.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// One line per call, numbers to three digits.
template <class E>
class DrawLog : public E::Draw {
    using Vec = typename E::Vec;
    using Color = typename E::Color;

public:
    void DrawPolygon(const Vec* v, int n, const Color& c) override { Write("polygon", v, n, 0, c); }
    void DrawSolidPolygon(const Vec* v, int n, const Color& c) override { Write("solid polygon", v, n, 0, c); }
    void DrawCircle(const Vec& p, float radius, const Color& c) override { Write("circle", &p, 1, radius, c); }
    void DrawSolidCircle(const Vec& p, float radius, const Vec& axis, const Color& c) override {
        const Vec v[2] = {p, axis};
        Write("solid circle", v, 2, radius, c);
    }
    void DrawSegment(const Vec& p1, const Vec& p2, const Color& c) override {
        const Vec v[2] = {p1, p2};
        Write("segment", v, 2, 0, c);
    }
    void DrawTransform(const typename E::Transform& xf) override {
        const Vec v[2] = {xf.p, {xf.q.c, xf.q.s}};
        Write("transform", v, 2, 0, Color(0, 0, 0));
    }
    void DrawPoint(const Vec& p, float size, const Color& c) override { Write("point", &p, 1, size, c); }
    Log log;

private:
    static std::string Number(float x) {
        char text[32];
        std::snprintf(text, sizeof text, " %.3f", static_cast<double>(std::abs(x) < 5e-4f ? 0.0f : x));
        return text;
    }
    void Write(const char* what, const Vec* v, int n, float size, const Color& c) {
        std::string line = what;
        for (int i = 0; i < n; ++i) line += Number(v[i].x) + Number(v[i].y);
        line += " size" + Number(size) + " colour" + Number(c.r) + Number(c.g) + Number(c.b) + Number(c.a);
        log.push_back(line);
    }
};

template <class E>
struct Gallery {
    Gallery() : world({0.0f, -10.0f}) {
        Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0), EdgeOf<E>({-20, 0}, {20, 0}), 0);
        typename E::Edge oneSided;
        oneSided.SetOneSided({5, 9}, {4, 9}, {2, 9}, {1, 9});
        Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0), oneSided, 0);
        Attach<E>(MakeBody<E>(world, E::isDynamic, 0, 0.5f), BoxShape<E>(0.5f, 0.5f));
        Attach<E>(MakeBody<E>(world, E::isDynamic, 3, 4), CircleOf<E>(0.5f));
        Attach<E>(MakeBody<E>(world, E::isKinematic, 6, 4), BoxShape<E>(0.5f, 0.2f));
        Attach<E>(MakeBody<E>(world, E::isDynamic, 9, 4), BoxShape<E>(0.5f, 0.2f), 0.0f);  // no mass
        typename E::Body* disabled = MakeBody<E>(world, E::isDynamic, 12, 4);
        Attach<E>(disabled, CircleOf<E>(0.3f));
        disabled->SetEnabled(false);
        typename E::Body* asleep = MakeBody<E>(world, E::isDynamic, 15, 4);
        Attach<E>(asleep, CircleOf<E>(0.3f));
        asleep->SetAwake(false);
        const typename E::Vec loop[4] = {{-12, 6}, {-10, 6}, {-10, 8}, {-12, 8}};
        typename E::Chain chain;
        E::MakeLoop(chain, loop, 4);
        Attach<E>(MakeBody<E>(world, E::isStatic, 0, 0), chain, 0);
        world.Step(1.0f / 60.0f, 8, 3);
    }
    Log Drawn(uint32_t flags, bool sorted = true) {
        DrawLog<E> draw;
        draw.SetFlags(flags);
        world.SetDebugDraw(&draw);
        world.DebugDraw();
        // Body lists differ in where static bodies stand, so only the multiset is compared.
        if (sorted) std::sort(draw.log.begin(), draw.log.end());
        return draw.log;
    }
    typename E::World world;
};

/// Every kind of joint between its own pair of bodies; `limits` turns limits on.
template <class E>
Log DrawnJoints(bool limits) {
    typename E::World world({0.0f, 0.0f});
    int column = 0;
    std::vector<typename E::Body*> pair;
    const auto next = [&](auto& def) {
        const float x = 5.0f * static_cast<float>(column++);
        typename E::Body* a = MakeBody<E>(world, E::isDynamic, x, 1);
        typename E::Body* b = MakeBody<E>(world, E::isDynamic, x + 2, 2);
        Attach<E>(a, BoxShape<E>(0.4f, 0.2f));
        Attach<E>(b, BoxShape<E>(0.4f, 0.2f));
        a->SetTransform(a->GetPosition(), 0.3f);
        pair = {a, b};
        (void)def;
    };
    const auto at = [&](float dx, float dy) {
        return typename E::Vec(pair[0]->GetPosition().x + dx, pair[0]->GetPosition().y + dy);
    };
    typename E::DistanceJointDef distance;
    next(distance);
    distance.Initialize(pair[0], pair[1], at(0.1f, 0), at(2, 1));
    if (limits) {
        distance.minLength = 0.5f;
        distance.maxLength = 4.0f;
    }
    world.CreateJoint(&distance);
    typename E::RevoluteJointDef revolute;
    next(revolute);
    revolute.Initialize(pair[0], pair[1], at(1, 1));
    revolute.enableLimit = limits;
    revolute.lowerAngle = -0.5f;
    revolute.upperAngle = 1.0f;
    world.CreateJoint(&revolute);
    typename E::PrismaticJointDef prismatic;
    next(prismatic);
    prismatic.Initialize(pair[0], pair[1], at(1, 0), {0.6f, 0.8f});
    prismatic.enableLimit = limits;
    prismatic.lowerTranslation = -1.0f;
    prismatic.upperTranslation = 2.0f;
    world.CreateJoint(&prismatic);
    typename E::WheelJointDef wheel;
    next(wheel);
    wheel.Initialize(pair[0], pair[1], at(1, 0), {0.0f, 1.0f});
    wheel.enableLimit = limits;
    wheel.lowerTranslation = -1.0f;
    wheel.upperTranslation = 2.0f;
    world.CreateJoint(&wheel);
    typename E::PulleyJointDef pulley;
    next(pulley);
    pulley.Initialize(pair[0], pair[1], at(0, 5), at(2, 5), at(0, 0.2f), at(2, 1.2f), 1.5f);
    world.CreateJoint(&pulley);
    typename E::MouseJointDef mouse;
    next(mouse);
    mouse.bodyA = pair[0];
    mouse.bodyB = pair[1];
    mouse.target = at(2.5f, 1.5f);
    mouse.maxForce = 10.0f;
    mouse.stiffness = 5.0f;
    world.CreateJoint(&mouse);
    typename E::WeldJointDef weld;
    next(weld);
    weld.Initialize(pair[0], pair[1], at(1, 0.5f));
    world.CreateJoint(&weld);
    typename E::FrictionJointDef friction;
    next(friction);
    friction.Initialize(pair[0], pair[1], at(1, 0.5f));
    world.CreateJoint(&friction);
    typename E::MotorJointDef motor;
    next(motor);
    motor.Initialize(pair[0], pair[1]);
    world.CreateJoint(&motor);
    DrawLog<E> draw;
    draw.SetFlags(E::Draw::e_jointBit);
    world.SetDebugDraw(&draw);
    world.DebugDraw();
    return draw.log;
}

TEST(DebugDraw, JointsAreDrawnAsBox2DDrawsThem) {
    for (const bool limits : {false, true}) {
        const Log ours = DrawnJoints<Ours>(limits), theirs = DrawnJoints<Theirs>(limits);
        ASSERT_EQ(ours.size(), theirs.size()) << limits;
        for (size_t i = 0; i < ours.size(); ++i) EXPECT_EQ(ours[i], theirs[i]) << i << " " << limits;
    }
}

TEST(DebugDraw, ShapesHaveBox2DsFormsAndColours) {
    Gallery<Ours> ours;
    Gallery<Theirs> theirs;
    const Log log = ours.Drawn(Draw::e_shapeBit);
    EXPECT_EQ(log, theirs.Drawn(b2Draw::e_shapeBit));
    EXPECT_EQ(log.size(), 1u + 2u + 1u + 6u + 4u);
}

TEST(DebugDraw, CentresOfMassAreBox2Ds) {
    Gallery<Ours> ours;
    Gallery<Theirs> theirs;
    EXPECT_EQ(ours.Drawn(Draw::e_centerOfMassBit), theirs.Drawn(b2Draw::e_centerOfMassBit));
}

TEST(DebugDraw, PairsJoinTheCentresOfTouchingBoxes) {
    Gallery<Ours> ours;
    Gallery<Theirs> theirs;
    EXPECT_EQ(ours.Drawn(Draw::e_pairBit).size(), theirs.Drawn(b2Draw::e_pairBit).size());
}

TEST(DebugDraw, BoxesAreThoseOfTheBroadPhase) {
    Gallery<Ours> ours;
    Gallery<Theirs> theirs;
    EXPECT_EQ(ours.Drawn(Draw::e_aabbBit).size(), theirs.Drawn(b2Draw::e_aabbBit).size());
}

TEST(DebugDraw, FlagsAddUpAndNoneDrawsNothing) {
    Gallery<Ours> ours;
    EXPECT_TRUE(ours.Drawn(0).empty());
    size_t total = 0;
    for (uint32_t bit = 1; bit <= 16; bit *= 2) total += ours.Drawn(bit).size();
    EXPECT_EQ(ours.Drawn(31).size(), total);
    ours.world.SetDebugDraw(nullptr);
    ours.world.DebugDraw();
}

}  // namespace
}  // namespace scree::test
