// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Measurements from the states of bodies, in double, the same for every engine: sums that are conserved, periods,
// apexes, thresholds, the exact catenary and pendulum, orders of convergence.

#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "testbed/engines/lab.h"

namespace testbed {

inline constexpr double gravity = 10.0;  ///< m/s², of all laws

/// |measured / exact − 1|.
[[nodiscard]] double RelativeError(double measured, double exact);

/// What an isolated system keeps.
struct Invariants {
    double kinetic = 0.0;  ///< J
    double angular = 0.0;  ///< about the world's origin, kg·m²/s
    Point momentum;        ///< kg·m/s
};
[[nodiscard]] Invariants SumInvariants(std::span<const BodyReading> bodies);

/// Relative changes of the invariants seen so far.
class DriftWatch {
public:
    /// `momentumScale` (kg·m/s) and `angularScale` (kg·m²/s) are what drifts are relative to.
    DriftWatch(const Invariants& start, double momentumScale, double angularScale);
    void Add(const Invariants& now);

    [[nodiscard]] double GetMomentum() const { return m_momentum; }  ///< worst drift
    [[nodiscard]] double GetAngular() const { return m_angular; }    ///< worst drift
    [[nodiscard]] double GetGain() const { return m_gain; }          ///< worst rise of the energy, ≥ 0
    [[nodiscard]] double GetEnergy() const { return m_energy; }      ///< energy at last, over that of the start

private:
    Invariants m_start;
    double m_momentumScale, m_angularScale;
    double m_momentum = 0.0, m_angular = 0.0, m_gain = 0.0, m_energy = 1.0;
};

/// Times at which a sampled value falls through zero, by linear interpolation.
class FallingPasses {
public:
    void Add(double time, double value);
    [[nodiscard]] const std::vector<double>& GetTimes() const { return m_times; }

private:
    std::optional<double> m_lastTime;
    double m_lastValue = 0.0;
    std::vector<double> m_times;
};

/// Heights of the apexes of a bouncing body, from samples.
class ApexFinder {
public:
    /// `height` above the point of impact, m; `speed` upward, m/s.
    void Add(double height, double speed);
    /// Each is the height of the parabola through its highest sample.
    [[nodiscard]] const std::vector<double>& GetApexes() const { return m_apexes; }

private:
    bool m_rising = false;
    double m_highest = 0.0, m_apex = 0.0;
    std::vector<double> m_apexes;
};

/// The x in [low, high] from which on `holds` is true, to `halvings` halvings of the interval.
[[nodiscard]] double Bisect(double low, double high, int halvings, const std::function<bool(double)>& holds);

/// Period of a physical pendulum released at rest from `amplitude` rad: 4 √(I/(m g d)) K(sin(amplitude/2)), s.
[[nodiscard]] double PendulumPeriod(double inertiaAboutPin, double mass, double distance, double amplitude);

/// Equilibrium of N equal links of length 1 hung over a span: tan θᵢ = (i − (N+1)/2)·w/H and Σ cos θᵢ = span.
struct Catenary {
    double horizontal = 0.0, sag = 0.0, endPull = 0.0;  ///< forces in weights of a link; m
    std::vector<double> angle;                          ///< of each link, falling first, rad
};
[[nodiscard]] Catenary SolveCatenary(int links, double span);

/// log2 of the ratio of the errors at a step and at half of it.
[[nodiscard]] double GetOrder(double error, double errorAtHalf);

/// Root mean square speed.
[[nodiscard]] double RmsSpeed(std::span<const BodyReading> bodies);

/// Velocity after the frictionless collision of a body of velocity `v` with one at rest that is `massRatio` times as
/// heavy, with restitution `e` along `normal`.
[[nodiscard]] Point AfterCollision(Point v, Point normal, double massRatio, double e);

}  // namespace testbed
