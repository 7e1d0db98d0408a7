// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Semi-implicit Euler with sequential impulses between velocity and position update, then position correction and the
// sleep rule, island by island. Isolated bodies run the same integration without the rest (the dissertation, §5.2.1).

#include "pipeline/solve_islands.h"

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/isolated_bodies.h"
#include "pipeline/parts/pose_finisher.h"
#include "pipeline/parts/report_impulses.h"
#include "pipeline/parts/run_kernel.h"

namespace scree {

namespace {

JointStep JointStepOf(const SolverSettings& settings) {
    return {settings.dt, 1.0f / settings.dt, settings.impulseScale, settings.Slop()};
}

/// Without `forces` no body has damping, a gravity scale or a force. Their neutral values change no bit, so only the
/// sum with a force of 0 stays (it turns −0 into 0).
template <bool forces>
void IntegrateVelocity(const SolverSettings& settings, BodyTable& bodies, BodyIndex b) {
    bodies.NoteStart(b);
    if (settings.exactDrift) bodies.startVelocity[b] = bodies.velocity[b];
    if (bodies.type[b] != dynamicBody) return;
    const float h = settings.dt;
    const MassRow& mass = bodies.mass[b];
    const MotionRow& motion = bodies.motion[b];
    Velocity& v = bodies.velocity[b];
    if constexpr (!forces) {
        v.v += (h * mass.invMass) * (motion.mass * settings.gravity + vec2Zero);
        v.w += 0.0f;
        return;
    }
    const ForceRow& force = bodies.force[b];
    v.v += (h * mass.invMass) * ((motion.gravityScale * motion.mass) * settings.gravity + force.force);
    v.w += h * mass.invI * force.torque;
    // Implicit damping, dv/dt = −c·v: stable at any c and h.
    v.v *= 1.0f / (1.0f + h * motion.linearDamping);
    v.w *= 1.0f / (1.0f + h * motion.angularDamping);
}

/// What the body moves in this step, under the caps. `capped` is set if one acted.
template <bool limit>
Velocity MotionOf(const SolverSettings& settings, BodyTable& bodies, BodyIndex b, bool& capped) {
    const float h = settings.dt;
    Velocity& v = bodies.velocity[b];
    Velocity mean = v;
    if (settings.exactDrift) {
        const Velocity& before = bodies.startVelocity[b];
        mean = {0.5f * (before.v + v.v), 0.5f * (before.w + v.w), 0.0f};
    }
    if constexpr (limit) {
        const CapFactors cap = CapMotion(settings, h * mean.v, h * mean.w);
        capped = cap.Acts();
        if (capped) {
            v.v *= cap.linear, v.w *= cap.angular;
            mean.v *= cap.linear, mean.w *= cap.angular;
        }
    }
    return {h * mean.v, h * mean.w, 0.0f};
}

/// Moves the body by its velocity. Returns true if a cap acted.
template <bool limit>
bool IntegratePosition(const SolverSettings& settings, BodyTable& bodies, BodyIndex b) {
    bool capped = false;
    const Velocity motion = MotionOf<limit>(settings, bodies, b, capped);
    bodies.Shift(b, motion.v);
    bodies.position[b].a += motion.w;
    return capped;
}

/// Larger than one slop: the push itself aims at leaving one slop of overlap.
float ContactTolerance(const SolverSettings& settings) { return -3.0f * settings.Slop(); }

/// The solve of one island; the methods are the phases in order.
class IslandSolver {
public:
    IslandSolver(const SolverSettings& settings, const IslandTable& islands, const Island& island, SolverTables tables,
                 SolverScratch& scratch)
        : m_settings(settings),
          m_tables(tables),
          m_scratch(scratch),
          m_bodies(Bodies(islands, island)),
          m_contacts(Contacts(islands, island)),
          m_joints(Joints(islands, island)) {}

