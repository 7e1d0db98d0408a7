// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contact rows and the hash over their pairs. Fibonacci hashing (Knuth, The Art of Computer Programming 3, §6.4) of
// both fixture indices, linear probing, deletion by shifting back (no tombstones). So a lookup stays O(1) however many
// contacts one body has.

#include "state/contacts.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <iterator>

#include "base/bytes.h"
#include "base/slots.h"

namespace scree {

namespace {

/// The same key whatever the order of the two fixtures.
uint64_t KeyOf(FixtureIndex a, FixtureIndex b) {
    const uint64_t low = ProxyOf(std::min(a, b)), high = ProxyOf(std::max(a, b));
    return low << 32 | high;
}

/// The flags of eight rows as one number.
uint64_t LoadFlags(const uint8_t* flags) {
    uint64_t eight;
    std::memcpy(&eight, flags, sizeof eight);
    return eight;
}

/// One flag, or several, in all eight rows.
constexpr uint64_t InAll(uint8_t flag) { return 0x0101010101010101ull * flag; }

/// Whether as many contacts want a larger hash: linear probing beyond 2/3 would mean long runs.
bool IsTooFull(int count, size_t slots) { return ToSize(count) * 3 > slots * 2; }

/// Below this many rows gaps cost little.
constexpr size_t leastRowsToClose = 4096;

constexpr uint64_t goldenRatio = 0x9E3779B97F4A7C15ull;

}  // namespace

size_t ContactTable::Home(FixtureIndex a, FixtureIndex b) const {
    // The two halves are mixed first: plain multiplication of a<<32|b would drop a's high bits from the result's top.
    uint64_t key = KeyOf(a, b);
    key ^= key >> 29;
    return static_cast<size_t>((key * goldenRatio) >> m_shift);
}

ContactIndex ContactTable::Find(FixtureIndex fixture1, FixtureIndex fixture2) const {
    if (m_hash.empty()) return ContactIndex::none;
    const uint64_t key = KeyOf(fixture1, fixture2);
    const size_t mask = m_hash.size() - 1;
    for (size_t slot = Home(fixture1, fixture2); IsSome(m_hash[slot]); slot = (slot + 1) & mask) {
        const ContactPair& p = pair[m_hash[slot]];
        if (KeyOf(p.fixtureA, p.fixtureB) == key) return m_hash[slot];
    }
    return ContactIndex::none;
}

ContactIndex ContactTable::Add(const ContactPair& newPair) {
    ContactIndex index;
    if (m_free.empty()) {
        index = flags.End();
        flags.push_back(0);
        pair.emplace_back();
        manifold.emplace_back();
        material.emplace_back();
        place.push_back(0);
        if (!steady.empty()) steady.emplace_back();
        if (!rolling.empty()) rolling.emplace_back();
    } else {
        index = m_free.back();
        m_free.pop_back();
    }
    flags[index] = ContactFlag::alive | ContactFlag::marked;
    if (addsFresh) flags[index] |= ContactFlag::fresh;
    pair[index] = newPair;
    manifold[index].pointCount = 0;
    ForgetSteady(index);
    if (!steady.empty()) steady[index].initialOverlap = 0.0f;
    if (!rolling.empty()) rolling[index] = 0.0f;
    NoteActive(index);
    mustMatch = true;
    ++m_count;
    active.Insert(index);
    if (IsTooFull(m_count, m_hash.size())) {
        Grow(m_count);
    } else {
        InsertKey(index);
    }
    return index;
}

void ContactTable::Remove(ContactIndex contact) {
    if (Has(contact, ContactFlag::touching)) ++grouping;
    EraseKey(contact);
    NoteEnd(contact);
    if (!active.Erase(contact)) UnlinkResting(contact);
    flags[contact] = 0;
    --m_count;
    m_free.push_back(contact);
    m_isCompact = false;
}

void ContactTable::Rest(ContactIndex contact) {
    if (!active.Erase(contact)) return;
    m_adjacency.Set(0);
    EnsureRow(m_resting, contact);
    const BodyIndex bodies[2] = {pair[contact].bodyA, pair[contact].bodyB};
    for (int side = 0; side < 2; ++side) {
        EnsureRow(m_restingFirst, bodies[side], -1);
        int& first = m_restingFirst[bodies[side]];
        m_resting[contact].prev[side] = -1;
        m_resting[contact].next[side] = first;
        if (first >= 0) m_resting[ContactOf(first)].prev[SideOf(first)] = EntryOf(contact, side);
        first = EntryOf(contact, side);
    }
    m_restingTouching += Has(contact, ContactFlag::touching) ? 1 : 0;
}

void ContactTable::UnlinkResting(ContactIndex contact) {
    const BodyIndex bodies[2] = {pair[contact].bodyA, pair[contact].bodyB};
    for (int side = 0; side < 2; ++side) {
        const int prev = m_resting[contact].prev[side], next = m_resting[contact].next[side];
        (prev < 0 ? m_restingFirst[bodies[side]] : m_resting[ContactOf(prev)].next[SideOf(prev)]) = next;
        if (next >= 0) m_resting[ContactOf(next)].prev[SideOf(next)] = prev;
    }
    m_restingTouching -= Has(contact, ContactFlag::touching) ? 1 : 0;
}

void ContactTable::Rouse(ContactIndex contact) {
    if (!IsAlive(contact) || !active.Insert(contact)) return;
    UnlinkResting(contact);
    NoteActive(contact);
    mayRest = true;
}

int ContactTable::RouseOf(BodyIndex body, ContactIndex row) {
    int touching = 0;
    while (HasResting(body)) {
        const ContactIndex contact = ContactOf(m_restingFirst[body]);
        if (contact < row && Has(contact, ContactFlag::touching)) ++touching;
        Rouse(contact);
    }
    return touching;
}

void ContactTable::ListResting(BodyIndex body, std::vector<ContactIndex>& rows) const {
    if (!HasResting(body)) return;
    for (int entry = m_restingFirst[body]; entry >= 0; entry = m_resting[ContactOf(entry)].next[SideOf(entry)]) {
        rows.push_back(ContactOf(entry));
    }
}

void ContactTable::RouseAll() {
    active.Clear();
    for (const ContactIndex row : flags.Rows()) {
        if (flags[row] != 0) active.Insert(row);
    }
    m_restingFirst.assign(m_restingFirst.size(), -1);
    m_restingTouching = 0;
    m_adjacency.Set(0);
    mayRest = true;
}

void ContactTable::ClearMarks() {
    uint8_t* f = flags.data();
    size_t row = 0;
    for (; row + 8 <= flags.size(); row += 8) {
        const uint64_t cleared = LoadFlags(f + row) & ~InAll(ContactFlag::marked);
        std::memcpy(f + row, &cleared, sizeof cleared);
    }
    for (; row < flags.size(); ++row) f[row] = static_cast<uint8_t>(f[row] & ~ContactFlag::marked);
}

void ContactTable::RemoveParted() {
    // Both shifted onto the flag `alive`.
    static_assert(ContactFlag::alive == 1 && ContactFlag::marked == 2 && ContactFlag::touching == 4);
    const auto parted = [](uint64_t eight) {
        return eight & ~(eight >> 1) & ~(eight >> 2) & InAll(ContactFlag::alive);
    };
    const uint8_t* f = flags.data();
    const size_t freeBefore = m_free.size();
    const auto look = [&](size_t begin, size_t end) {
        size_t row = begin;
        for (; row + 8 <= end; row += 8) {
            if (parted(LoadFlags(f + row)) == 0) continue;
            for (size_t i = row; i < row + 8; ++i) {
                if (parted(f[i]) != 0) m_free.push_back(ToIndex<ContactIndex>(i));
            }
        }
        for (; row < end; ++row) {
            if (parted(f[row]) != 0) m_free.push_back(ToIndex<ContactIndex>(row));
        }
    };
    if (RestingCount() == 0) {
        look(0, flags.size());
    } else {
        active.ForEachRun([&](size_t begin) { look(begin, std::min(begin + 64, flags.size())); });
    }
    const std::span<const ContactIndex> gone = std::span(m_free).subspan(freeBefore);
    if (gone.empty()) return;
    m_isCompact = false;
    m_count -= static_cast<int>(gone.size());
    // Erasing a key takes about twice as long as inserting one.
    const bool rehash = gone.size() * 2 > ToSize(m_count);
    constexpr size_t fetchAhead = 8;
    for (size_t i = 0; i < gone.size(); ++i) {
        const ContactIndex contact = gone[i];
        if (i + 2 * fetchAhead < gone.size()) Prefetch(&pair[gone[i + 2 * fetchAhead]]);
        if (i + fetchAhead < gone.size()) {
            const ContactPair& soon = pair[gone[i + fetchAhead]];
            FetchHome(soon.fixtureA, soon.fixtureB);
        }
        if (!rehash) EraseKey(contact);
        NoteEnd(contact);
        if (!active.Erase(contact)) UnlinkResting(contact);
        flags[contact] = 0;
    }
    if (rehash) Rehash();
}

void ContactTable::CloseGaps() {
    ++grouping;
    const size_t rows = flags.size();
    Column<ContactIndex, ContactIndex> movedTo(rows, ContactIndex::none);
    ContactIndex to{0};
    for (const ContactIndex from : flags.Rows()) {
        if (flags[from] == 0) continue;
        movedTo[from] = to;
        flags[to] = flags[from];
        pair[to] = pair[from];
        manifold[to] = manifold[from];
        material[to] = material[from];
        place[to] = place[from];
        if (!steady.empty()) steady[to] = steady[from];
        if (!rolling.empty()) rolling[to] = rolling[from];
        ++to;
    }
    Resize(ToSize(to));
    const auto move = [&](ContactIndex& row) { row = movedTo.Has(row) ? movedTo[row] : ContactIndex::none; };
    for (ContactIndex& row : order) move(row);
    for (ContactIndex& row : m_hash) move(row);
    MoveHandles(movedTo);
    RouseAll();
    m_free.clear();
    m_adjacency.Set(0);
    m_isCompact = true;
}

void ContactTable::Resize(size_t rows) {
    flags.resize(rows);
    pair.resize(rows);
    manifold.resize(rows);
    material.resize(rows);
    place.resize(rows);
    if (!steady.empty()) steady.resize(rows);
    if (!rolling.empty()) rolling.resize(rows);
}

void ContactTable::MoveHandles(const Column<ContactIndex, ContactIndex>& movedTo) {
    Column<ContactIndex, ContactNumber> number(m_handles.size(), ContactNumber::none);
    std::vector<ContactNumber> spare;
    for (const ContactIndex row : number.Rows()) {
        const ContactIndex to = movedTo.Has(row) ? movedTo[row] : ContactIndex::none;
        if (IsSome(to)) {
            number[to] = NumberOfRow(row);
        } else {
            spare.push_back(NumberOfRow(row));
        }
    }
    for (ContactIndex row = number.End(); ToInt(row) > 0;) {
        --row;
        if (IsNone(number[row])) {
            number[row] = spare.back();
            spare.pop_back();
        }
        NumberOfRow(row) = number[row];
        m_handles[number[row]].m_row = row;
    }
}

void ContactTable::Compact() {
    if (flags.size() >= leastRowsToClose && ToSize(m_count) * 2 < flags.size()) CloseGaps();
    if (m_isCompact) return;
    m_isCompact = true;
    const uint8_t* f = flags.data();
    size_t rows = flags.size();
    while (rows > 0 && f[rows - 1] == 0) --rows;
    if (rows < flags.size()) m_adjacency.Set(0);  // it may list rows that are over, but none behind the end
    Resize(rows);
    f = flags.data();
    // Every row is written down, and stays if it is free: a branch would be mispredicted. The last write needs a place.
    const size_t freeCount = rows - ToSize(m_count);
    m_free.resize(freeCount + 1);
    ContactIndex* next = m_free.data();
    const auto look = [&](size_t row) {
        *next = ToIndex<ContactIndex>(row);
        next += f[row] == 0 ? 1 : 0;
    };
    size_t i = rows;
    for (; i % 8 != 0; --i) look(i - 1);
    for (; i > 0; i -= 8) {
        if ((~LoadFlags(f + i - 8) & InAll(ContactFlag::alive)) == 0) continue;
        for (size_t k = i; k > i - 8; --k) look(k - 1);
    }
    m_free.resize(freeCount);
}

bool ContactTable::Restore() {
    if (!steady.empty() && steady.size() != flags.size()) return false;
    if (!rolling.empty() && rolling.size() != flags.size()) return false;
    if (pair.size() != flags.size() || manifold.size() != flags.size() || material.size() != flags.size()) return false;
    Column<ContactIndex, uint8_t> isFree(flags.size(), 0);
    for (const ContactIndex row : m_free) {
        if (!flags.Has(row) || flags[row] != 0 || isFree[row] != 0) return false;
        isFree[row] = 1;
    }
    for (const ContactIndex row : flags.Rows()) {
        const bool alive = Has(row, ContactFlag::alive);
        if (alive == (isFree[row] != 0) || (!alive && flags[row] != 0)) return false;
    }
    MakeAnew();
    for (const ContactIndex row : pair.Rows()) {
        const ContactPair& p = pair[row];
        if (IsAlive(row) && Find(p.fixtureA, p.fixtureB) != row) return false;
    }
    return true;
}

void ContactTable::MakeAnew() {
    m_count = 0;
    filtersAgree = false;
    for (const uint8_t flag : flags) m_count += (flag & ContactFlag::alive) != 0 ? 1 : 0;
    place.assign(flags.size(), 0);
    order.clear();
    RouseAll();
    m_isCompact = false;
    m_hash.clear();
    if (m_count > 0) Grow(m_count);
}

void ContactTable::NoteReturn(const FormerRows& before) {
    ++grouping;
    filtersAgree = false;
    mustMatch = true;
    m_isCompact = false;
    refused.Clear();
    const auto areEqual = [](const auto& a, const auto& b) {
        return a.size() == b.size() &&
               (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a.front())) == 0);
    };
    const bool sameFlags = areEqual(flags, before.flags);
    const auto livesAlike = [](uint8_t a, uint8_t b) { return ((a ^ b) & ContactFlag::alive) == 0; };
    if (areEqual(pair, before.pair) &&
        (sameFlags || std::equal(flags.begin(), flags.end(), before.flags.begin(), livesAlike))) {
        if (!sameFlags && RestingCount() > 0) RouseAll();
        return;
    }
    MakeAnew();
    ForgetNumbers();
}

