// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of contacts and the hash that finds a contact by its pair. One row is at most 128 bytes with its share of
// the hash (GetBytesPerRow); handles are made only for programs that look at contacts.
//
// Persistence (the dissertation, §4.2): the broad phase reports all pairs of the present boxes. Each reported pair
// marks its contact or makes one. The contacts left unmarked are removed in one batch.
//
// Contacts of bodies that rest are kept aside: a step walks over the rows in `active` only. A resting contact is in the
// lists of its two bodies, so that it is found when one of them stirs. Which contacts rest changes no result.

#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/compiler.h"
#include "base/index_set.h"
#include "base/lazy_rows.h"
#include "scree/collision.h"
#include "scree/contact.h"
#include "state/indices.h"
#include "state/refused_pairs.h"

namespace scree {

struct ContactFlag {
    static constexpr uint8_t alive = 1;   ///< the row is in use
    static constexpr uint8_t marked = 2;  ///< its pair was reported by the last pair finding
    static constexpr uint8_t touching = 4;
    static constexpr uint8_t enabled = 8;    ///< PreSolve may clear it for one step
    static constexpr uint8_t sensor = 16;    ///< one of the fixtures is a sensor
    static constexpr uint8_t refilter = 32;  ///< filters must be asked again
    static constexpr uint8_t fresh = 64;     ///< bodies may have been put into each other; until the manifold is known
};

/// Who takes part. A and B are ordered as the collision function of the two shapes wants them.
struct ContactPair {
    FixtureIndex fixtureA, fixtureB;
    BodyIndex bodyA, bodyB;
};

struct ContactMaterial {
    float friction, restitution, restitutionThreshold, tangentSpeed;
};

/// Normal, arms and separations of a contact of two points as they were when its bodies came to lie as they do. The
/// soft step solves with these while the bodies stay about there. Points that are found anew in every step wander with
/// whatever little the bodies do. Columns then buckle under moments that come of nothing else. (Persistent manifolds;
/// this form: Catto, Box2D 3.2, "contact recycling".) Sides A and B are those of the solver: B can be pushed.
struct SteadyContact {
    float turnA = 0.0f, turnB = 0.0f;  ///< angles of the bodies, rad
    Vec2 between{0.0f, 0.0f};          ///< from A's centre to B's
    Vec2 normal{0.0f, 0.0f};           ///< from A to B
    float isKept = 0.0f;               ///< 1, or 0: the manifold is newer; −1: a program has set it, for one step
    float reach = 0.0f;                ///< of the longest arm of a body that can be pushed, m
    Vec2 arm[maxManifoldPoints]{};     ///< from A's centre to the point
    float separation[maxManifoldPoints]{};
    float isSwapped = 0.0f;  ///< 1: the solver's side A is the contact's B
    /// What is left of the overlap in which the bodies were made or put, m; below 0: minus its share of all overlap.
    float initialOverlap = 0.0f;
};

struct ContactTable {
    Column<ContactIndex, uint8_t> flags;  ///< ContactFlag; its size is the number of rows
    Column<ContactIndex, ContactPair> pair;
    Column<ContactIndex, Manifold> manifold;
    Column<ContactIndex, ContactMaterial> material;
    Column<ContactIndex, SteadyContact> steady;  ///< rows only after a soft step
    Column<ContactIndex, float>
        rolling;               ///< impulse of rolling resistance, N·m·s; rows only after a step that has some
    bool keepsSteady = false;  ///< this step is a soft one
    float steadyReach = 0.0f;  ///< how far steady points may wander before they are found anew, m

    /// The contacts of the pairs in the order in which all were last matched; below 0: a pair without one. Pairs come
    /// in nearly the same order in every step, which then finds most contacts without the hash. A hint: any rows are
    /// valid.
    std::vector<ContactIndex> order;
    Column<ContactIndex, int> place;  ///< where the row stood in `order` when it was last there; likewise
    /// Changes whenever a row that stays touching has another pair or another number of points. While it does not,
    /// solvers may keep what they made of the same list of contacts.
    uint64_t grouping = 0;
    std::vector<ContactIndex> matched;    ///< scratch of the matching: the contact of each pair
    std::vector<int> missing;             ///< likewise: pairs that have none
    std::vector<uint64_t> freshPairs;     ///< likewise
    std::vector<uint64_t> freshRefusals;  ///< likewise: of these, what the filter has refused
    RefusedPairs refused;

