// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// New manifold of one contact at the bodies' present transforms, and its events. Shared by the narrow phase and the
// continuous collision.

#pragma once

#include "pipeline/contact_events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// The points of a manifold as it was, taken before it is computed anew. Collision functions leave impulses alone, so
/// those of a point that keeps its place are there already.
class OldPoints {
public:
    explicit OldPoints(const Manifold& manifold)
        : m_count(manifold.pointCount), m_key{manifold.points[0].id.key, manifold.points[1].id.key} {}

    [[nodiscard]] int GetCount() const { return m_count; }
    /// Gives each point the impulses of the old point with its feature id, 0 if there was none.
    void CarryImpulses(Manifold& fresh) const {
        if (fresh.pointCount == 0) return;
        const ManifoldPoint was[maxManifoldPoints] = {fresh.points[0], fresh.points[1]};
        for (int i = 0; i < fresh.pointCount; ++i) {
            ManifoldPoint& p = fresh.points[i];
            int from = 0;
            while (from < m_count && m_key[from] != p.id.key) ++from;
            if (from == i && i < m_count) continue;
            p.normalImpulse = from < m_count ? was[from].normalImpulse : 0.0f;
            p.tangentImpulse = from < m_count ? was[from].tangentImpulse : 0.0f;
        }
    }

private:
    int m_count;
    uint32_t m_key[maxManifoldPoints];
};

/// Whether a contact may have steady geometry: only contacts of two points do, from their first soft step on.
inline bool MayBeSteady(const Manifold& manifold) { return manifold.pointCount == maxManifoldPoints; }
/// True if the contact goes on with the geometry that it keeps (SteadyContact): its bodies lie about as they did.
bool StaysSteady(ContactIndex contact, const BodyTable& bodies, const ContactTable& contacts);

/// The manifold at the present transforms, with the impulses of the old one by feature id; true if the fixtures touch.
/// Nothing else changes but `work`, the counts of what sensors cost, so contacts may be computed in any order and at
/// the same time.
bool ComputeManifold(ContactIndex contact, const FixtureTable& fixtures, const BodyTable& bodies, TOIStats& work,
                     ContactTable& contacts);

/// What follows a computed manifold: flags, and the bodies wake if the contact began or ended
/// (ContactEvents::restartsTimers). True if it did.
bool NoteTouching(ContactIndex contact, bool isTouching, bool restartsTimers, BodyTable& bodies,
                  ContactTable& contacts);

/// The same for a contact that does not rest, where nobody is told; several workers may call it at once. False, and
/// nothing noted for good, if it has to be done in the order of contacts: somebody would wake, say.
bool TryNoteTouching(ContactIndex contact, bool isTouching, bool restartsTimers, BodyTable& bodies,
                     ContactTable& contacts);

/// Tells the listener of a contact that began or ended (`hasChanged`), and of one that is going to be solved. `old` is
/// its manifold before that was computed, of interest only where somebody hears of pre-solve.
void TellAbout(ContactIndex contact, bool isTouching, bool hasChanged, const Manifold& old, const ContactEvents& events,
               ContactTable& contacts);

/// All of this: computes, notes and tells. Returns true if the fixtures touch.
bool UpdateContact(ContactIndex contact, const FixtureTable& fixtures, const ContactEvents& events, BodyTable& bodies,
                   ContactTable& contacts);

}  // namespace scree
