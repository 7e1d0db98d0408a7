// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A laboratory for laws of mechanics: worlds of either engine under the same settings, bodies, and readings of their
// state in double. An experiment is a generic lambda over the engine; Measure runs it in both.

#pragma once

#include <cmath>
#include <vector>

#include "tests/physics/law_table.h"
#include "tests/world/engines.h"

namespace scree::test {

inline constexpr int stepRate = 60;          ///< 1/s
inline constexpr double h = 1.0 / stepRate;  ///< s
inline constexpr double g = 10.0;            ///< m/s²
inline constexpr double circleRatio = 3.14159265358979323846;

/// Gravity (0, −gravity). This library gets Box2D's caps of speed, so that both run under the same rules.
inline WorldDef WorldInput(Ours, double gravity) {
    WorldDef def;
    def.gravity = {0.0f, static_cast<float>(-gravity)};
    def.maxTranslation = maxTranslation;
    def.maxRotation = maxRotation;
    return def;
}
inline b2Vec2 WorldInput(Theirs, double gravity) { return {0.0f, static_cast<float>(-gravity)}; }

/// A point or vector in double.
struct Point {
    double x = 0.0, y = 0.0;
};
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double Dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double Cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double Length(Point a) { return std::hypot(a.x, a.y); }

template <class Vec>
Point Read(const Vec& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

template <class Body>
Point Centre(const Body* body) {
    return Read(body->GetWorldCenter());
}
template <class Body>
Point Speed(const Body* body) {
    return Read(body->GetLinearVelocity());
}
template <class Body>
double Spin(const Body* body) {
    return static_cast<double>(body->GetAngularVelocity());
}
template <class Body>
double Angle(const Body* body) {
    return static_cast<double>(body->GetAngle());
}

/// A body's point in world coordinates, turned in double.
template <class Body>
Point WorldPoint(const Body* body, Point local) {
    const double c = std::cos(Angle(body)), s = std::sin(Angle(body));
    return Read(body->GetPosition()) + Point{c * local.x - s * local.y, s * local.x + c * local.y};
}

/// A hinge and what it holds together.
template <class E>
struct Pin {
    typename E::Joint* joint;
    typename E::Body *bodyA, *bodyB;
    Point localA, localB;  ///< anchors, from the bodies' origins

    [[nodiscard]] Point AnchorA() const { return WorldPoint(bodyA, localA); }
    [[nodiscard]] Point AnchorB() const { return WorldPoint(bodyB, localB); }
    [[nodiscard]] double Gap() const { return Length(AnchorA() - AnchorB()); }
    [[nodiscard]] double Pull() const { return Length(Read(joint->GetReactionForce(static_cast<float>(stepRate)))); }
};

/// Laboratories of this library run the soft step instead of sequential impulses.
inline bool runsSoftStep = false;

/// A world without sleep: no law stops to hold because something rests.
template <class E>
struct Lab {
    using World = typename E::World;
    using Body = typename E::Body;
    using Vec = typename E::Vec;

    explicit Lab(double gravity = g) : world(WorldInput(E{}, gravity)) { world.SetAllowSleeping(false); }

    static Vec At(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

    Body* Add(typename E::BodyType type, double x, double y, double angle = 0.0) {
        typename E::BodyDef def;
        def.type = type;
        def.position = At(x, y);
        def.angle = static_cast<float>(angle);
        return world.CreateBody(&def);
    }
    Body* Dynamic(double x, double y, double angle = 0.0) { return Add(E::isDynamic, x, y, angle); }
    Body* Static(double x = 0.0, double y = 0.0, double angle = 0.0) { return Add(E::isStatic, x, y, angle); }

    /// A two-sided edge along y = 0 with the given friction.
    Body* Ground(double friction = 0.2) {
        Body* ground = Static();
        const auto edge = EdgeOf<E>(At(-500.0, 0.0), At(500.0, 0.0));
        ground->CreateFixture(&edge, 0.0f)->SetFriction(static_cast<float>(friction));
        return ground;
    }

    Pin<E> Hinge(Body* a, Body* b, double x, double y) {
        typename E::RevoluteJointDef def;
        def.Initialize(a, b, At(x, y));
        return {world.CreateJoint(&def), a, b, Read(def.localAnchorA), Read(def.localAnchorB)};
    }

    void Step(int steps = 1, double dt = h) {
        for (int i = 0; i < steps; ++i) {
            if constexpr (std::is_same_v<E, Ours>) {
                if (runsSoftStep) {
                    world.Step(static_cast<float>(dt), Accuracy::game);
                    continue;
                }
            }
            world.Step(static_cast<float>(dt), 8, 3);
        }
    }

    World world;
};

struct Material {
    double density = 1.0, friction = 0.2, restitution = 0.0, restitutionThreshold = 1.0;
};

template <class E, class Shape>
void AttachShape(typename E::Body* body, const Shape& shape, const Material& material) {
    typename E::FixtureDef def;
    def.shape = &shape;
    def.density = static_cast<float>(material.density);
    def.friction = static_cast<float>(material.friction);
    def.restitution = static_cast<float>(material.restitution);
    def.restitutionThreshold = static_cast<float>(material.restitutionThreshold);
    body->CreateFixture(&def);
}

template <class E>
void AttachBox(typename E::Body* body, double hx, double hy, const Material& material = {}) {
    AttachShape<E>(body, BoxShape<E>(static_cast<float>(hx), static_cast<float>(hy)), material);
}

template <class E>
void AttachDisk(typename E::Body* body, double radius, const Material& material = {}) {
    AttachShape<E>(body, CircleOf<E>(static_cast<float>(radius)), material);
}

/// Conserved quantities of a set of bodies whose centre of mass is their origin.
struct Invariants {
    double kinetic = 0.0, angular = 0.0;
    Point momentum;
};

template <class Body>
Invariants Sum(const std::vector<Body*>& bodies) {
    Invariants sum;
    for (const Body* body : bodies) {
        const double m = static_cast<double>(body->GetMass()), inertia = static_cast<double>(body->GetInertia());
        const Point v = Speed(body), c = Centre(body);
        const double w = Spin(body);
        sum.momentum = sum.momentum + m * v;
        sum.angular += m * Cross(c, v) + inertia * w;
        sum.kinetic += 0.5 * m * Dot(v, v) + 0.5 * inertia * w * w;
    }
    return sum;
}

/// Runs an experiment, a lambda [](auto engine), in both engines, in ours by either solver.
template <class Experiment>
auto Measure(const Experiment& experiment) {
    using Result = decltype(experiment(Ours{}));
    Both<Result> both{experiment(Ours{}), experiment(Theirs{}), {}};
    runsSoftStep = true;
    both.soft = experiment(Ours{});
    runsSoftStep = false;
    return both;
}

/// One quantity out of both results.
template <class T>
Both<double> Pick(const Both<T>& both, double T::*field) {
    return {both.ours.*field, both.box2d.*field, both.soft.*field};
}

}  // namespace scree::test
