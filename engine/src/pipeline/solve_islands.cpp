// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Semi-implicit Euler with sequential impulses between velocity and position update, then position correction and the
// sleep rule, island by island. Isolated bodies run the same integration without the rest (the dissertation, §5.2.1).

#include "pipeline/solve_islands.h"

#include <algorithm>
#include <limits>

#include "pipeline/parts/report_impulses.h"

namespace scree {

namespace {

void IntegrateVelocity(const SolverSettings& settings, BodyTable& bodies, size_t b) {
    bodies.startPosition[b] = bodies.position[b];
    if (settings.exactDrift) bodies.startVelocity[b] = bodies.velocity[b];
    if (bodies.type[b] != dynamicBody) return;
    const float h = settings.dt;
    const MassRow& mass = bodies.mass[b];
    const ForceRow& force = bodies.force[b];
    const MotionRow& motion = bodies.motion[b];
    Velocity& v = bodies.velocity[b];
    v.v += (h * mass.invMass) * ((motion.gravityScale * bodies.info[b].mass) * settings.gravity + force.force);
    v.w += h * mass.invI * force.torque;
    // Implicit damping, dv/dt = −c·v: stable at any c and h.
    v.v *= 1.0f / (1.0f + h * motion.linearDamping);
    v.w *= 1.0f / (1.0f + h * motion.angularDamping);
}

/// Moves the body by its velocity, under the caps. Returns true if a cap acted.
bool IntegratePosition(const SolverSettings& settings, BodyTable& bodies, size_t b) {
    const float h = settings.dt;
    Velocity& v = bodies.velocity[b];
    bool capped = false;
    Velocity mean = v;
    if (settings.exactDrift) {
        const Velocity& before = bodies.startVelocity[b];
        mean = {0.5f * (before.v + v.v), 0.5f * (before.w + v.w), 0.0f};
    }
    const Vec2 translation = h * mean.v;
    const float lengthSquared = Dot(translation, translation);
    if (lengthSquared > settings.maxTranslation * settings.maxTranslation) {
        const float ratio = settings.maxTranslation / std::sqrt(lengthSquared);
        v.v *= ratio;
        mean.v *= ratio;
        capped = true;
    }
    const float rotation = h * mean.w;
    if (rotation * rotation > settings.maxRotation * settings.maxRotation) {
        const float ratio = settings.maxRotation / Abs(rotation);
        v.w *= ratio;
        mean.w *= ratio;
        capped = true;
    }
    bodies.position[b].c += h * mean.v;
    bodies.position[b].a += h * mean.w;
    return capped;
}

/// Updates the transform; a body that is not finite any more goes back to its start, at rest. Returns true if it did.
bool FinishPose(BodyTable& bodies, size_t b) {
    const Position& p = bodies.position[b];
    const Velocity& v = bodies.velocity[b];
    const bool finite = p.c.IsValid() && std::isfinite(p.a) && v.v.IsValid() && std::isfinite(v.w);
    if (!finite) {
        bodies.position[b] = bodies.startPosition[b];
        bodies.velocity[b] = {vec2Zero, 0.0f, 0.0f};
    }
    bodies.UpdateTransform(static_cast<int>(b));
    return !finite;
}

/// Advances the body's sleep timer and returns it.
float UpdateSleepTimer(BodyTable& bodies, size_t b, float dt) {
    const Velocity& v = bodies.velocity[b];
    const bool slow = v.w * v.w <= angularSleepTolerance * angularSleepTolerance &&
                      Dot(v.v, v.v) <= linearSleepTolerance * linearSleepTolerance;
    if (!bodies.Has(static_cast<int>(b), BodyFlag::autoSleep) || !slow) {
        bodies.sleepTime[b] = 0.0f;
        return 0.0f;
    }
    bodies.sleepTime[b] += dt;
    return bodies.sleepTime[b];
}

/// The solve of one island; the methods are the phases in order.
class IslandSolver {
public:
    IslandSolver(const SolverSettings& settings, const IslandTable& islands, const Island& island, SolverTables tables,
                 SolverScratch& scratch)
        : m_settings(settings),
          m_tables(tables),
          m_scratch(scratch),
          m_bodies(islands.bodies.data() + island.bodyBegin, static_cast<size_t>(island.bodyEnd - island.bodyBegin)),
          m_contacts(islands.contacts.data() + island.contactBegin,
                     static_cast<size_t>(island.contactEnd - island.contactBegin)),
          m_joints(islands.joints.data() + island.jointBegin,
                   static_cast<size_t>(island.jointEnd - island.jointBegin)) {}

