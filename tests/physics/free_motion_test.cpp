// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Free flight and spin, against the parabola, its discrete form under semi-implicit Euler and θ = ωt; and what isolated
// systems keep: momentum, angular momentum, energy.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

/// A projectile thrown with (10, 20) m/s, after 4 s: distances from two forms of the parabola, energy per kg.
struct Flight {
    double miss = 0.0, discreteMiss = 0.0, energy = 0.0;
};

template <class E>
Flight Throw(int rate) {
    Lab<E> lab;
    auto* ball = lab.Dynamic(0.0, 0.0);
    AttachDisk<E>(ball, 0.1);
    ball->SetLinearVelocity(Lab<E>::At(10.0, 20.0));
    const int steps = 4 * rate;
    const double dt = 1.0 / rate;
    lab.Step(steps, dt);
    const Point p = Centre(ball), v = Speed(ball);
    const double discreteY = 20.0 * 4.0 - g * dt * dt * steps * (steps + 1) / 2.0;
    return {Length(p - Point{40.0, 0.0}), Length(p - Point{40.0, discreteY}), 0.5 * Dot(v, v) + g * p.y};
}

TEST(FreeMotion, AProjectileFollowsTheParabola) {
    const auto flight = Measure([]<class E>(E) { return Throw<E>(stepRate); });
    // Semi-implicit Euler falls short of the parabola by g·h·t/2 = 0.333 m.
    Judge({"projectile: miss of (40, 0) after 4 s, m", 0.0, 0.34}, Pick(flight, &Flight::miss));
    // What remains against its own discrete form is 240 additions of floats up to 40 (an ulp there is 4e-6).
    Judge({"projectile: miss of the discrete parabola, m", 0.0, 1e-3, 1e-4, true}, Pick(flight, &Flight::discreteMiss));
    // The energy is short by what that fall is worth, g·0.333 of 250 J/kg.
    Judge({"projectile: energy after 4 s, J/kg", 250.0, 3.4}, Pick(flight, &Flight::energy));
}

TEST(FreeMotion, TheErrorOfFreeFlightIsOfFirstOrderInTheStep) {
    // The soft step's error is the rounding of floats, without an order.
    const auto order = Measure([]<class E>(E) { return std::log2(Throw<E>(60).miss / Throw<E>(120).miss); });
    Judge({"order of convergence of free flight, h 1/60 to 1/120", 1.0, 0.1, 1e-3, true}, order);
    const auto finer = Measure([]<class E>(E) { return std::log2(Throw<E>(120).miss / Throw<E>(240).miss); });
    Judge({"order of convergence of free flight, h 1/120 to 1/240", 1.0, 0.1, 1e-3, true}, finer);
}

/// Turn angle read from the rotation matrix, with the number of whole turns from the angle.
template <class E>
double TurnOf(const typename E::Body* body) {
    const auto& q = body->GetTransform().q;
    const double part = std::atan2(static_cast<double>(q.s), static_cast<double>(q.c));
    return part + 2.0 * circleRatio * std::round((Angle(body) - part) / (2.0 * circleRatio));
}

TEST(FreeMotion, FreeSpinKeepsItsRate) {
    for (const double rate : {5.0, 20.0, 40.0}) {
        const auto turn = Measure([rate]<class E>(E) {
            Lab<E> lab(0.0);
            auto* box = lab.Dynamic(0.0, 0.0);
            AttachBox<E>(box, 0.5, 0.2);
            box->SetAngularVelocity(static_cast<float>(rate));
            lab.Step(10 * stepRate);
            return TurnOf<E>(box);
        });
        // 600 additions, each rounded to half an ulp of the sum: ≤ 600·1.5e-5 at 400 rad, far below 1 %.
        Judge({"free spin " + std::to_string(static_cast<int>(rate)) + " rad/s: angle after 10 s, rad", 10.0 * rate,
               0.01},
              turn);
    }
}

/// Relative errors of what an isolated system keeps; gain is the largest rise of the energy.
struct Drift {
    double momentum = 0.0, angular = 0.0, gain = 0.0, energy = 0.0;
};

template <class E>
Drift Watch(Lab<E>& lab, const std::vector<typename E::Body*>& bodies, double momentumScale, int steps) {
    const Invariants start = Sum(bodies);
    Drift drift;
    for (int i = 0; i < steps; ++i) {
        lab.Step();
        const Invariants now = Sum(bodies);
        drift.momentum = std::max(drift.momentum, Length(now.momentum - start.momentum) / momentumScale);
        if (start.angular != 0.0) drift.angular = std::max(drift.angular, std::abs(now.angular / start.angular - 1.0));
        drift.energy = now.kinetic / start.kinetic;
        drift.gain = std::max(drift.gain, drift.energy - 1.0);
    }
    return drift;
}