    void Prepare(const FixtureTable& fixtures) {
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
            for (const BodyIndex b : m_bodies) IntegrateVelocity<forces>(m_settings, m_tables.bodies, b);
        });
        m_scratch.locked.Gather(m_settings.kernels, m_bodies, m_tables.bodies);
        PrepareContacts({m_tables.bodies, fixtures, m_tables.contacts, m_contacts, m_settings.impulseScale,
                         m_settings.kernels.restitution},
                        m_scratch.contacts);
        PrepareRolling(m_settings, fixtures, m_contacts, m_settings.impulseScale, m_tables, m_scratch.rolling);
        if (m_settings.impulseScale > 0.0f) {
            WarmStartContacts(m_scratch.contacts, m_tables.bodies.velocity);
            m_scratch.rolling.WarmStart(m_tables.bodies.velocity);
        }
        PrepareJoints(JointWork(), m_joints);
        m_scratch.locked.Stop(m_tables.bodies.velocity);
    }

    void SolveVelocities() {
        for (int i = 0; i < m_settings.velocityIterations; ++i) {
            SolveJointVelocities(JointWork());
            SolveContactVelocities(m_scratch.contacts, m_tables.bodies.velocity, m_settings.kernels.friction);
            m_scratch.rolling.Solve(m_tables.bodies.velocity,
                                    [&](int at) { return GetPressure(m_scratch.contacts, at); });
            m_scratch.locked.Stop(m_tables.bodies.velocity);
        }
        StoreContactImpulses(m_scratch.contacts, m_tables.contacts.manifold);
        m_scratch.rolling.Store(1.0f, m_tables.contacts.rolling);
    }

    int IntegratePositions() {
        int capped = 0;
        WithBodyKernel(m_settings.kernels, [&](auto, auto limit) {
            for (const BodyIndex b : m_bodies)
                capped += IntegratePosition<limit>(m_settings, m_tables.bodies, b) ? 1 : 0;
        });
        return capped;
    }

    /// Stops as soon as everything is within tolerance; false if it never was.
    bool SolvePositions() {
        for (int i = 0; i < m_settings.positionIterations; ++i) {
            bool solved = SolveContactPositions(m_scratch.contacts, m_tables.bodies,
                                                {baumgarte, m_settings.lengthScale}) >= ContactTolerance(m_settings);
            solved = SolveJointPositions(JointWork()) && solved;
            m_scratch.locked.Return(m_tables.bodies);
            if (solved) return true;
        }
        return false;
    }

    int Finish() {
        int nonFinite = 0;
        for (const BodyIndex b : m_bodies) nonFinite += FinishPose(m_tables.bodies, b) ? 1 : 0;
        return nonFinite;
    }

    void Sleep(bool positionsSolved) {
        if (m_settings.allowSleep) SleepIsland(m_tables.bodies, m_bodies, m_settings, positionsSolved);
    }

private:
    [[nodiscard]] JointTask JointWork() {
        return {JointStepOf(m_settings), m_tables.bodies, m_tables.joints, m_scratch.joints};
    }

    const SolverSettings& m_settings;
    SolverTables m_tables;
    SolverScratch& m_scratch;
    std::span<const BodyIndex> m_bodies;
    std::span<const ContactIndex> m_contacts;
    std::span<const JointIndex> m_joints;
};

/// The solve of islands with contacts together, by the vector kernels; the methods are the phases in order.
/// Separations are linear in the bodies' motion, with the normals and arms of the start of the step.
class WideSolver {
public:
    WideSolver(const SolverSettings& settings, const IslandTable& islands, SolverTables tables, SolverScratch& scratch)
        : m_settings(settings),
          m_islands(islands),
          m_bodies(tables.bodies),
          m_tables(tables),
          m_s(scratch),
          m_kernels(GetContactKernels()) {}

