// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Boxes of moved fixtures.

#include "pipeline/update_boxes.h"

namespace scree {

void UpdateBodyBoxes(const BodyTable& bodies, const FixtureTable& fixtures, int body, Vec2 displacement,
                     BroadPhase& broadPhase) {
    const Transform& xf = bodies.transform[static_cast<size_t>(body)];
    for (int f = bodies.info[static_cast<size_t>(body)].fixtureHead; f >= 0;
         f = fixtures.info[static_cast<size_t>(f)].next) {
        AABB box;
        fixtures.shape[static_cast<size_t>(f)]->ComputeAABB(&box, xf);
        broadPhase.Update(static_cast<uint32_t>(f), box, displacement);
    }
}

}  // namespace scree
