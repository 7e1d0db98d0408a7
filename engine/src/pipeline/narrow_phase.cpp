// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One pass over all contacts.

#include "pipeline/narrow_phase.h"

#include <cstring>
#include <optional>

#include "base/compiler.h"
#include "base/slots.h"
#include "geometry/collide_circles.h"
#include "geometry/collide_quads.h"
#include "pipeline/parts/contact_update.h"
#include "pipeline/parts/destroy_contact.h"
#include "pipeline/parts/make_contact.h"
#include "pipeline/parts/note_events.h"
#include "pipeline/parts/rouse.h"
#include "state/frames.h"

namespace scree {

namespace {

/// Still reported by the broad phase, and not refused by joints and filters when they must be asked again.
bool Stays(ContactIndex contact, const ContactEvents& events, NarrowPhaseTables t) {
    uint8_t& flags = t.contacts.flags[contact];
    if ((flags & ContactFlag::marked) == 0) return false;
    if ((flags & ContactFlag::refilter) == 0) return true;
    flags = static_cast<uint8_t>(flags & ~ContactFlag::refilter);
    const ContactPair& pair = t.contacts.pair[contact];
    return MayHaveContact(pair.fixtureA, pair.fixtureB, events, t.fixtures, t.joints);
}

/// How many rows ahead the shapes, poses and the manifold of a contact are fetched, and its pair before them.
constexpr int fetchAhead = 4, fetchPairAhead = 12;

/// Asks for what the update of a coming row reads; rows of neighbours are in memory anywhere.
void Fetch(ContactIndex contact, const NarrowPhaseTables& t) {
    if (ToInt(contact) < fetchPairAhead) return;
    Prefetch(&t.contacts.pair[ContactIndex{ToInt(contact) - fetchPairAhead}]);
    const ContactIndex next{ToInt(contact) - fetchAhead};
    const ContactPair& pair = t.contacts.pair[next];
    PrefetchToWrite(&t.contacts.manifold[next]);
    Prefetch(&t.bodies.transform[pair.bodyA]);
    Prefetch(&t.bodies.transform[pair.bodyB]);
    Prefetch(t.fixtures.shape[pair.fixtureA]);
    Prefetch(t.fixtures.shape[pair.fixtureB]);
}

SCREE_INLINE bool IsActive(ContactIndex contact, const NarrowPhaseTables& t) {
    const ContactPair& pair = t.contacts.pair[contact];
    return t.bodies.IsActive(pair.bodyA) || t.bodies.IsActive(pair.bodyB);
}

/// From this many contacts on, manifolds are computed ahead: together where shapes allow it, and by all workers.
constexpr int leastContacts = 16;
/// Or from this many on whose shapes are round: two of them together take less time than one after the other.
constexpr int leastCorePairs = 2;
/// Below this many they are not worth waking workers for.
constexpr int leastContactsToShare = 128;

bool PaysToLookAhead(const NarrowPhaseTables& t) {
    if (t.contacts.active.Count() >= leastContacts) return true;
    if (t.contacts.active.Count() < leastCorePairs) return false;
    int corePairs = 0;
    for (ContactIndex contact = t.contacts.flags.End(); IsSome(contact = t.contacts.Before(contact));) {
        if (!t.contacts.IsAlive(contact)) continue;
        const ContactPair& pair = t.contacts.pair[contact];
        corePairs += CorePair(*t.fixtures.shape[pair.fixtureA], *t.fixtures.shape[pair.fixtureB]).GoTogether() ? 1 : 0;
        if (corePairs == leastCorePairs) return true;
    }
    return false;
}

/// What workers that look ahead have noted for good.
struct PassedContacts {
    int touching = 0;
    int regrouped = 0;
};

/// Computes the manifolds that are sure to be wanted of a range of contacts.
class AheadOfOrder {
public:
    /// `isQuick`: nobody is told, so that contacts which wake nobody need no place in the order.
    AheadOfOrder(const NarrowPhaseTables& tables, const ContactEvents& events, bool isQuick, bool keepsOld,
                 NarrowPhaseScratch& scratch)
        : m_t(tables),
          m_isFar(tables.bodies.IsFar()),
          m_keepsOld(keepsOld),
          m_isQuick(isQuick),
          m_restartsTimers(events.restartsTimers),
          m_work(*events.work),
          m_scratch(scratch) {}

