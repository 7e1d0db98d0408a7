// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The poses of solved bodies at the end of a step, eight at a time: start plus motion, and the rotation that belongs to
// it. The same arithmetic as body by body in body_motion.h, hence the same bits. Plain data only, because translation
// units for different instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

/// Columns of the body table, four floats a row.
struct FinishPosesTask {
    const float* velocity;       ///< v, w
    const float* startPosition;  ///< centre of mass, angle, its rest
    const float* mass;           ///< 1/mass, 1/inertia, local centre
    float* delta;                ///< motion since the start of the step; becomes 0
    float* position;             ///< written
    float* transform;            ///< origin, sine, cosine
    bool keepsRests;             ///< what the sum of an angle loses goes to its rest
    bool hasLimit;               ///< of motion
    float maxTranslation, maxRotation;
};

/// Finishes the bodies of eight different rows. False if nothing was written: a cap acts on one of them, or it is not
/// finite or so far away that it must be looked at by itself.
using FinishPosesFunction = bool (*)(const FinishPosesTask& task, const int32_t* eight);

/// The best form this processor has. All forms give the same bits.
FinishPosesFunction GetFinishPoses();

}  // namespace scree
