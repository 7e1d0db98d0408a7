// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Moves the origin of a world: every stored world coordinate loses `newOrigin`. Contacts and impulses live in body
// coordinates and stay.

#include "pipeline/parts/update_boxes.h"
#include "world/guard.h"
#include "world/refresh.h"

namespace scree {

ErrorCode World::ShiftOrigin(Vec2 newOrigin) {
    WorldState& s = *m_state;
    Guard guard(s, "World::ShiftOrigin");
    guard.Unlocked("shift the origin outside of Step and callbacks").Near(newOrigin, "newOrigin");
    for (BodyIndex body = s.bodies.listHead; IsSome(body); body = s.bodies.info[body].listNext) {
        guard.Require(IsInRange(s.bodies.position[body].c - newOrigin), ErrorCode::outOfRange, "newOrigin",
                      "leave every body within 1e18 m of the origin");
    }
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(newOrigin);
    for (BodyIndex body = s.bodies.listHead; IsSome(body); body = s.bodies.info[body].listNext) {
        NotePosition(s, s.bodies.position[body].c - newOrigin, vec2Zero);
    }
    for (BodyIndex body = s.bodies.listHead; IsSome(body); body = s.bodies.info[body].listNext) {
        s.bodies.ShiftOrigin(body, newOrigin);
        if (s.bodies.Has(body, BodyFlag::enabled)) UpdateBodyBoxes(s.bodies, s.fixtures, body, vec2Zero, *s.broadPhase);
    }
    // Boxes are rounded anew, and some may come to touch.
    for (const BodyIndex body : s.bodies.movers) s.bodies.List(body);
    s.edited.AddAll();
    s.isEdited = true;
    s.continuousScratch.nearStatics.ForgetAll();
    s.joints.ShiftOrigin(newOrigin);
    return ErrorCode::ok;
}

}  // namespace scree