    PassedContacts Compute(int begin, int end) {
        for (ContactIndex contact{end}; ToInt(contact = m_t.contacts.Before(contact)) >= begin;) {
            Fetch(contact, m_t);
            constexpr uint8_t sure = ContactFlag::alive | ContactFlag::marked;
            const uint8_t flags = m_t.contacts.flags[contact];
            if ((flags & ContactFlag::alive) != 0) m_scratch.findings[contact] = NarrowPhaseScratch::nothing;
            if ((flags & (sure | ContactFlag::refilter)) != sure || !IsActive(contact, m_t)) continue;
            const Manifold& manifold = m_t.contacts.manifold[contact];
            if (m_keepsOld) m_scratch.old[contact] = manifold;
            if (MayBeSteady(manifold)) {
                if (StaysSteady(contact, m_t.bodies, m_t.contacts)) {
                    Note(contact, true, false);
                    continue;
                }
                m_t.contacts.ForgetSteady(contact);
            }
            if ((flags & ContactFlag::sensor) != 0 || !Batch(contact)) {
                const int before = manifold.pointCount;
                const bool touches = ComputeManifold(contact, m_t.fixtures, m_t.bodies, m_work, m_t.contacts);
                Note(contact, touches, manifold.pointCount != before);
            }
        }
        if (m_quads.batch.Size() > 0) ComputeBatch(m_quads);
        if (m_disks.batch.Size() > 0) ComputeBatch(m_disks);
        for (auto& ofA : m_cores) {
            for (auto& lanes : ofA) {
                if (lanes && lanes->batch.Size() > 0) ComputeBatch(*lanes);
            }
        }
        return m_passed;
    }

private:
    /// A batch, and where its bodies are far from the origin.
    template <typename Batch>
    struct Lanes {
        Batch batch;
        Transform near[quadLanes][2]{};
    };

    bool Batch(ContactIndex contact) {
        const ContactPair& pair = m_t.contacts.pair[contact];
        const Shape& a = *m_t.fixtures.shape[pair.fixtureA];
        const Shape& b = *m_t.fixtures.shape[pair.fixtureB];
        if (a.GetType() == Shape::e_circle && b.GetType() == Shape::e_circle && !m_isFar) {
            CollideDisks(contact, static_cast<const CircleShape&>(a), static_cast<const CircleShape&>(b));
            return true;
        }
        if (IsQuad(a) && IsQuad(b)) {
            Add(m_quads, contact, static_cast<const PolygonShape&>(a), static_cast<const PolygonShape&>(b));
            return true;
        }
        if (IsQuad(a) && b.GetType() == Shape::e_circle) {
            Add(m_disks, contact, static_cast<const PolygonShape&>(a), static_cast<const CircleShape&>(b));
            return true;
        }
        const CorePair kinds(a, b);
        if (!kinds.GoTogether()) return false;
        std::optional<Lanes<CoreBatch>>& lanes = m_cores[static_cast<int>(kinds.a)][static_cast<int>(kinds.b)];
        if (!lanes) lanes.emplace(Lanes<CoreBatch>{.batch = CoreBatch(kinds)});
        Add(*lanes, contact, a, b);
        return true;
    }

    /// Most of the pairs whose boxes overlap are apart, and were.
    SCREE_INLINE void CollideDisks(ContactIndex contact, const CircleShape& a, const CircleShape& b) {
        const ContactPair& pair = m_t.contacts.pair[contact];
        const Transform &xfA = m_t.bodies.transform[pair.bodyA], &xfB = m_t.bodies.transform[pair.bodyB];
        Manifold& manifold = m_t.contacts.manifold[contact];
        if (manifold.pointCount == 0 && !DoCirclesTouch(a, xfA, b, xfB)) return Note(contact, false, false);
        const OldPoints old(manifold);
        CollideCircles(&manifold, &a, xfA, &b, xfB);
        old.CarryImpulses(manifold);
        Note(contact, manifold.pointCount > 0, manifold.pointCount != old.GetCount());
    }

