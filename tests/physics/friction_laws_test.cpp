// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Coulomb friction and tipping: threshold, sliding, creep, braking, slip to roll, rolling on a pulled box, the angle at
// which a box tips, each against its closed form.

#include <gtest/gtest.h>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

/// A box (half extents hx × hy) lying on an incline of slope `alpha` through the origin, both of friction μ.
template <class E>
typename E::Body* PutOnIncline(Lab<E>& lab, double alpha, double mu, Point half) {
    const Material rough{1.0, mu};
    AttachBox<E>(lab.Static(0.0, 0.0, alpha), 50.0, 0.5, rough);
    // Two skins of 1 cm less one slop apart, or, in the soft step, outlines that touch.
    const double height = 0.5 + half.y + (runsSoftStep ? 0.0 : 0.015);
    auto* box = lab.Dynamic(-std::sin(alpha) * height, std::cos(alpha) * height, alpha);
    AttachBox<E>(box, half.x, half.y, rough);
    return box;
}

/// How far the box slides in two seconds, after half a second to settle.
template <class E>
double Slide(double alpha, double mu) {
    Lab<E> lab;
    auto* box = PutOnIncline<E>(lab, alpha, mu, {0.5, 0.5});
    lab.Step(30);
    const Point start = Centre(box);
    lab.Step(120);
    return Length(Centre(box) - start);
}

/// The x in [low, high] from which on `holds` is true, to 1/1000 of the interval.
template <class Predicate>
double Bisect(double low, double high, const Predicate& holds) {
    for (int i = 0; i < 10; ++i) {
        const double mid = 0.5 * (low + high);
        (holds(mid) ? high : low) = mid;
    }
    return 0.5 * (low + high);
}

const double alpha = std::atan(0.5);

constexpr double polygonSkin = 0.01;  ///< m, of polygons and edges in both engines

TEST(FrictionLaws, ABoxOnAnInclineSlidesBelowMuEqualToTheSlope) {
    const auto threshold = Measure([]<class E>(E) {
        return Bisect(0.8, 1.2, [](double factor) { return Slide<E>(alpha, 0.5 * factor) < 0.01; });
    });
    // 1 cm in 2 s is a = 5 mm/s², 0.1 % of the threshold, and the bisection stops at 4e-4.
    Judge({"incline: friction at which it sticks, over the slope's tangent", 1.0, 0.02, 2e-3}, threshold);
}

TEST(FrictionLaws, ASlidingBoxAcceleratesByGSinMinusMuCos) {
    for (const double factor : {0.8, 0.9}) {
        const double mu = 0.5 * factor;
        const auto speed = Measure([mu]<class E>(E) {
            Lab<E> lab;
            auto* box = PutOnIncline<E>(lab, alpha, mu, {0.5, 0.5});
            lab.Step(30);
            const double before = Length(Speed(box));
            lab.Step(120);
            return (Length(Speed(box)) - before) / 2.0;
        });
        const double exact = g * (std::sin(alpha) - mu * std::cos(alpha));
        Judge({"incline: acceleration at " + std::to_string(factor).substr(0, 3) + " of the threshold, m/s²", exact,
               0.02 * exact, 1e-4 * exact},
              speed);
    }
}

TEST(FrictionLaws, AStickingBoxDoesNotCreep) {
    for (const double factor : {1.05, 1.2}) {
        const auto creep = Measure([factor]<class E>(E) {
            Lab<E> lab;
            auto* box = PutOnIncline<E>(lab, alpha, 0.5 * factor, {0.5, 0.5});
            lab.Step(60);
            const Point start = Centre(box);
            lab.Step(600);
            return Length(Centre(box) - start);
        });
        Judge({"incline: creep in 10 s at " + std::to_string(factor).substr(0, 4) + " of the threshold, m", 0.0, 5e-3,
               1e-5},
              creep);
    }
}

TEST(FrictionLaws, SlidingStopsAfterVSquaredOver2MuG) {
    const auto way = Measure([]<class E>(E) {
        Lab<E> lab;
        lab.Ground(0.5);
        auto* box = lab.Dynamic(0.0, 0.515);
        AttachBox<E>(box, 0.5, 0.5, {1.0, 0.5});
        lab.Step(30);
        const double start = Centre(box).x;
        box->SetLinearVelocity(Lab<E>::At(8.0, 0.0));
        lab.Step(180);
        return Centre(box).x - start;
    });
    Judge({"slide to stop from 8 m/s, friction 0.5: way, m", 6.4, 0.02 * 6.4, 1e-4}, way);
}

