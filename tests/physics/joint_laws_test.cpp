// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of jointed bodies: the pendulum's period and pull, a spring's amplitude, the catenary of a bridge, the pull and
// the stretch of loaded chains.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scree/scree.h"
#include "testbed/engines/measure.h"
#include "tests/physics/lab.h"

namespace scree::test {
namespace {

struct Pendulum {
    double firstPeriod = 0.0, period = 0.0, bottomPull = 0.0, pin = 0.0;
};

/// A rod 1 × 0.1 on its end, released at 90°, for ten seconds.
template <class E>
Pendulum SwingRod() {
    Lab<E> lab;
    auto* rod = lab.Dynamic(0.5, 0.0);
    AttachBox<E>(rod, 0.5, 0.05);
    const auto pin = lab.Hinge(lab.Static(), rod, 0.0, 0.0);
    const double weight = static_cast<double>(rod->GetMass()) * g;
    Pendulum result;
    std::vector<double> passes;  // times of downward passes through the vertical
    double before = 0.5 * circleRatio;
    for (int i = 0; i < 10 * stepRate; ++i) {
        lab.Step();
        const double after = Angle(rod) + 0.5 * circleRatio;
        if (before > 0.0 && after <= 0.0) passes.push_back(h * (i + before / (before - after)));
        if (i < stepRate) result.bottomPull = std::max(result.bottomPull, pin.Pull() / weight);
        result.pin = std::max(result.pin, pin.Gap());
        before = after;
    }
    result.firstPeriod = passes.at(1) - passes.at(0);
    result.period = (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
    return result;
}

TEST(JointLaws, ARodPendulumKeepsItsPeriodAndPullsAtTheBottom) {
    const auto rod = Measure([]<class E>(E) { return SwingRod<E>(); });
    // T = 4·√(I/(m·g·d))·K(sin 45°). A pin held along the tangent of a step loses amplitude, to first order in h, and a
    // smaller swing is a shorter one. So 1 % is out of reach at 60 Hz, and the mean of ten seconds is bounded by
    // Box2D's.
    Judge({"rod pendulum from 90°: first period, s", 1.91727, 0.05 * 1.91727, 1e-4}, Pick(rod, &Pendulum::firstPeriod));
    Judge({"rod pendulum from 90°: mean period of 10 s, s", 1.91727, unbounded, 1e-4}, Pick(rod, &Pendulum::period));
    Judge({"rod pendulum from 90°: pull at the bottom, weights", 2.49626, 0.05 * 2.49626, 1e-4},
          Pick(rod, &Pendulum::bottomPull));
    Judge({"rod pendulum from 90°: worst gap of the pin, m", 0.0, 1e-3, 1e-5}, Pick(rod, &Pendulum::pin));
}

TEST(JointLaws, ASpringOfTwoHertzLosesItsAmplitudeAsImplicitEulerDoes) {
    const double omega = 2.0 * circleRatio * 2.0;
    const auto left = Measure([omega]<class E>(E) {
        Lab<E> lab(0.0);
        auto* wall = lab.Static();
        auto* mass = lab.Dynamic(2.5, 0.0);
        AttachDisk<E>(mass, 0.2);
        typename E::DistanceJointDef def;
        def.bodyA = wall;
        def.bodyB = mass;
        def.length = 2.0f;
        def.stiffness = static_cast<float>(static_cast<double>(mass->GetMass()) * omega * omega);
        lab.world.CreateJoint(&def);
        lab.Step(stepRate / 2);  // one period
        return std::hypot(Centre(mass).x - 2.0, Speed(mass).x / omega) / 0.5;
    });
    Judge({"spring of 2 Hz: amplitude after one period, relative", 1.0, 0.5, 1e-4}, left);
    // Implicit Euler multiplies the amplitude by 1/√(1 + (ωh)²) in each step.
    const double discrete = std::pow(1.0 + omega * h * omega * h, -0.25 * stepRate);
    Judge({"spring of 2 Hz: the same by the discrete closed form", discrete, 1e-3, 1e-4, true}, left);
}

struct Driven {
    double speed = 0.0, stop = 0.0;
};

/// An arm turned by a motor from 0 into a limit of 1.5 or −1 rad.
template <class E>
Driven DriveArm(double motorSpeed) {
    Lab<E> lab(0.0);
    auto* arm = lab.Dynamic(1.0, 0.0);
    AttachBox<E>(arm, 1.0, 0.1);
    typename E::RevoluteJointDef def;
    def.Initialize(lab.Static(), arm, Lab<E>::At(0.0, 0.0));
    def.enableMotor = true;
    def.motorSpeed = static_cast<float>(motorSpeed);
    def.maxMotorTorque = 100.0f;
    def.enableLimit = true;
    def.lowerAngle = -1.0f;
    def.upperAngle = 1.5f;
    lab.world.CreateJoint(&def);
    Driven driven;
    lab.Step(20);
    driven.speed = Spin(arm);
    lab.Step(120);
    driven.stop = Angle(arm);
    return driven;
}

TEST(JointLaws, AMotorReachesItsSpeedAndLimitsHold) {
    const double slop = static_cast<double>(angularSlop);
    const auto forward = Measure([]<class E>(E) { return DriveArm<E>(2.0); });
    const auto back = Measure([]<class E>(E) { return DriveArm<E>(-2.0); });
    // The point is solved after the motor and disturbs it a little.
    Judge({"driven arm: speed under a motor of 2 rad/s, rad/s", 2.0, 1e-3, 1e-5}, Pick(forward, &Driven::speed));
    Judge({"driven arm: stop at an upper limit of 1.5, rad", 1.5, slop, 1e-5}, Pick(forward, &Driven::stop));
    Judge({"driven arm: stop at a lower limit of -1, rad", -1.0, slop, 1e-5}, Pick(back, &Driven::stop));
}

struct Bridge {
    double sag = 0.0, pull = 0.0, gap = 0.0;
};

/// Hangs links in the exact shape and lets them find their own, damped so that they come to rest.
template <class E>
Bridge HangBridge(const testbed::Catenary& shape) {
    Lab<E> lab;
    double span = 0.0;
    for (const double angle : shape.angle) span += std::cos(angle);
    std::vector<Pin<E>> pins;
    std::vector<typename E::Body*> bodies;
    auto* before = lab.Static();
    Point end;
    for (const double angle : shape.angle) {
        const Point next = end + Point{std::cos(angle), std::sin(angle)};
        auto* link = lab.Dynamic(0.5 * (end.x + next.x), 0.5 * (end.y + next.y), angle);
        AttachBox<E>(link, 0.5, 0.0625);
        link->SetLinearDamping(1.0f);
        link->SetAngularDamping(1.0f);
        pins.push_back(lab.Hinge(before, link, end.x, end.y));
        bodies.push_back(link);
        before = link;
        end = next;
    }
    pins.push_back(lab.Hinge(before, lab.Static(span, 0.0), span, 0.0));
    lab.Step(8 * stepRate);
    for (auto* link : bodies) {  // implicit damping also takes its share of each step's gravity
        link->SetLinearDamping(0.0f);
        link->SetAngularDamping(0.0f);
    }
    lab.Step(2 * stepRate);
    const double weight = static_cast<double>(bodies.front()->GetMass()) * g;
    Bridge bridge;
    for (int i = 0; i < 30; ++i) {
        lab.Step();
        bridge.pull += 0.5 * (pins.front().Pull() + pins.back().Pull()) / weight / 30.0;
    }
    for (const Pin<E>& pin : pins) {
        bridge.sag = std::max(bridge.sag, -pin.AnchorB().y);
        bridge.gap = std::max(bridge.gap, pin.Gap());
    }
    return bridge;
}

TEST(JointLaws, ABridgeHangsInItsCatenary) {
    for (const int links : {20, 40}) {
        const testbed::Catenary exact = testbed::SolveCatenary(links, 0.8 * links);
        if (links == 40) {
            EXPECT_NEAR(exact.sag, 10.6210, 1e-4);
            EXPECT_NEAR(exact.endPull, 24.1443, 1e-4);
        }
        const auto bridge = Measure([&]<class E>(E) { return HangBridge<E>(exact); });
        const std::string name = "bridge of " + std::to_string(links) + " links over 0.8 of their length: ";
        Judge({name + "sag, m", exact.sag, 0.01 * exact.sag, 1e-4}, Pick(bridge, &Bridge::sag));
        Judge({name + "pull at the ends, weights of a link", exact.endPull, 0.05 * exact.endPull, 1e-3},
              Pick(bridge, &Bridge::pull));
        Judge({name + "worst gap of a joint, m", 0.0, 5e-3, 1e-5}, Pick(bridge, &Bridge::gap));
    }
}

struct Chain {
    double pull = 0.0, gap = 0.0;
};

/// N links of length 1 with `load` times a link's mass at the end, hanging or starting from the horizontal.
template <class E>
Chain HangChain(int links, double load, bool swung, int steps) {
    Lab<E> lab;
    std::vector<Pin<E>> pins;
    auto* before = lab.Static();
    const Point way = swung ? Point{1.0, 0.0} : Point{0.0, -1.0};
    for (int i = 0; i < links; ++i) {
        const Point at = (i + 0.5) * way;
        auto* link = lab.Dynamic(at.x, at.y, swung ? 0.0 : -0.5 * circleRatio);
        AttachBox<E>(link, 0.5, 0.125);
        pins.push_back(lab.Hinge(before, link, i * way.x, i * way.y));
        before = link;
    }
    const double mass = static_cast<double>(before->GetMass()), radius = 0.5;
    const Point end = static_cast<double>(links) * way;
    auto* ball = lab.Dynamic(end.x, end.y);
    AttachDisk<E>(ball, radius, {load * mass / (circleRatio * radius * radius)});
    pins.push_back(lab.Hinge(before, ball, end.x, end.y));
    Chain chain;
    for (int i = 0; i < steps; ++i) {
        lab.Step();
        if (!swung && i < steps - 60) continue;
        for (size_t j = 0; j < pins.size(); ++j) {
            chain.gap = std::max(chain.gap, pins[j].Gap());
            // Joint j carries the links below it and the load.
            const double carried = (static_cast<double>(links) - static_cast<double>(j) + load) * mass * g;
            chain.pull = std::max(chain.pull, std::abs(pins[j].Pull() / carried - 1.0));
        }
    }
    return chain;
}

TEST(JointLaws, AHangingChainCarriesItsLoad) {
    // 8 sweeps a step gain a decade in 8 s under a load of 100.
    for (const double load : {10.0, 100.0}) {
        const auto chain = Measure([load]<class E>(E) { return HangChain<E>(10, load, false, 40 * stepRate); });
        const std::string name = "hanging chain of 10, end mass " + std::to_string(static_cast<int>(load)) + ": ";
        Judge({name + "worst joint pull after 40 s, relative error", 0.0, 1e-3, 1e-4}, Pick(chain, &Chain::pull));
        Judge({name + "worst stretch after 40 s, m", 0.0, 2e-3, 1e-5}, Pick(chain, &Chain::gap));
    }
}

TEST(JointLaws, ASwungChainStretchesNoMoreThanBox2ds) {
    // A load of 100 is beyond 8 sweeps (they would need about 2.3·N·R): only Box2D's own stretch bounds these.
    for (const double load : {10.0, 100.0}) {
        const auto chain = Measure([load]<class E>(E) { return HangChain<E>(10, load, true, 3 * stepRate); });
        const std::string name =
            "chain of 10 swung from horizontal, end mass " + std::to_string(static_cast<int>(load));
        Judge({name + ": peak stretch, m", 0.0, unbounded, 1e-5}, Pick(chain, &Chain::gap));
    }
}

TEST(JointLaws, AChainUnderAStrongPullDoesNotSwingItselfUp) {
    // Gravity stands for the pull: what counts is its square of the step over a link's length.
    for (const int substeps : {2, 4, 8, 16}) {
        for (const float pull : {130.0f, 310.0f, 470.0f, 720.0f, 1000.0f, 1400.0f}) {
            World world({0.0f, -pull});
            const BodyDef anchor;
            Body* before = world.CreateBody(&anchor);
            std::vector<Body*> links;
            for (int i = 0; i < 8; ++i) {
                BodyDef def;
                def.type = dynamicBody;
                def.position = {static_cast<float>(i) + 0.5f, 0.0f};
                Body* link = world.CreateBody(&def);
                PolygonShape box;
                box.SetAsBox(0.5f, 0.125f);
                FixtureDef fixture;
                fixture.shape = &box;
                fixture.density = 1.0f;
                fixture.filter.groupIndex = -1;  // links never collide
                link->CreateFixture(&fixture);
                RevoluteJointDef hinge;
                hinge.Initialize(before, link, {static_cast<float>(i), 0.0f});
                world.CreateJoint(&hinge);
                links.push_back(link);
                before = link;
            }
            double most = 0.0;
            for (int step = 0; step < 300; ++step) {
                world.Step(1.0f / 60.0f, substeps);
                double energy = 0.0;  // 0 at the start
                for (const Body* link : links) {
                    const double v = static_cast<double>(link->GetLinearVelocity().LengthSquared());
                    const double w = static_cast<double>(link->GetAngularVelocity());
                    const double height = static_cast<double>(link->GetWorldCenter().y);
                    energy += static_cast<double>(link->GetMass()) * (0.5 * v + static_cast<double>(pull) * height) +
                              0.5 * static_cast<double>(link->GetInertia()) * w * w;
                }
                most = std::max(most, energy);
            }
            // Two kilograms fall by four metres until they hang.
            const double fall = 2.0 * 4.0 * static_cast<double>(pull);
            // Most gain nothing; 8 sub-steps at 1000 m/s² gain 0.8 of it once. What swings itself up gains a thousand.
            EXPECT_LT(most, fall) << substeps << " sub-steps, " << pull << " m/s²";
        }
    }
}

}  // namespace
}  // namespace scree::test
