// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels for the instruction set that the whole library is compiled for, and the choice of the best ones.

#define SCREE_LANE_SET baseLaneKernels
#include "constraints/lane_kernels.inc"

namespace scree {

extern const LaneKernels avx2LaneKernels;

const LaneKernels& GetLaneKernels() { return SCREE_WIDEST(baseLaneKernels, avx2LaneKernels); }

}  // namespace scree
