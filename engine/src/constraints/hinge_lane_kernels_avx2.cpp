// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels of whole revolute joints for processors with AVX2; compiled with the flags for it where the compiler
// targets x86-64.

#if defined(SCREE_HAS_AVX2_KERNELS)
#define SCREE_HINGE_LANE_SET avx2HingeLaneKernels
#include "constraints/hinge_lane_kernels.inc"
#endif
