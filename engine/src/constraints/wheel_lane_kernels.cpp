// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The wheel kernels for the instruction set that the whole library is compiled for, and the choice of the best ones.

#define SCREE_WHEEL_LANE_SET baseWheelLaneKernels
#include "constraints/wheel_lane_kernels.inc"

namespace scree {

extern const WheelLaneKernels avx2WheelLaneKernels;

const WheelLaneKernels& GetWheelLaneKernels() { return SCREE_WIDEST(baseWheelLaneKernels, avx2WheelLaneKernels); }

}  // namespace scree
