// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The joint kernels for processors with AVX2; compiled with the flags for it where the compiler targets x86-64.

#if defined(SCREE_HAS_AVX2_KERNELS)
#define SCREE_JOINT_KERNEL_SET avx2JointBatchKernels
#include "constraints/joint_batch_kernels.inc"
#endif
