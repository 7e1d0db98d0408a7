#include "broad_phase/algorithms.h"
namespace scree::broadphase {
std::unique_ptr<BroadPhase> MakeKeys(const BroadPhaseConfig& config) { return MakeUnified(config); }
}
