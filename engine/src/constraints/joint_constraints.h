// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scratch of all joint types, kept between steps: constraints by type, and the order in which they are solved. The
// order is kept as runs of neighbours of one type, so that a run costs one call.

#pragma once

#include <tuple>
#include <vector>

#include "constraints/distance.h"
#include "constraints/friction.h"
#include "constraints/gear.h"
#include "constraints/hinge_lanes.h"
#include "constraints/motor.h"
#include "constraints/mouse.h"
#include "constraints/prismatic.h"
#include "constraints/pulley.h"
#include "constraints/revolute.h"
#include "constraints/revolute_lanes.h"
#include "constraints/weld.h"
#include "constraints/wheel.h"
#include "constraints/wheel_lanes.h"

namespace scree {

/// Constraints [begin, end) of one type.
struct JointRun {
    JointType type;
    int begin, end;
};

template <typename... Row>
using ConstraintTables = std::tuple<std::vector<typename JointTraits<Row>::Constraint>...>;

struct JointConstraints {
    std::vector<JointRun> runs;
    HingeLanes wholeHinges;  ///< in place of all runs, or none
    // Joints that a direct solve holds, of which limits, motors and springs remain, in this order: of revolute joints
    // and wheels either the runs or the lanes.
    std::vector<JointRun> bounds;
    JointLanes<RevoluteRow> hinges;
    std::vector<JointRun> wheelBounds;
    JointLanes<WheelRow> wheels;
    std::vector<JointIndex> ofBounds, ofWheelBounds;  ///< of the step: joints of which these runs are made
    OfJointTypes<ConstraintTables> byType;

    /// Some joint is solved row by row at present.
    [[nodiscard]] bool Act() const {
        return !runs.empty() || !bounds.empty() || hinges.Act() || !wheelBounds.empty() || wheels.Act();
    }
    void Clear() {
        runs.clear();
        wholeHinges.Clear();
        bounds.clear();
        wheelBounds.clear();
        std::apply([](auto&... constraints) { (constraints.clear(), ...); }, byType);
    }
    /// For joints that are all solved in turn.
    void MatchRoomOf(const JointConstraints& other) {
        MatchRoom(runs, other.runs);
        wholeHinges.MatchRoomOf(other.wholeHinges);
        std::apply(
            [&](auto&... own) {
                std::apply([&](const auto&... others) { (MatchRoom(own, others), ...); }, other.byType);
            },
            byType);
    }
    [[nodiscard]] size_t GetMemoryBytes() const {
        size_t bytes = (runs.capacity() + bounds.capacity() + wheelBounds.capacity()) * sizeof(JointRun) +
                       BytesOf(ofBounds, ofWheelBounds) + wholeHinges.GetMemoryBytes() + hinges.GetMemoryBytes() +
                       wheels.GetMemoryBytes();
        std::apply([&](const auto&... c) { ((bytes += c.capacity() * sizeof(c[0])), ...); }, byType);
        return bytes;
    }
};

}  // namespace scree