TEST(FreeMotion, AFreeChainKeepsMomentumAndAngularMomentumAndGainsNoEnergy) {
    const auto drift = Measure([]<class E>(E) {
        Lab<E> lab(0.0);
        std::vector<typename E::Body*> links;
        for (int i = 0; i < 20; ++i) {
            links.push_back(lab.Dynamic(i - 9.5, 0.0));
            AttachBox<E>(links.back(), 0.5, 0.125);
            if (i > 0) lab.Hinge(links[static_cast<size_t>(i) - 1], links.back(), i - 10.0, 0.0);
        }
        // A thrown, turning chain, consistent with its joints at the start.
        for (auto* link : links) {
            link->SetAngularVelocity(1.0f);
            link->SetLinearVelocity(Lab<E>::At(2.0, 1.0 + Centre(link).x));
        }
        return Watch<E>(lab, links, Length(Sum(links).momentum), 10 * stepRate);
    });
    Judge({"free chain of 20: drift of momentum, relative", 0.0, 1e-5, 1e-5}, Pick(drift, &Drift::momentum));
    // Position corrections of 8/3 move links sideways to their velocities: 1 % is out of reach, Box2D's error bounds
    // it.
    Judge({"free chain of 20: drift of angular momentum, relative", 0.0, unbounded, 1e-5},
          Pick(drift, &Drift::angular));
    Judge({"free chain of 20: gain of energy, relative", 0.0, 1e-2, 1e-5}, Pick(drift, &Drift::gain));
}

/// Disks of restitution 1 on a jittered grid, thrown at random.
template <class E>
std::vector<typename E::Body*> AddGas(Lab<E>& lab, unsigned seed, double inward) {
    std::mt19937 random(seed);
    const auto uniform = [&random] { return static_cast<double>(random()) / 4294967296.0 * 2.0 - 1.0; };
    std::vector<typename E::Body*> disks;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            const double x = 2.0 * i - 7.0 + 0.3 * uniform(), y = 2.0 * j - 7.0 + 0.3 * uniform();
            disks.push_back(lab.Dynamic(x, y));
            AttachDisk<E>(disks.back(), 0.4, {1.0, 0.0, 1.0, 0.0});
            const double vx = 3.0 * uniform() - inward * x, vy = 3.0 * uniform() - inward * y;
            disks.back()->SetLinearVelocity(Lab<E>::At(vx, vy));
        }
    }
    return disks;
}

/// Adds a run's share to the mean energies.
Both<double> Sum(const Both<double>& energy, const Both<Drift>& drift, int runs) {
    return {energy.ours + drift.ours.energy / runs, energy.box2d + drift.box2d.energy / runs,
            energy.soft + drift.soft.energy / runs};
}

TEST(FreeMotion, AFreeElasticGasKeepsMomentumAndEnergy) {
    Both<double> momentum{}, energy{};
    const int runs = 8;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const auto drift = Measure([seed]<class E>(E) {
            Lab<E> lab(0.0);
            const auto disks = AddGas<E>(lab, seed, 0.5);
            double scale = 0.0;
            for (const auto* disk : disks) scale += static_cast<double>(disk->GetMass()) * Length(Speed(disk));
            return Watch<E>(lab, disks, scale, 5 * stepRate);
        });
        momentum = {std::max(momentum.ours, drift.ours.momentum), std::max(momentum.box2d, drift.box2d.momentum),
                    std::max(momentum.soft, drift.soft.momentum)};
        energy = Sum(energy, drift, runs);
    }
    Judge({"free elastic gas of 64 disks: drift of momentum, relative", 0.0, 1e-5, 1e-5}, momentum);
    Judge({"free elastic gas of 64 disks: energy after 5 s, relative, mean of 8 runs", 1.0, 1e-2, 1e-4}, energy);
}

TEST(FreeMotion, AnElasticGasInABoxKeepsItsEnergy) {
    Both<double> energy{};
    const int runs = 8;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const auto drift = Measure([seed]<class E>(E) {
            Lab<E> lab(0.0);
            auto* walls = lab.Static();
            for (int side = 0; side < 4; ++side) {
                const double angle = 0.5 * circleRatio * side;
                const double c = std::round(std::cos(angle)), s = std::round(std::sin(angle));
                const auto a = Lab<E>::At(9.0 * (c - s), 9.0 * (s + c)), b = Lab<E>::At(9.0 * (c + s), 9.0 * (s - c));
                AttachShape<E>(walls, EdgeOf<E>(a, b), {0.0, 0.0, 1.0, 0.0});
            }
            return Watch<E>(lab, AddGas<E>(lab, seed, 0.0), 1.0, 10 * stepRate);
        });
        energy = Sum(energy, drift, runs);
    }
    Judge({"elastic gas of 64 disks in a box: energy after 10 s, relative, mean of 8 runs", 1.0, 5e-2, 1e-4}, energy);
}

}  // namespace
}  // namespace scree::test
