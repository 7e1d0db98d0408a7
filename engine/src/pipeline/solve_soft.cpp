// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The soft step: the step is cut into sub-steps, and each solves every constraint once with soft rows, moves the
// bodies, and solves once more without push, so that what pushed overlaps apart does not stay as speed (Macklin et al.,
// "Small Steps in Physics Simulation", 2019; Catto, "Solver2D", 2024). Contacts are frozen at the start of the step:
// normals, arms and masses are computed once, separations are linear in the bodies' motion.
//
// With frozen Jacobians warm starting needs no pass over the contacts: what they did to a body's velocity in the last
// sub-step, they do again at the start of this one. Joints are made anew in every sub-step, at the present poses; they
// are solved rigidly on velocities, and their position error is removed after each move, as in sequential impulses.
//
// A body that no constraint pushed in a sub-step drifts by the mean of its velocities before and after, which is exact
// for constant forces. Isolated bodies run the same arithmetic, hence get the same bits.

#include "pipeline/solve_soft.h"

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/report_impulses.h"
#include "pipeline/parts/run_kernel.h"

namespace scree {

namespace {

/// Without `forces` as in solve_islands.cpp.
template <bool forces>
SoftBody MakeSoftBody(const SolverSettings& settings, const BodyTable& bodies, int body) {
    const auto b = static_cast<size_t>(body);
    const float h = settings.dt / static_cast<float>(settings.substeps);
    SoftBody soft{};
    soft.body = body;
    soft.linearDamp = soft.angularDamp = 1.0f;
    if (bodies.type[b] != dynamicBody) return soft;
    const MassRow& mass = bodies.mass[b];
    const MotionRow& motion = bodies.motion[b];
    if constexpr (!forces) {
        soft.speedUp.v = (h * mass.invMass) * (motion.mass * settings.gravity + vec2Zero);
        return soft;
    }
    const ForceRow& force = bodies.force[b];
    soft.speedUp.v = (h * mass.invMass) * ((motion.gravityScale * motion.mass) * settings.gravity + force.force);
    soft.speedUp.w = h * mass.invI * force.torque;
    soft.linearDamp = 1.0f / (1.0f + h * motion.linearDamping);
    soft.angularDamp = 1.0f / (1.0f + h * motion.angularDamping);
    return soft;
}

/// Forces and damping; contacts push as they did in the last sub-step.
template <bool forces>
inline void IntegrateVelocity(SoftBody& soft, Velocity& v) {
    soft.before = {v.v, v.w};
    if constexpr (!forces) {
        soft.unpushed = {v.v + soft.speedUp.v, v.w + 0.0f};
        v.v = soft.unpushed.v + soft.pushed.v;
        v.w = soft.unpushed.w + soft.pushed.w;
        return;
    }
    soft.unpushed = {soft.linearDamp * (v.v + soft.speedUp.v), soft.angularDamp * (v.w + soft.speedUp.w)};
    v.v = soft.unpushed.v + soft.pushed.v;
    v.w = soft.unpushed.w + soft.pushed.w;
}

/// No constraint pushed the body in this sub-step.
inline bool IsFree(const SoftBody& soft, const Velocity& v) {
    return soft.pushed.v == vec2Zero && soft.pushed.w == 0.0f && v.v == soft.unpushed.v && v.w == soft.unpushed.w;
}

inline void IntegrateDelta(const SoftBody& soft, const Velocity& v, float h, Velocity& delta) {
    if (IsFree(soft, v)) {
        const float half = 0.5f * h;
        delta.v += half * (soft.before.v + v.v);
        delta.w += half * (soft.before.w + v.w);
    } else {
        delta.v += h * v.v;
        delta.w += h * v.w;
    }
}

/// The end pose from the start pose and the motion, under the caps. Returns true if a cap acted.
template <bool limit>
bool MoveBody(const SolverSettings& settings, BodyTable& bodies, size_t b, Velocity& delta) {
    bool capped = false;
    if constexpr (limit) {
        const CapFactors cap = CapMotion(settings, delta.v, delta.w);
        capped = cap.Acts();
        if (capped) {
            delta.v *= cap.linear, delta.w *= cap.angular;
            bodies.velocity[b].v *= cap.linear, bodies.velocity[b].w *= cap.angular;
        }
    }
    bodies.position[b].c = bodies.startPosition[b].c + delta.v;
    bodies.position[b].a = bodies.startPosition[b].a + delta.w;
    return capped;
}

template <bool forces, bool limit>
SolverCounts SolveIsolated(const SolverSettings& settings, const IslandTable& active, TaskPool& pool,
                           BodyTable& bodies) {
    const float h = settings.dt / static_cast<float>(settings.substeps);
    return CountOver(pool, active.isolated.size(), [&](size_t at) {
        const int body = active.isolated[at];
        const auto b = static_cast<size_t>(body);
        bodies.startPosition[b] = bodies.position[b];
        SoftBody soft = MakeSoftBody<forces>(settings, bodies, body);
        Velocity v = bodies.velocity[b];
        Velocity delta{};
        for (int i = 0; i < settings.substeps; ++i) {
            IntegrateVelocity<forces>(soft, v);
            IntegrateDelta(soft, v, h, delta);
        }
        bodies.velocity[b] = v;
        SolverCounts counts;
        counts.capped = MoveBody<limit>(settings, bodies, b, delta) ? 1 : 0;
        counts.nonFinite = FinishPose(bodies, b) ? 1 : 0;
        if (settings.allowSleep && UpdateSleepTimer(bodies, b, settings) >= timeToSleep) bodies.PutToSleep(body);
        return counts;
    });
}

/// All islands together; the methods are the phases in order.
class SoftSolver {
public:
    SoftSolver(const SolverSettings& settings, const IslandTable& islands, SolverTables tables, SolverScratch& scratch)
        : m_settings(settings),
          m_h(settings.dt / static_cast<float>(settings.substeps)),
          m_islands(islands),
          m_bodies(tables.bodies),
          m_tables(tables),
          m_s(scratch),
          m_kernels(GetContactKernels()) {}

