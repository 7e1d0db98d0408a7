// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The makers of the algorithms, one per file; CreateBroadPhase picks among them.

#pragma once

#include <memory>

#include "broad_phase/broad_phase.h"

namespace scree::broadphase {

std::unique_ptr<BroadPhase> MakeBruteForce();
std::unique_ptr<BroadPhase> MakeSweepAndPrune();
std::unique_ptr<BroadPhase> MakeBvhBarycentre(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeBvhSah(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeFatTree(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeGlobal1(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeGlobal2(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeGlobal3(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeUnified(const BroadPhaseConfig& config);
std::unique_ptr<BroadPhase> MakeKeys(const BroadPhaseConfig& config);

}  // namespace scree::broadphase
