// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of contacts and the hash that finds a contact by its pair. One row is at most 128 bytes with its share of
// the hash (GetBytesPerRow); handles are made only for programs that look at contacts.
//
// Persistence (the dissertation, §4.2): the broad phase reports all pairs of the present boxes; each reported pair
// marks its contact or makes one; the contacts left unmarked are removed in one batch.
//
// Contacts of bodies that rest are kept aside: a step walks over the rows in `active` only. A resting contact is in the
// lists of its two bodies, so that it is found when one of them stirs. Which contacts rest changes no result.

#pragma once

#include <algorithm>
#include <deque>
#include <span>
#include <vector>

#include "base/index_set.h"
#include "base/lazy_rows.h"
#include "scree/collision.h"
#include "scree/contact.h"
#include "state/refused_pairs.h"

namespace scree {

struct ContactFlag {
    static constexpr uint8_t alive = 1;   ///< the row is in use
    static constexpr uint8_t marked = 2;  ///< its pair was reported by the last pair finding
    static constexpr uint8_t touching = 4;
    static constexpr uint8_t enabled = 8;    ///< PreSolve may clear it for one step
    static constexpr uint8_t sensor = 16;    ///< one of the fixtures is a sensor
    static constexpr uint8_t refilter = 32;  ///< filters must be asked again
};

/// Who takes part. A and B are ordered as the collision function of the two shapes wants them.
struct ContactPair {
    uint32_t fixtureA, fixtureB;
    int bodyA, bodyB;
};

struct ContactMaterial {
    float friction, restitution, restitutionThreshold, tangentSpeed;
};

/// Normal, arms and separations of a contact of two points as they were when its bodies came to lie as they do. The
/// soft step solves with these while the bodies stay about there: points that are found anew in every step wander with
/// whatever little the bodies do, and columns buckle under moments that come of nothing else. (Persistent manifolds;
/// this form: Catto, Box2D 3.2, "contact recycling".) Sides A and B are those of the solver: B can be pushed.
struct SteadyContact {
    float turnA = 0.0f, turnB = 0.0f;  ///< angles of the bodies, rad
    Vec2 between{0.0f, 0.0f};          ///< from A's centre to B's
    Vec2 normal{0.0f, 0.0f};           ///< from A to B
    float isKept = 0.0f;               ///< 1, or 0: the manifold is newer
    float reach = 0.0f;                ///< of the longest arm of a body that can be pushed, m
    Vec2 arm[maxManifoldPoints]{};     ///< from A's centre to the point
    float separation[maxManifoldPoints]{};
    float isSwapped = 0.0f;  ///< 1: the solver's side A is the contact's B
    float unused = 0.0f;
};

struct ContactTable {
    std::vector<uint8_t> flags;  ///< ContactFlag; its size is the number of rows
    std::vector<ContactPair> pair;
    std::vector<Manifold> manifold;
    std::vector<ContactMaterial> material;
    std::vector<SteadyContact> steady;  ///< rows only after a soft step
    std::vector<float> rolling;  ///< impulse of rolling resistance, N·m·s; rows only after a step that has some
    bool keepsSteady = false;    ///< this step is a soft one
    float steadyReach = 0.0f;    ///< how far steady points may wander before they are found anew, m

    /// The row whose pair came behind this row's pair when pairs were last matched, −1 none: pairs come in nearly the
    /// same order in every step, which then finds most contacts without the hash. A hint; any value is valid.
    std::vector<int> successor;
    int firstMatched = -1;                ///< where that order begins
    std::vector<int> matched;             ///< scratch of the matching: the contact of each pair
    std::vector<uint64_t> freshPairs;     ///< likewise
    std::vector<uint64_t> freshRefusals;  ///< likewise: of these, what the filter has refused
    RefusedPairs refused;

    IndexSet active;       ///< living rows that do not rest
    bool mayRest = false;  ///< some of them could, as some body has fallen asleep or contacts were roused
    bool mustMatch =
        true;  ///< pairs must be matched even if no box changes: contacts were added, or the filter changed