    void Prepare(const FixtureTable& fixtures, bool report) {
        m_s.delta.resize(static_cast<size_t>(m_bodies.slots.Size()));
        m_s.soft.clear();
        m_s.jointed.clear();
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) { PrepareBodies<forces>(); });
        m_s.before.resize(m_s.jointed.size());
        m_s.blocks.Build({Pool(), m_bodies, fixtures, m_tables.contacts, m_islands.contacts, SubstepScale(),
                          m_settings.kernels.restitution, m_settings.Slop()});
        m_task = m_s.blocks.Task(m_bodies.velocity, m_s.delta);
        m_task.soft = MakeConstants();
        m_task.friction = m_settings.kernels.friction;
        m_task.sumImpulses = report || m_s.blocks.Bounces();
        RunKernel(Pool(), m_task, m_kernels.finish);
    }

    void Substep(bool first) {
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
            ForEachSoft([&](SoftBody& soft) {
                IntegrateVelocity<forces>(soft, m_bodies.velocity[static_cast<size_t>(soft.body)]);
            });
        });
        if (first && m_settings.impulseScale > 0.0f) NotePush([&] { RunKernel(Pool(), m_task, m_kernels.warmStart); });
        if (HasJoints()) {
            PrepareJoints(JointWork(first ? SubstepScale() : 1.0f), m_islands.joints);
            SolveJointVelocities(JointWork(1.0f));
        }
        NotePush([&] { RunKernel(Pool(), m_task, m_kernels.solveSoft); });
        ForEachSoft([&](const SoftBody& soft) {
            const auto b = static_cast<size_t>(soft.body);
            IntegrateDelta(soft, m_bodies.velocity[b], m_h, m_s.delta[b]);
        });
        if (HasJoints()) {
            CorrectJoints();
            SolveJointVelocities(JointWork(1.0f));
        }
        NotePush([&] { RunKernel(Pool(), m_task, m_kernels.relax); });
        ForEachSoft([&](SoftBody& soft) {
            if (soft.jointed) return;  // noted
            const Velocity& v = m_bodies.velocity[static_cast<size_t>(soft.body)];
            soft.pushed = {v.v - soft.unpushed.v, v.w - soft.unpushed.w};
        });
    }

    SolverCounts Finish() {
        if (m_s.blocks.Bounces()) RunKernel(Pool(), m_task, m_kernels.bounce);
        // A manifold's impulses are those of a whole step, whatever its sub-steps.
        m_s.blocks.Store(static_cast<float>(m_settings.substeps), m_tables.contacts.manifold);
        if (HasJoints()) ScaleJointImpulses(JointWork(static_cast<float>(m_settings.substeps)), m_islands.joints);
        return WithBodyKernel(m_settings.kernels, [&](auto, auto limit) {
            return CountOver(Pool(), m_s.soft.size(), [&](size_t i) {
                const auto b = static_cast<size_t>(m_s.soft[i].body);
                SolverCounts counts;
                counts.capped = MoveBody<limit>(m_settings, m_bodies, b, m_s.delta[b]) ? 1 : 0;
                m_s.delta[b] = {};
                counts.nonFinite = FinishPose(m_bodies, b) ? 1 : 0;
                return counts;
            });
        });
    }

