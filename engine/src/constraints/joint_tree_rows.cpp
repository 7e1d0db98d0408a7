// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which joints a direct solve takes over, by type.

#include "constraints/joint_tree_rows.h"

#include <algorithm>
#include <type_traits>

namespace scree {

namespace {

bool IsBounded(const LimitState& limit, const MotorState& motor) { return limit.enabled || motor.enabled; }

// One overload a type: false if it has no exact rows.
template <typename Row>
bool Describe(const Row&, TreeShape&, bool&) {
    return false;
}
bool Describe(const RevoluteRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::point;
    bounded = IsBounded(row.limit, row.motor);
    return true;
}
bool Describe(const WeldRow& row, TreeShape& shape, bool& bounded) {
    bounded = row.stiffness > 0.0f;  // turning is a spring then
    shape.kind = bounded ? TreeKind::point : TreeKind::pointAndAngle;
    shape.reference = double{row.referenceAngle};
    return true;
}
bool Describe(const PrismaticRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::slide;
    shape.axisX = double{row.localAxisA.x}, shape.axisY = double{row.localAxisA.y};
    shape.reference = double{row.referenceAngle};
    bounded = IsBounded(row.limit, row.motor);
    return true;
}
bool Describe(const WheelRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::line;
    shape.axisX = double{row.localAxisA.x}, shape.axisY = double{row.localAxisA.y};
    bounded = IsBounded(row.limit, row.motor) || row.stiffness > 0.0f;
    return true;
}
bool Describe(const DistanceRow& row, TreeShape& shape, bool& bounded) {
    shape.kind = TreeKind::rod;
    shape.reference = double{row.limit.lower};
    shape.shortest = double{row.shortest};
    bounded = false;
    return row.limit.lower >= row.limit.upper;
}

template <typename Row>
concept HasTwoAnchors = requires(Row& row) {
    row.localAnchorA, row.localAnchorB;
};

Vec2 ToVec(const float (&impulse)[maxTreeRows]) { return {impulse[0], impulse[1]}; }

template <typename Row>
void Keep(Row&, const TreeShape&, const TreeRows&, const float (&)[maxTreeRows]) {}
void Keep(RevoluteRow& row, const TreeShape&, const TreeRows&, const float (&impulse)[maxTreeRows]) {
    row.impulse = ToVec(impulse);
}
void Keep(WeldRow& row, const TreeShape& shape, const TreeRows&, const float (&impulse)[maxTreeRows]) {
    row.impulse = ToVec(impulse);
    if (shape.kind == TreeKind::pointAndAngle) row.turnImpulse = impulse[2];
}
template <typename Row>
void KeepAxis(Row& row, const TreeRows& rows) {
    row.axis = {static_cast<float>(rows.axisX), static_cast<float>(rows.axisY)};
}
void Keep(PrismaticRow& row, const TreeShape&, const TreeRows& rows, const float (&impulse)[maxTreeRows]) {
    row.impulse = ToVec(impulse);
    KeepAxis(row, rows);
}
void Keep(WheelRow& row, const TreeShape&, const TreeRows& rows, const float (&impulse)[maxTreeRows]) {
    row.impulse = impulse[0];
    KeepAxis(row, rows);
}
void Keep(DistanceRow& row, const TreeShape&, const TreeRows& rows, const float (&impulse)[maxTreeRows]) {
    row.impulse = impulse[0];
    KeepAxis(row, rows);
}

}  // namespace

bool MakeTreeShape(const BodyTable& bodies, const JointTable& joints, int joint, TreeShape& shape, bool& bounded) {
    const JointInfo& info = joints.info[static_cast<size_t>(joint)];
    bool isExact = false;
    shape = {};
    JointTable::WithStore(joints, info.type, [&](const auto& store) {
        const auto& row = store.rows[static_cast<size_t>(info.row)];
        if constexpr (HasTwoAnchors<std::remove_cvref_t<decltype(row)>>) {
            isExact = Describe(row, shape, bounded);
            const Vec2 a = row.localAnchorA - bodies.mass[static_cast<size_t>(info.bodyA)].localCenter;
            const Vec2 b = row.localAnchorB - bodies.mass[static_cast<size_t>(info.bodyB)].localCenter;
            shape.ax = double{a.x}, shape.ay = double{a.y};
            shape.bx = double{b.x}, shape.by = double{b.y};
        }
    });
    return isExact;
}

void StoreImpulse(const TreeShape& shape, const TreeRows& rows, const float (&impulse)[maxTreeRows], int joint,
                  JointTable& joints) {
    const JointInfo& info = joints.info[static_cast<size_t>(joint)];
    JointTable::WithStore(joints, info.type,
                          [&](auto& store) { Keep(store.rows[static_cast<size_t>(info.row)], shape, rows, impulse); });
}

void LoadImpulse(int joint, const JointTable& joints, double scale, double (&impulse)[maxTreeRows]) {
    for (double& i : impulse) i = 0.0;
    const JointInfo& info = joints.info[static_cast<size_t>(joint)];
    JointTable::WithStore(joints, info.type, [&](const auto& store) {
        using Row = std::remove_cvref_t<decltype(store.rows[0])>;
        if constexpr (std::is_same_v<Row, RevoluteRow> || std::is_same_v<Row, WeldRow>) {
            const Vec2 kept = store.rows[static_cast<size_t>(info.row)].impulse;
            if (!kept.IsValid()) return;
            impulse[0] = scale * double{kept.x}, impulse[1] = scale * double{kept.y};
        }
    });
}

void ForgetExactImpulse(int joint, JointTable& joints) {
    const JointInfo& info = joints.info[static_cast<size_t>(joint)];
    JointTable::WithStore(joints, info.type, [&](auto& store) {
        auto& row = store.rows[static_cast<size_t>(info.row)];
        if constexpr (requires { row.impulse = {}; }) row.impulse = {};
        if constexpr (requires {
                          row.turnImpulse;
                          row.stiffness;
                      }) {
            if (row.stiffness <= 0.0f) row.turnImpulse = 0.0f;
        }
    });
}

}  // namespace scree
