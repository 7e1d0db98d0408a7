// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One contact class; the collision function comes from a table by shape types (the dissertation, §4.2.4). The pairs
// that fill worlds are called by name.

#include "pipeline/parts/contact_update.h"

#include "base/shared_count.h"
#include "geometry/collide.h"
#include "pipeline/parts/note_events.h"
#include "state/frames.h"

namespace scree {

namespace {

void Collide(Manifold& manifold, const Shape& shapeA, const Transform& xfA, const Shape& shapeB, const Transform& xfB) {
    if (shapeA.GetType() == Shape::e_polygon && shapeB.GetType() == Shape::e_polygon) {
        CollidePolygons(&manifold, static_cast<const PolygonShape*>(&shapeA), xfA,
                        static_cast<const PolygonShape*>(&shapeB), xfB);
    } else if (shapeA.GetType() == Shape::e_circle && shapeB.GetType() == Shape::e_circle) {
        CollideCircles(&manifold, static_cast<const CircleShape*>(&shapeA), xfA,
                       static_cast<const CircleShape*>(&shapeB), xfB);
    } else {
        FindCollide(shapeA.GetType(), shapeB.GetType()).function(manifold, shapeA, xfA, shapeB, xfB);
    }
}

/// Of a contact whose manifold is known.
uint8_t FlagsOf(uint8_t before, bool isTouching) {
    constexpr uint8_t noted = ContactFlag::touching | ContactFlag::fresh;
    return static_cast<uint8_t>((before & ~noted) | ContactFlag::enabled | (isTouching ? ContactFlag::touching : 0));
}

bool AsksInitialOverlap(uint8_t flags) {
    return (flags & (ContactFlag::fresh | ContactFlag::sensor)) == ContactFlag::fresh;
}

/// The body is a static one, or awake already.
bool NeedsNoWaking(BodyIndex body, const BodyTable& bodies) {
    return bodies.type[body] == staticBody || (bodies.Has(body, BodyFlag::awake) && bodies.isListed[body] != 0);
}

}  // namespace

bool StaysSteady(ContactIndex contact, const BodyTable& bodies, const ContactTable& contacts) {
    if (!contacts.keepsSteady || !contacts.steady.Has(contact)) return false;
    const SteadyContact& row = contacts.steady[contact];
    if (row.isKept <= 0.0f || contacts.Has(contact, ContactFlag::sensor)) return false;
    const float mostWay = contacts.steadyReach;
    constexpr float mostTurn = 0.2f;
    const ContactPair& pair = contacts.pair[contact];
    const bool isSwapped = row.isSwapped != 0.0f;
    const BodyIndex a = isSwapped ? pair.bodyB : pair.bodyA, b = isSwapped ? pair.bodyA : pair.bodyB;
    const float turnA = bodies.position[a].a - row.turnA;
    const float turnB = bodies.position[b].a - row.turnB;
    if (!(Abs(turnA) < mostTurn && Abs(turnB) < mostTurn)) return false;
    const Vec2 frame = FrameOf(bodies, a, b);
    const Vec2 between = CentreIn(frame, bodies, b) - CentreIn(frame, bodies, a);
    const float turned = Abs(turnB - turnA) * row.reach;
    // The turn of A moves the far end of the way by no more than this; where that is little enough, its sine and cosine
    // need not be known.
    const float most = (between - row.between).Length() + Abs(turnA) * row.between.Length();
    constexpr float roundingErrors = 1.001f;
    if (roundingErrors * (most + turned) < mostWay) return true;
    // As A sees it: a tower that leans as a whole keeps all its contacts.
    return (between - Mul(Rot(turnA), row.between)).Length() + turned < mostWay;
}

bool ComputeManifold(ContactIndex contact, const FixtureTable& fixtures, const BodyTable& bodies, TOIStats& work,
                     ContactTable& contacts) {
    Manifold& manifold = contacts.manifold[contact];
    if (MayBeSteady(manifold)) {
        if (StaysSteady(contact, bodies, contacts)) return true;
        contacts.ForgetSteady(contact);
    }
    const ContactPair& pair = contacts.pair[contact];
    const Shape& shapeA = *fixtures.shape[pair.fixtureA];
    const Shape& shapeB = *fixtures.shape[pair.fixtureB];
    const Vec2 frame = FrameOf(bodies, pair.bodyA, pair.bodyB);
    const Transform xfA = TransformIn(frame, bodies, pair.bodyA), xfB = TransformIn(frame, bodies, pair.bodyB);
    if (contacts.Has(contact, ContactFlag::sensor)) {
        manifold.pointCount = 0;  // sensors push nobody
        DistanceProxy proxyA, proxyB;
        proxyA.Set(&shapeA, 0);
        proxyB.Set(&shapeB, 0);
        const OverlapResult result = FindOverlap(proxyA, xfA, proxyB, xfB);
        CountDistance(work, result.iterations);
        return result.overlaps;
    }
    const OldPoints old(manifold);
    Collide(manifold, shapeA, xfA, shapeB, xfB);
    old.CarryImpulses(manifold);
    return manifold.pointCount > 0;
}

bool NoteTouching(ContactIndex contact, bool isTouching, bool restartsTimers, BodyTable& bodies,
                  ContactTable& contacts) {
    if (contacts.RestingCount() > 0) contacts.Rouse(contact);
    const uint8_t flags = contacts.flags[contact];
    const bool hasChanged = ((flags & ContactFlag::touching) != 0) != isTouching;
    contacts.flags[contact] = FlagsOf(flags, isTouching);
    if (isTouching && AsksInitialOverlap(flags)) contacts.AskInitialOverlap(contact);
    if (hasChanged && (flags & ContactFlag::sensor) == 0) {
        for (const BodyIndex body : {contacts.pair[contact].bodyA, contacts.pair[contact].bodyB}) {
            if (restartsTimers || !bodies.Has(body, BodyFlag::awake)) bodies.Wake(body);
        }
    }
    return hasChanged;
}

bool TryNoteTouching(ContactIndex contact, bool isTouching, bool restartsTimers, BodyTable& bodies,
                     ContactTable& contacts) {
    const uint8_t flags = contacts.flags[contact];
    const bool asks = isTouching && AsksInitialOverlap(flags);
    if (asks && contacts.keepsSteady && !contacts.steady.Has(contact)) return false;
    const bool hasChanged = ((flags & ContactFlag::touching) != 0) != isTouching;
    if (hasChanged && (flags & ContactFlag::sensor) == 0) {
        const ContactPair& pair = contacts.pair[contact];
        if (!NeedsNoWaking(pair.bodyA, bodies) || !NeedsNoWaking(pair.bodyB, bodies)) return false;
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (restartsTimers && bodies.type[body] != staticBody) StoreShared(bodies.sleepTime[body], 0.0f);
        }
    }
    if (asks) contacts.AskInitialOverlap(contact);
    contacts.flags[contact] = FlagsOf(flags, isTouching);
    return true;
}

