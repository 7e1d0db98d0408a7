// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Dispatch to the phases of each joint type by a table indexed with JointType.

#include "constraints/joint_solver.h"

#include <array>

#include "constraints/joint_tree_rows.h"

namespace scree {

namespace {

using PhaseTable = std::array<const JointPhases*, e_motorJoint + 1>;

template <typename... Row>
struct PhasesByType {
    PhaseTable table{};
    PhasesByType() { ((table[Row::type] = &JointTraits<Row>::GetPhases()), ...); }
};

/// By type.
const PhaseTable& GetPhases() {
    static const OfJointTypes<PhasesByType> phases;
    return phases.table;
}

}  // namespace

void PlanBounds(const JointTask& task, std::span<const JointIndex> bounded) {
    task.scratch.wheels.Plan(bounded, task.bodies, task.joints);
}

void ScaleJointImpulses(const JointTask& task, std::span<const JointIndex> joints,
                        std::span<const JointIndex> bounded) {
    task.scratch.Clear();
    const PhaseTable& phases = GetPhases();
    for (const JointIndex joint : joints) phases[task.joints.info[joint].type]->prepare(task, joint);
    WheelLanes& wheels = task.scratch.wheels;
    for (const JointIndex joint : bounded) {
        const JointType type = task.joints.info[joint].type;
        if (type != e_wheelJoint || wheels.IsEmpty()) phases[type]->prepareBounds(task, joint);
    }
    if (!wheels.IsEmpty()) wheels.Store(task.step.impulseScale, task.joints.Store<WheelRow>().rows);
}

void PrepareJoints(const JointTask& task, std::span<const JointIndex> joints, std::span<const JointIndex> bounded) {
    task.scratch.Clear();
    const PhaseTable& phases = GetPhases();
    const auto add = [&](JointIndex joint, std::vector<JointRun>& runs, auto phase) {
        const JointType type = task.joints.info[joint].type;
        const int number = (phases[type]->*phase)(task, joint);
        if (runs.empty() || runs.back().type != type) runs.push_back({type, number, number});
        runs.back().end = number + 1;
    };
    for (const JointIndex joint : joints) add(joint, task.scratch.runs, &JointPhases::prepare);
    const auto addBounds = [&](bool areWheels) {
        for (const JointIndex joint : bounded) {
            const JointType type = task.joints.info[joint].type;
            if ((type == e_wheelJoint) != areWheels || phases[type]->isIdle(task, joint)) continue;
            ForgetExactImpulse(joint, task.joints);
            add(joint, task.scratch.bounds, &JointPhases::prepareBounds);
        }
    };
    addBounds(false);
    // Wheels come last, side by side or not.
    WheelLanes& wheels = task.scratch.wheels;
    wheels.IsEmpty() ? addBounds(true) : wheels.Prepare(task.step, task.bodies);
    WarmStartJoints(task);
}

void WarmStartJoints(const JointTask& task) {
    const PhaseTable& phases = GetPhases();
    for (const JointRun& run : task.scratch.runs) phases[run.type]->warmStart(task, run);
    for (const JointRun& run : task.scratch.bounds) phases[run.type]->warmStartBounds(task, run);
    if (!task.scratch.wheels.IsEmpty()) task.scratch.wheels.WarmStart(task.bodies.velocity);
}

void SolveJointVelocities(const JointTask& task) {
    const PhaseTable& phases = GetPhases();
    for (const JointRun& run : task.scratch.runs) phases[run.type]->solveVelocity(task, run);
    for (const JointRun& run : task.scratch.bounds) phases[run.type]->solveBounds(task, run);
    if (!task.scratch.wheels.IsEmpty()) task.scratch.wheels.Solve(task.step, task.bodies.velocity);
}

bool SolveJointPositions(const JointTask& task) {
    const PhaseTable& phases = GetPhases();
    bool solved = true;
    for (const JointRun& run : task.scratch.runs) solved = phases[run.type]->solvePosition(task, run) && solved;
    for (const JointRun& run : task.scratch.bounds) solved = phases[run.type]->solveBoundPosition(task, run) && solved;
    WheelLanes& wheels = task.scratch.wheels;
    if (wheels.IsEmpty()) return solved;
    return wheels.SolvePositions(task.step, task.bodies, task.joints.Store<WheelRow>().rows) && solved;
}

}  // namespace scree
