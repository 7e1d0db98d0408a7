// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Semi-implicit Euler with sequential impulses between velocity and position update, then position correction and the
// sleep rule, island by island. Isolated bodies run the same integration without the rest (the dissertation, §5.2.1).

#include "pipeline/solve_islands.h"

#include <algorithm>
#include <tuple>

#include "base/bytes.h"

#include "pipeline/parts/ballistic_path.h"
#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/integrate.h"
#include "pipeline/parts/lane_solver.h"
#include "pipeline/parts/pose_finisher.h"
#include "pipeline/parts/report_impulses.h"
#include "pipeline/parts/run_kernel.h"

namespace scree {

namespace {

JointStep JointStepOf(const SolverSettings& settings) {
    return {settings.dt, 1.0f / settings.dt, settings.impulseScale, settings.Slop()};
}

/// The solve of one island; the methods are the phases in order.
class IslandSolver {
public:
    IslandSolver(const SolverSettings& settings, const IslandTable& islands, const Island& island, SolverTables tables,
                 IslandRows& scratch)
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
        PrepareIslandJoints(JointWork(), m_joints);
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
        StoreJointImpulses(JointWork());
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
        return {JointStepOf(m_settings), m_tables.bodies, m_tables.joints, m_scratch.joints, m_tables.pool};
    }

    const SolverSettings& m_settings;
    SolverTables m_tables;
    IslandRows& m_scratch;
    std::span<const BodyIndex> m_bodies;
    std::span<const ContactIndex> m_contacts;
    std::span<const JointIndex> m_joints;
};

/// The solve of one large island by the vector kernels, contacts side by side; the methods are the phases in order.
/// Separations are linear in the bodies' motion, with the normals and arms of the start of the step.
class WideSolver {
public:
    /// `delta` has a row for each body of the world.
    WideSolver(const SolverSettings& settings, const IslandTable& islands, const Island& island, SolverTables tables,
               IslandRows& scratch, ContactBlocks& blocks, Column<BodyIndex, Velocity>& delta)
        : m_settings(settings),
          m_tables(tables),
          m_bodies(tables.bodies),
          m_s(scratch),
          m_blocks(blocks),
          m_delta(delta),
          m_own(Bodies(islands, island)),
          m_contacts(Contacts(islands, island)),
          m_joints(Joints(islands, island)),
          m_kernels(GetContactKernels()) {}