    template <typename Batch, typename A, typename B>
    void Add(Lanes<Batch>& lanes, ContactIndex contact, const A& a, const B& b) {
        const ContactPair& pair = m_t.contacts.pair[contact];
        const Transform* xfA = &m_t.bodies.transform[pair.bodyA];
        const Transform* xfB = &m_t.bodies.transform[pair.bodyB];
        if (m_isFar) {
            const Vec2 frame = FrameOf(m_t.bodies, pair.bodyA, pair.bodyB);
            Transform* const near = lanes.near[lanes.batch.Size()];
            near[0] = TransformIn(frame, m_t.bodies, pair.bodyA), near[1] = TransformIn(frame, m_t.bodies, pair.bodyB);
            xfA = &near[0], xfB = &near[1];
        }
        lanes.batch.Add(ToInt(contact), a, *xfA, b, *xfB);
        if (lanes.batch.IsFull()) ComputeBatch(lanes);
    }

    template <typename Batch>
    void ComputeBatch(Lanes<Batch>& lanes) {
        lanes.batch.Collide();
        for (int i = 0; i < lanes.batch.Size(); ++i) {
            const ContactIndex contact{lanes.batch.GetId(i)};
            Manifold& manifold = m_t.contacts.manifold[contact];
            const OldPoints old(manifold);
            lanes.batch.Write(i, manifold);
            old.CarryImpulses(manifold);
            Note(contact, manifold.pointCount > 0, manifold.pointCount != old.GetCount());
        }
        lanes.batch.Clear();
    }

    SCREE_INLINE void Note(ContactIndex contact, bool touches, bool isRegrouped) {
        if (m_isQuick && TryNoteTouching(contact, touches, m_restartsTimers, m_t.bodies, m_t.contacts)) {
            m_passed.touching += touches ? 1 : 0;
            m_passed.regrouped += isRegrouped ? 1 : 0;
            m_scratch.findings[contact] = NarrowPhaseScratch::passed;
            return;
        }
        m_scratch.findings[contact] =
            static_cast<uint8_t>(NarrowPhaseScratch::known | (touches ? NarrowPhaseScratch::touching : 0) |
                                 (isRegrouped ? NarrowPhaseScratch::regrouped : 0) |
                                 (m_t.contacts.Has(contact, ContactFlag::sensor) ? NarrowPhaseScratch::asSensor : 0));
    }