    [[nodiscard]] int Size() const { return static_cast<int>(flags.size()); }
    [[nodiscard]] bool IsAlive(int contact) const {
        return contact >= 0 && contact < Size() && Has(contact, ContactFlag::alive);
    }
    [[nodiscard]] int Count() const { return m_count; }
    [[nodiscard]] bool Has(int contact, uint8_t flag) const {
        return (flags[static_cast<size_t>(contact)] & flag) != 0;
    }
    /// The contact of two fixtures, or −1.
    [[nodiscard]] int Find(uint32_t fixture1, uint32_t fixture2) const;
    /// True if the row is that of the pair. Any row may be asked.
    [[nodiscard]] bool IsRowOf(int contact, uint32_t fixture1, uint32_t fixture2) const {
        if (static_cast<size_t>(static_cast<unsigned>(contact)) >= pair.size()) return false;
        const ContactPair& p = pair[static_cast<size_t>(contact)];
        const bool same = ((p.fixtureA == fixture1) & (p.fixtureB == fixture2)) |
                          ((p.fixtureA == fixture2) & (p.fixtureB == fixture1));
        return same && IsAlive(contact);
    }
    /// Room for so many more contacts.
    void Reserve(size_t more);
    /// A new row for a pair that has none; no flags but alive and marked.
    int Add(const ContactPair& newPair);
    /// Frees the row; Compact makes it usable again.
    void Remove(int contact);
    /// The manifold of this contact is another, or its bodies' centres are.
    void ForgetSteady(int contact) {
        if (!steady.empty()) steady[static_cast<size_t>(contact)].isKept = 0.0f;
    }
    [[nodiscard]] int RestingCount() const { return m_count - active.Count(); }
    /// Resting contacts that touch.
    [[nodiscard]] int RestingTouchingCount() const { return m_restingTouching; }
    /// The highest row below `row` that a step looks at; as long as nothing rests every row.
    [[nodiscard]] int Before(int row) const { return RestingCount() == 0 ? row - 1 : active.Before(row); }
    [[nodiscard]] bool IsResting(int contact) const { return !active.Has(contact); }
    void Rest(int contact);
    void Rouse(int contact);
    /// Rouses the contacts of a body. Returns how many of them touch in rows below `row`.
    int RouseOf(int body, int row = 0);
    /// Appends the resting contacts of a body, in any order.
    void ListResting(int body, std::vector<int>& rows) const;
    [[nodiscard]] bool HasResting(int body) const {
        return static_cast<size_t>(body) < m_restingFirst.size() && m_restingFirst[static_cast<size_t>(body)] >= 0;
    }
    /// Clears the flag `marked` of all rows, or of those that do not rest and for whose pair the predicate holds.
    void ClearMarks();
    template <typename Predicate>
    void ClearMarksIf(Predicate goes) {
        active.ForEach([&](int row) {
            const auto r = static_cast<size_t>(row);
            if (goes(pair[r])) flags[r] = static_cast<uint8_t>(flags[r] & ~ContactFlag::marked);
        });
    }
    /// Removes the rows that have neither the flag `marked` nor `touching`; none of them rests.
    void RemoveParted();
    /// Orders the free rows, so that new contacts take the lowest, and frees trailing ones. Where most of many rows are
    /// free, contacts move to the lowest rows in the same order: stages walk over rows. O(rows).
    void Compact();
    template <typename Self, typename Visit>
    static void Fields(Self& t, Visit& visit) {
        auto& [flags, pair, manifold, material, steady, rolling, keepsSteady, steadyReach, successor, firstMatched,
               matched, freshPairs, freshRefusals, refused, active, mayRest, mustMatch, hash, shift, free, isCompact,
               handles, generation, count, resting, restingFirst, restingTouching, adjacency, first, entries, ofBody,
               handleRows, generationRows] = t;
        visit.Rows(t, flags, pair, manifold, material, steady, rolling), visit(keepsSteady, free);
        visit.LeftOut(steadyReach, successor, firstMatched, matched, freshPairs, freshRefusals, refused, active,
                      mayRest, mustMatch, hash, shift, isCompact, handles, generation, count, resting, restingFirst,
                      restingTouching, adjacency, first, entries, ofBody, handleRows, generationRows);
    }
    /// After the fields were read: makes the rest anew. False if they contradict each other.
    [[nodiscard]] bool Restore();
    /// Contacts of a body, newest row first; rows removed since the last Add are still listed. Valid until the next
    /// Add, Rest or Rouse; of a body with resting contacts until the next call. O(contacts that do not rest) after one
    /// of these, else O(contacts of the body).
    std::span<const int> OfBody(int body);
    // These may be called by several threads at once while nobody changes the table: what they look up is made by the
    // first one.
    /// The same rows, added to a list of the caller's, and how many of them are alive.
    void ListOfBody(int body, std::vector<int>& rows) const;
    [[nodiscard]] int CountOfBody(int body) const;
    /// Takes over the handles of a table that this one is to replace. Their ids name nothing any more.
    void TakeHandles(ContactTable& old);
    /// The handle of a row, made on first use; it stays with the contact until that ends.
    Contact* Handle(WorldState* state, int contact) const;
    /// The handle with this number while its contact lives, null without one.
    [[nodiscard]] Contact* HandleOf(int number) const;
    [[nodiscard]] bool Owns(const Contact* contact) const;
    /// How many contacts the handle with this number has outlived since generations are counted: from the first call
    /// on.
    [[nodiscard]] uint32_t GetGeneration(int number) const;
    /// Number of a row's contact (Contact::GetIndex), and one more than the largest there is.
    [[nodiscard]] int GetNumber(int contact) const {
        const auto row = static_cast<size_t>(contact);
        return row < HandleCount() ? m_handles[row].numberOfRow : contact;
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
        HandleSlot(WorldState* state, int number) : Contact(state, number), numberOfRow(number) {}
        int numberOfRow;
    };

