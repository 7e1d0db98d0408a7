// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernel for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_MOVE_ISOLATED MoveIsolatedBase
#include "pipeline/parts/isolated_bodies.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
IsolatedMove MoveIsolatedAvx2(const IsolatedBodiesTask& task, const int32_t* eight);
#endif

MoveIsolatedFunction GetMoveIsolated() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return &MoveIsolatedAvx2;
#endif
    return &MoveIsolatedBase;
}

}  // namespace scree