TEST(FrictionLaws, ASlippingDiskRollsAtTwoThirdsOfItsSpeed) {
    struct Roll {
        double speed = 0.0, time = 0.0, slip = 0.0, contactSlip = 0.0;
    };
    const double v0 = 6.0, mu = 0.2, radius = 0.5;
    const auto roll = Measure([=]<class E>(E) {
        Lab<E> lab;
        lab.Ground(mu);
        auto* disk = lab.Dynamic(0.0, radius + 0.005);
        AttachDisk<E>(disk, radius, {1.0, mu});
        lab.Step(30);
        disk->SetLinearVelocity(Lab<E>::At(v0, 0.0));
        disk->SetAngularVelocity(0.0f);
        Roll result;
        double slip = v0;
        for (int i = 0; i < 180; ++i) {
            lab.Step();
            const double now = Speed(disk).x + radius * Spin(disk);
            // Slip falls by 3μg·h per step until it is used up; the last, shorter stretch is interpolated.
            if (result.time == 0.0 && now < 1e-3) result.time = h * (i + slip / (3.0 * mu * g * h));
            slip = now;
        }
        result.speed = Speed(disk).x;
        result.slip = slip;
        // The contact point lies midway between the disk and the floor's skin, which overlap by a slop at rest.
        result.contactSlip = Speed(disk).x + 0.5 * (radius + Centre(disk).y - polygonSkin) * Spin(disk);
        return result;
    });
    const double time = v0 / (3.0 * mu * g);
    Judge({"slip to roll from 6 m/s: final speed, m/s", 4.0, 0.02 * 4.0, 1e-4}, Pick(roll, &Roll::speed));
    Judge({"slip to roll from 6 m/s: time to roll, s", time, 0.02 * time, 1e-4}, Pick(roll, &Roll::time));
    // The soft step lets a disk roll by its radius; its final speed above tells.
    Judge({"slip to roll from 6 m/s: slip at the contact point after 3 s, m/s", 0.0, 1e-4, 1e-5, true},
          Pick(roll, &Roll::contactSlip));
    // At the disk's own radius half a slop of overlap remains as slip: 4 m/s · 0.0025/0.4975.
    Judge({"slip to roll from 6 m/s: slip at the radius after 3 s, m/s", 0.0, 0.0205, 1e-5}, Pick(roll, &Roll::slip));
}

TEST(FrictionLaws, APulledBoxRollsTenDisksOnItsTop) {
    // The floor slows by μ(M + n·m)g; each disk rolls backward on the box and takes m·a/3 from it.
    const double force = 130.0, mu = 0.3, radius = 0.3;
    struct Result {
        double acceleration = 0.0, disks = 0.0, exact = 0.0;
    };
    const auto pull = Measure([=]<class E>(E) {
        Lab<E> lab;
        lab.Ground(mu * mu / 0.5);  // friction mixes by the geometric mean
        auto* box = lab.Dynamic(0.0, 0.515);
        AttachBox<E>(box, 8.0, 0.5, {1.0, 0.5});
        std::vector<typename E::Body*> disks;
        for (int i = 0; i < 10; ++i) {
            disks.push_back(lab.Dynamic(1.2 * i - 5.4, 1.015 + radius + 0.005));
            AttachDisk<E>(disks.back(), radius, {1.0, 0.5});
        }
        lab.Step(60);
        const int steps = 90;
        const double before = Speed(box).x;
        Result result;
        for (int i = 0; i < steps; ++i) {
            box->ApplyForceToCenter(Lab<E>::At(force, 0.0), true);
            lab.Step();
        }
        result.acceleration = (Speed(box).x - before) / (steps * h);
        for (const auto* disk : disks) result.disks += Speed(disk).x / (steps * h) / 10.0;
        const double boxMass = static_cast<double>(box->GetMass());
        const double diskMass = 10.0 * static_cast<double>(disks.front()->GetMass());
        result.exact = (force - mu * (boxMass + diskMass) * g) / (boxMass + diskMass / 3.0);
        return result;
    });
    const double exact = pull.ours.exact;
    Judge({"box with ten disks, pulled: acceleration of the box, m/s²", exact, 0.02 * exact, 1e-4 * exact},
          Pick(pull, &Result::acceleration));
    Judge({"box with ten disks, pulled: mean acceleration of the disks, m/s²", exact / 3.0, 0.02 * exact / 3.0,
           1e-4 * exact},
          Pick(pull, &Result::disks));
}

TEST(FrictionLaws, ABoxTipsWhereItsCentreLeavesItsFoot) {
    for (const double width : {0.3, 0.6}) {
        const double exact = width;  // tan α = w / h, the box being 1 m high
        const auto tangent = Measure([=]<class E>(E) {
            return Bisect(0.8 * exact, 1.2 * exact, [width](double slope) {
                Lab<E> lab;
                const double tilt = std::atan(slope);
                auto* box = PutOnIncline<E>(lab, tilt, 2.0, {0.5 * width, 0.5});
                lab.Step(240);
                return std::abs(Angle(box) - tilt) > 0.3;
            });
        });
        // The bisection ends at 4e-4 of the slope.
        Judge({"box " + std::to_string(width).substr(0, 3) + " × 1 on an incline: slope at which it tips", exact,
               0.05 * exact, 1e-3 * exact},
              tangent);
    }
}

}  // namespace
}  // namespace scree::test
