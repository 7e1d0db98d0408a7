// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernel for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_FINISH_POSES FinishPosesBase
#include "pipeline/parts/finish_poses.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
bool FinishPosesAvx2(const FinishPosesTask& task, const int32_t* eight);
#endif

FinishPosesFunction GetFinishPoses() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return &FinishPosesAvx2;
#endif
    return &FinishPosesBase;
}

}  // namespace scree
