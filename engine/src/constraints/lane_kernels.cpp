// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels for the instruction set that the whole library is compiled for, and the choice of the best ones.

#define SCREE_LANE_SET baseLaneKernels
#include "constraints/lane_kernels.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
extern const LaneKernels avx2LaneKernels;
#endif

const LaneKernels& GetLaneKernels() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return avx2LaneKernels;
#endif
    return baseLaneKernels;
}

}  // namespace scree