void ContactTable::MakeAdjacency() const {
    BodyIndex end{0};
    active.ForEach([&](ContactIndex row) { end = std::max({end, NextOf(pair[row].bodyA), NextOf(pair[row].bodyB)}); });
    m_first.assign(ToSize(end) + 1, 0);
    active.ForEach([&](ContactIndex row) {
        ++m_first[pair[row].bodyA];
        ++m_first[pair[row].bodyB];
    });
    int total = 0;
    for (int& first : m_first) {
        total += first;
        first = total;  // the end for now; filling turns it into the start, with the newest row in front
    }
    m_entries.resize(ToSize(total));
    active.ForEach([&](ContactIndex row) {
        m_entries[ToSize(--m_first[pair[row].bodyA])] = row;
        m_entries[ToSize(--m_first[pair[row].bodyB])] = row;
    });
    m_late.clear();
}

void ContactTable::NoteActive(ContactIndex row) {
    if (m_adjacency.Count() == 0 || IsLate(row)) return;
    if (m_late.size() == mostLate) return m_adjacency.Set(0);
    m_late.insert(std::ranges::lower_bound(m_late, row), row);
}

bool ContactTable::IsLate(ContactIndex row) const { return std::ranges::binary_search(m_late, row); }

bool ContactTable::HasLate(BodyIndex body) const {
    return std::ranges::any_of(m_late, [&](ContactIndex row) { return Joins(row, body); });
}

