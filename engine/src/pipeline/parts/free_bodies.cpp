// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernel for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_MOVE_FREE MoveFreeBase
#include "pipeline/parts/free_bodies.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
FreeMove MoveFreeAvx2(const FreeBodiesTask& task, const int32_t* eight);
#endif

MoveFreeFunction GetMoveFree() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return &MoveFreeAvx2;
#endif
    return &MoveFreeBase;
}

}  // namespace scree
