// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Speeds at the points of a contact.

#include "pipeline/parts/note_events.h"

#include "scree/collision.h"
#include "state/frames.h"

namespace scree {

void NoteChange(ContactIndex contact, const ContactTable& contacts, EventLog& log) {
    log.NoteChange(contacts.pair[contact], contacts.Has(contact, ContactFlag::sensor),
                   contacts.Has(contact, ContactFlag::touching));
}

void NoteHit(ContactIndex contact, const FixtureTable& fixtures, const BodyTable& bodies, const ContactTable& contacts,
             EventLog& log) {
    const ContactPair& pair = contacts.pair[contact];
    if (!contacts.Has(contact, ContactFlag::touching) || contacts.Has(contact, ContactFlag::sensor)) return;
    if (!log.Wants(pair, Report::hits)) return;
    const Vec2 frame = FrameOf(bodies, pair.bodyA, pair.bodyB);
    WorldManifold at;
    at.Initialize(&contacts.manifold[contact], TransformIn(frame, bodies, pair.bodyA),
                  fixtures.shape[pair.fixtureA]->m_radius, TransformIn(frame, bodies, pair.bodyB),
                  fixtures.shape[pair.fixtureB]->m_radius);
    const Velocity& a = bodies.velocity[pair.bodyA];
    const Velocity& b = bodies.velocity[pair.bodyB];
    const Vec2 centreA = CentreIn(frame, bodies, pair.bodyA), centreB = CentreIn(frame, bodies, pair.bodyB);
    float fastest = 0.0f;
    Vec2 where = vec2Zero;
    for (int i = 0; i < contacts.manifold[contact].pointCount; ++i) {
        const Vec2 p = at.points[i];
        const Vec2 apart = b.v + Cross(b.w, p - centreB) - a.v - Cross(a.w, p - centreA);
        const float speed = -Dot(apart, at.normal);
        if (speed > fastest) fastest = speed, where = p;
    }
    if (fastest > 0.0f && fastest >= log.hitSpeed) log.NoteHit(pair, frame + where, at.normal, fastest);
}

}  // namespace scree