    [[nodiscard]] size_t Home(uint32_t a, uint32_t b) const;
    /// Enlarges the hash, for `count` contacts at least.
    void Grow(int count);
    /// Fills the hash anew.
    void Rehash();
    void CloseGaps();
    /// The contact leaves the lists of resting contacts.
    void UnlinkResting(int contact);
    /// All living rows are active.
    void RouseAll();
    /// Row r has become row movedTo[r + 1], −1 if it was free.
    void MoveHandles(std::span<const int> movedTo);
    void EnsureAdjacency() const {
        m_adjacency.Ensure(1, [this] { MakeAdjacency(); });
    }
    void MakeAdjacency() const;
    /// Of the contacts that do not rest.
    [[nodiscard]] std::span<const int> ActiveOfBody(int body) const;
    [[nodiscard]] size_t HandleCount() const { return static_cast<size_t>(m_handleRows.Count()); }
    void NoteEnd(int contact) {
        const auto number = static_cast<size_t>(GetNumber(contact));
        if (number < m_generation.size()) ++m_generation[number];
    }
    void InsertKey(int contact);
    void EraseKey(int contact);

    std::vector<int> m_hash;  ///< open addressing, linear probing, −1 empty; size a power of two, at most 2/3 full
    int m_shift = 64;
    std::vector<int> m_free;  ///< highest first, when compact
    bool m_isCompact = true;  ///< no row was removed since Compact
    mutable std::deque<HandleSlot> m_handles;
    mutable std::vector<uint32_t> m_generation;  ///< per number; empty until somebody asks for one
    int m_count = 0;

    /// Places of a resting contact in the lists of its bodies. An entry is 2 · row + side (0: body A, 1: body B).
    struct RestingLinks {
        int prev[2], next[2];
    };
    std::vector<RestingLinks> m_resting;  ///< per row; empty until a contact rests
    std::vector<int> m_restingFirst;      ///< per body: first entry, −1 none
    int m_restingTouching = 0;

    mutable LazyRows m_adjacency;  ///< 1 while the next two are valid
    /// Of the contacts that do not rest, per body up to the last one with any: start in m_entries; one more at the end.
    mutable std::vector<int> m_first;
    mutable std::vector<int> m_entries;
    std::vector<int> m_ofBody;  ///< the last answer for a body with resting contacts
    mutable LazyRows m_handleRows, m_generationRows;
};

}  // namespace scree