    void Prepare(const FixtureTable& fixtures) {
        m_s.delta.resize(ToSize(m_bodies.slots.Size()));
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
            ForEachOf(Pool(), m_s.wide.bodies.size(),
                      [&](size_t i) { IntegrateVelocity<forces>(m_settings, m_bodies, m_s.wide.bodies[i]); });
        });
        m_s.locked.Gather(m_settings.kernels, m_s.wide.bodies, m_bodies);
        m_s.blocks.Build({Pool(), m_bodies, fixtures, m_tables.contacts, m_s.wide.contacts, m_settings.impulseScale,
                          m_settings.kernels.restitution, m_settings.lengthScale});
        m_task = m_s.blocks.Task(m_bodies.velocity, m_s.delta);
        m_task.friction = m_settings.kernels.friction;
        m_task.largestPush = maxLinearCorrection * m_settings.lengthScale;
        PrepareRolling(m_settings, fixtures, m_s.wide.contacts, m_settings.impulseScale, m_tables, m_s.rolling);
        if (m_settings.impulseScale > 0.0f) {
            RunKernel(Pool(), m_task, m_kernels.warmStart);
            m_s.rolling.WarmStart(m_bodies.velocity);
        }
        if (HasJoints()) PrepareJoints(JointWork(), m_s.wide.joints);
        m_s.locked.Stop(m_bodies.velocity);
    }

    void SolveVelocities() {
        for (int i = 0; i < m_settings.velocityIterations; ++i) {
            if (HasJoints()) SolveJointVelocities(JointWork());
            RunKernel(Pool(), m_task, m_kernels.solveRigid);
            m_s.rolling.Solve(m_bodies.velocity, [&](int at) { return m_s.blocks.GetPressure(at); });
            m_s.locked.Stop(m_bodies.velocity);
        }
        m_s.blocks.Store(1.0f, Pool(), m_tables.contacts.manifold);
        m_s.rolling.Store(1.0f, m_tables.contacts.rolling);
    }

    int IntegratePositions() {
        return WithBodyKernel(m_settings.kernels, [&](auto, auto limit) {
            const SolverCounts counts = CountOver(Pool(), m_s.wide.bodies.size(), [&](size_t i) {
                const BodyIndex b = m_s.wide.bodies[i];
                bool capped = false;
                m_s.delta[b] = MotionOf<limit>(m_settings, m_bodies, b, capped);
                return SolverCounts{capped ? 1 : 0, 0};
            });
            return counts.capped;
        });
    }

    /// Stops as soon as everything is within tolerance. What is not by then is judged island by island.
    void SolvePositions() {
        bool contactsSolved = false, jointsSolved = false;
        for (int i = 0; i < m_settings.positionIterations && !(contactsSolved && jointsSolved); ++i) {
            contactsSolved = IsWithinTolerance(RunPushApart(Pool(), m_task, m_kernels, baumgarte));
            jointsSolved = !HasJoints() || CorrectJoints();
            m_s.locked.Stop(m_s.delta);
        }
        m_s.islandSolved.clear();
        int contact = 0;  // the islands' contacts lie one behind the other in the blocks' list
        for (const Island& island : m_s.wide.islands) {
            const int end = contact + island.contactEnd - island.contactBegin;
            const bool joints = jointsSolved || island.jointBegin == island.jointEnd;
            const bool solved = joints && (contactsSolved || (IsSleepy(island) && AreContactsSolved(contact, end)));
            m_s.islandSolved.push_back(solved ? 1 : 0);
            contact = end;
        }
    }

    int Finish() {
        const PoseFinisher finisher(m_settings, m_bodies, m_s.delta, {.keepsRests = false, .hasLimit = false});
        const auto bodyAt = [this](size_t i) { return m_s.wide.bodies[i]; };
        return finisher
            .Finish(Pool(), m_s.wide.bodies.size(), bodyAt,
                    [this](BodyIndex b) {
                        Move(b);
                        m_s.delta[b] = {};
                        return SolverCounts{0, FinishPose(m_bodies, b) ? 1 : 0};
                    })
            .nonFinite;
    }

    void Sleep() {
        if (!m_settings.allowSleep) return;
        for (size_t i = 0; i < m_s.wide.islands.size(); ++i) {
            SleepIsland(m_bodies, Bodies(m_islands, m_s.wide.islands[i]), m_settings, m_s.islandSolved[i] != 0);
        }
    }