    IndexSet<ContactIndex> active;  ///< living rows that do not rest
    bool mayRest = false;           ///< some of them could, as some body has fallen asleep or contacts were roused
    bool addsFresh = false;         ///< rows that are added now are
    /// No contact is of a pair that its filters refuse. To be put to false where a filter changes or contacts come from
    /// elsewhere; the matching finds out anew.
    bool filtersAgree = false;
    bool mustMatch =
        true;  ///< pairs must be matched even if no box changes: contacts were added, or the filter changed

    [[nodiscard]] int Size() const { return static_cast<int>(flags.size()); }
    [[nodiscard]] IndexRange<ContactIndex> Rows() const { return flags.Rows(); }
    [[nodiscard]] bool IsAlive(ContactIndex contact) const {
        return flags.Has(contact) && Has(contact, ContactFlag::alive);
    }
    [[nodiscard]] int Count() const { return m_count; }
    [[nodiscard]] bool Has(ContactIndex contact, uint8_t flag) const { return (flags[contact] & flag) != 0; }
    /// The contact of two fixtures, or −1.
    [[nodiscard]] ContactIndex Find(FixtureIndex fixture1, FixtureIndex fixture2) const;
    /// True if the row is that of the pair. Any row may be asked.
    [[nodiscard]] bool IsRowOf(ContactIndex contact, FixtureIndex fixture1, FixtureIndex fixture2) const {
        if (!pair.Has(contact)) return false;
        const ContactPair& p = pair[contact];
        const bool same = ((p.fixtureA == fixture1) & (p.fixtureB == fixture2)) |
                          ((p.fixtureA == fixture2) & (p.fixtureB == fixture1));
        return same && IsAlive(contact);
    }
    /// Room for so many more contacts.
    void Reserve(size_t more);
    /// Asks for the place of a pair in the hash, which is to be looked up soon.
    void FetchHome(FixtureIndex a, FixtureIndex b) const {
        if (!m_hash.empty()) Prefetch(&m_hash[Home(a, b)]);
    }
    /// A new row for a pair that has none; no flags but alive and marked.
    ContactIndex Add(const ContactPair& newPair);
    /// Frees the row; Compact makes it usable again.
    void Remove(ContactIndex contact);
    /// At the beginning of a step; steady points are those of soft ones.
    void KeepSteady(bool isSoft, float lengthScale) {
        keepsSteady = isSoft;
        steadyReach = 10.0f * linearSlop * lengthScale;
    }
    /// The manifold of this contact is another, or its bodies' centres are.
    void ForgetSteady(ContactIndex contact) {
        if (!steady.empty()) steady[contact].isKept = 0.0f;
    }
    /// The manifold of this contact holds for this step alone.
    void LeaveUnsteady(ContactIndex contact) {
        if (steady.Has(contact))
            steady[contact].isKept = manifold[contact].pointCount < maxManifoldPoints ? 0.0f : -1.0f;
    }
    /// A callback may leave a touching contact without points, or make a sensor's solid, which never has any. It cannot
    /// push: it is disabled for the step.
    void DisableWithoutPoints(ContactIndex contact) {
        constexpr uint8_t kind = ContactFlag::touching | ContactFlag::sensor;
        if ((flags[contact] & kind) != ContactFlag::touching || manifold[contact].pointCount > 0) return;
        flags[contact] = static_cast<uint8_t>(flags[contact] & ~ContactFlag::enabled);
    }
    /// The fresh contact touches: the soft step is to see how deep its bodies are in each other.
    void AskInitialOverlap(ContactIndex contact) {
        if (!keepsSteady) return;
        if (steady.size() < flags.size()) steady.resize(flags.size());
        steady[contact].initialOverlap = -1.0f;
    }
    [[nodiscard]] int RestingCount() const { return m_count - active.Count(); }
    /// Resting contacts that touch.
    [[nodiscard]] int RestingTouchingCount() const { return m_restingTouching; }
    /// The highest row below `row` that a step looks at; as long as nothing rests every row.
    [[nodiscard]] ContactIndex Before(ContactIndex row) const {
        return RestingCount() == 0 ? ContactIndex{ToInt(row) - 1} : active.Before(row);
    }
    /// −1: there is none.
    [[nodiscard]] ContactIndex LastAliveBelow(ContactIndex row) const {
        while (IsSome(--row) && !IsAlive(row)) continue;
        return row;
    }
    [[nodiscard]] bool IsResting(ContactIndex contact) const { return !active.Has(contact); }
    void Rest(ContactIndex contact);
    void Rouse(ContactIndex contact);
    /// Rouses the contacts of a body. Returns how many of them touch in rows below `row`.
    int RouseOf(BodyIndex body, ContactIndex row = ContactIndex{0});
    /// Appends the resting contacts of a body, in any order.
    void ListResting(BodyIndex body, std::vector<ContactIndex>& rows) const;
    [[nodiscard]] bool HasResting(BodyIndex body) const {
        return m_restingFirst.Has(body) && m_restingFirst[body] >= 0;
    }
    /// False if the body has no contacts, without looking for any.
    [[nodiscard]] bool MayHave(BodyIndex body) const { return !active.IsEmpty() || HasResting(body); }
    /// Clears the flag `marked` of all rows, or of those that do not rest and for whose pair the predicate holds.
    void ClearMarks();
    template <typename Predicate>
    void ClearMarksIf(Predicate goes) {
        active.ForEach([&](ContactIndex row) {
            if (goes(pair[row])) flags[row] = static_cast<uint8_t>(flags[row] & ~ContactFlag::marked);
        });
    }
    /// Removes the rows that have neither the flag `marked` nor `touching`; none of them rests.
    void RemoveParted();
    /// Orders the free rows, so that new contacts take the lowest, and frees trailing ones. Where most of many rows are
    /// free, contacts move to the lowest rows in the same order: stages walk over rows. O(rows).
    void Compact();
    template <typename Self, typename Visit>
    static void Fields(Self& t, Visit& visit) {
        auto& [flags, pair, manifold, material, steady, rolling, keepsSteady, steadyReach, order, place, grouping,
               matched, missing, freshPairs, freshRefusals, refused, active, mayRest, addsFresh, filtersAgree,
               mustMatch, hash, shift, free, isCompact, handles, generation, count, resting, restingFirst,
               restingTouching, adjacency, first, entries, late, ofBody, handleRows, generationRows] = t;
        visit.Rows(t, flags, pair, manifold, material, steady, rolling), visit(keepsSteady, free);
        visit.LeftOut(steadyReach, order, place, grouping, matched, missing, freshPairs, freshRefusals, refused, active,
                      mayRest, addsFresh, filtersAgree, mustMatch, hash, shift, isCompact, handles, generation, count,
                      resting, restingFirst, restingTouching, adjacency, first, entries, late, ofBody, handleRows,
                      generationRows);
    }
    /// After the fields were read: makes the rest anew. False if they contradict each other.
    [[nodiscard]] bool Restore();
    /// What the fields were before they were put back to another time.
    struct FormerRows {
        Column<ContactIndex, uint8_t> flags;
        Column<ContactIndex, ContactPair> pair;
    };
    /// After that: the rest follows. Ids of contacts name nothing any more unless all contacts are those of before.
    void NoteReturn(const FormerRows& before);
    /// Contacts of a body, newest row first; rows removed since the last Add are still listed. Valid until the next
    /// Add, Rest or Rouse, or the next call. O(contacts that do not rest) after a Rest or many of the others, else
    /// O(contacts of the body).
    std::span<const ContactIndex> OfBody(BodyIndex body);
    // These may be called by several threads at once while nobody changes the table: what they look up is made by the
    // first one.
    /// The same rows, added to a list of the caller's, and how many of them are alive.
    void ListOfBody(BodyIndex body, std::vector<ContactIndex>& rows) const;
    [[nodiscard]] int CountOfBody(BodyIndex body) const;
    /// Takes over the handles of a table that this one is to replace. Their ids name nothing any more.
    void TakeHandles(ContactTable& old);
    /// The handle of a row, made on first use; it stays with the contact until that ends.
    Contact* Handle(WorldState* state, ContactIndex contact) const;
    /// The handle with this number while its contact lives, null without one.
    [[nodiscard]] Contact* HandleOf(ContactNumber number) const;
    [[nodiscard]] bool Owns(const Contact* contact) const;
    /// How many contacts the handle with this number has outlived since generations are counted: from the first call
    /// on.
    [[nodiscard]] uint32_t GetGeneration(ContactNumber number) const;
    /// Number of a row's contact (Contact::GetIndex), and one more than the largest there is.
    [[nodiscard]] ContactNumber GetNumber(ContactIndex contact) const {
        return ToSize(contact) < HandleCount() ? NumberOfRow(contact) : ContactNumber{ToInt(contact)};
    }
    [[nodiscard]] size_t GetNumberEnd() const { return std::max(flags.size(), HandleCount()); }

