// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A step without stages.

#include "world/still_step.h"

#include <algorithm>

#include "pipeline/parts/rouse.h"

namespace scree {

bool IsStill(const WorldState& s, const StepRequest& request) {
    if (s.idleSubsteps != request.substeps || request.IsTooShort()) return false;
    if (!s.contacts.active.IsEmpty() || s.continuousScratch.resuming) return false;
    const std::span<const BodyIndex> listed = s.bodies.Listed();
    if (listed.empty()) return true;
    return !s.contacts.mustMatch && std::ranges::none_of(listed, [&](BodyIndex b) { return s.bodies.IsActive(b); });
}

void StandStill(WorldState& s, const StepRequest& request, StepResults& results) {
    results.touchingCount = s.contacts.RestingTouchingCount();
    PrepareKernels(s);
    if (s.bodies.fellAsleep > 0 || s.contacts.mayRest || !s.bodies.risen.empty()) {
        RestSleepers(*s.pool, s.bodies, s.fixtures, s.contacts, *s.broadPhase, s.islandScratch.sleepy.rows);
    }
    if (!s.bodies.risenProxies.empty()) {
        std::erase_if(s.bodies.risenProxies, [&](BodyIndex b) { return s.bodies.isListed[b] == 0; });
    }
    s.contacts.Compact();  // some may have ended in a step of no duration
    s.lastInverseDt = 1.0f / request.dt;
}

}  // namespace scree
