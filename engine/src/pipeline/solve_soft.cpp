// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The soft step: the step is cut into sub-steps. Each solves every constraint once with soft rows, moves the bodies,
// and solves once more without push. So what pushed overlaps apart does not stay as speed (Macklin et al., "Small Steps
// in Physics Simulation", 2019; Catto, "Solver2D", 2024). Contacts are frozen at the start of the step: normals, arms
// and masses are computed once, separations are linear in the bodies' motion.
//
// Forces, and what contacts are expected to do, act half before and half after a move: kick, drift, kick. So motion
// under constant forces, sliding included, is exact. It is the Störmer–Verlet method (Hairer, Lubich, Wanner,
// "Geometric Numerical Integration", 2006, I.1.4). Isolated bodies run the same arithmetic, hence get the same bits.
//
// With frozen Jacobians warm starting needs no pass over the contacts. What they did to a body's velocity in the last
// sub-step, they are expected to do again in this one. Joints are made anew in every sub-step, at the present poses.
// They are solved rigidly on velocities, and their position error is removed after each move, as in sequential
// impulses.
//
// A contact bounces in the sub-step in which it is met, before anything else.
//
// Where contacts alone hold the bodies, threads go through all sub-steps in one loop: the bodies of a slice follow on
// the blocks that push them (constraints/block_chains.h).

#include "pipeline/solve_soft.h"

#include <algorithm>
#include <array>

#include "base/gather_parts.h"
#include "pipeline/parts/ballistic_path.h"
#include "pipeline/parts/pose_finisher.h"
#include "pipeline/parts/report_impulses.h"
#include "pipeline/parts/run_kernel.h"
#include "pipeline/parts/soft_bodies.h"

namespace scree {

namespace {

template <bool forces, bool limit>
SolverCounts SolveIsolated(const SolverSettings& settings, const IslandTable& active, TaskPool& pool,
                           BodyTable& bodies) {
    if (active.isolated.empty()) return {};
    const float h = settings.dt / static_cast<float>(settings.substeps);
    const BallisticPath path(settings, bodies, settings.substeps);
    return path.Move(pool, active.isolated, [&](BodyIndex body) {
        bodies.NoteStart(body);
        SoftBody soft = MakeSoftBody<forces>(settings, bodies, body);
        Velocity v = bodies.velocity[body];
        Velocity delta{};
        for (int i = 0; i < settings.substeps; ++i) {
            Kick<forces>(soft, v);
            Drift(v, h, delta);
            Kick<forces>(soft, v);
        }
        if (settings.kernels.locks) {
            StopLocked(bodies, body, v);
            StopLocked(bodies, body, delta);
        }
        bodies.velocity[body] = v;
        return MoveBody<limit>(settings, bodies, body, delta);
    });
}

/// In a row of equal balls each hands on (1 + e)/2 of what it got, and e of that is what a bounce adds to a blow
/// without one. A contact takes part in a pass while that is 1 % of the first blow. By pass: the largest e that is out.
constexpr std::array<float, 32> MakeLeastBounces() {
    constexpr double share = 0.01;
    std::array<float, 32> least{};
    for (size_t pass = 1; pass < least.size(); ++pass) {
        double low = 0.0, high = 1.0;
        for (int i = 0; i < 40; ++i) {
            const double e = 0.5 * (low + high);
            double handed = e;
            for (size_t k = 0; k < pass; ++k) handed *= 0.5 * (1.0 + e);
            (handed > share ? high : low) = e;
        }
        least[pass] = static_cast<float>(low);
    }
    return least;
}
constexpr std::array<float, 32> leastBounces = MakeLeastBounces();

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
          m_tree(scratch.constraints.tree),
          m_blocks(scratch.constraints.blocks),
          m_joints(scratch.constraints.joints),
          m_kernels(GetContactKernels()) {}

