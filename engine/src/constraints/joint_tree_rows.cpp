// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which joints a direct solve takes over, as their traits tell, and their impulses.

#include "constraints/joint_tree_rows.h"

#include <algorithm>
#include <type_traits>

#include "constraints/joint_constraints.h"

namespace scree {

namespace {

template <typename Row>
concept HasTwoAnchors = requires(Row& row) {
    row.localAnchorA, row.localAnchorB;
};

}  // namespace

bool MakeTreeShape(const BodyTable& bodies, const JointTable& joints, JointIndex joint, TreeShape& shape,
                   bool& bounded) {
    const JointInfo& info = joints.info[joint];
    bool isExact = false;
    shape = {};
    JointTable::WithStore(joints, info.type, [&](const auto& store) {
        const auto& row = store.rows[info.row];
        using Row = std::remove_cvref_t<decltype(row)>;
        if constexpr (HasTwoAnchors<Row>) {
            isExact = JointTraits<Row>::Describe(row, shape, bounded);
            const Vec2 a = row.localAnchorA - bodies.mass[info.bodyA].localCenter;
            const Vec2 b = row.localAnchorB - bodies.mass[info.bodyB].localCenter;
            shape.ax = double{a.x}, shape.ay = double{a.y};
            shape.bx = double{b.x}, shape.by = double{b.y};
        }
    });
    return isExact;
}

void StoreImpulse(const TreeShape& shape, const TreeRows& rows, const float (&impulse)[maxTreeRows], JointIndex joint,
                  JointTable& joints) {
    const JointInfo& info = joints.info[joint];
    JointTable::WithStore(joints, info.type, [&](auto& store) {
        auto& row = store.rows[info.row];
        JointTraits<std::remove_cvref_t<decltype(row)>>::Keep(row, shape, rows, impulse);
    });
}

void LoadImpulse(JointIndex joint, const JointTable& joints, double scale, double (&impulse)[maxTreeRows]) {
    for (double& i : impulse) i = 0.0;
    const JointInfo& info = joints.info[joint];
    JointTable::WithStore(joints, info.type, [&](const auto& store) {
        using Row = typename std::remove_cvref_t<decltype(store)>::RowType;
        if constexpr (std::is_same_v<Row, RevoluteRow> || std::is_same_v<Row, WeldRow>) {
            const Vec2 kept = store.rows[info.row].impulse;
            if (!kept.IsValid()) return;
            impulse[0] = scale * double{kept.x}, impulse[1] = scale * double{kept.y};
        }
    });
}

void RecallImpulse(JointIndex joint, const TreeShape& shape, const JointTable& joints, float scale,
                   float (&impulse)[maxTreeRows]) {
    for (float& i : impulse) i = 0.0f;
    const JointInfo& info = joints.info[joint];
    JointTable::WithStore(joints, info.type, [&](const auto& store) {
        const auto& row = store.rows[info.row];
        if constexpr (requires { row.impulse.x; }) {
            impulse[0] = scale * row.impulse.x, impulse[1] = scale * row.impulse.y;
        } else if constexpr (requires { row.impulse; }) {
            impulse[0] = scale * row.impulse;
        }
        if constexpr (requires { row.turnImpulse; }) {
            if (shape.kind == TreeKind::pointAndAngle) impulse[2] = scale * row.turnImpulse;
        }
    });
    for (const float i : impulse) {
        if (std::isfinite(i)) continue;
        for (float& all : impulse) all = 0.0f;
        return;
    }
}

void ForgetExactImpulse(JointIndex joint, JointTable& joints) {
    const JointInfo& info = joints.info[joint];
    JointTable::WithStore(joints, info.type, [&](auto& store) {
        auto& row = store.rows[info.row];
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