    void Prepare(const FixtureTable& fixtures) {
        BodySlices& slices = m_blocks.GetSlices();
        slices.Update(Pool(), m_bodies, m_tables.contacts, m_contacts);
        m_own = slices.Sort(Pool(), m_bodies, m_own, m_s.sliced);
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
            ForEachOf(Pool(), m_own.size(),
                      [&](size_t i) { IntegrateVelocity<forces>(m_settings, m_bodies, m_own[i]); });
        });
        m_s.locked.Gather(m_settings.kernels, m_own, m_bodies);
        m_blocks.Build({.pool = Pool(),
                        .bodies = m_bodies,
                        .fixtures = fixtures,
                        .contacts = m_tables.contacts,
                        .list = m_contacts,
                        .impulseScale = m_settings.impulseScale,
                        .restitution = m_settings.kernels.restitution,
                        .lengthScale = m_settings.lengthScale},
                       m_s.marks);
        m_task = m_blocks.Task(m_bodies.velocity, m_delta);
        m_task.friction = m_settings.kernels.friction;
        m_task.largestPush = maxLinearCorrection * m_settings.lengthScale;
        PrepareRolling(m_settings, fixtures, m_contacts, m_settings.impulseScale, m_tables, m_s.rolling);
        if (m_settings.impulseScale > 0.0f) {
            RunKernel(Pool(), m_task, m_kernels.warmStart);
            m_s.rolling.WarmStart(m_bodies.velocity);
        }
        if (HasJoints()) PrepareIslandJoints(JointWork(), m_joints);
        m_s.locked.Stop(m_bodies.velocity);
    }

    void SolveVelocities() {
        // Where nothing comes between the passes over contacts, they are one.
        const bool isBare = !HasJoints() && m_s.rolling.IsEmpty() && m_s.locked.IsEmpty();
        const int passes = isBare ? m_settings.velocityIterations : 1;
        for (int i = 0; i < m_settings.velocityIterations; i += passes) {
            if (HasJoints()) SolveJointVelocities(JointWork());
            RunKernel(Pool(), m_task, m_kernels.solveRigid, passes);
            m_s.rolling.Solve(m_bodies.velocity, [&](int at) { return m_blocks.GetPressure(at); });
            m_s.locked.Stop(m_bodies.velocity);
        }
        if (HasJoints()) StoreJointImpulses(JointWork());
        m_blocks.Store(1.0f, Pool(), m_tables.contacts.manifold);
        m_s.rolling.Store(1.0f, m_tables.contacts.rolling);
    }

    int IntegratePositions() {
        return WithBodyKernel(m_settings.kernels, [&](auto, auto limit) {
            const SolverCounts counts = CountOver(Pool(), m_own.size(), [&](size_t i) {
                const BodyIndex b = m_own[i];
                bool capped = false;
                m_delta[b] = MotionOf<limit>(m_settings, m_bodies, b, capped);
                return SolverCounts{capped ? 1 : 0, 0};
            });
            return counts.capped;
        });
    }

    /// Stops as soon as everything is within tolerance; false if it is not.
    bool SolvePositions() {
        bool contactsSolved = false, jointsSolved = false;
        for (int i = 0; i < m_settings.positionIterations && !(contactsSolved && jointsSolved); ++i) {
            contactsSolved = IsWithinTolerance(RunPushApart(Pool(), m_task, m_kernels, baumgarte));
            jointsSolved = !HasJoints() || CorrectJoints();
            m_s.locked.Stop(m_delta);
        }
        return jointsSolved && (contactsSolved || (IsSleepy() && AreContactsSolved()));
    }

    int Finish() {
        const PoseFinisher finisher(m_settings, m_bodies, m_delta, {.keepsRests = false, .hasLimit = false});
        const auto bodyAt = [this](size_t i) { return m_own[i]; };
        return finisher
            .Finish(Pool(), m_own.size(), bodyAt,
                    [this](BodyIndex b) {
                        Move(b);
                        m_delta[b] = {};
                        return SolverCounts{0, FinishPose(m_bodies, b) ? 1 : 0};
                    })
            .nonFinite;
    }

    void Sleep(bool positionsSolved) {
        if (m_settings.allowSleep) SleepIsland(m_bodies, m_own, m_settings, positionsSolved);
    }

private:
    [[nodiscard]] TaskPool& Pool() const { return m_tables.pool; }
    [[nodiscard]] bool HasJoints() const { return !m_joints.empty(); }
    [[nodiscard]] JointTask JointWork() {
        return {JointStepOf(m_settings), m_bodies, m_tables.joints, m_s.joints, Pool()};
    }

    [[nodiscard]] bool IsWithinTolerance(float separation) const {
        return separation - m_settings.Slop() >= ContactTolerance(m_settings);
    }
    /// After the last pass.
    [[nodiscard]] bool AreContactsSolved() const {
        for (size_t i = 0; i < m_contacts.size(); ++i) {
            if (!IsWithinTolerance(m_blocks.GetSeparation(i, m_delta))) return false;
        }
        return true;
    }
    /// False if a body of the island has moved too lately for the island to fall asleep in this step.
    [[nodiscard]] bool IsSleepy() const {
        for (const BodyIndex b : m_own) {
            if (m_bodies.sleepTime[b] + m_settings.dt < timeToSleep) return false;
        }
        return true;
    }

    void Move(BodyIndex b) {
        m_bodies.SetMotion(b, m_delta[b].v);
        m_bodies.position[b].a = m_bodies.startPosition[b].a + m_delta[b].w;
    }

    bool CorrectJoints() {
        for (const BodyIndex b : m_own) {
            if (m_bodies.info[b].jointCount > 0) Move(b);
        }
        const bool solved = SolveJointPositions(JointWork());
        for (const BodyIndex body : m_own) {
            if (m_bodies.info[body].jointCount == 0) continue;
            m_delta[body].v = m_bodies.GetMotion(body);
            m_delta[body].w = m_bodies.position[body].a - m_bodies.startPosition[body].a;
        }
        return solved;
    }

    const SolverSettings& m_settings;
    SolverTables m_tables;
    BodyTable& m_bodies;
    IslandRows& m_s;
    ContactBlocks& m_blocks;
    Column<BodyIndex, Velocity>& m_delta;
    std::span<const BodyIndex> m_own;
    std::span<const ContactIndex> m_contacts;
    std::span<const JointIndex> m_joints;
    const ContactKernels& m_kernels;
    KernelTask m_task{};
};

