// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contact rows and the hash over their pairs: Fibonacci hashing (Knuth, The Art of Computer Programming 3, §6.4) of
// both fixture indices, linear probing, deletion by shifting back (no tombstones), so a lookup stays O(1) however many
// contacts one body has.

#include "state/contacts.h"

#include <algorithm>

namespace scree {

namespace {

/// The same key whatever the order of the two fixtures.
uint64_t KeyOf(uint32_t a, uint32_t b) {
    return a < b ? (static_cast<uint64_t>(a) << 32 | b) : (static_cast<uint64_t>(b) << 32 | a);
}

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
    } else {
        index = m_free.back();
        m_free.pop_back();
    }
    const auto i = static_cast<size_t>(index);
    flags[i] = ContactFlag::alive | ContactFlag::marked;
    pair[i] = newPair;
    manifold[i].pointCount = 0;
    m_adjacencyValid = false;
    ++m_count;
    if (static_cast<size_t>(m_count) * 2 > m_hash.size()) {
        Grow();
    } else {
        InsertKey(index);
    }
    return index;
}

void ContactTable::Remove(int contact) {
    EraseKey(contact);
    flags[static_cast<size_t>(contact)] = 0;
    --m_count;
    m_free.push_back(contact);
}

void ContactTable::Compact() {
    size_t rows = flags.size();
    while (rows > 0 && flags[rows - 1] == 0) --rows;
    flags.resize(rows);
    pair.resize(rows);
    manifold.resize(rows);
    material.resize(rows);
    m_free.clear();
    for (size_t i = rows; i-- > 0;) {
        if (flags[i] == 0) m_free.push_back(static_cast<int>(i));
    }
}

bool ContactTable::Restore() {
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
    while (static_cast<size_t>(m_count) * 2 > m_hash.size()) m_hash.resize(std::max<size_t>(32, m_hash.size() * 2));
    if (m_count > 0) {
        m_hash.resize(m_hash.size() / 2);
        Grow();
    }
    for (int i = 0; i < Size(); ++i) {
        const ContactPair& p = pair[static_cast<size_t>(i)];
        if (IsAlive(i) && Find(p.fixtureA, p.fixtureB) != i) return false;
    }
    return true;
}

void ContactTable::EnsureAdjacency() {
    if (m_adjacencyValid) return;
    int bodyCount = 0;
    for (size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] != 0) bodyCount = std::max({bodyCount, pair[i].bodyA + 1, pair[i].bodyB + 1});
    }
    m_first.assign(static_cast<size_t>(bodyCount) + 1, 0);
    for (size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] == 0) continue;
        ++m_first[static_cast<size_t>(pair[i].bodyA)];
        ++m_first[static_cast<size_t>(pair[i].bodyB)];
    }
    int total = 0;
    for (int& first : m_first) {
        total += first;
        first = total;  // the end for now; filling turns it into the start, with the newest row in front
    }
    m_entries.resize(static_cast<size_t>(total));
    for (size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] == 0) continue;
        m_entries[static_cast<size_t>(--m_first[static_cast<size_t>(pair[i].bodyA)])] = static_cast<int>(i);
        m_entries[static_cast<size_t>(--m_first[static_cast<size_t>(pair[i].bodyB)])] = static_cast<int>(i);
    }
    m_adjacencyValid = true;
}

std::span<const int> ContactTable::OfBody(int body) {
    EnsureAdjacency();
    const auto b = static_cast<size_t>(body);
    if (b + 1 >= m_first.size()) return {};  // beyond the last body with a contact
    return {m_entries.data() + m_first[b], static_cast<size_t>(m_first[b + 1] - m_first[b])};
}

Contact* ContactTable::Handle(WorldState* state, int contact) {
    while (static_cast<int>(m_handles.size()) <= contact)
        m_handles.emplace_back(state, static_cast<int>(m_handles.size()));
    return &m_handles[static_cast<size_t>(contact)];
}

void ContactTable::Grow() {
    const size_t size = std::max<size_t>(64, m_hash.size() * 2);
    m_hash.assign(size, -1);
    m_shift = 64;
    for (size_t s = size; s > 1; s >>= 1) --m_shift;
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
    // The hash is between a quarter and half full: at most four entries a contact.
    return sizeof(uint8_t) + sizeof(ContactPair) + sizeof(Manifold) + sizeof(ContactMaterial) + 4 * sizeof(int) +
           sizeof(Contact);
}

size_t ContactTable::GetMemoryBytes() const {
    return flags.size() * (sizeof(uint8_t) + sizeof(ContactPair) + sizeof(Manifold) + sizeof(ContactMaterial)) +
           m_hash.size() * sizeof(int) + m_handles.size() * sizeof(Contact);
}

}  // namespace scree
