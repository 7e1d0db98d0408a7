// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernel for processors with AVX2; compiled with the flags for it where the compiler targets x86-64.

#if defined(SCREE_HAS_AVX2_KERNELS)
#define SCREE_FINISH_POSES FinishPosesAvx2
#include "pipeline/parts/finish_poses.inc"
#endif
