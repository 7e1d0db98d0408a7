// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the kernels of springs, motors and limits of eight joints get and do. Plain data only, because translation units
// for different instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int jointBatchSize = 8;

/// Batches of eight joints no two of which push the same body. Lanes to spare come last and repeat the first.
template <typename Batch>
struct JointLaneTask {
    Batch* batches;
    int32_t count;
    const float* position;  ///< by body: centre of mass, angle, and one more
    float* velocity;        ///< by body: v, w, and one more
    float dt, inverseDt;
    float impulseScale;  ///< of warm starting
    float slop;          ///< m or rad
};

/// All forms give the bits of solving joint after joint.
template <typename Batch>
struct JointLaneKernels {
    using Task = JointLaneTask<Batch>;
    /// Arms and masses at the bodies' present positions and speeds; scales the impulses. False if no joint acts.
    bool (*prepare)(const Task& task);
    void (*warmStart)(const Task& task);
    /// One iteration.
    void (*solve)(const Task& task);
    /// A bit for each lane of this batch that may be out of its range.
    uint32_t (*findOutOfRange)(const Task& task, const Batch& batch);
    /// Multiplies the impulses by impulseScale.
    void (*scale)(const Task& task);
};

}  // namespace scree
