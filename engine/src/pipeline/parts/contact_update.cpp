// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One contact class; the collision function comes from a table by shape types (the dissertation, §4.2.4).

#include "pipeline/parts/contact_update.h"

#include "geometry/collide.h"

namespace scree {

namespace {

/// Copies the impulses of points that persisted, by feature id.
void MatchImpulses(const Manifold& old, Manifold& fresh) {
    for (int i = 0; i < fresh.pointCount; ++i) {
        ManifoldPoint& p = fresh.points[i];
        p.normalImpulse = 0.0f;
        p.tangentImpulse = 0.0f;
        for (int j = 0; j < old.pointCount; ++j) {
            if (old.points[j].id.key == p.id.key) {
                p.normalImpulse = old.points[j].normalImpulse;
                p.tangentImpulse = old.points[j].tangentImpulse;
                break;
            }
        }
    }
}

struct ContactUpdate {
    bool wasTouching, isTouching, isSensor;
};

/// New manifold of one contact; the old one goes to `old`.
ContactUpdate UpdateManifold(const FixtureTable& fixtures, const BodyTable& bodies, int contact, ContactTable& contacts,
                             Manifold& old) {
    const auto c = static_cast<size_t>(contact);
    const ContactPair& pair = contacts.pair[c];
    const Shape& shapeA = *fixtures.shape[pair.fixtureA];
    const Shape& shapeB = *fixtures.shape[pair.fixtureB];
    const Transform& xfA = bodies.transform[static_cast<size_t>(pair.bodyA)];
    const Transform& xfB = bodies.transform[static_cast<size_t>(pair.bodyB)];
    Manifold& manifold = contacts.manifold[c];

    ContactUpdate update{};
    update.wasTouching = contacts.Has(contact, ContactFlag::touching);
    update.isSensor = contacts.Has(contact, ContactFlag::sensor);
    if (update.isSensor) {
        update.isTouching = TestOverlap(shapeA, xfA, shapeB, xfB);
        manifold.pointCount = 0;  // sensors push nobody
    } else {
        old = manifold;
        FindCollide(shapeA.GetType(), shapeB.GetType()).function(manifold, shapeA, xfA, shapeB, xfB);
        MatchImpulses(old, manifold);
        update.isTouching = manifold.pointCount > 0;
    }
    uint8_t flags = contacts.flags[c];
    flags = static_cast<uint8_t>((flags & ~ContactFlag::touching) | ContactFlag::enabled);
    if (update.isTouching) flags |= ContactFlag::touching;
    contacts.flags[c] = flags;
    return update;
}

}  // namespace

bool UpdateContact(int contact, const FixtureTable& fixtures, const ContactEvents& events, BodyTable& bodies,
                   ContactTable& contacts) {
    Manifold old;
    const ContactUpdate update = UpdateManifold(fixtures, bodies, contact, contacts, old);
    if (update.wasTouching != update.isTouching && !update.isSensor) {
        bodies.Wake(contacts.pair[static_cast<size_t>(contact)].bodyA);
        bodies.Wake(contacts.pair[static_cast<size_t>(contact)].bodyB);
    }
    if (events.listener == nullptr) return update.isTouching;
    if (!update.wasTouching && update.isTouching) events.listener->BeginContact(contacts.Handle(events.state, contact));
    if (update.wasTouching && !update.isTouching) events.listener->EndContact(contacts.Handle(events.state, contact));
    if (!update.isSensor && update.isTouching) {
        events.listener->PreSolve(contacts.Handle(events.state, contact), &old);
    }
    return update.isTouching;
}

}  // namespace scree