/// Bodies without contacts and joints.
class IsolatedSolver {
public:
    IsolatedSolver(const SolverSettings& settings, const IslandTable& islands, BodyTable& bodies)
        : m_settings(settings), m_bodies(bodies), m_isolated(islands.isolated), m_path(settings, bodies, 0) {}

    /// Those of [begin, end), on one thread.
    SolverCounts Solve(int begin, int end) const {
        return WithOne([&](auto&& one) { return m_path.MoveRange(Range(m_isolated, begin, end), one); });
    }
    SolverCounts SolveAll(TaskPool& pool) const {
        if (m_isolated.empty()) return {};
        return WithOne([&](auto&& one) { return m_path.Move(pool, m_isolated, one); });
    }
    [[nodiscard]] int Count() const { return static_cast<int>(m_isolated.size()); }

private:
    template <typename Body>
    SolverCounts WithOne(Body&& body) const {
        return WithBodyKernel(m_settings.kernels, [&](auto forces, auto limit) {
            return body([&](BodyIndex b) {
                IntegrateVelocity<forces>(m_settings, m_bodies, b);
                if (m_settings.kernels.locks) StopLocked(m_bodies, b, m_bodies.velocity[b]);
                return IntegratePosition<limit>(m_settings, m_bodies, b);
            });
        });
    }

    const SolverSettings& m_settings;
    BodyTable& m_bodies;
    const std::vector<BodyIndex>& m_isolated;
    BallisticPath m_path;
};

/// What all islands share.
struct IslandWork {
    const SolverSettings& settings;
    const FixtureTable& fixtures;
    const IslandTable& islands;
    const ContactEvents& events;
    SolverScratch& scratch;
};

/// The phases of either solver.
template <typename Solver, typename Report>
SolverCounts RunPhases(Solver&& solver, const FixtureTable& fixtures, Report&& report) {
    SolverCounts counts;
    solver.Prepare(fixtures);
    solver.SolveVelocities();
    counts.capped = solver.IntegratePositions();
    const bool positionsSolved = solver.SolvePositions();
    counts.nonFinite = solver.Finish();
    report();
    solver.Sleep(positionsSolved);
    return counts;
}

/// Which of the rows the caller takes for what it solves while no worker has a job. Such islands may be large, and not
/// all workers need the room.
int RowsAlone(const SolverScratch& s) { return static_cast<int>(s.islandRows.size()) - 1; }