    const NarrowPhaseTables& m_t;
    const bool m_isFar, m_keepsOld, m_isQuick, m_restartsTimers;
    PassedContacts m_passed;
    TOIStats& m_work;
    NarrowPhaseScratch& m_scratch;
    Lanes<QuadBatch> m_quads;
    Lanes<QuadDiskBatch> m_disks;
    std::optional<Lanes<CoreBatch>> m_cores[2][2];  ///< by the kinds of both; most worlds have none
};

/// Bodies that wake on the way may add manifolds to these, which follow in order. Returns how many contacts that are
/// passed touch.
int ComputeAhead(const NarrowPhaseTables& t, const ContactEvents& events, bool isQuick, bool keepsOld,
                 NarrowPhaseScratch& scratch) {
    const size_t rows = t.contacts.flags.size();
    scratch.findings.assign(rows, NarrowPhaseScratch::unseen);
    if (keepsOld) EnsureRows(scratch.old, rows);
    PassedContacts passed[maxWorkers];
    t.pool.For(t.contacts.Size(), leastContactsToShare, [&](int begin, int end, int worker) {
        const PassedContacts more = AheadOfOrder(t, events, isQuick, keepsOld, scratch).Compute(begin, end);
        passed[worker].touching += more.touching;
        passed[worker].regrouped += more.regrouped;
    });
    int touching = 0;
    for (const PassedContacts& ofWorker : passed) {
        touching += ofWorker.touching;
        t.contacts.grouping += static_cast<uint64_t>(ofWorker.regrouped);
    }
    return touching;
}

/// The highest row below `row` that was not passed ahead of order; −1: there is none.
ContactIndex OpenBelow(const Column<ContactIndex, uint8_t>& findings, ContactIndex row) {
    constexpr uint8_t closed = NarrowPhaseScratch::passed | NarrowPhaseScratch::unseen;
    constexpr size_t width = sizeof(uint64_t);
    size_t at = ToSize(row);
    while (at > 0) {
        // Eight at a time; the bit for `unseen` comes to where that for `passed` is.
        static_assert(NarrowPhaseScratch::unseen == 2 * NarrowPhaseScratch::passed);
        constexpr uint64_t allClosed = NarrowPhaseScratch::passed * 0x0101010101010101u;
        uint64_t eight = 0;
        if (at >= width) std::memcpy(&eight, findings.data() + (at - width), width);
        if (((eight | eight >> 1) & allClosed) == allClosed) {
            at -= width;
        } else if ((findings[ContactIndex{static_cast<int>(--at)}] & closed) == 0) {
            return ContactIndex{static_cast<int>(at)};
        }
    }
    return ContactIndex::none;
}

/// Whether what was found ahead of a contact still holds: callbacks may have put its bodies to sleep, or made one of
/// its fixtures a sensor.
bool Holds(uint8_t finding, ContactIndex contact, const NarrowPhaseTables& t) {
    const bool isSensor = t.contacts.Has(contact, ContactFlag::sensor);
    return isSensor == ((finding & NarrowPhaseScratch::asSensor) != 0) && IsActive(contact, t);
}

}  // namespace

int UpdateManifolds(const ContactEvents& events, NarrowPhaseTables t, NarrowPhaseScratch& scratch) {
    const bool ahead = PaysToLookAhead(t);
    const bool keepsOld = events.HearsPreSolve();
    const bool isQuick = ahead && events.listener == nullptr && events.log == nullptr;
    int touchingCount = ahead ? ComputeAhead(t, events, isQuick, keepsOld, scratch) : 0;
    touchingCount += t.contacts.RestingTouchingCount();
    ContactIndex contact = t.contacts.flags.End();
    // Contacts of a body that wakes on the way are looked at, too, if they come later in the order.
    bool leapsOn = isQuick;
    const auto goOn = [&] {
        if (!t.bodies.risen.empty()) {
            touchingCount -= RouseContacts(t.bodies, t.contacts, contact);
            leapsOn = false;
        }
        contact = leapsOn ? OpenBelow(scratch.findings, contact) : t.contacts.Before(contact);
        return IsSome(contact);
    };
    bool isTold = false;  // the listener has been called, and may have changed what was found ahead
    while (goOn()) {
        const uint8_t flags = t.contacts.flags[contact];
        uint8_t known = ahead ? scratch.findings[contact] : uint8_t{NarrowPhaseScratch::nothing};
        if (known == NarrowPhaseScratch::passed) continue;
        if (known == NarrowPhaseScratch::unseen) known = NarrowPhaseScratch::nothing;  // it was roused since
        if ((known & NarrowPhaseScratch::regrouped) != 0) ++t.contacts.grouping;
        if ((flags & ContactFlag::alive) == 0) continue;
        if (!Stays(contact, events, t)) {
            isTold = isTold || events.listener != nullptr;
            DestroyContact(contact, !t.contacts.Has(contact, ContactFlag::marked), events, t.bodies, t.contacts);
            continue;
        }
        bool touching = (known & NarrowPhaseScratch::touching) != 0;
        if (known != NarrowPhaseScratch::nothing && (!isTold || Holds(known, contact, t))) {
            const bool changed = NoteTouching(contact, touching, events.restartsTimers, t.bodies, t.contacts);
            if (changed && events.log != nullptr) NoteChange(contact, t.contacts, *events.log);
            if (events.listener != nullptr && (changed || (touching && events.heard.preSolve))) {
                isTold = true;
                const Column<ContactIndex, Manifold>& old = keepsOld ? scratch.old : t.contacts.manifold;
                TellAbout(contact, touching, changed, old[contact], events, t.contacts);
            }
        } else {
            isTold = isTold || events.listener != nullptr;
            touching = IsActive(contact, t) ? UpdateContact(contact, t.fixtures, events, t.bodies, t.contacts)
                                            : t.contacts.Has(contact, ContactFlag::touching);
        }
        if (touching && events.log != nullptr && IsActive(contact, t))
            NoteHit(contact, t.fixtures, t.bodies, t.contacts, *events.log);
        if (touching) ++touchingCount;
    }
    return touchingCount;
}

}  // namespace scree