    [[nodiscard]] size_t GetMemoryBytes() const;
    /// Gives back the room for more contacts.
    void Trim();
    [[nodiscard]] static size_t GetBytesPerRow();

private:
    /// A handle, and in the bytes it leaves unused the number of the handle of the row with this position: a
    /// permutation.
    struct HandleSlot : Contact {
        HandleSlot(WorldState* state, ContactNumber number)
            : Contact(state, ContactIndex{ToInt(number)}), numberOfRow(number) {}
        ContactNumber numberOfRow;
    };

    [[nodiscard]] ContactNumber& NumberOfRow(ContactIndex row) const {
        return m_handles[ContactNumber{ToInt(row)}].numberOfRow;
    }
    [[nodiscard]] size_t Home(FixtureIndex a, FixtureIndex b) const;
    /// Enlarges the hash, for `count` contacts at least.
    void Grow(int count);
    /// Fills the hash anew.
    void Rehash();
    void CloseGaps();
    /// Of the columns with a row per contact.
    void Resize(size_t rows);
    /// The contact leaves the lists of resting contacts.
    void UnlinkResting(ContactIndex contact);
    /// All living rows are active.
    void RouseAll();
    /// What follows from the flags and pairs.
    void MakeAnew();
    /// Handles have the numbers of their rows, and are those of other contacts.
    void ForgetNumbers();
    /// Row r has become row movedTo[r], −1 if it was free.
    void MoveHandles(const Column<ContactIndex, ContactIndex>& movedTo);
    void EnsureAdjacency() const {
        m_adjacency.Ensure(1, [this] { MakeAdjacency(); });
    }
    void MakeAdjacency() const;
    /// The row does not rest any more, or is new.
    void NoteActive(ContactIndex row);
    [[nodiscard]] bool Joins(ContactIndex row, BodyIndex body) const {
        return pair[row].bodyA == body || pair[row].bodyB == body;
    }
    [[nodiscard]] bool IsLate(ContactIndex row) const;
    [[nodiscard]] bool HasLate(BodyIndex body) const;
    /// Of the contacts that do not rest, without the late ones. A late row may be among them as that of another
    /// contact.
    [[nodiscard]] std::span<const ContactIndex> EntriesOf(BodyIndex body) const;
    [[nodiscard]] size_t HandleCount() const { return ToSize(m_handleRows.Count()); }
    void NoteEnd(ContactIndex contact) {
        if (const ContactNumber number = GetNumber(contact); m_generation.Has(number)) ++m_generation[number];
    }
    void InsertKey(ContactIndex contact);
    void EraseKey(ContactIndex contact);

