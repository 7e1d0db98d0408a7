// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of measure.h.

#include "testbed/engines/measure.h"

#include <algorithm>
#include <cmath>

#include "scenes/build.h"

namespace testbed {

double RelativeError(double measured, double exact) { return std::abs(measured / exact - 1.0); }

Invariants SumInvariants(std::span<const BodyReading> bodies) {
    Invariants sum;
    for (const BodyReading& b : bodies) {
        sum.momentum = sum.momentum + b.mass * b.velocity;
        sum.angular += b.mass * Cross(b.centre, b.velocity) + b.inertia * b.spin;
        sum.kinetic += 0.5 * b.mass * Dot(b.velocity, b.velocity) + 0.5 * b.inertia * b.spin * b.spin;
    }
    return sum;
}

DriftWatch::DriftWatch(const Invariants& start, double momentumScale, double angularScale)
    : m_start(start), m_momentumScale(momentumScale), m_angularScale(angularScale) {}

void DriftWatch::Add(const Invariants& now) {
    m_momentum = std::max(m_momentum, Length(now.momentum - m_start.momentum) / m_momentumScale);
    m_angular = std::max(m_angular, std::abs(now.angular - m_start.angular) / m_angularScale);
    m_energy = now.kinetic / m_start.kinetic;
    m_gain = std::max(m_gain, m_energy - 1.0);
}

void FallingPasses::Add(double time, double value) {
    if (m_lastTime && m_lastValue > 0.0 && value <= 0.0) {
        m_times.push_back(*m_lastTime + (time - *m_lastTime) * m_lastValue / (m_lastValue - value));
    }
    m_lastTime = time;
    m_lastValue = value;
}

void ApexFinder::Add(double height, double speed) {
    if (speed > 0.0) {
        if (!m_rising || height > m_highest) {
            // Far from the apex the discrete parabola has another energy; the last sample before it is the best.
            m_highest = height;
            m_apex = height + speed * speed / (2.0 * gravity);
        }
        m_rising = true;
    } else if (m_rising) {
        m_apexes.push_back(m_apex);
        m_rising = false;
    }
}

double Bisect(double low, double high, int halvings, const std::function<bool(double)>& holds) {
    for (int i = 0; i < halvings; ++i) {
        const double mid = 0.5 * (low + high);
        (holds(mid) ? high : low) = mid;
    }
    return 0.5 * (low + high);
}

double PendulumPeriod(double inertiaAboutPin, double mass, double distance, double amplitude) {
    // K(k) = π / (2 agm(1, √(1 − k²))), and √(1 − sin²) = cos.
    double a = 1.0, b = std::cos(0.5 * amplitude);
    for (int i = 0; i < 8; ++i) {  // quadratic convergence
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return 4.0 * std::sqrt(inertiaAboutPin / (mass * gravity * distance)) * scenes::pi / (2.0 * a);
}

Catenary SolveCatenary(int links, double span) {
    const auto tangent = [links](int i, double horizontal) { return (i - 0.5 * (links + 1)) / horizontal; };
    double low = 1e-3, high = 1e4;
    for (int k = 0; k < 200; ++k) {
        const double mid = std::sqrt(low * high);
        double width = 0.0;
        for (int i = 1; i <= links; ++i) width += std::cos(std::atan(tangent(i, mid)));
        (width < span ? low : high) = mid;
    }
    Catenary result;
    result.horizontal = low;
    double y = 0.0;
    for (int i = 1; i <= links; ++i) {
        result.angle.push_back(std::atan(tangent(i, low)));
        y += std::sin(result.angle.back());
        result.sag = std::max(result.sag, -y);
    }
    result.endPull = std::hypot(low, 0.5 * links);
    return result;
}

double GetOrder(double error, double errorAtHalf) { return std::log2(error / errorAtHalf); }

double RmsSpeed(std::span<const BodyReading> bodies) {
    double sum = 0.0;
    for (const BodyReading& b : bodies) sum += Dot(b.velocity, b.velocity);
    return bodies.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(bodies.size()));
}

Point AfterCollision(Point v, Point normal, double massRatio, double e) {
    const double share = massRatio / (1.0 + massRatio);  // m2/(m1 + m2)
    return v - ((1.0 + e) * share * Dot(v, normal)) * normal;
}

}  // namespace testbed
