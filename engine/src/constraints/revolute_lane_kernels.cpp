// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels of revolute joints for the instruction set that the whole library is compiled for, and the choice of the
// best ones.

#define SCREE_REVOLUTE_LANE_SET baseRevoluteLaneKernels
#include "constraints/revolute_lane_kernels.inc"

namespace scree {

extern const RevoluteLaneKernels avx2RevoluteLaneKernels;

const RevoluteLaneKernels& GetRevoluteLaneKernels() {
    return SCREE_WIDEST(baseRevoluteLaneKernels, avx2RevoluteLaneKernels);
}

}  // namespace scree