private:
    [[nodiscard]] TaskPool& Pool() const { return m_tables.pool; }
    [[nodiscard]] bool HasJoints() const { return !m_s.wide.joints.empty(); }
    [[nodiscard]] JointTask JointWork() { return {JointStepOf(m_settings), m_bodies, m_tables.joints, m_s.joints}; }

    [[nodiscard]] bool IsWithinTolerance(float separation) const {
        return separation - m_settings.Slop() >= ContactTolerance(m_settings);
    }
    /// Of the contacts [begin, end) of the blocks' list.
    [[nodiscard]] bool AreContactsSolved(int begin, int end) const {
        for (int i = begin; i < end; ++i) {
            if (!IsWithinTolerance(m_s.blocks.GetSeparation(ToSize(i), m_s.delta))) return false;
        }
        return true;
    }
    /// False if a body of the island has moved too lately for the island to fall asleep in this step.
    [[nodiscard]] bool IsSleepy(const Island& island) const {
        for (const BodyIndex b : Bodies(m_islands, island)) {
            if (m_bodies.sleepTime[b] + m_settings.dt < timeToSleep) return false;
        }
        return true;
    }

    void Move(BodyIndex b) {
        m_bodies.SetMotion(b, m_s.delta[b].v);
        m_bodies.position[b].a = m_bodies.startPosition[b].a + m_s.delta[b].w;
    }

    bool CorrectJoints() {
        for (const BodyIndex b : m_s.wide.bodies) {
            if (m_bodies.info[b].jointCount > 0) Move(b);
        }
        const bool solved = SolveJointPositions(JointWork());
        for (const BodyIndex body : m_s.wide.bodies) {
            if (m_bodies.info[body].jointCount == 0) continue;
            m_s.delta[body].v = m_bodies.GetMotion(body);
            m_s.delta[body].w = m_bodies.position[body].a - m_bodies.startPosition[body].a;
        }
        return solved;
    }

    const SolverSettings& m_settings;
    const IslandTable& m_islands;
    BodyTable& m_bodies;
    SolverTables m_tables;
    SolverScratch& m_s;
    const ContactKernels& m_kernels;
    KernelTask m_task{};
};

/// The ballistic path: the same arithmetic without constraints, hence the same bits.
class BallisticPath {
public:
    BallisticPath(const SolverSettings& settings, BodyTable& bodies)
        : m_settings(settings), m_bodies(bodies), m_moveIsolated(GetMoveIsolated()) {
        m_task = {&bodies.velocity.data()->v.x,
                  &bodies.position.data()->c.x,
                  &bodies.startPosition.data()->c.x,
                  &bodies.transform.data()->p.x,
                  &bodies.mass.data()->invMass,
                  bodies.force.empty() ? nullptr : &bodies.force.data()->force.x,
                  &bodies.motion.data()->linearDamping,
                  settings.kernels.bodyForces,
                  settings.kernels.speedLimit,
                  settings.dt,
                  settings.gravity.x,
                  settings.gravity.y,
                  settings.maxTranslation,
                  settings.maxRotation,
                  SleepSpeed(settings) * SleepSpeed(settings),
                  angularSleepTolerance * angularSleepTolerance};
    }

    SolverCounts Move(std::span<const BodyIndex> rows) const {
        SolverCounts counts;
        size_t done = 0;
        const bool byEight = !m_settings.exactDrift && !m_bodies.IsFar() && !m_settings.kernels.locks;
        for (; byEight && done + laneCount <= rows.size(); done += laneCount) {
            counts += MoveEight(rows.subspan(done, laneCount));
        }
        for (; done < rows.size(); ++done) counts += MoveOne(rows[done]);
        return counts;
    }

private:
    static constexpr size_t laneCount = 8;

    SolverCounts MoveEight(std::span<const BodyIndex> rows) const {
        SolverCounts counts;
        int32_t plain[laneCount];
        for (size_t lane = 0; lane < laneCount; ++lane) plain[lane] = ToInt(rows[lane]);
        switch (m_moveIsolated(m_task, plain)) {
            case IsolatedMove::refused:
                for (const BodyIndex body : rows) counts += MoveOne(body);
                break;
            case IsolatedMove::fast:
                if (!m_settings.allowSleep) break;
                for (const BodyIndex body : rows) m_bodies.sleepTime[body] = 0.0f;
                break;
            case IsolatedMove::slow:
                for (const BodyIndex body : rows) Sleep(body);
                break;
        }
        return counts;
    }

