// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a direct solve needs of one joint, in double: the exact constraints of its type at a given pose, their errors
// and Jacobians, and where their impulses are kept.

#pragma once

#include <cmath>
#include <span>

#include "constraints/joint_math.h"
#include "state/joints.h"

namespace scree {

inline constexpr int maxTreeRows = 3;

/// Centre of mass, angle, and rotation.
struct TreePose {
    double x, y, angle, cos, sin;
};

/// Share of a row's own inverse mass by which it gives way. A pull of F at a mass m opens a joint by this times h²·F/m,
/// which does not show. With it, rows that repeat others share what they hold. A tight rope with a load on it, which no
/// finite force holds straight, has a solution.
inline constexpr double jointCompliance = 1e-5;
/// The same along velocities of a pulled tree that bears a load. A taut chain holds a load crosswise by what it is
/// bent, and only if it hardly gives way. Else the load takes bodies along and the next aim takes them back, so that
/// the load falls through them.
inline constexpr double loadedCompliance = 1e-8;
/// A pivot below this share of its row's own inverse mass is rounding: the row repeats others.
inline constexpr double leastPivot = 1e-9;

/// What is held of a joint.
enum class TreeKind : uint8_t {
    point,          ///< both anchors together
    pointAndAngle,  ///< and no turning
    slide,          ///< B's anchor on a line fixed in A, and no turning
    line,           ///< B's anchor on a line fixed in A
    rod,            ///< the distance of the anchors
};
constexpr int RowCount(TreeKind kind) {
    return kind == TreeKind::pointAndAngle ? 3 : kind == TreeKind::point || kind == TreeKind::slide ? 2 : 1;
}

/// A joint's constants.
struct TreeShape {
    TreeKind kind;
    double ax, ay, bx, by;  ///< anchors from the centres of mass, in the bodies' frames
    double axisX, axisY;    ///< of slide and line, in A's frame
    double reference;       ///< angle, rad, or length, m
    double shortest;        ///< of rod: has no direction below, m
};

/// What the solves of a step did to a joint, and to whom.
struct TreeResult {
    struct Side {
        BodyIndex body;
        double invMass, invI;  ///< 0 if joints cannot push it
    };
    JointIndex joint;
    const TreeShape& shape;
    const struct TreeRows& rows;
    const double (&impulse)[maxTreeRows];
    Side a, b;
};

/// Constraints at one pose. A row's speed is a·(vx, vy, w) of A plus b·(…) of B.
struct TreeRows {
    int count;
    double error[maxTreeRows];  ///< m or rad
    double a[maxTreeRows][3], b[maxTreeRows][3];
    double axisX, axisY;  ///< of slide, line and rod, in world coordinates
};

/// False if no direct solve takes over joints of this type. `bounded`: it has limits, motors or springs besides.
bool MakeTreeShape(const BodyTable& bodies, const JointTable& joints, JointIndex joint, TreeShape& shape,
                   bool& bounded);
/// Impulses of the rows → the joint's table.
void StoreImpulse(const TreeShape& shape, const TreeRows& rows, const float (&impulse)[maxTreeRows], JointIndex joint,
                  JointTable& joints);
/// Impulses that the joint's table keeps of a joint at a point, times `scale`; 0 for other rows.
void LoadImpulse(JointIndex joint, const JointTable& joints, double scale, double (&impulse)[maxTreeRows]);
/// Those of all rows of any joint: what StoreImpulse wrote last.
void RecallImpulse(JointIndex joint, const TreeShape& shape, const JointTable& joints, float scale,
                   float (&impulse)[maxTreeRows]);
/// Sets the impulses of the exact rows to 0, so that warm starting leaves them out.
void ForgetExactImpulse(JointIndex joint, JointTable& joints);

/// Where a body stands within a step, and how far it has turned in it.
struct TreeStart {
    double x, y, angle, turn;
};
inline TreeStart StartOf(const BodyTable& bodies, const Column<BodyIndex, Velocity>& motion, BodyIndex body) {
    const bool isStatic = bodies.type[body] == staticBody;
    const Velocity delta = isStatic ? Velocity{} : motion[body];
    const Position& from = isStatic ? bodies.position[body] : bodies.startPosition[body];
    const PositionRest& rests = bodies.IsFar() ? bodies.rest[body] : PositionRest{};
    const Vec2 rest = isStatic ? rests.end : rests.start;
    return {double{from.c.x} + (double{rest.x} + double{delta.v.x}),
            double{from.c.y} + (double{rest.y} + double{delta.v.y}),
            double{from.a} + (double{from.aRest} + double{delta.w}), double{delta.w}};
}

/// Rotates (cos, sin) by `angle`: the Taylor series of a part small enough, doubled back.
inline void Turn(double cos, double sin, double angle, TreePose& pose) {
    int halvings = 0;
    while (std::abs(angle) > 0.25 && halvings < 60) angle *= 0.5, ++halvings;
    const double square = angle * angle;
    double c = 1.0 - square / 2.0 * (1.0 - square / 12.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0)));
    double s = angle * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))));
    for (; halvings > 0; --halvings) {
        const double doubled = 2.0 * s * c;
        c = 1.0 - 2.0 * s * s;
        s = doubled;
    }
    pose.cos = cos * c - sin * s;
    pose.sin = sin * c + cos * s;
}

