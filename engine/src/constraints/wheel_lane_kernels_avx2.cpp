// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The wheel kernels for processors with AVX2; compiled with the flags for it where the compiler targets x86-64.

#if defined(SCREE_HAS_AVX2_KERNELS)
#define SCREE_WHEEL_LANE_SET avx2WheelLaneKernels
#include "constraints/wheel_lane_kernels.inc"
#endif