    SolverCounts MoveOne(BodyIndex body) const {
        SolverCounts counts;
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto limit) {
            IntegrateVelocity<forces>(m_settings, m_bodies, body);
            if (m_settings.kernels.locks) StopLocked(m_bodies, body, m_bodies.velocity[body]);
            counts.capped = IntegratePosition<limit>(m_settings, m_bodies, body) ? 1 : 0;
        });
        counts.nonFinite = FinishPose(m_bodies, body) ? 1 : 0;
        Sleep(body);
        return counts;
    }

    void Sleep(BodyIndex body) const {
        if (!m_settings.allowSleep) return;
        if (UpdateSleepTimer(m_bodies, body, m_settings) >= timeToSleep) {
            m_bodies.PutToSleep(body);
        }
    }

    const SolverSettings& m_settings;
    BodyTable& m_bodies;
    MoveIsolatedFunction m_moveIsolated;
    IsolatedBodiesTask m_task;
};

SolverCounts SolveIsolated(const SolverSettings& settings, const IslandTable& islands, TaskPool& pool,
                           BodyTable& bodies) {
    if (islands.isolated.empty()) return {};
    const BallisticPath path(settings, bodies);
    return CountRanges(pool, islands.isolated.size(), pool.IsWide() ? leastBodies : leastIsolatedBodies,
                       [&](int begin, int end) { return path.Move(Range(islands.isolated, begin, end)); });
}

/// Which islands are solved side by side by the vector kernels: all that have contacts if these are many enough to fill
/// the vectors. Otherwise the tiny ones, where the order of contacts matters least, if they do so together.
class WideChoice {
public:
    explicit WideChoice(const IslandTable& islands) : m_all(islands.contacts.size() >= 128) {
        if (m_all || islands.contacts.size() < leastTogether) return;
        size_t together = 0;
        for (const Island& island : islands.islands) together += IsTiny(island) ? ContactCount(island) : 0;
        m_tiny = together >= leastTogether;
    }

    [[nodiscard]] bool Any() const { return m_all || m_tiny; }
    [[nodiscard]] bool Has(const Island& island) const {
        return ContactCount(island) > 0 && (m_all || (m_tiny && IsTiny(island)));
    }

private:
    static constexpr size_t leastTogether = 32;

    static size_t ContactCount(const Island& island) { return ToSize(island.contactEnd - island.contactBegin); }
    static bool IsTiny(const Island& island) { return ContactCount(island) <= 8; }

    bool m_all, m_tiny = false;
};

void GatherWide(const IslandTable& islands, const WideChoice& choice, IslandTable& wide) {
    wide.Clear();
    if (!choice.Any()) return;
    for (const Island& island : islands.islands) {
        if (!choice.Has(island)) continue;
        wide.islands.push_back(island);
        const auto append = [](auto& to, auto from) { to.insert(to.end(), from.begin(), from.end()); };
        append(wide.bodies, Bodies(islands, island));
        append(wide.contacts, Contacts(islands, island));
        append(wide.joints, Joints(islands, island));
    }
}

void SolveWide(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& islands,
               const ContactEvents& events, SolverTables tables, SolverScratch& scratch, SolverCounts& counts) {
    WideSolver solver(settings, islands, tables, scratch);
    solver.Prepare(fixtures);
    solver.SolveVelocities();
    counts.capped += solver.IntegratePositions();
    solver.SolvePositions();
    counts.nonFinite += solver.Finish();
    ReportBlockImpulses(scratch, false, scratch.wide.contacts, events, tables.contacts);
    solver.Sleep();
}

}  // namespace

SolverCounts SolveIslands(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& islands,
                          const ContactEvents& events, SolverTables tables, SolverScratch& scratch) {
    SolverCounts counts = SolveIsolated(settings, islands, tables.pool, tables.bodies);
    const WideChoice wide(islands);
    for (const Island& island : islands.islands) {
        if (wide.Has(island)) continue;
        IslandSolver solver(settings, islands, island, tables, scratch);
        solver.Prepare(fixtures);
        solver.SolveVelocities();
        counts.capped += solver.IntegratePositions();
        const bool positionsSolved = solver.SolvePositions();
        counts.nonFinite += solver.Finish();
        ReportImpulses(scratch.contacts, events, tables.contacts);
        solver.Sleep(positionsSolved);
    }
    GatherWide(islands, wide, scratch.wide);
    if (wide.Any()) SolveWide(settings, fixtures, islands, events, tables, scratch, counts);
    return counts;
}

}  // namespace scree
