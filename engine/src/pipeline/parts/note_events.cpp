// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Speeds at the points of a contact.

#include "pipeline/parts/note_events.h"

#include "scree/collision.h"
#include "state/frames.h"

namespace scree {

void NoteChange(int contact, const ContactTable& contacts, EventLog& log) {
    log.NoteChange(contacts.pair[static_cast<size_t>(contact)], contacts.Has(contact, ContactFlag::sensor),
                   contacts.Has(contact, ContactFlag::touching));
}

void NoteHit(int contact, const FixtureTable& fixtures, const BodyTable& bodies, const ContactTable& contacts,
             EventLog& log) {
    const auto c = static_cast<size_t>(contact);
    const ContactPair& pair = contacts.pair[c];
    if (!contacts.Has(contact, ContactFlag::touching) || contacts.Has(contact, ContactFlag::sensor)) return;
    if (!log.Wants(pair, Report::hits)) return;
    const Vec2 frame = FrameOf(bodies, pair.bodyA, pair.bodyB);
    WorldManifold at;
    at.Initialize(&contacts.manifold[c], TransformIn(frame, bodies, pair.bodyA),
                  fixtures.shape[pair.fixtureA]->m_radius, TransformIn(frame, bodies, pair.bodyB),
                  fixtures.shape[pair.fixtureB]->m_radius);
    const Velocity& a = bodies.velocity[static_cast<size_t>(pair.bodyA)];
    const Velocity& b = bodies.velocity[static_cast<size_t>(pair.bodyB)];
    const Vec2 centreA = CentreIn(frame, bodies, pair.bodyA), centreB = CentreIn(frame, bodies, pair.bodyB);
    float fastest = 0.0f;
    Vec2 where = vec2Zero;
    for (int i = 0; i < contacts.manifold[c].pointCount; ++i) {
        const Vec2 p = at.points[i];
        const Vec2 apart = b.v + Cross(b.w, p - centreB) - a.v - Cross(a.w, p - centreA);
        const float speed = -Dot(apart, at.normal);
        if (speed > fastest) fastest = speed, where = p;
    }
    if (fastest > 0.0f && fastest >= log.hitSpeed) log.NoteHit(pair, frame + where, at.normal, fastest);
}

}  // namespace scree
