// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The joint kernels for the instruction set that the whole library is compiled for, and the choice of the best set.

#define SCREE_JOINT_KERNEL_SET baseJointBatchKernels
#include "constraints/joint_batch_kernels.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
extern const JointBatchKernels avx2JointBatchKernels;
#endif

const JointBatchKernels& GetJointBatchKernels() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return avx2JointBatchKernels;
#endif
    return baseJointBatchKernels;
}

}  // namespace scree
