// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The arithmetic of joint_batches.h, four joints or four bodies at a time. Plain data only, because translation units
// for different instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int jointLanes = 4;

/// Four numbers of one body.
struct alignas(32) BodyRow {
    double v[4];
};
/// One number of four joints.
struct alignas(32) LaneRow {
    double v[jointLanes];
};

/// Four joints at a point. `child` is the body that is eliminated with the joint, `parent` the one that remains.
struct PointBatch {
    LaneRow anchorChild[2], anchorParent[2];        ///< from the centres of mass, in the bodies' frames, m
    LaneRow armChild[2], armParent[2];              ///< in world coordinates
    LaneRow inverse[3];                             ///< of the joint's inverse mass: xx, xy, yy
    LaneRow response[2][3];                         ///< of the parent's velocity, to impulses along x and y
    LaneRow total[2], recent[2];                    ///< impulses on the child: of the step, since bodies last moved
    int32_t child[jointLanes], parent[jointLanes];  ///< rows of the bodies
};

/// What a solve of `count` rows notes of four joints. Between solves nothing of it counts, and `give` is 0.
template <int count>
struct SolveNotes {
    LaneRow right[count];  ///< right side
    LaneRow aim[count];    ///< impulses of the last solve before a move
    LaneRow give;          ///< compliance beside that of the task
};

inline constexpr int rowLimit = 3;

/// Four joints of any kind, of `count` rows each.
struct RowBatch {
    LaneRow rowChild[rowLimit][3], rowParent[rowLimit][3];  ///< Jacobians
    LaneRow inverse[rowLimit][rowLimit];
    LaneRow response[rowLimit][3];
    LaneRow total[rowLimit], recent[rowLimit];
    int32_t child[jointLanes], parent[jointLanes];
    int32_t count;  ///< of rows
    // Of joints that hold B's anchor on a line fixed in A.
    bool isLine;
    int32_t bodyA[jointLanes], bodyB[jointLanes];  ///< rows of the bodies
    LaneRow childIsB;                              ///< 1, or 0 where A is
    LaneRow anchorA[2], anchorB[2], localAxis[2];  ///< in the bodies' frames
    LaneRow axis[2];                               ///< in world coordinates
};

struct JointBatchTask {
    int32_t bodyCount;  ///< a multiple of four; row 0 is nothing, for lanes without a joint
    // What stays from one kernel to the next.
    BodyRow* pose;      ///< x, y of the centre of mass, cos, sin
    BodyRow* course;    ///< angle, turn since the start of the step, cos and sin at that start
    BodyRow* velocity;  ///< x, y, turning
    BodyRow* mass;      ///< 1/mass, 1/inertia, the same as the solve takes it, what factorize leaves of the spin
    double* stiffness;  ///< sub-step times what recent pulls turn a body back with; reach adds to it
    PointBatch* points;
    int32_t pointCount;
    RowBatch* rows;
    int32_t rowCount;
    // What only one solve needs.
    BodyRow* aimed;      ///< velocity to be
    BodyRow* next;       ///< `pose` where that leads
    LaneRow* nextAngle;  ///< and the angles there
    LaneRow* left;       ///< the most that the turns of the last aim may leave of an error, in shares of an arm
    BodyRow* mobility;   ///< two rows a body: xx, xy, xt, – and yy, yt, tt, –
    BodyRow* shift;      ///< velocity as joints so far want it
    BodyRow* impulse;    ///< on the body
    SolveNotes<2>* pointNotes;
    SolveNotes<rowLimit>* rowNotes;
    const int32_t* order;  ///< of elimination: batches of points, or ~ those of rows
    int32_t batchCount;
    const int32_t* roots;  ///< bodies that are eliminated with no joint
    int32_t rootCount;
    double h;           ///< sub-step, s
    double compliance;  ///< of a row, in shares of its own inverse mass
    double leastPivot;  ///< in the same shares: less is rounding, the row repeats others
    /// Rotates (cos, sin) by any angle.
    void (*turnFar)(double cos, double sin, double angle, double* cosSin);
};

struct JointBatchKernels {
    /// Courses → cos and sin of `pose`.
    void (*turn)(const JointBatchTask& task);
    /// Arms of points, and what their recent pulls make of the bodies' inertia; forgets these pulls.
    void (*reach)(const JointBatchTask& task);
    /// Jacobians of joints on lines; forgets their recent impulses.
    void (*align)(const JointBatchTask& task);
    /// Mobilities, inverses and responses; with `h` 0 no pull counts.
    void (*factorize)(const JointBatchTask& task);
    /// Aims at the velocities there are, without impulses.
    void (*coast)(const JointBatchTask& task);
    /// Where the velocities of `aimed` lead.
    void (*lead)(const JointBatchTask& task);
    /// Errors of points and of joints on lines at `next` → right sides.
    void (*measure)(const JointBatchTask& task);
    /// Velocities and impulses with which these errors are closed, by the Jacobians of `pose`.
    /// Returns the largest of `left`.
    double (*aim)(const JointBatchTask& task);
    /// Takes over what was aimed.
    void (*keep)(const JointBatchTask& task);
    /// Removes all speed along the joints.
    void (*stop)(const JointBatchTask& task);
};

/// The best form this processor has. All forms give the same bits.
const JointBatchKernels& GetJointBatchKernels();

}  // namespace scree
