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
    task.scratch.hinges.Plan(bounded, task.bodies, task.joints, task.pool);
    task.scratch.wheels.Plan(bounded, task.bodies, task.joints, task.pool);
}

void ScaleJointImpulses(const JointTask& task, std::span<const JointIndex> joints,
                        std::span<const JointIndex> bounded) {
    task.scratch.Clear();
    const PhaseTable& phases = GetPhases();
    auto& hinges = task.scratch.hinges;
    auto& wheels = task.scratch.wheels;
    for (const JointIndex joint : joints) phases[task.joints.info[joint].type]->prepare(task, joint);
    for (const JointIndex joint : bounded) {
        const JointType type = task.joints.info[joint].type;
        const bool isInLanes =
            (type == e_revoluteJoint && !hinges.IsEmpty()) || (type == e_wheelJoint && !wheels.IsEmpty());
        if (!isInLanes) phases[type]->prepareBounds(task, joint);
    }
    if (!hinges.IsEmpty()) hinges.Store(task.step, task.bodies, task.joints.Store<RevoluteRow>().rows, task.pool);
    if (!wheels.IsEmpty()) wheels.Store(task.step, task.bodies, task.joints.Store<WheelRow>().rows, task.pool);
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
    const auto addBounds = [&](std::vector<JointRun>& runs, auto&& isWanted) {
        for (const JointIndex joint : bounded) {
            const JointType type = task.joints.info[joint].type;
            if (!isWanted(type) || phases[type]->isIdle(task, joint)) continue;
            ForgetExactImpulse(joint, task.joints);
            add(joint, runs, &JointPhases::prepareBounds);
        }
    };
    const auto isHinge = [](JointType type) { return type == e_revoluteJoint; };
    const auto isWheel = [](JointType type) { return type == e_wheelJoint; };
    JointConstraints& s = task.scratch;
    addBounds(s.bounds, [&](JointType type) { return !isHinge(type) && !isWheel(type); });
    s.hinges.IsEmpty() ? addBounds(s.bounds, isHinge) : s.hinges.Prepare(task.step, task.bodies, task.pool);
    s.wheels.IsEmpty() ? addBounds(s.wheelBounds, isWheel) : s.wheels.Prepare(task.step, task.bodies, task.pool);
    WarmStartJoints(task);
}

void PrepareIslandJoints(const JointTask& task, std::span<const JointIndex> joints) {
    HingeLanes& hinges = task.scratch.wholeHinges;
    task.scratch.Clear();
    hinges.Plan(joints, task.bodies, task.joints);
    if (hinges.IsEmpty()) return PrepareJoints(task, joints);
    hinges.Prepare(task.step, task.bodies);
    hinges.WarmStart(task.step, task.bodies);
}
void StoreJointImpulses(const JointTask& task) {
    task.scratch.wholeHinges.Store(task.joints.Store<RevoluteRow>().rows);
}

void WarmStartJoints(const JointTask& task) {
    const PhaseTable& phases = GetPhases();
    JointConstraints& s = task.scratch;
    for (const JointRun& run : s.runs) phases[run.type]->warmStart(task, run);
    for (const JointRun& run : s.bounds) phases[run.type]->warmStartBounds(task, run);
    if (s.hinges.Act()) s.hinges.WarmStart(task.step, task.bodies, task.pool);
    for (const JointRun& run : s.wheelBounds) phases[run.type]->warmStartBounds(task, run);
    if (s.wheels.Act()) s.wheels.WarmStart(task.step, task.bodies, task.pool);
}

void SolveJointVelocities(const JointTask& task) {
    const PhaseTable& phases = GetPhases();
    JointConstraints& s = task.scratch;
    if (!s.wholeHinges.IsEmpty()) s.wholeHinges.Solve(task.step, task.bodies);
    for (const JointRun& run : s.runs) phases[run.type]->solveVelocity(task, run);
    for (const JointRun& run : s.bounds) phases[run.type]->solveBounds(task, run);
    if (s.hinges.Act()) s.hinges.Solve(task.step, task.bodies, task.pool);
    for (const JointRun& run : s.wheelBounds) phases[run.type]->solveBounds(task, run);
    if (s.wheels.Act()) s.wheels.Solve(task.step, task.bodies, task.pool);
}

bool SolveJointPositions(const JointTask& task) {
    const PhaseTable& phases = GetPhases();
    JointConstraints& s = task.scratch;
    bool solved = true;
    const auto note = [&solved](bool one) { solved = one && solved; };
    if (!s.wholeHinges.IsEmpty()) note(s.wholeHinges.SolvePositions(task.step, task.bodies));
    for (const JointRun& run : s.runs) note(phases[run.type]->solvePosition(task, run));
    for (const JointRun& run : s.bounds) note(phases[run.type]->solveBoundPosition(task, run));
    if (s.hinges.Act())
        note(s.hinges.SolvePositions(task.step, task.bodies, task.joints.Store<RevoluteRow>().rows, task.pool));
    for (const JointRun& run : s.wheelBounds) note(phases[run.type]->solveBoundPosition(task, run));
    if (s.wheels.Act())
        note(s.wheels.SolvePositions(task.step, task.bodies, task.joints.Store<WheelRow>().rows, task.pool));
    return solved;
}

}  // namespace scree