/// By the loops of `tables.pool`.
SolverCounts SolveLone(const IslandWork& work, const LoneIsland& lone, SolverTables tables, int rowsOf) {
    const Island& island = work.islands.islands[ToSize(lone.island)];
    SolverScratch& s = work.scratch;
    IslandRows& rows = s.islandRows[ToSize(rowsOf)];
    if (!IsWide(island)) {
        return RunPhases(IslandSolver(work.settings, work.islands, island, tables, rows), work.fixtures,
                         [&] { ReportImpulses(rows.contacts, work.events, tables.contacts); });
    }
    ContactBlocks& blocks = lone.blocks < 0 ? rows.blocks : s.wide[ToSize(lone.blocks)];
    const auto report = [&] {
        std::ranges::copy(blocks.GetColours(), s.colours.begin() + island.contactBegin);
        ReportBlockImpulses({blocks, false, Contacts(work.islands, island)}, work.events, tables.contacts, s.impulses);
    };
    return RunPhases(WideSolver(work.settings, work.islands, island, tables, rows, blocks, s.delta), work.fixtures,
                     report);
}

/// Lists the islands that are in no group of `lanes`, with room for the blocks of the large ones.
void ListLone(const IslandTable& islands, const LaneSolver& lanes, const BodyTable& bodies, SolverScratch& s) {
    // It pays to keep the blocks of an island until the next step: their contacts need not be coloured again. Small
    // islands may be thousands, and then new blocks in a cache are faster than kept ones outside.
    constexpr int leastKeptContacts = 128;
    s.lone.clear();
    s.colours.clear();
    int kept = 0;
    bool isAnyWide = false;
    for (size_t i = 0; i < islands.islands.size(); ++i) {
        if (lanes.Has(i)) continue;
        const Island& island = islands.islands[i];
        const int size = CountContacts(island) + island.jointEnd - island.jointBegin;
        s.lone.push_back({static_cast<int>(i), CountContacts(island) >= leastKeptContacts ? kept++ : -1, size});
        isAnyWide = isAnyWide || IsWide(island);
    }
    if (!isAnyWide) return;
    s.colours.resize(islands.contacts.size());
    s.delta.resize(ToSize(bodies.slots.Size()));
    if (s.wide.size() < ToSize(kept)) s.wide.resize(ToSize(kept));
    // The place of a large island among the others changes. Its room is not to stay wherever it was.
    constexpr size_t mostRoom = 4, anyRoom = 1024;
    for (const LoneIsland& lone : s.lone) {
        if (lone.blocks < 0) continue;
        ContactBlocks& blocks = s.wide[ToSize(lone.blocks)];
        if (blocks.GetRoom() > mostRoom * ToSize(lone.size) + anyRoom) blocks = {};
    }
}

/// What is solved by one worker each: the lone islands from `firstLone` on, and groups. The longest first.
void ListJobs(const IslandTable& islands, size_t firstLone, const LaneSolver& lanes, SolverScratch& s) {
    s.jobs.clear();
    for (size_t i = firstLone; i < s.lone.size(); ++i)
        s.jobs.push_back({false, static_cast<int>(i), CostOf(islands.islands[ToSize(s.lone[i].island)])});
    for (int group = 0; group < lanes.CountGroups(); ++group) s.jobs.push_back({true, group, lanes.CostOf(group)});
    std::ranges::sort(s.jobs, [](const SolverJob& a, const SolverJob& b) {
        return std::tie(b.cost, a.isGroup, a.index) < std::tie(a.cost, b.isGroup, b.index);
    });
}