std::span<const ContactIndex> ContactTable::EntriesOf(BodyIndex body) const {
    EnsureAdjacency();
    if (!m_first.Has(NextOf(body))) return {};
    const int begin = m_first[body], end = m_first[NextOf(body)];
    return std::span(m_entries).subspan(ToSize(begin), ToSize(end - begin));
}

std::span<const ContactIndex> ContactTable::OfBody(BodyIndex body) {
    const std::span<const ContactIndex> rows = EntriesOf(body);
    if (m_late.empty() && !HasResting(body)) return rows;
    m_ofBody.clear();
    ListOfBody(body, m_ofBody);
    return m_ofBody;
}

void ContactTable::ListOfBody(BodyIndex body, std::vector<ContactIndex>& rows) const {
    const auto begin = static_cast<std::ptrdiff_t>(rows.size());
    const std::span<const ContactIndex> entries = EntriesOf(body);
    // A late row may have been another contact's when the entries were made.
    std::ranges::copy_if(entries, std::back_inserter(rows), [&](ContactIndex row) { return !IsLate(row); });
    std::ranges::copy_if(m_late, std::back_inserter(rows), [&](ContactIndex row) { return Joins(row, body); });
    ListResting(body, rows);
    if (HasResting(body) || HasLate(body)) std::sort(rows.begin() + begin, rows.end(), std::greater<>());
}