private:
    [[nodiscard]] TaskPool& Pool() const { return m_tables.pool; }

    template <bool forces>
    void PrepareBodies() {
        for (const int body : m_islands.bodies) {
            const auto b = static_cast<size_t>(body);
            m_bodies.startPosition[b] = m_bodies.position[b];
            m_s.soft.push_back(MakeSoftBody<forces>(m_settings, m_bodies, body));
            if (!HasJoints() || m_bodies.info[b].jointCount == 0) continue;
            m_s.soft.back().jointed = true;
            m_s.jointed.push_back(static_cast<int>(m_s.soft.size()) - 1);
        }
    }

    template <typename Visit>
    void ForEachSoft(Visit&& visit) {
        ForEachOf(Pool(), m_s.soft.size(), [&](size_t i) { visit(m_s.soft[i]); });
    }

    [[nodiscard]] float SubstepScale() const {
        return m_settings.impulseScale / static_cast<float>(m_settings.substeps);
    }

    [[nodiscard]] SoftConstants MakeConstants() const {
        const float omega = 2.0f * pi * m_settings.contactHertzRatio;  // per sub-step
        const float a = omega * (2.0f * m_settings.contactDampingRatio + omega);
        return {.inverseH = 1.0f / m_h,
                .biasRate = omega / (2.0f * m_settings.contactDampingRatio + omega) / m_h,
                .massScale = a / (1.0f + a),
                .impulseScale = 1.0f / (1.0f + a),
                .pushSpeed = m_settings.contactPushSpeed};
    }

    [[nodiscard]] bool HasJoints() const { return !m_islands.joints.empty(); }

    [[nodiscard]] JointTask JointWork(float impulseScale) {
        return {{m_h, 1.0f / m_h, impulseScale}, m_bodies, m_tables.joints, m_s.joints};
    }

    /// Runs a pass over the contacts and notes what it did to jointed bodies: joints are warm-started by themselves, so
    /// only the push of contacts is to be repeated. For other bodies the end of the sub-step tells.
    template <typename Pass>
    void NotePush(Pass&& pass) {
        for (size_t i = 0; i < m_s.jointed.size(); ++i) {
            const Velocity& v = VelocityOf(m_s.jointed[i]);
            m_s.before[i] = {v.v, v.w};
        }
        pass();
        for (size_t i = 0; i < m_s.jointed.size(); ++i) {
            const Velocity& v = VelocityOf(m_s.jointed[i]);
            SoftBody& soft = m_s.soft[static_cast<size_t>(m_s.jointed[i])];
            soft.pushed.v += v.v - m_s.before[i].v;
            soft.pushed.w += v.w - m_s.before[i].w;
        }
    }
    [[nodiscard]] const Velocity& VelocityOf(int soft) const {
        return m_bodies.velocity[static_cast<size_t>(m_s.soft[static_cast<size_t>(soft)].body)];
    }

    /// Moves jointed bodies, removes the joints' position errors, and takes the result back as motion.
    void CorrectJoints() {
        for (const int i : m_s.jointed) {
            const auto b = static_cast<size_t>(m_s.soft[static_cast<size_t>(i)].body);
            m_bodies.position[b].c = m_bodies.startPosition[b].c + m_s.delta[b].v;
            m_bodies.position[b].a = m_bodies.startPosition[b].a + m_s.delta[b].w;
        }
        SolveJointPositions(JointWork(1.0f));
        for (const int i : m_s.jointed) {
            const auto b = static_cast<size_t>(m_s.soft[static_cast<size_t>(i)].body);
            m_s.delta[b].v = m_bodies.position[b].c - m_bodies.startPosition[b].c;
            m_s.delta[b].w = m_bodies.position[b].a - m_bodies.startPosition[b].a;
        }
    }

    const SolverSettings& m_settings;
    const float m_h;
    const IslandTable& m_islands;
    BodyTable& m_bodies;
    SolverTables m_tables;
    SolverScratch& m_s;
    const ContactKernels& m_kernels;
    KernelTask m_task{};
};

}  // namespace

SolverCounts SolveSoft(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& active,
                       const ContactEvents& events, SolverTables tables, SolverScratch& scratch) {
    SolverCounts counts = WithBodyKernel(settings.kernels, [&](auto forces, auto limit) {
        return SolveIsolated<forces, limit>(settings, active, tables.pool, tables.bodies);
    });
    if (active.bodies.empty()) return counts;
    SoftSolver solver(settings, active, tables, scratch);
    solver.Prepare(fixtures, events.listener != nullptr);
    for (int i = 0; i < settings.substeps; ++i) solver.Substep(i == 0);
    const SolverCounts island = solver.Finish();
    counts += island;
    ReportBlockImpulses(scratch, true, active.contacts, events, tables.contacts);
    return counts;
}

void SleepIslands(const SolverSettings& settings, const IslandTable& active, const IslandTable& islands,
                  BodyTable& bodies) {
    if (!settings.allowSleep) return;
    for (const Island& island : islands.islands) SleepIsland(bodies, Bodies(islands, island), settings, true);
    if (!islands.islands.empty()) return;
    for (const int body : active.bodies) UpdateSleepTimer(bodies, static_cast<size_t>(body), settings);
}

}  // namespace scree
