// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernel for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_MOVE_ISOLATED MoveIsolatedBase
#include "pipeline/parts/isolated_bodies.inc"

namespace scree {

IsolatedMove MoveIsolatedAvx2(const IsolatedBodiesTask& task, const int32_t* eight);

MoveIsolatedFunction GetMoveIsolated() { return SCREE_WIDEST(&MoveIsolatedBase, &MoveIsolatedAvx2); }

}  // namespace scree