int ContactTable::CountOfBody(BodyIndex body) const {
    const std::span<const ContactIndex> entries = EntriesOf(body);
    auto count = std::ranges::count_if(entries, [&](ContactIndex row) { return IsAlive(row) && !IsLate(row); });
    count += std::ranges::count_if(m_late, [&](ContactIndex row) { return IsAlive(row) && Joins(row, body); });
    if (!HasResting(body)) return static_cast<int>(count);
    for (int entry = m_restingFirst[body]; entry >= 0; entry = m_resting[ContactOf(entry)].next[SideOf(entry)]) {
        ++count;
    }
    return static_cast<int>(count);
}

Contact* ContactTable::Handle(WorldState* state, ContactIndex contact) const {
    if (ToSize(contact) >= HandleCount()) {
        m_handleRows.Ensure(Size(), [&] {
            while (m_handles.size() < flags.size()) m_handles.emplace_back(state, m_handles.End());
        });
    }
    return &m_handles[GetNumber(contact)];
}

void ContactTable::TakeHandles(ContactTable& old) {
    grouping = old.grouping + 1;
    m_handles.swap(old.m_handles);
    m_generation.swap(old.m_generation);
    ForgetNumbers();
    m_handleRows.Set(static_cast<int>(m_handles.size()));
    m_generationRows.Set(static_cast<int>(m_generation.size()));
}

