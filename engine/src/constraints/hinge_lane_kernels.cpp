// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels of whole revolute joints for the instruction set that the whole library is compiled for, and the choice
// of the best ones.

#define SCREE_HINGE_LANE_SET baseHingeLaneKernels
#include "constraints/hinge_lane_kernels.inc"

namespace scree {

extern const HingeLaneKernels avx2HingeLaneKernels;

const HingeLaneKernels& GetHingeLaneKernels() { return SCREE_WIDEST(baseHingeLaneKernels, avx2HingeLaneKernels); }

}  // namespace scree