void TellAbout(ContactIndex contact, bool isTouching, bool hasChanged, const Manifold& old, const ContactEvents& events,
               ContactTable& contacts) {
    if (hasChanged && isTouching && events.HearsBegin())
        events.listener->BeginContact(contacts.Handle(events.state, contact));
    if (hasChanged && !isTouching && events.HearsEnd())
        events.listener->EndContact(contacts.Handle(events.state, contact));
    if (!isTouching || !events.HearsPreSolve() || contacts.Has(contact, ContactFlag::sensor)) return;
    events.listener->PreSolve(contacts.Handle(events.state, contact), &old);
}

bool UpdateContact(ContactIndex contact, const FixtureTable& fixtures, const ContactEvents& events, BodyTable& bodies,
                   ContactTable& contacts) {
    Manifold old;
    if (events.HearsPreSolve()) old = contacts.manifold[contact];
    const int before = contacts.manifold[contact].pointCount;
    const bool isTouching = ComputeManifold(contact, fixtures, bodies, *events.work, contacts);
    if (contacts.manifold[contact].pointCount != before) ++contacts.grouping;
    const bool hasChanged = NoteTouching(contact, isTouching, events.restartsTimers, bodies, contacts);
    if (hasChanged && events.log != nullptr) NoteChange(contact, contacts, *events.log);
    if (events.listener != nullptr) TellAbout(contact, isTouching, hasChanged, old, events, contacts);
    return isTouching;
}

}  // namespace scree