    void Prepare(const FixtureTable& fixtures) {
        for (const int b : m_bodies) IntegrateVelocity(m_settings, m_tables.bodies, static_cast<size_t>(b));
        PrepareContacts({m_tables.bodies, fixtures, m_tables.contacts, m_contacts, m_settings.impulseScale},
                        m_scratch.contacts);
        if (m_settings.impulseScale > 0.0f) WarmStartContacts(m_scratch.contacts, m_tables.bodies.velocity);
        PrepareJoints(JointWork(), m_joints);
    }

    void SolveVelocities() {
        for (int i = 0; i < m_settings.velocityIterations; ++i) {
            SolveJointVelocities(JointWork());
            SolveContactVelocities(m_scratch.contacts, m_tables.bodies.velocity);
        }
        StoreContactImpulses(m_scratch.contacts, m_tables.contacts.manifold);
    }

    int IntegratePositions() {
        int capped = 0;
        for (const int b : m_bodies)
            capped += IntegratePosition(m_settings, m_tables.bodies, static_cast<size_t>(b)) ? 1 : 0;
        return capped;
    }

    /// Stops as soon as everything is within tolerance; false if it never was.
    bool SolvePositions() {
        // Larger than one slop: the push itself aims at leaving one slop of overlap.
        constexpr float contactTolerance = -3.0f * linearSlop;
        for (int i = 0; i < m_settings.positionIterations; ++i) {
            bool solved = SolveContactPositions(m_scratch.contacts, m_tables.bodies.position) >= contactTolerance;
            solved = SolveJointPositions(JointWork()) && solved;
            if (solved) return true;
        }
        return false;
    }

    int Finish() {
        int nonFinite = 0;
        for (const int b : m_bodies) nonFinite += FinishPose(m_tables.bodies, static_cast<size_t>(b)) ? 1 : 0;
        return nonFinite;
    }

    void Sleep(bool positionsSolved) {
        if (!m_settings.allowSleep) return;
        float shortest = std::numeric_limits<float>::max();
        for (const int b : m_bodies)
            shortest = Min(shortest, UpdateSleepTimer(m_tables.bodies, static_cast<size_t>(b), m_settings.dt));
        if (shortest < timeToSleep || !positionsSolved) return;
        for (const int b : m_bodies) m_tables.bodies.PutToSleep(b);
    }

private:
    [[nodiscard]] JointTask JointWork() {
        const JointStep step{m_settings.dt, 1.0f / m_settings.dt, m_settings.impulseScale};
        return {step, m_tables.bodies, m_tables.joints, m_scratch.joints};
    }

    const SolverSettings& m_settings;
    SolverTables m_tables;
    SolverScratch& m_scratch;
    std::span<const int> m_bodies, m_contacts, m_joints;
};

/// The ballistic path: the same arithmetic without constraints, hence the same bits.
void SolveIsolated(const SolverSettings& settings, const IslandTable& islands, BodyTable& bodies,
                   SolverCounts& counts) {
    for (const int body : islands.isolated) {
        const auto b = static_cast<size_t>(body);
        IntegrateVelocity(settings, bodies, b);
        counts.capped += IntegratePosition(settings, bodies, b) ? 1 : 0;
        counts.nonFinite += FinishPose(bodies, b) ? 1 : 0;
        if (settings.allowSleep && UpdateSleepTimer(bodies, b, settings.dt) >= timeToSleep) bodies.PutToSleep(body);
    }
}

}  // namespace

SolverCounts SolveIslands(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& islands,
                          const ContactEvents& events, SolverTables tables, SolverScratch& scratch) {
    SolverCounts counts;
    SolveIsolated(settings, islands, tables.bodies, counts);
    for (const Island& island : islands.islands) {
        IslandSolver solver(settings, islands, island, tables, scratch);
        solver.Prepare(fixtures);
        solver.SolveVelocities();
        counts.capped += solver.IntegratePositions();
        const bool positionsSolved = solver.SolvePositions();
        counts.nonFinite += solver.Finish();
        ReportImpulses(scratch.contacts, events, tables.contacts);
        solver.Sleep(positionsSolved);
    }
    return counts;
}

}  // namespace scree
