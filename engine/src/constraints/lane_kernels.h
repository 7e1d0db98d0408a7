// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Small islands side by side: eight lanes, in each of them islands one after the other, contact after contact in the
// order of contact_rows.h. The same arithmetic as there, lane by lane, hence the same bits: how an island is solved
// does not depend on what it lies beside. Plain data only, because translation units for different instruction sets
// share it.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int islandLanes = 8;

/// The n-th contact of each of eight lanes; a lane without one has no points there.
struct alignas(32) LaneContact {
    using Row = float[islandLanes];

    struct Point {
        Row armAX, armAY, armBX, armBY;  ///< from the centres of mass
        Row normalMass, tangentMass, bias;
        Row normalImpulse, tangentImpulse;
        Row localX, localY;  ///< for positions: in the frame of the body that has no face
    };

    int32_t bodyA[islandLanes], bodyB[islandLanes];  ///< rows of LaneTask
    Row invMassA, invMassB, invIA, invIB;
    Row centerAX, centerAY, centerBX, centerBY;  ///< centres of mass in the bodies' frames
    Row normalX, normalY;
    Row friction, tangentSpeed;
    Row k11, k12, k22, inv11, inv12, inv22;  ///< of both points together
    Row isBlock;                             ///< 1: both points are solved together; else 0
    Row pointCount;                          ///< in the velocity pass: 0, 1 or 2
    Row positionCount;                       ///< in the position pass
    Row isCircles, isFaceB;                  ///< 1 or 0: kind of the manifold
    Row localNormalX, localNormalY, localPointX, localPointY;
    Row radius;      ///< of both shapes together
    Row isActive;    ///< 1: the positions of its island are not within tolerance yet; else 0
    Row separation;  ///< the smallest in the last position pass, at most 0
    Point points[2];
};

/// A group of islands.
struct LaneTask {
    LaneContact* contacts;
    int32_t count;
    float* velocity;  ///< rows of v, w
    float* position;  ///< rows of centre of mass, angle
    float* rotation;  ///< rows of sine and cosine of the angle in `position`
    bool friction;    ///< some contact may have friction
    // Position pass: share of the overlap beyond the slop, m of slop and of the largest push.
    float share, slop, largestPush;
};

/// Where preparing finds what it needs: columns of the tables of bodies and contacts, rows of floats.
struct LaneSource {
    const float* transform;  ///< by body: x, y, sine, cosine of the origin
    const float* position;   ///< by body: x, y of the centre of mass, and two more
    const float* velocity;   ///< by body: x, y, angular, and one more
    const float* mass;       ///< by body: inverse mass, inverse inertia, centre of mass in the body's frame
    const float* manifold;   ///< by contact: Manifold
    const float* material;   ///< by contact: friction, restitution, restitution threshold, tangent speed
    float impulseScale;      ///< of warm starting
    bool restitution;        ///< some contact may bounce
};

/// What preparing is told of the n-th contacts of eight lanes. A lane without one repeats another, with no points.
struct alignas(32) LaneNames {
    using Row = float[islandLanes];
    int32_t contact[islandLanes], bodyA[islandLanes], bodyB[islandLanes];  ///< rows of the tables
    Row radiusA, radiusB;                                                  ///< of the shapes
    Row pointCount, isCircles, isFaceB;                                    ///< as in LaneContact
    bool anyCircles, anyPairs;                                             ///< in some lane; of two points
};

struct LaneKernels {
    /// Everything but bodyA, bodyB and what positions do, from the bodies' present positions and velocities.
    void (*prepare)(const LaneSource& source, const LaneNames& names, LaneContact& contact);
    void (*warmStart)(const LaneTask& task);
    void (*solveVelocities)(const LaneTask& task, int32_t iterations);
    /// Sets `rotation` of so many rows, a multiple of eight.
    void (*turn)(const LaneTask& task, int32_t rows);
    /// One iteration for the contacts that are active.
    void (*solvePositions)(const LaneTask& task);
};

/// The best form this processor has. All forms give the same bits.
const LaneKernels& GetLaneKernels();

}  // namespace scree
