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
    JointConstraints& s = task.scratch;
    s.hinges.Plan(bounded, task.bodies, task.joints, task.pool);
    s.wheels.Plan(bounded, task.bodies, task.joints, task.pool);
    s.ofBounds.clear(), s.ofWheelBounds.clear();
    const bool leavesHinges = s.hinges.IsEmpty(), leavesWheels = s.wheels.IsEmpty();
    if (!leavesHinges && s.hinges.CountJoints() == bounded.size()) return;
    const auto typeOf = [&](JointIndex joint) { return task.joints.info[joint].type; };
    for (const JointIndex joint : bounded) {
        if (typeOf(joint) != e_revoluteJoint && typeOf(joint) != e_wheelJoint) s.ofBounds.push_back(joint);
    }
    for (const JointIndex joint : bounded) {
        if (leavesHinges && typeOf(joint) == e_revoluteJoint) s.ofBounds.push_back(joint);
        if (leavesWheels && typeOf(joint) == e_wheelJoint) s.ofWheelBounds.push_back(joint);
    }
}

void ScaleJointImpulses(const JointTask& task, std::span<const JointIndex> joints) {
    JointConstraints& s = task.scratch;
    s.Clear();
    const PhaseTable& phases = GetPhases();
    const auto typeOf = [&](JointIndex joint) { return task.joints.info[joint].type; };
    for (const JointIndex joint : joints) phases[typeOf(joint)]->prepare(task, joint);
    for (const JointIndex joint : s.ofBounds) phases[typeOf(joint)]->prepareBounds(task, joint);
    for (const JointIndex joint : s.ofWheelBounds) phases[typeOf(joint)]->prepareBounds(task, joint);
    if (!s.hinges.IsEmpty()) s.hinges.Store(task.step, task.bodies, task.joints.Store<RevoluteRow>().rows, task.pool);
    if (!s.wheels.IsEmpty()) s.wheels.Store(task.step, task.bodies, task.joints.Store<WheelRow>().rows, task.pool);
}

void PrepareJoints(const JointTask& task, std::span<const JointIndex> joints) {
    JointConstraints& s = task.scratch;
    s.Clear();
    const PhaseTable& phases = GetPhases();
    const auto add = [&](JointIndex joint, std::vector<JointRun>& runs, auto phase) {
        const JointType type = task.joints.info[joint].type;
        const int number = (phases[type]->*phase)(task, joint);
        if (runs.empty() || runs.back().type != type) runs.push_back({type, number, number});
        runs.back().end = number + 1;
    };
    for (const JointIndex joint : joints) add(joint, s.runs, &JointPhases::prepare);
    const auto addBounds = [&](std::span<const JointIndex> bounded, std::vector<JointRun>& runs) {
        for (const JointIndex joint : bounded) {
            if (phases[task.joints.info[joint].type]->isIdle(task, joint)) continue;
            ForgetExactImpulse(joint, task.joints);
            add(joint, runs, &JointPhases::prepareBounds);
        }
    };
    addBounds(s.ofBounds, s.bounds);
    addBounds(s.ofWheelBounds, s.wheelBounds);
    if (!s.hinges.IsEmpty()) s.hinges.Prepare(task.step, task.bodies, task.pool);
    if (!s.wheels.IsEmpty()) s.wheels.Prepare(task.step, task.bodies, task.pool);
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

void SolveJointPositionsAndWarmStart(const JointTask& task) {
    JointConstraints& s = task.scratch;
    if (!s.wholeHinges.IsEmpty() || !s.runs.empty() || !s.bounds.empty() || !s.wheelBounds.empty()) {
        SolveJointPositions(task);
        return WarmStartJoints(task);
    }
    // The threads share lanes alone: one loop for both.
    const auto both = [&](auto& lanes, auto& rows) {
        if (lanes.Act()) lanes.SolvePositionsAndWarmStart(task.step, task.bodies, rows, task.pool);
    };
    both(s.hinges, task.joints.Store<RevoluteRow>().rows);
    both(s.wheels, task.joints.Store<WheelRow>().rows);
}

}  // namespace scree