void ContactTable::ForgetNumbers() {
    for (const ContactNumber number : m_handles.Rows()) {
        m_handles[number].numberOfRow = number;
        m_handles[number].m_row = ContactIndex{ToInt(number)};
    }
    for (uint32_t& generation : m_generation) ++generation;
}

Contact* ContactTable::HandleOf(ContactNumber number) const {
    if (IsNone(number) || ToSize(number) >= HandleCount()) return nullptr;
    HandleSlot& handle = m_handles[number];
    return IsAlive(handle.m_row) ? &handle : nullptr;
}

bool ContactTable::Owns(const Contact* contact) const {
    if (contact == nullptr || !IsAlive(contact->m_row)) return false;
    const ContactNumber number = GetNumber(contact->m_row);
    return ToSize(number) < HandleCount() && &m_handles[number] == contact;
}

uint32_t ContactTable::GetGeneration(ContactNumber number) const {
    if (ToInt(number) >= m_generationRows.Count()) {
        const size_t rows = GetNumberEnd();
        m_generationRows.Ensure(static_cast<int>(rows), [&] { EnsureRows(m_generation, rows, 0u); });
    }
    return m_generation[number];
}

void ContactTable::Reserve(size_t more) {
    const size_t rows = flags.size() + more - std::min(more, m_free.size());
    if (rows > flags.capacity()) {
        const size_t capacity = std::bit_ceil(rows);  // in one go what adding them one by one would come to
        flags.reserve(capacity);
        pair.reserve(capacity);
        manifold.reserve(capacity);
        material.reserve(capacity);
        place.reserve(capacity);
    }
    if (IsTooFull(m_count + static_cast<int>(more), m_hash.size())) Grow(m_count + static_cast<int>(more));
}

