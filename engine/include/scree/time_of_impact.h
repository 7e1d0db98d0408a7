// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// When do two moving convex shapes touch first? Two proxies and their sweeps → a state and a time, with Box2D 2.4's
// names and tolerances.

#pragma once

#include "scree/api.h"
#include "scree/distance.h"
#include "scree/math.h"

namespace scree {

struct TOIInput {
    DistanceProxy proxyA;
    DistanceProxy proxyB;
    Sweep sweepA;  ///< interpolated from alpha0 (time 0) to the end of the step (time 1); alpha0 itself is not read
    Sweep sweepB;
    float tMax;                ///< the search covers times in [0, tMax]
    float lengthScale = 1.0f;  ///< factor on the tolerances (WorldDef::lengthScale)
};

struct TOIOutput {
    enum State : uint8_t {
        e_unknown,
        e_failed,      ///< not finite, or out of rounds: nothing touches before t, what follows is not known
        e_overlapped,  ///< the cores overlap at time 0; t = 0
        e_touching,    ///< the cores come within the target distance at t
        e_separated    ///< they stay apart up to t = tMax
    };

    State state;
    float t;  ///< the shapes do not touch in [0, t): a fraction of the sweep

    int iterations;          ///< separating axes tried
    int rootIterations;      ///< evaluations of the separation along an axis
    int distanceCalls;       ///< GJK runs
    int distanceIterations;  ///< GJK rounds in all of them
    int maxDistanceIterations;
};

/// The distance of the cores that counts as a touch: within their radii by 3·linearSlop, so that the discrete solver
/// finds a contact to work on, and never below linearSlop. `totalRadius` is the sum of both radii.
constexpr float TOITarget(float totalRadius, float lengthScale = 1.0f) {
    const float slop = linearSlop * lengthScale;
    return Max(slop, totalRadius - 3.0f * slop);
}
/// How much more than the target still counts as a touch, m.
inline constexpr float toiTolerance = 0.25f * linearSlop;

/// Finds the first time at which the distance of the cores falls to TOITarget (within toiTolerance above it). The time
/// is conservative: however fast the shapes move or spin, they do not come nearer than the target before it. Bodies
/// that start nearer than the target touch at 0.
SCREE_API void TimeOfImpact(TOIOutput* output, const TOIInput* input);

/// Sums over calls, for statistics. Plain sums and maxima: merge in any order.
struct SCREE_API TOIStats {
    int calls = 0;
    int iterations = 0, maxIterations = 0;
    int rootIterations = 0, maxRootIterations = 0;
    int distanceCalls = 0, distanceIterations = 0, maxDistanceIterations = 0;

    void Add(const TOIOutput& output);
};

}  // namespace scree