    void Prepare(const FixtureTable& fixtures, bool report) {
        m_s.delta.resize(ToSize(m_bodies.slots.Size()));
        m_s.jointed.clear();
        if (HasJoints() && !m_tables.isRest) m_s.startVelocities.Reserve(m_bodies.velocity.size());
        m_blocks.GetSlices().Update(Pool(), m_bodies, m_tables.contacts, m_islands.contacts);
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) { PrepareBodies<forces>(); });
        m_s.locked.Gather(m_settings.kernels, m_islands.bodies, m_bodies);
        // Before any of them counts as heavier.
        if (HasJoints() && FollowsLoads()) {
            m_s.bearers.Find(Pool(), m_bodies, m_tables.contacts, m_islands.contacts);
        }
        RaiseLoaded(fixtures);
        m_tree.Build({Pool(), m_bodies, m_tables.joints, m_islands.joints, m_settings.SubstepScale(), JointCompliance(),
                      m_settings.directJoints, &m_s.bearers});
        m_s.bearers.Forget();
        m_tables.contacts.steady.resize(m_tables.contacts.flags.size());
        m_blocks.Build({Pool(), m_bodies, fixtures, m_tables.contacts, m_islands.contacts, m_settings.ContactScale(),
                        m_settings.kernels.restitution, m_settings.lengthScale, true, &m_tables.contacts.steady, true,
                        AreHeldByContacts()},
                       m_s.marks);
        PrepareRolling(m_settings, fixtures, m_islands.contacts, m_settings.ContactScale(), m_tables, m_s.rolling);
        m_task = m_blocks.Task(m_bodies.velocity, m_s.delta);
        m_task.soft = MakeConstants();
        m_task.friction = m_settings.kernels.friction;
        m_task.sumImpulses = report || m_blocks.Bounces() || !m_s.loaded.IsEmpty();
        if (m_blocks.GetInitialOverlapCount() > 0) {
            if (HasJoints()) m_blocks.LeaveJointed(m_bodies, Pool(), m_tables.contacts.steady);
            if (!m_tables.isRest) PushInitialApart();
        }
        const bool hasRows = !m_tree.GetOthers().empty() || !m_tree.GetBounded().empty();
        m_plan = {.warmStarts = m_settings.ContactScale() > 0.0f,
                  .hasContacts = !m_blocks.IsEmpty(),
                  .bounces = m_blocks.Bounces(),
                  .hasRows = hasRows,
                  .placesInDrift = hasRows && m_s.locked.IsEmpty(),
                  .hasTrees = !m_tree.IsEmpty(),
                  .hasNets = !m_tree.GetNets().IsEmpty()};
        if (m_plan.hasNets) GatherNetted();
        PlanBounds(JointWork(1.0f), m_tree.GetBounded());
    }

    void RunSubsteps() {
        const bool mayChain = MayChain();
        for (int begin = 0, end = 0; begin < m_settings.substeps; begin = end) {
            end = begin + 1;
            while (end < m_settings.substeps && !RenewsExpected(end)) ++end;
            if (mayChain && Pool().KeepsPace()) {
                RunChained(begin, end);
            } else {
                for (int i = begin; i < end; ++i) Substep(i);
            }
        }
    }

    SolverCounts Finish() {
        // A manifold's impulses are those of a whole step, whatever its sub-steps.
        m_blocks.Store(static_cast<float>(m_settings.substeps), Pool(), m_tables.contacts.manifold);
        m_s.rolling.Store(static_cast<float>(m_settings.substeps), m_tables.contacts.rolling);
        if (m_plan.hasRows) {
            ScaleJointImpulses(JointWork(2.0f * static_cast<float>(m_settings.substeps)), m_tree.GetOthers());
        }
        m_tree.Store(1.0f, m_tables.joints);
        LowerLoaded();
        return WithBodyKernel(m_settings.kernels, [&](auto, auto limit) {
            const PoseFinisher finisher(m_settings, m_bodies, m_s.delta, {.keepsRests = true, .hasLimit = limit});
            const auto bodyAt = [this](size_t i) { return m_s.soft[i].body; };
            return finisher.Finish(Pool(), m_s.soft.size(), bodyAt, [&](BodyIndex b) {
                SolverCounts counts;
                counts.capped = MoveBody<limit>(m_settings, m_bodies, b, m_s.delta[b]) ? 1 : 0;
                m_s.delta[b] = {};
                counts.nonFinite = FinishPose(m_bodies, b) ? 1 : 0;
                return counts;
            });
        });
    }