/// Errors, and with `jacobian` the rows too.
template <bool jacobian>
inline void MakeRows(const TreeShape& shape, const TreePose& a, const TreePose& b, TreeRows& rows) {
    const double rax = a.cos * shape.ax - a.sin * shape.ay, ray = a.sin * shape.ax + a.cos * shape.ay;
    const double rbx = b.cos * shape.bx - b.sin * shape.by, rby = b.sin * shape.bx + b.cos * shape.by;
    const double dx = b.x - a.x + (rbx - rax), dy = b.y - a.y + (rby - ray);
    const auto noTurning = [&](int i) {
        rows.error[i] = b.angle - a.angle - shape.reference;
        if constexpr (jacobian) {
            rows.a[i][0] = rows.a[i][1] = rows.b[i][0] = rows.b[i][1] = 0.0;
            rows.a[i][2] = -1.0, rows.b[i][2] = 1.0;
        }
    };
    /// Along (x, y), with A's arm reaching `rx`, `ry` from its centre.
    const auto along = [&](int i, double x, double y, double rx, double ry) {
        rows.a[i][0] = -x, rows.a[i][1] = -y, rows.a[i][2] = -(rx * y - ry * x);
        rows.b[i][0] = x, rows.b[i][1] = y, rows.b[i][2] = rbx * y - rby * x;
    };
    switch (shape.kind) {
        case TreeKind::pointAndAngle:
            noTurning(2);
            [[fallthrough]];
        case TreeKind::point:
            rows.error[0] = dx, rows.error[1] = dy;
            if constexpr (jacobian) along(0, 1.0, 0.0, rax, ray), along(1, 0.0, 1.0, rax, ray);
            return;
        case TreeKind::slide:
            noTurning(1);
            [[fallthrough]];
        case TreeKind::line: {
            const double x = a.cos * shape.axisX - a.sin * shape.axisY;
            const double y = a.sin * shape.axisX + a.cos * shape.axisY;
            rows.error[0] = -y * dx + x * dy;
            if constexpr (jacobian) {
                rows.axisX = x, rows.axisY = y;
                along(0, -y, x, rax + dx, ray + dy);
            }
            return;
        }
        case TreeKind::rod: {
            const double length = std::sqrt(dx * dx + dy * dy);
            rows.error[0] = length - shape.reference;
            if constexpr (jacobian) {
                const double inverse = length > shape.shortest ? 1.0 / length : 0.0;
                rows.axisX = inverse * dx, rows.axisY = inverse * dy;
                along(0, rows.axisX, rows.axisY, rax, ray);
            }
            return;
        }
    }
}

}  // namespace scree
