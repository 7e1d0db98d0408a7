// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contact rows and the hash over their pairs: Fibonacci hashing (Knuth, The Art of Computer Programming 3, §6.4) of
// both fixture indices, linear probing, deletion by shifting back (no tombstones), so a lookup stays O(1) however many
// contacts one body has.

#include "state/contacts.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>

#include "base/bytes.h"
#include "base/slots.h"

namespace scree {

namespace {

/// The same key whatever the order of the two fixtures.
uint64_t KeyOf(uint32_t a, uint32_t b) {
    return a < b ? (static_cast<uint64_t>(a) << 32 | b) : (static_cast<uint64_t>(b) << 32 | a);
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
bool IsTooFull(int count, size_t slots) { return static_cast<size_t>(count) * 3 > slots * 2; }

/// Below this many rows gaps cost little.
constexpr size_t leastRowsToClose = 4096;

constexpr uint64_t goldenRatio = 0x9E3779B97F4A7C15ull;

}  // namespace

size_t ContactTable::Home(uint32_t a, uint32_t b) const {
    // The two halves are mixed first: plain multiplication of a<<32|b would drop a's high bits from the result's top.
    uint64_t key = KeyOf(a, b);
    key ^= key >> 29;
    return static_cast<size_t>((key * goldenRatio) >> m_shift);
}

int ContactTable::Find(uint32_t fixture1, uint32_t fixture2) const {
    if (m_hash.empty()) return -1;
    const uint64_t key = KeyOf(fixture1, fixture2);
    const size_t mask = m_hash.size() - 1;
    for (size_t slot = Home(fixture1, fixture2); m_hash[slot] >= 0; slot = (slot + 1) & mask) {
        const ContactPair& p = pair[static_cast<size_t>(m_hash[slot])];
        if (KeyOf(p.fixtureA, p.fixtureB) == key) return m_hash[slot];
    }
    return -1;
}

int ContactTable::Add(const ContactPair& newPair) {
    int index;
    if (m_free.empty()) {
        index = Size();
        flags.push_back(0);
        pair.emplace_back();
        manifold.emplace_back();
        material.emplace_back();
        successor.push_back(-1);
        if (!steady.empty()) steady.emplace_back();
        if (!rolling.empty()) rolling.emplace_back();
    } else {
        index = m_free.back();
        m_free.pop_back();
    }
    const auto i = static_cast<size_t>(index);
    flags[i] = ContactFlag::alive | ContactFlag::marked;
    pair[i] = newPair;
    manifold[i].pointCount = 0;
    ForgetSteady(index);
    if (!rolling.empty()) rolling[i] = 0.0f;
    m_adjacency.Set(0);
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

void ContactTable::Remove(int contact) {
    EraseKey(contact);
    NoteEnd(contact);
    if (!active.Erase(contact)) UnlinkResting(contact);
    flags[static_cast<size_t>(contact)] = 0;
    --m_count;
    m_free.push_back(contact);
    m_isCompact = false;
}

void ContactTable::Rest(int contact) {
    if (!active.Erase(contact)) return;
    m_adjacency.Set(0);
    EnsureRow(m_resting, contact);
    const auto c = static_cast<size_t>(contact);
    const int bodies[2] = {pair[c].bodyA, pair[c].bodyB};
    for (int side = 0; side < 2; ++side) {
        EnsureRow(m_restingFirst, bodies[side], -1);
        int& first = m_restingFirst[static_cast<size_t>(bodies[side])];
        m_resting[c].prev[side] = -1;
        m_resting[c].next[side] = first;
        if (first >= 0) m_resting[static_cast<size_t>(first >> 1)].prev[first & 1] = 2 * contact + side;
        first = 2 * contact + side;
    }
    m_restingTouching += Has(contact, ContactFlag::touching) ? 1 : 0;
}

void ContactTable::UnlinkResting(int contact) {
    const auto c = static_cast<size_t>(contact);
    const int bodies[2] = {pair[c].bodyA, pair[c].bodyB};
    for (int side = 0; side < 2; ++side) {
        const int prev = m_resting[c].prev[side], next = m_resting[c].next[side];
        (prev < 0 ? m_restingFirst[static_cast<size_t>(bodies[side])]
                  : m_resting[static_cast<size_t>(prev >> 1)].next[prev & 1]) = next;
        if (next >= 0) m_resting[static_cast<size_t>(next >> 1)].prev[next & 1] = prev;
    }
    m_restingTouching -= Has(contact, ContactFlag::touching) ? 1 : 0;
}

void ContactTable::Rouse(int contact) {
    if (!IsAlive(contact) || !active.Insert(contact)) return;
    UnlinkResting(contact);
    m_adjacency.Set(0);
    mayRest = true;
}

int ContactTable::RouseOf(int body, int row) {
    int touching = 0;
    while (HasResting(body)) {
        const int contact = m_restingFirst[static_cast<size_t>(body)] >> 1;
        if (contact < row && Has(contact, ContactFlag::touching)) ++touching;
        Rouse(contact);
    }
    return touching;
}

void ContactTable::ListResting(int body, std::vector<int>& rows) const {
    if (!HasResting(body)) return;
    for (int entry = m_restingFirst[static_cast<size_t>(body)]; entry >= 0;
         entry = m_resting[static_cast<size_t>(entry >> 1)].next[entry & 1]) {
        rows.push_back(entry >> 1);
    }
}

void ContactTable::RouseAll() {
    active.Clear();
    for (int row = 0; row < Size(); ++row) {
        if (flags[static_cast<size_t>(row)] != 0) active.Insert(row);
    }
    m_restingFirst.assign(m_restingFirst.size(), -1);
    m_restingTouching = 0;
    m_adjacency.Set(0);
    mayRest = true;
}

void ContactTable::ClearMarks() {
    size_t row = 0;
    for (; row + 8 <= flags.size(); row += 8) {
        const uint64_t cleared = LoadFlags(&flags[row]) & ~InAll(ContactFlag::marked);
        std::memcpy(&flags[row], &cleared, sizeof cleared);
    }
    for (; row < flags.size(); ++row) flags[row] = static_cast<uint8_t>(flags[row] & ~ContactFlag::marked);
}

void ContactTable::RemoveParted() {
    // Both shifted onto the flag `alive`.
    static_assert(ContactFlag::alive == 1 && ContactFlag::marked == 2 && ContactFlag::touching == 4);
    const auto parted = [](uint64_t f) { return f & ~(f >> 1) & ~(f >> 2) & InAll(ContactFlag::alive); };
    const size_t freeBefore = m_free.size();
    const auto look = [&](size_t begin, size_t end) {
        size_t row = begin;
        for (; row + 8 <= end; row += 8) {
            if (parted(LoadFlags(&flags[row])) == 0) continue;
            for (size_t i = row; i < row + 8; ++i) {
                if (parted(flags[i]) != 0) m_free.push_back(static_cast<int>(i));
            }
        }
        for (; row < end; ++row) {
            if (parted(flags[row]) != 0) m_free.push_back(static_cast<int>(row));
        }
    };
    if (RestingCount() == 0) {
        look(0, flags.size());
    } else {
        active.ForEachRun([&](size_t begin) { look(begin, std::min(begin + 64, flags.size())); });
    }
    const std::span<const int> gone = std::span(m_free).subspan(freeBefore);
    if (gone.empty()) return;
    m_isCompact = false;
    m_count -= static_cast<int>(gone.size());
    // Erasing a key takes about twice as long as inserting one.
    const bool rehash = gone.size() * 2 > static_cast<size_t>(m_count);
    for (const int contact : gone) {
        if (!rehash) EraseKey(contact);
        NoteEnd(contact);
        if (!active.Erase(contact)) UnlinkResting(contact);
        flags[static_cast<size_t>(contact)] = 0;
    }
    if (rehash) Rehash();
}

void ContactTable::CloseGaps() {
    const size_t rows = flags.size();
    std::vector<int> movedTo(rows + 1, -1);  // one more, for −1
    size_t to = 0;
    for (size_t from = 0; from < rows; ++from) {
        if (flags[from] == 0) continue;
        movedTo[from + 1] = static_cast<int>(to);
        flags[to] = flags[from];
        pair[to] = pair[from];
        manifold[to] = manifold[from];
        material[to] = material[from];
        successor[to] = successor[from];
        if (!steady.empty()) steady[to] = steady[from];
        if (!rolling.empty()) rolling[to] = rolling[from];
        ++to;
    }
    flags.resize(to);
    pair.resize(to);
    manifold.resize(to);
    material.resize(to);
    successor.resize(to);
    if (!steady.empty()) steady.resize(to);
    if (!rolling.empty()) rolling.resize(to);
    for (int& row : successor) row = row < static_cast<int>(rows) ? movedTo[static_cast<size_t>(row + 1)] : -1;
    if (firstMatched < static_cast<int>(rows)) firstMatched = movedTo[static_cast<size_t>(firstMatched + 1)];
    for (int& row : m_hash) {
        if (row >= 0) row = movedTo[static_cast<size_t>(row + 1)];
    }
    MoveHandles(movedTo);
    RouseAll();
    m_free.clear();
    m_adjacency.Set(0);
    m_isCompact = true;
}

void ContactTable::MoveHandles(std::span<const int> movedTo) {
    std::vector<int> number(m_handles.size(), -1), spare;
    for (size_t row = 0; row < m_handles.size(); ++row) {
        const int to = row + 1 < movedTo.size() ? movedTo[row + 1] : -1;
        if (to >= 0) {
            number[static_cast<size_t>(to)] = m_handles[row].numberOfRow;
        } else {
            spare.push_back(m_handles[row].numberOfRow);
        }
    }
    for (size_t row = m_handles.size(); row-- > 0;) {
        if (number[row] < 0) {
            number[row] = spare.back();
            spare.pop_back();
        }
        m_handles[row].numberOfRow = number[row];
        m_handles[static_cast<size_t>(number[row])].m_row = static_cast<int>(row);
    }
}

void ContactTable::Compact() {
    if (flags.size() >= leastRowsToClose && static_cast<size_t>(m_count) * 2 < flags.size()) CloseGaps();
    if (m_isCompact) return;
    m_isCompact = true;
    size_t rows = flags.size();
    while (rows > 0 && flags[rows - 1] == 0) --rows;
    if (rows < flags.size()) m_adjacency.Set(0);  // it may list rows that are over, but none behind the end
    flags.resize(rows);
    pair.resize(rows);
    manifold.resize(rows);
    material.resize(rows);
    successor.resize(rows);
    if (!steady.empty()) steady.resize(rows);
    if (!rolling.empty()) rolling.resize(rows);
    m_free.clear();
    size_t i = rows;
    for (; i % 8 != 0; --i) {
        if (flags[i - 1] == 0) m_free.push_back(static_cast<int>(i) - 1);
    }
    for (; i > 0; i -= 8) {
        if ((~LoadFlags(&flags[i - 8]) & InAll(ContactFlag::alive)) == 0) continue;
        for (size_t k = i; k > i - 8; --k) {
            if (flags[k - 1] == 0) m_free.push_back(static_cast<int>(k) - 1);
        }
    }
}

bool ContactTable::Restore() {
    if (!steady.empty() && steady.size() != flags.size()) return false;
    if (!rolling.empty() && rolling.size() != flags.size()) return false;
    if (pair.size() != flags.size() || manifold.size() != flags.size() || material.size() != flags.size()) return false;
    std::vector<uint8_t> isFree(flags.size(), 0);
    for (const int row : m_free) {
        if (row < 0 || row >= Size() || flags[static_cast<size_t>(row)] != 0 || isFree[static_cast<size_t>(row)] != 0)
            return false;
        isFree[static_cast<size_t>(row)] = 1;
    }
    for (size_t i = 0; i < flags.size(); ++i) {
        const bool alive = (flags[i] & ContactFlag::alive) != 0;
        if (alive == (isFree[i] != 0) || (!alive && flags[i] != 0)) return false;
        m_count += alive ? 1 : 0;
    }
    successor.assign(flags.size(), -1);
    RouseAll();
    m_isCompact = false;
    m_hash.clear();
    if (m_count > 0) Grow(m_count);
    for (int i = 0; i < Size(); ++i) {
        const ContactPair& p = pair[static_cast<size_t>(i)];
        if (IsAlive(i) && Find(p.fixtureA, p.fixtureB) != i) return false;
    }
    return true;
}

void ContactTable::MakeAdjacency() const {
    int bodyCount = 0;
    active.ForEach([&](int row) {
        const ContactPair& p = pair[static_cast<size_t>(row)];
        bodyCount = std::max({bodyCount, p.bodyA + 1, p.bodyB + 1});
    });
    m_first.assign(static_cast<size_t>(bodyCount) + 1, 0);
    active.ForEach([&](int row) {
        const ContactPair& p = pair[static_cast<size_t>(row)];
        ++m_first[static_cast<size_t>(p.bodyA)];
        ++m_first[static_cast<size_t>(p.bodyB)];
    });
    int total = 0;
    for (int& first : m_first) {
        total += first;
        first = total;  // the end for now; filling turns it into the start, with the newest row in front
    }
    m_entries.resize(static_cast<size_t>(total));
    active.ForEach([&](int row) {
        const ContactPair& p = pair[static_cast<size_t>(row)];
        m_entries[static_cast<size_t>(--m_first[static_cast<size_t>(p.bodyA)])] = row;
        m_entries[static_cast<size_t>(--m_first[static_cast<size_t>(p.bodyB)])] = row;
    });
}

std::span<const int> ContactTable::ActiveOfBody(int body) const {
    EnsureAdjacency();
    const auto b = static_cast<size_t>(body);
    if (b + 1 >= m_first.size()) return {};
    return {m_entries.data() + m_first[b], static_cast<size_t>(m_first[b + 1] - m_first[b])};
}

std::span<const int> ContactTable::OfBody(int body) {
    const std::span<const int> rows = ActiveOfBody(body);
    if (!HasResting(body)) return rows;
    m_ofBody.clear();
    ListOfBody(body, m_ofBody);
    return m_ofBody;
}

void ContactTable::ListOfBody(int body, std::vector<int>& rows) const {
    const auto begin = static_cast<std::ptrdiff_t>(rows.size());
    const std::span<const int> awake = ActiveOfBody(body);
    rows.insert(rows.end(), awake.begin(), awake.end());
    if (!HasResting(body)) return;
    ListResting(body, rows);
    std::sort(rows.begin() + begin, rows.end(), std::greater<>());
}

int ContactTable::CountOfBody(int body) const {
    int count = 0;
    for (const int row : ActiveOfBody(body)) count += IsAlive(row) ? 1 : 0;
    if (!HasResting(body)) return count;
    for (int entry = m_restingFirst[static_cast<size_t>(body)]; entry >= 0;
         entry = m_resting[static_cast<size_t>(entry >> 1)].next[entry & 1]) {
        ++count;
    }
    return count;
}

Contact* ContactTable::Handle(WorldState* state, int contact) const {
    if (static_cast<size_t>(contact) >= HandleCount()) {
        m_handleRows.Ensure(Size(), [&] {
            while (m_handles.size() < flags.size()) m_handles.emplace_back(state, static_cast<int>(m_handles.size()));
        });
    }
    return &m_handles[static_cast<size_t>(GetNumber(contact))];
}

void ContactTable::TakeHandles(ContactTable& old) {
    m_handles.swap(old.m_handles);
    m_generation.swap(old.m_generation);
    for (size_t i = 0; i < m_handles.size(); ++i) {
        m_handles[i].numberOfRow = static_cast<int>(i);
        m_handles[i].m_row = static_cast<int>(i);
    }
    for (uint32_t& generation : m_generation) ++generation;
    m_handleRows.Set(static_cast<int>(m_handles.size()));
    m_generationRows.Set(static_cast<int>(m_generation.size()));
}

Contact* ContactTable::HandleOf(int number) const {
    if (number < 0 || static_cast<size_t>(number) >= HandleCount()) return nullptr;
    HandleSlot& handle = m_handles[static_cast<size_t>(number)];
    return IsAlive(handle.m_row) ? &handle : nullptr;
}

bool ContactTable::Owns(const Contact* contact) const {
    if (contact == nullptr || !IsAlive(contact->m_row)) return false;
    const auto number = static_cast<size_t>(GetNumber(contact->m_row));
    return number < HandleCount() && &m_handles[number] == contact;
}

uint32_t ContactTable::GetGeneration(int number) const {
    if (number >= m_generationRows.Count()) {
        const auto rows = static_cast<int>(GetNumberEnd());
        m_generationRows.Ensure(rows, [&] { EnsureRows(m_generation, static_cast<size_t>(rows), 0u); });
    }
    return m_generation[static_cast<size_t>(number)];
}

void ContactTable::Reserve(size_t more) {
    const size_t rows = flags.size() + more - std::min(more, m_free.size());
    if (rows > flags.capacity()) {
        const size_t capacity = std::bit_ceil(rows);  // in one go what adding them one by one would come to
        flags.reserve(capacity);
        pair.reserve(capacity);
        manifold.reserve(capacity);
        material.reserve(capacity);
        successor.reserve(capacity);
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
    std::fill(m_hash.begin(), m_hash.end(), -1);
    for (int i = 0; i < Size(); ++i) {
        if (flags[static_cast<size_t>(i)] != 0) InsertKey(i);
    }
}
void ContactTable::InsertKey(int contact) {
    const ContactPair& p = pair[static_cast<size_t>(contact)];
    const size_t mask = m_hash.size() - 1;
    size_t slot = Home(p.fixtureA, p.fixtureB);
    while (m_hash[slot] >= 0) slot = (slot + 1) & mask;
    m_hash[slot] = contact;
}

void ContactTable::EraseKey(int contact) {
    const ContactPair& erased = pair[static_cast<size_t>(contact)];
    const size_t mask = m_hash.size() - 1;
    size_t hole = Home(erased.fixtureA, erased.fixtureB);
    while (m_hash[hole] != contact) hole = (hole + 1) & mask;
    // Shift back every later entry of the run that may not stay behind the hole.
    for (size_t slot = (hole + 1) & mask; m_hash[slot] >= 0; slot = (slot + 1) & mask) {
        const ContactPair& p = pair[static_cast<size_t>(m_hash[slot])];
        const size_t home = Home(p.fixtureA, p.fixtureB);
        if (((slot - home) & mask) >= ((slot - hole) & mask)) {
            m_hash[hole] = m_hash[slot];
            hole = slot;
        }
    }
    m_hash[hole] = -1;
}

size_t ContactTable::GetBytesPerRow() {
    // The hash is between one and two thirds full: at most three entries a contact. One number more for the successor.
    return sizeof(uint8_t) + sizeof(ContactPair) + sizeof(Manifold) + sizeof(ContactMaterial) + 4 * sizeof(int) +
           sizeof(HandleSlot);
}

size_t ContactTable::GetMemoryBytes() const {
    return BytesOf(flags, pair, manifold, material, steady, rolling, successor, matched, freshPairs, freshRefusals,
                   m_hash, m_free, m_generation, m_first, m_entries, m_ofBody, m_resting, m_restingFirst) +
           active.GetMemoryBytes() + m_handles.size() * sizeof(HandleSlot) + refused.GetMemoryBytes();
}

void ContactTable::Trim() {
    Shrink(flags, pair, manifold, material, steady, rolling, successor);
    matched = {}, freshPairs = {}, freshRefusals = {};
    m_first = {}, m_entries = {}, m_ofBody = {};
    m_adjacency.Set(0);
    Shrink(m_free, m_generation);
    m_hash = {};
    m_shift = 64;
    if (m_count > 0) Grow(m_count);
}

}  // namespace scree