void ContactTable::Grow(int count) {
    size_t size = std::max<size_t>(64, m_hash.size() * 2);
    while (IsTooFull(count, size)) size *= 2;
    m_shift = 64 - std::countr_zero(size);
    m_hash.resize(size);
    Rehash();
}

void ContactTable::Rehash() {
    std::fill(m_hash.begin(), m_hash.end(), ContactIndex::none);
    for (const ContactIndex row : flags.Rows()) {
        if (flags[row] != 0) InsertKey(row);
    }
}
void ContactTable::InsertKey(ContactIndex contact) {
    const ContactPair& p = pair[contact];
    const size_t mask = m_hash.size() - 1;
    size_t slot = Home(p.fixtureA, p.fixtureB);
    while (IsSome(m_hash[slot])) slot = (slot + 1) & mask;
    m_hash[slot] = contact;
}

void ContactTable::EraseKey(ContactIndex contact) {
    const ContactPair& erased = pair[contact];
    const size_t mask = m_hash.size() - 1;
    size_t hole = Home(erased.fixtureA, erased.fixtureB);
    while (m_hash[hole] != contact) hole = (hole + 1) & mask;
    // Shift back every later entry of the run that may not stay behind the hole.
    for (size_t slot = (hole + 1) & mask; IsSome(m_hash[slot]); slot = (slot + 1) & mask) {
        const ContactPair& p = pair[m_hash[slot]];
        const size_t home = Home(p.fixtureA, p.fixtureB);
        if (((slot - home) & mask) >= ((slot - hole) & mask)) {
            m_hash[hole] = m_hash[slot];
            hole = slot;
        }
    }
    m_hash[hole] = ContactIndex::none;
}

size_t ContactTable::GetBytesPerRow() {
    // The hash is between one and two thirds full: at most three entries a contact. One number more for the place.
    return sizeof(uint8_t) + sizeof(ContactPair) + sizeof(Manifold) + sizeof(ContactMaterial) + 4 * sizeof(int) +
           sizeof(HandleSlot);
}

size_t ContactTable::GetMemoryBytes() const {
    return BytesOf(flags, pair, manifold, material, steady, rolling, order, place, matched, missing, freshPairs,
                   freshRefusals, m_hash, m_free, m_generation, m_first, m_entries, m_late, m_ofBody, m_resting,
                   m_restingFirst) +
           active.GetMemoryBytes() + m_handles.size() * sizeof(HandleSlot) + refused.GetMemoryBytes();
}

void ContactTable::Trim() {
    Shrink(flags, pair, manifold, material, steady, rolling, order, place);
    matched = {}, missing = {}, freshPairs = {}, freshRefusals = {};
    m_first = {}, m_entries = {}, m_late = {}, m_ofBody = {};
    m_adjacency.Set(0);
    Shrink(m_free, m_generation);
    m_hash = {};
    m_shift = 64;
    if (m_count > 0) Grow(m_count);
}

}  // namespace scree
