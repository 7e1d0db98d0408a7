// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Algorithm name → algorithm.

#include "broad_phase/algorithms.h"

namespace scree {

std::unique_ptr<BroadPhase> CreateBroadPhase(BroadPhaseKind kind, const BroadPhaseConfig& config) {
    switch (kind) {
        case BroadPhaseKind::bruteForce:
            return broadphase::MakeBruteForce();
        case BroadPhaseKind::sweepAndPrune:
            return broadphase::MakeSweepAndPrune();
        case BroadPhaseKind::bvhBarycentre:
            return broadphase::MakeBvhBarycentre(config);
        case BroadPhaseKind::bvhSah:
            return broadphase::MakeBvhSah(config);
        case BroadPhaseKind::fatTree:
            return broadphase::MakeFatTree(config);
        case BroadPhaseKind::global1:
            return broadphase::MakeGlobal1(config);
        case BroadPhaseKind::global2:
            return broadphase::MakeGlobal2(config);
        case BroadPhaseKind::global3:
            return broadphase::MakeGlobal3(config);
        case BroadPhaseKind::unified:
            return broadphase::MakeUnified(config);
        case BroadPhaseKind::automatic:
        case BroadPhaseKind::keys:
            break;
    }
    return broadphase::MakeKeys(config);
}

}  // namespace scree
