// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The joint kernels for the instruction set that the whole library is compiled for, and the choice of the best set.

#define SCREE_JOINT_KERNEL_SET baseJointBatchKernels
#include "constraints/joint_batch_kernels.inc"

namespace scree {

extern const JointBatchKernels avx2JointBatchKernels;

const JointBatchKernels& GetJointBatchKernels() { return SCREE_WIDEST(baseJointBatchKernels, avx2JointBatchKernels); }

}  // namespace scree