    std::vector<ContactIndex>
        m_hash;  ///< open addressing, linear probing, −1 empty; size a power of two, at most 2/3 full
    int m_shift = 64;
    std::vector<ContactIndex> m_free;  ///< highest first, when compact
    bool m_isCompact = true;           ///< no row was removed since Compact
    mutable StableColumn<ContactNumber, HandleSlot> m_handles;
    mutable Column<ContactNumber, uint32_t> m_generation;  ///< per number; empty until somebody asks for one
    int m_count = 0;

    static constexpr ContactIndex ContactOf(int entry) { return ContactIndex{entry >> 1}; }
    static constexpr int SideOf(int entry) { return entry & 1; }
    static constexpr int EntryOf(ContactIndex contact, int side) { return 2 * ToInt(contact) + side; }
    /// Places of a resting contact in the lists of its bodies. An entry is 2 · row + side (0: body A, 1: body B).
    struct RestingLinks {
        int prev[2], next[2];
    };
    Column<ContactIndex, RestingLinks> m_resting;  ///< per row; empty until a contact rests
    Column<BodyIndex, int> m_restingFirst;         ///< per body: first entry, −1 none
    int m_restingTouching = 0;

    mutable LazyRows m_adjacency;  ///< 1 while the next three are valid
    /// Of the contacts that do not rest, per body up to the last one with any: start in m_entries; one more at the end.
    mutable Column<BodyIndex, int> m_first;
    mutable std::vector<ContactIndex> m_entries;
    /// Rows that came since, in ascending order: an event of continuous collision adds a few, and a world may have many
    /// contacts.
    mutable std::vector<ContactIndex> m_late;
    static constexpr size_t mostLate = 64;
    std::vector<ContactIndex> m_ofBody;  ///< the last answer for a body with resting contacts
    mutable LazyRows m_handleRows, m_generationRows;
};

}  // namespace scree