/// Large islands one after the other, each by loops that the workers share. Then all else, each by one worker. Neither
/// way changes a bit.
SolverCounts SolveShared(const IslandWork& work, const IsolatedSolver& isolated, LaneSolver& lanes,
                         SolverTables tables) {
    // Smaller ones have too few contacts of one colour for a loop of several workers.
    constexpr int leastSharedSize = 2048;
    // Less of all together is not worth a loop. So many isolated bodies take as long as one contact side by side.
    constexpr int leastCost = 64, isolatedOfOne = 24;
    SolverScratch& s = work.scratch;
    SolverCounts counts;
    const int alone = RowsAlone(s);
    const std::span ofWorkers = std::span(s.islandRows).first(ToSize(alone));
    MatchRooms(ofWorkers);
    s.islandRows[ToSize(alone)].MatchRoomOf(ofWorkers.front());
    MatchRooms(std::span(s.lanes.workers));
    std::ranges::sort(s.lone, [](const LoneIsland& a, const LoneIsland& b) {
        return std::tie(b.size, a.island) < std::tie(a.size, b.island);
    });
    int64_t rest = isolated.Count() / isolatedOfOne;
    for (const LoneIsland& one : s.lone) rest += CostOf(work.islands.islands[ToSize(one.island)]);
    for (int group = 0; group < lanes.CountGroups(); ++group) rest += lanes.CostOf(group);
    size_t first = 0;
    const int workers = tables.pool.GetWorkerCount();
    for (; first < s.lone.size(); ++first) {
        const LoneIsland& one = s.lone[first];
        if (one.size < leastSharedSize || static_cast<int64_t>(one.size) * workers <= rest) break;
        counts += SolveLone(work, one, tables, alone);
        rest -= CostOf(work.islands.islands[ToSize(one.island)]);
    }
    rest = lanes.Spread(rest, workers, s.lone);
    ListJobs(work.islands, first, lanes, s);
    // Jobs are dealt like cards, the longest first, so that parts and neighbouring parts are of like size. Isolated
    // bodies are cut where other loops over bodies are, so that a thread has those that it has in its caches.
    constexpr int partsPerWorker = 4, leastIsolatedOfPart = 128;
    const auto count = static_cast<int>(s.jobs.size());
    const int pieces = count + (isolated.Count() + leastIsolatedOfPart - 1) / leastIsolatedOfPart;
    const int rounds = pieces >= partsPerWorker * workers ? partsPerWorker : 1;
    const int parts = std::min(pieces, rounds * workers);
    TaskPool onOne(1, {});
    const SolverTables own{onOne, tables.bodies, tables.contacts, tables.joints};
    const auto solve = [&](const SolverJob& job, int worker) {
        return job.isGroup ? lanes.Solve(work.fixtures, job.index, job.index + 1, worker)
                           : SolveLone(work, s.lone[ToSize(job.index)], own, worker);
    };
    const auto cut = [&](int part) {  // the newest come first, unlike in other loops
        return isolated.Count() - static_cast<int>(int64_t{isolated.Count()} * part / parts);
    };
    SolverCounts ofWorker[maxWorkers];
    tables.pool.For(parts, rest < leastCost ? parts + 1 : 2, [&](int begin, int end, int worker) {
        for (int part = begin; part < end; ++part) {
            for (int i = part % rounds * workers + part / rounds; i < count; i += parts)
                ofWorker[worker] += solve(s.jobs[ToSize(i)], worker);
            ofWorker[worker] += isolated.Solve(cut(part + 1), cut(part));
        }
    });
    for (const SolverCounts& some : ofWorker) counts += some;
    return counts;
}

}  // namespace

SolverCounts SolveIslands(const SolverSettings& settings, const FixtureTable& fixtures, const IslandTable& islands,
                          const ContactEvents& events, SolverTables tables, SolverScratch& scratch) {
    const int rows = tables.pool.GetRowCount();
    EnsureRows(scratch.islandRows, ToSize(rows > 1 ? rows + 1 : 1));
    EnsureRows(scratch.lanes.workers, ToSize(tables.pool.GetRowCount()));
    const IsolatedSolver isolated(settings, islands, tables.bodies);
    LaneSolver lanes(settings, islands, events, tables, scratch);
    ListLone(islands, lanes, tables.bodies, scratch);
    const IslandWork work{settings, fixtures, islands, events, scratch};
    if (tables.pool.IsOpen() && !events.HearsPostSolve()) return SolveShared(work, isolated, lanes, tables);
    SolverCounts counts = isolated.SolveAll(tables.pool);
    // In their order, in which the listener hears of them.
    for (const LoneIsland& lone : scratch.lone) counts += SolveLone(work, lone, tables, RowsAlone(scratch));
    return counts += lanes.Solve(fixtures, 0, lanes.CountGroups(), 0);
}

}  // namespace scree
