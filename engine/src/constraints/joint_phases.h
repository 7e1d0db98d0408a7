// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The four phases of a joint type behind function pointers, which are a row of the dispatch table. A row is made from
// the free functions Prepare, WarmStart, SolveVelocity and SolvePosition of a type.

#pragma once

#include "constraints/joint_constraints.h"

namespace scree {

/// What the phases work on.
struct JointTask {
    JointStep step;
    BodyTable& bodies;
    JointTable& joints;
    JointConstraints& scratch;
    TaskPool& pool;
};

struct JointPhases {
    /// Appends the constraint of one joint and returns its number.
    int (*prepare)(const JointTask& task, JointIndex joint);
    /// The same of a joint that a direct solve holds, for its limits, motors and springs.
    int (*prepareBounds)(const JointTask& task, JointIndex joint);
    /// Whether such a joint's limits are too far for the coming time step to matter, and it has nothing else.
    bool (*isIdle)(const JointTask& task, JointIndex joint);
    void (*warmStart)(const JointTask& task, const JointRun& run);
    /// The same of joints that a direct solve holds: their exact rows have no impulses.
    void (*warmStartBounds)(const JointTask& task, const JointRun& run);
    void (*solveVelocity)(const JointTask& task, const JointRun& run);
    /// Only limits, motors and springs; null for types that no direct solve takes over.
    void (*solveBounds)(const JointTask& task, const JointRun& run);
    /// True if every joint of the run is within tolerance.
    bool (*solvePosition)(const JointTask& task, const JointRun& run);
    /// The same of joints that a direct solve holds, where something besides that is out of bounds.
    bool (*solveBoundPosition)(const JointTask& task, const JointRun& run);
};

template <typename Row>
using ConstraintOf = typename JointTraits<Row>::Constraint;

template <typename Row>
std::vector<ConstraintOf<Row>>& ConstraintsOf(const JointTask& task) {
    return std::get<std::vector<ConstraintOf<Row>>>(task.scratch.byType);
}

/// Calls visit(constraint, row) along a run.
template <typename Row, typename Visit>
void ForEach(const JointTask& task, const JointRun& run, Visit&& visit) {
    Column<JointRow, Row>& rows = task.joints.Store<Row>().rows;
    const std::vector<ConstraintOf<Row>>& constraints = ConstraintsOf<Row>(task);
    for (int i = run.begin; i < run.end; ++i) {
        const ConstraintOf<Row>& c = constraints[ToSize(i)];
        visit(c, rows[c.row]);
    }
}

template <typename Row, typename Make>
int AppendConstraint(const JointTask& task, JointIndex joint, Make&& make) {
    const JointInfo& info = task.joints.info[joint];
    std::vector<ConstraintOf<Row>>& constraints = ConstraintsOf<Row>(task);
    ConstraintOf<Row>& c = constraints.emplace_back();
    c.row = info.row;
    const JointInput input{task.step, task.bodies, info};
    make(input, task.joints.Store<Row>().rows[info.row], c);
    return static_cast<int>(constraints.size()) - 1;
}

/// Whether the constraint may have impulses. Where these move nobody it has no mass, but its speeds may be beyond all
/// numbers, and 0 times infinity is none. A spring has impulses all the same. Gears and mouse joints have no such pair.
template <typename Constraint>
bool MayPush(const Constraint& c) {
    if constexpr (requires { c.soft; }) {
        return c.soft || IsMoved(c.pair);
    } else if constexpr (requires { c.pair; }) {
        return IsMoved(c.pair);
    } else {
        return true;
    }
}

template <typename Row>
constexpr JointPhases MakePhases() {
    using Constraint = ConstraintOf<Row>;
    JointPhases phases;
    phases.prepare = [](const JointTask& task, JointIndex joint) {
        return AppendConstraint<Row>(task, joint,
                                     [](const JointInput& in, Row& row, Constraint& c) { Prepare(in, row, c); });
    };
    phases.prepareBounds = phases.prepare;
    if constexpr (requires(const JointInput& in, Row& row, Constraint& c) { PrepareBounds(in, row, c); }) {
        phases.prepareBounds = [](const JointTask& task, JointIndex joint) {
            return AppendConstraint<Row>(
                task, joint, [](const JointInput& in, Row& row, Constraint& c) { PrepareBounds(in, row, c); });
        };
    }
    phases.isIdle = [](const JointTask&, JointIndex) { return false; };
    if constexpr (requires(const JointInput& in, const Row& row) { IsIdle(in, row); }) {
        phases.isIdle = [](const JointTask& task, JointIndex joint) {
            const JointInfo& info = task.joints.info[joint];
            const Row& row = task.joints.Store<Row>().rows[info.row];
            return IsIdle(JointInput{task.step, task.bodies, info}, row);
        };
    }
    phases.warmStart = [](const JointTask& task, const JointRun& run) {
        ForEach<Row>(task, run, [&](const Constraint& c, Row& row) { WarmStart(c, row, task.bodies.velocity); });
    };
    phases.warmStartBounds = phases.warmStart;
    if constexpr (requires(const Constraint& c, const Row& row, Column<BodyIndex, Velocity>& velocity) {
                      WarmStartBounds(c, row, velocity);
                  }) {
        phases.warmStartBounds = [](const JointTask& task, const JointRun& run) {
            ForEach<Row>(task, run,
                         [&](const Constraint& c, Row& row) { WarmStartBounds(c, row, task.bodies.velocity); });
        };
    }
    phases.solveVelocity = [](const JointTask& task, const JointRun& run) {
        ForEach<Row>(task, run, [&](const Constraint& c, Row& row) {
            if (MayPush(c)) SolveVelocity(c, row, task.step, task.bodies.velocity);
        });
    };
    phases.solveBounds = nullptr;
    if constexpr (requires(const Constraint& c, Row& row, const JointStep& step,
                           Column<BodyIndex, Velocity>& velocity) { SolveBounds(c, row, step, velocity); }) {
        phases.solveBounds = [](const JointTask& task, const JointRun& run) {
            ForEach<Row>(task, run, [&](const Constraint& c, Row& row) {
                if (MayPush(c)) SolveBounds(c, row, task.step, task.bodies.velocity);
            });
        };
    }
    phases.solvePosition = [](const JointTask& task, const JointRun& run) {
        bool solved = true;
        ForEach<Row>(task, run, [&](const Constraint& c, Row& row) {
            solved = SolvePosition(c, row, task.step, task.bodies) && solved;
        });
        return solved;
    };
    phases.solveBoundPosition = phases.solvePosition;
    if constexpr (requires(const Constraint& c, Row& row, const JointStep& step, BodyTable& bodies) {
                      KeepsBounds(c, row, step, bodies);
                  }) {
        phases.solveBoundPosition = [](const JointTask& task, const JointRun& run) {
            bool solved = true;
            ForEach<Row>(task, run, [&](const Constraint& c, Row& row) {
                if (!KeepsBounds(c, row, task.step, task.bodies))
                    solved = SolvePosition(c, row, task.step, task.bodies) && solved;
            });
            return solved;
        };
    }
    return phases;
}

}  // namespace scree
