// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernel for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_FINISH_POSES FinishPosesBase
#include "pipeline/parts/finish_poses.inc"

namespace scree {

bool FinishPosesAvx2(const FinishPosesTask& task, const int32_t* eight);

FinishPosesFunction GetFinishPoses() { return SCREE_WIDEST(&FinishPosesBase, &FinishPosesAvx2); }

}  // namespace scree