private:
    /// What there is to do in each sub-step; the same in all of them.
    struct Plan {
        bool warmStarts = false;  ///< impulses of the last step are known
        bool hasContacts = false;
        bool bounces = false;        ///< some contact may
        bool hasRows = false;        ///< joints that are solved row by row
        bool placesInDrift = false;  ///< bodies with joints are where these see them as soon as they have moved
        bool hasTrees = false;       ///< joints that are solved directly
        bool hasNets = false;        ///< joints of nets
    };

    [[nodiscard]] TaskPool& Pool() const { return m_tables.pool; }

    [[nodiscard]] bool AreHeldByContacts() const { return !HasJoints() && m_s.locked.IsEmpty(); }
    [[nodiscard]] bool MayChain() const {
        return AreHeldByContacts() && m_plan.hasContacts && m_plan.warmStarts && !m_plan.bounces &&
               m_s.rolling.IsEmpty() && m_blocks.FollowSlices();
    }

    /// The sub-steps [begin, end) as passes. The first one needs accumulated impulses: what these do comes first. Then
    /// come contacts, moves, contacts without push, and the kicks of the next sub-step.
    struct Chained {
        static constexpr bool hasBodies = true;
        SoftSolver& solver;
        int begin, end;

        [[nodiscard]] int CountPasses() const { return 1 + 2 * (end - begin); }
        void RunBlocks(const KernelTask& part, int pass, int /*worker*/) const {
            const ContactKernels& kernels = solver.m_kernels;
            (pass == 0 ? kernels.warmStart : pass % 2 == 1 ? kernels.solveSoft : kernels.relax)(part);
        }
        void RunBodies(int chain, int pass) const {
            WithBodyKernel(solver.m_settings.kernels, [&](auto forces, auto) {
                if (pass == 0) return ForEach(chain, [&](SoftBody& soft) { solver.Expect<forces>(soft); });
                if (pass % 2 == 1) return ForEach(chain, [&](SoftBody& soft) { solver.DriftBody<forces>(soft); });
                if (pass + 1 == CountPasses()) return;
                ForEach(chain, [&](SoftBody& soft) {
                    solver.EndContacts(soft);
                    solver.KickBody<forces>(soft);
                });
            });
        }
        template <typename Visit>
        void ForEach(int chain, Visit&& visit) const {
            const auto [first, last] = solver.m_blocks.GetSlices().GetRange(chain);
            for (size_t i = first; i < last; ++i) visit(solver.m_s.soft[i]);
        }
    };
    void RunChained(int begin, int end) {
        NoteVelocities(begin);
        const Chained work{*this, begin, end};
        RunChains(Pool(), m_task, work.CountPasses(), work);
    }

    template <bool forces>
    void PrepareBodies() {
        const std::span<const BodyIndex> list =
            m_blocks.GetSlices().Sort(Pool(), m_bodies, m_islands.bodies, m_s.sliced);
        m_s.soft.resize(list.size());
        const bool hasJoints = HasJoints();
        ForEachOf(Pool(), m_s.soft.size(), [&](size_t i) {
            const BodyIndex body = list[i];
            m_bodies.NoteStart(body);
            m_s.soft[i] = MakeSoftBody<forces>(m_settings, m_bodies, body);
            if (!hasJoints) m_s.soft[i].gained = {m_bodies.velocity[body].v, m_bodies.velocity[body].w};
        });
        if (hasJoints) ListJointed();
    }
    void ListJointed() {
        GatherParts<int, 1>(Pool(), static_cast<int>(m_s.soft.size()), leastBodies, {&m_s.jointed},
                            [&](int begin, int end, const std::array<int*, 1>& places) {
                                int* place = places[0];
                                for (int i = begin; i < end; ++i) {
                                    SoftBody& soft = m_s.soft[ToSize(i)];
                                    if (m_bodies.info[soft.body].jointCount == 0) continue;
                                    soft.jointed = true;
                                    if (!m_tables.isRest)
                                        m_s.startVelocities.Note(soft.body, m_bodies.velocity[soft.body]);
                                    *place++ = i;
                                }
                                return std::array{static_cast<size_t>(place - places[0])};
                            });
    }

    /// As many as a pile needs to rise as a whole where most contacts are such; few for the sake of few contacts.
    [[nodiscard]] int CountPasses() const {
        constexpr int leastPasses = 2, leastInCrowd = 8, mostPasses = 128;
        constexpr int visitsToStep = 1 << 14;  // of blocks
        const int blocks = m_blocks.GetBlockCount();
        const float share = static_cast<float>(m_blocks.GetInitialOverlapCount()) / static_cast<float>(blocks);
        const int wanted = static_cast<int>(4.0f * share * share);
        return std::clamp(wanted, leastPasses, std::clamp(visitsToStep / blocks, leastInCrowd, mostPasses));
    }
    /// With a tolerance whole piles rise where springs grow stiffer. That is rare, and they are to rise evenly. It
    /// takes them apart by a slop in a step, and neighbours by theirs; bodies in each other lack more.
    [[nodiscard]] bool IsStiffened(float lacking) const {
        constexpr float most = 2.5f;  // slops
        return m_settings.tolerance != nullptr && lacking <= most * m_settings.Slop();
    }
    [[nodiscard]] int CountStiffenedPasses() const {
        constexpr int leastPasses = 8, mostPasses = 512, visits = 1 << 19;
        return std::clamp(visits / m_blocks.GetBlockCount(), leastPasses, mostPasses);
    }
    /// Overlap in which bodies were made is not the doing of any speed, and pushing it apart is to leave none. So only
    /// positions move, before the first sub-step, and springs do not see it. A squeezed pile rises without being
    /// thrown, alike with any number of sub-steps. With few passes it would rise from its ends, tilt and spread; in
    /// large worlds that is the lesser evil. Faster, a house of cards that were made a little into each other falls.
    void PushInitialApart() {
        constexpr float rate = 12.0f, largestShare = 0.8f;  // of what is left, 1/s and in a step
        constexpr float deep = 10.0f;                       // slops: bodies lie in each other, none on another
        constexpr float fasterThanSprings = 30.0f;
        constexpr float enough = 0.05f;               // of what was lacking at first
        constexpr float passed = 0.02f, done = 0.1f;  // slops
        const Parting parting{.share = Min(rate * m_settings.dt, largestShare),
                              .largestShare = largestShare,
                              .atOnce = m_settings.tolerance != nullptr ? m_settings.Slop() : 0.0f,
                              .deep = deep * m_settings.Slop(),
                              .most = fasterThanSprings * m_settings.contactPushSpeed * m_settings.dt};
        int passes = CountPasses();
        float allowed = passed * m_settings.Slop();
        for (int i = 0; i < passes; ++i) {
            const float lacking = RunPart(Pool(), m_task, m_kernels, parting);
            if (i == 0) {
                allowed = Max(allowed, enough * lacking);
                if (IsStiffened(lacking)) passes = CountStiffenedPasses();
            }
            if (lacking <= allowed) break;
        }
        m_s.locked.Stop(m_s.delta);
        RunKernel(Pool(), m_task,
                  [&](const KernelTask& part, int) { m_kernels.endParting(part, parting, done * m_settings.Slop()); });
        m_blocks.StoreInitialOverlaps(Pool(), m_tables.contacts.steady);
        // In a crowd bodies are pushed into others that they had no contact with.
        const bool isCrowd = 2 * m_blocks.GetInitialOverlapCount() > blockLanes * m_blocks.GetBlockCount();
        m_tables.contacts.addsFresh = m_tables.contacts.addsFresh || isCrowd;
        // What still parts does not sleep.
        const float way = SleepSpeed(m_settings) * m_settings.dt;
        for (const SoftBody& soft : m_s.soft) {
            const Vec2 moved = m_s.delta[soft.body].v;
            if (Dot(moved, moved) > way * way) m_bodies.sleepTime[soft.body] = 0.0f;
        }
    }

    template <typename Visit>
    void ForEachSoft(Visit&& visit) {
        ForEachOf(Pool(), m_s.soft.size(), [&](size_t i) { visit(m_s.soft[i]); });
    }

    /// The same frequency whatever the number of sub-steps, so that bodies rest at the same depth; where sub-steps are
    /// too long for it, the stiffest spring that they carry. What cannot be pushed holds twice as stiffly: piles are
    /// not to sink into the ground. Only where a tolerance asks for less overlap more sub-steps make it stiffer.
    [[nodiscard]] float ContactHertz() const {
        constexpr float mostTurns = 0.25f;  // of a spring in a sub-step
        constexpr float usual = 4.0f;       // sub-steps
        float hertz = m_settings.contactHertz;
        if (m_settings.tolerance != nullptr) hertz *= static_cast<float>(m_settings.substeps) / usual;
        return Min(hertz, mostTurns / m_h);
    }
    /// Of joints that a direct solve holds, in shares of a row's own inverse mass per sub-step. So joints are stiffer
    /// the shorter sub-steps are. Under a tolerance their number changes from step to step, and a stretched joint that
    /// grew stiffer would bring energy. There joints are always as stiff as with sub-steps of this length.
    [[nodiscard]] double JointCompliance() const {
        constexpr double usual = 1.0 / 960.0;  // s
        if (m_settings.tolerance == nullptr) return jointCompliance;
        const double shorter = usual / double{m_h};
        return jointCompliance * shorter * shorter;
    }
    [[nodiscard]] SoftConstants MakeConstants() const {
        const float hertz = ContactHertz();
        return {.inverseH = 1.0f / m_h,
                .pushSpeed = m_settings.contactPushSpeed,
                .between = MakeSoftSpring(hertz),
                .fixed = MakeSoftSpring(2.0f * hertz)};
    }
    [[nodiscard]] SoftSpring MakeSoftSpring(float hertz) const {
        const float turn = 2.0f * pi * hertz * m_h;
        const float damping = 2.0f * m_settings.contactDampingRatio + turn;
        return {.biasRate = turn / (damping * m_h), .stiffness = 1.0f + 1.0f / (turn * damping)};
    }

    /// Longer sub-steps do not follow what springs back when a taut chain takes a load up.
    [[nodiscard]] bool FollowsLoads() const {
        constexpr float mostTurns = 0.125f;  // of a contact's spring in a sub-step
        return m_settings.contactHertz * m_h <= 1.001f * mostTurns;
    }
    void RaiseLoaded(const FixtureTable& fixtures) {
        constexpr float depth = 0.5f;  // slops
        const float turnRate = 2.0f * pi * ContactHertz();
        m_s.loaded.Raise({.pool = Pool(),
                          .fixtures = fixtures,
                          .contacts = m_tables.contacts,
                          .joints = m_tables.joints,
                          .bodies = m_islands.bodies,
                          .list = m_islands.contacts,
                          .gravity = m_settings.gravity,
                          .dt = m_settings.dt,
                          .stiffness = turnRate * turnRate,
                          .depth = depth * m_settings.Slop(),
                          .raisesJointed = FollowsLoads()},
                         m_bodies);
    }
    void LowerLoaded() {
        if (m_s.loaded.IsEmpty()) return;
        m_blocks.GetImpulses(true, m_s.impulses);
        m_s.loaded.Lower(m_bodies, m_s.impulses);
    }
    [[nodiscard]] bool HasJoints() const { return !m_islands.joints.empty(); }
    /// Impulses of half a sub-step; what may still close, may do so in a whole one.
    [[nodiscard]] JointTask JointWork(float impulseScale) {
        const float dt = m_settings.dt, slop = m_settings.Slop();
        return {JointStep::Half(dt, m_settings.substeps, m_substep, impulseScale, slop), m_bodies, m_tables.joints,
                m_joints, Pool()};
    }
    [[nodiscard]] JointTree::Poses Poses() const { return {m_bodies, m_s.delta}; }

    void Substep(int index) {
        m_substep = index;
        const bool isFirst = index == 0;
        Bounce();
        ExpectContacts(index);
        KickAll();
        PrepareRows(isFirst);
        ProjectTrees(isFirst);
        SolveRows();
        SolveContacts(isFirst);
        AimTrees();
        DriftAll();
        CorrectRows();
        StopTrees();
        StopRows();
        Relax(index);
    }

    // The phases of a sub-step, in order.

    /// Contacts bounce one after the other until none is left, as each ball in a row hands on what it got. Source:
    /// Smith, Kaufman, Vouga, Tamstorf, Grinspun, "Reflections on Simultaneous Impact", SIGGRAPH 2012.
    void Bounce() {
        if (!m_plan.bounces) return;
        for (const float least : leastBounces) {
            m_task.leastBounce = least;
            if (!RunBounce(Pool(), m_task, m_kernels)) return;
        }
    }
    void KickAll() {
        if (!m_isKicked) {
            WithBodyKernel(m_settings.kernels,
                           [&](auto forces, auto) { ForEachSoft([&](SoftBody& soft) { KickBody<forces>(soft); }); });
        }
        m_isKicked = false;
        StopLocked();
    }
    template <bool forces>
    SCREE_INLINE void KickBody(SoftBody& soft) {
        soft.jointed ? Kick<forces>(soft, VelocityOf(soft)) : KickWhole<forces>(soft, VelocityOf(soft));
    }
    /// Joints are solved twice in a sub-step, with half of its forces each time.
    void PrepareRows(bool isFirst) {
        if (!m_plan.hasRows) return;
        PrepareJoints(JointWork(isFirst ? 0.5f * m_settings.SubstepScale() : 1.0f), m_tree.GetOthers());
        m_rowsAct = m_joints.Act();
    }
    /// Rows and contacts of a tree must see what its joints make of the forces.
    void ProjectTrees(bool isFirst) {
        if (!m_plan.hasTrees) return;
        const bool isSeen = m_plan.hasContacts || m_rowsAct;
        if (isFirst && isSeen) return m_tree.FactorizeAndStop(Poses(), m_h, m_bodies.velocity);
        if (isFirst) m_tree.Factorize(Poses(), m_h);
        if (isSeen) m_tree.SolveAfterMove(m_bodies.velocity);
    }
    void SolveRows() {
        if (m_rowsAct) SolveJointVelocities(JointWork(1.0f));
        if (!m_plan.hasNets) return;
        KickNetted();
        m_tree.GetNets().SolveBeforeMove(Pool(), m_bodies, m_s.delta, m_h, m_bodies.velocity);
        StopLocked();
    }
    /// Without warm starting nothing is known of the contacts in the first sub-step: piles would sag before their
    /// impulses have grown.
    void SolveContacts(bool isFirst) {
        constexpr int coldIterations = 32;
        const int iterations = isFirst && !m_plan.warmStarts ? 1 + coldIterations : 1;
        if (!m_plan.hasContacts) return;
        NoteUnaided();
        for (int i = 0; i < iterations; ++i) {
            RunKernel(Pool(), m_task, m_kernels.solveSoft);
            SolveRolling();
            StopLocked();
        }
        ForEachOf(Pool(), m_s.jointed.size(), [&](size_t i) { NoteGained(Jointed(i)); });
    }
    /// Velocities with which the trees' joints are closed after the move.
    void AimTrees() {
        if (m_plan.hasNets) HoldNettedBack();
        if (m_plan.hasTrees) m_tree.SolveBeforeMove(Poses(), m_h, m_bodies.velocity);
        StopLocked();
    }
    void DriftAll() {
        WithBodyKernel(m_settings.kernels,
                       [&](auto forces, auto) { ForEachSoft([&](SoftBody& soft) { DriftBody<forces>(soft); }); });
        StopLocked();
        m_s.locked.Stop(m_s.delta);
    }
    template <bool forces>
    SCREE_INLINE void DriftBody(SoftBody& soft) {
        Velocity& v = VelocityOf(soft);
        Velocity& delta = m_s.delta[soft.body];
        if (!soft.jointed) return DriftWhole(soft, v, m_h, delta);
        Drift(v, m_h, delta);
        Kick<forces>(soft, v);
        if (m_plan.placesInDrift) Place(soft);
    }
    void CorrectRows() {
        if (!m_plan.hasRows) return;
        if (!m_plan.placesInDrift) ForEachOf(Pool(), m_s.jointed.size(), [&](size_t i) { Place(Jointed(i)); });
        if (!m_rowsAct) return;
        CorrectJoints();
        m_s.locked.Stop(m_s.delta);
    }
    /// No speed is left along the trees' joints.
    void StopTrees() {
        if (!m_plan.hasTrees) return;
        m_tree.FactorizeAndStop(Poses(), m_h, m_bodies.velocity);
    }
    void StopRows() {
        if (m_plan.hasNets) {
            m_tree.GetNets().SolveAfterMove(Pool(), m_bodies, m_s.delta, m_bodies.velocity);
            StopLocked();
        }
        if (!m_rowsAct) return;
        SolveJointVelocities(JointWork(1.0f));
        if (m_plan.hasTrees) m_tree.SolveAfterMove(m_bodies.velocity);
    }
    /// Contacts once more, without pushing apart.
    void Relax(int substep) {
        if (m_plan.hasContacts) {
            NoteUnaided();
            RunKernel(Pool(), m_task, m_kernels.relax);
            SolveRolling();
        }
        StopLocked();
        EndContacts(substep);
    }
    /// What contacts did in this sub-step is what they are expected to do in the next one. Where nothing comes between
    /// that and the next kick, one walk over the bodies does both.
    void EndContacts(int substep) {
        const int next = substep + 1;
        if (!m_plan.hasContacts || next == m_settings.substeps || RenewsExpected(next)) return;
        if (m_plan.bounces) return ForEachSoft([&](SoftBody& soft) { EndContacts(soft); });
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
            ForEachSoft([&](SoftBody& soft) {
                EndContacts(soft);
                KickBody<forces>(soft);
            });
        });
        m_isKicked = true;
    }

    /// What is repeated comes from differences of velocities. Their rounding errors, which differ from body to body,
    /// would be repeated with it, and momentum drift with the number of sub-steps to the power of 1.5.
    static bool RenewsExpected(int substep) { return substep >= 4 && substep % 2 == 0; }

    /// What contacts will do to each body in this sub-step: by their accumulated impulses where those are needed, else
    /// what they did in the last one.
    void ExpectContacts(int substep) {
        const bool isNeeded = substep == 0 ? m_plan.warmStarts : RenewsExpected(substep);
        if (!isNeeded) return;
        NoteVelocities(substep);
        RunKernel(Pool(), m_task, m_kernels.warmStart);
        m_s.rolling.WarmStart(m_bodies.velocity);
        WithBodyKernel(m_settings.kernels,
                       [&](auto forces, auto) { ForEachSoft([&](SoftBody& soft) { Expect<forces>(soft); }); });
        m_isKicked = true;
    }
    /// Those before warm starting. When the step begins most worlds know them.
    void NoteVelocities(int substep) {
        if (substep == 0 && !m_plan.bounces && !HasJoints()) return;
        ForEachSoft([&](SoftBody& soft) {
            const Velocity& v = VelocityOf(soft);
            soft.gained = {v.v, v.w};
        });
    }
    /// After warm starting: takes back what it did, and kicks.
    template <bool forces>
    SCREE_INLINE void Expect(SoftBody& soft) {
        Velocity& v = VelocityOf(soft);
        soft.byContacts = {v.v - soft.gained.v, v.w - soft.gained.w};
        v.v = soft.gained.v, v.w = soft.gained.w;
        soft.gained = {};
        KickBody<forces>(soft);
    }

    // Bodies of nets get all forces of a sub-step before their joints are solved, and move by what comes of it. With
    // the velocity between the halves they would move by half of impulses that joints solved in turn do not know yet:
    // unequal masses would feed on that.

    void GatherNetted() {
        m_s.netted.clear();
        for (const int i : m_s.jointed) {
            if (m_tree.GetNets().Holds(m_s.soft[ToSize(i)].body)) m_s.netted.push_back({i, {}});
        }
    }
    void KickNetted() {
        WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
            for (NettedBody& netted : m_s.netted) {
                SoftBody& soft = m_s.soft[ToSize(netted.soft)];
                Velocity& v = VelocityOf(soft);
                netted.ahead = {-v.v, -v.w};
                Kick<forces>(soft, v);
                netted.ahead.v += v.v, netted.ahead.w += v.w;
            }
        });
    }
    void HoldNettedBack() {
        for (const NettedBody& netted : m_s.netted) {
            const SoftBody& soft = m_s.soft[ToSize(netted.soft)];
            Velocity& v = VelocityOf(soft);
            v.v -= netted.ahead.v, v.w -= netted.ahead.w;  // DriftAll brings it
            m_s.delta[soft.body].v += m_h * netted.ahead.v;
            m_s.delta[soft.body].w += m_h * netted.ahead.w;
        }
    }

    void StopLocked() { m_s.locked.Stop(m_bodies.velocity); }
    void SolveRolling() {
        m_s.rolling.Solve(m_bodies.velocity, [&](int at) { return m_blocks.GetPressure(at); });
    }

    // Joints are warm-started by themselves, so of what jointed bodies gain only what contacts did is to be repeated.
    // For other bodies the velocities before and after a sub-step tell.

    void NoteUnaided() {
        ForEachOf(Pool(), m_s.jointed.size(), [&](size_t i) {
            SoftBody& soft = Jointed(i);
            const Velocity& v = VelocityOf(soft);
            soft.unaided = {v.v, v.w};
        });
    }
    SCREE_INLINE void NoteGained(SoftBody& soft) {
        const Velocity& v = VelocityOf(soft);
        soft.gained.v += v.v - soft.unaided.v;
        soft.gained.w += v.w - soft.unaided.w;
    }
    SCREE_INLINE void EndContacts(SoftBody& soft) {
        if (soft.jointed) {
            NoteGained(soft);
            soft.byContacts.v += soft.gained.v, soft.byContacts.w += soft.gained.w;
            soft.gained = {};
            return;
        }
        const Velocity& v = VelocityOf(soft);
        soft.byContacts = {v.v - soft.unaided.v, v.w - soft.unaided.w};
    }
    [[nodiscard]] Velocity& VelocityOf(const SoftBody& soft) { return m_bodies.velocity[soft.body]; }
    [[nodiscard]] SoftBody& Jointed(size_t i) { return m_s.soft[ToSize(m_s.jointed[i])]; }

    /// Where joints that are rows see it.
    SCREE_INLINE void Place(const SoftBody& soft) {
        const Velocity& delta = m_s.delta[soft.body];
        m_bodies.SetMotion(soft.body, delta.v);
        m_bodies.position[soft.body].a = m_bodies.startPosition[soft.body].a + delta.w;
    }
    /// Removes the position errors of joints that are rows, takes the result back as motion, and warm-starts the joints
    /// for what comes after the move.
    void CorrectJoints() {
        SolveJointPositionsAndWarmStart(JointWork(1.0f));
        ForEachOf(Pool(), m_s.jointed.size(), [&](size_t i) {
            const BodyIndex b = Jointed(i).body;
            m_s.delta[b].v = m_bodies.GetMotion(b);
            m_s.delta[b].w = m_bodies.position[b].a - m_bodies.startPosition[b].a;
        });
    }

    const SolverSettings& m_settings;
    const float m_h;
    const IslandTable& m_islands;
    BodyTable& m_bodies;
    SolverTables m_tables;
    SolverScratch& m_s;
    JointTree& m_tree;
    ContactBlocks& m_blocks;
    JointConstraints& m_joints;
    const ContactKernels& m_kernels;
    KernelTask m_task{};
    Plan m_plan;
    int m_substep = 0;
    bool m_rowsAct = false;   ///< in this sub-step some joint is solved row by row
    bool m_isKicked = false;  ///< bodies have had the first kick of the next sub-step
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
    solver.RunSubsteps();
    counts += solver.Finish();
    if (tables.noteDemand) scratch.constraints.tree.NotePullRates(settings.dt, tables.bodies.demand);
    ReportBlockImpulses({scratch.constraints.blocks, true, active.contacts}, events, tables.contacts, scratch.impulses);
    return counts;
}

}  // namespace scree
