// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Fixture index → slot of its proxy, so that callers keep no proxy handles and one fixture can be in several broad
// phases. Small indices go through a plain array: one load, no hashing. Larger ones would make that array huge. They go
// through the chained table with Fibonacci hashing of Tsamis 2020, §3.7.3 (multiplier: Knuth, The Art of Computer
// Programming 3, §6.4).

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scree::broadphase {

inline constexpr uint32_t noSlot = 0xFFFFFFFFu;

/// Hash table with separate chaining in flat arrays: the chains are lists of entry indices, freed entries are reused.
class FixtureNodeTable {
public:
    [[nodiscard]] uint32_t Find(uint32_t fixture) const {
        if (m_heads.empty()) return noSlot;
        for (uint32_t e = m_heads[BucketOf(fixture)]; e != noSlot; e = m_entries[e].next) {
            if (m_entries[e].fixture == fixture) return m_entries[e].slot;
        }
        return noSlot;
    }

    /// Adds the fixture or changes its slot.
    void Set(uint32_t fixture, uint32_t slot) {
        if (m_count >= m_heads.size()) Grow();
        uint32_t& head = m_heads[BucketOf(fixture)];
        for (uint32_t e = head; e != noSlot; e = m_entries[e].next) {
            if (m_entries[e].fixture == fixture) {
                m_entries[e].slot = slot;
                return;
            }
        }
        uint32_t entry = m_free;
        if (entry == noSlot) {
            entry = static_cast<uint32_t>(m_entries.size());
            m_entries.emplace_back();
        } else {
            m_free = m_entries[entry].next;
        }
        m_entries[entry] = {fixture, slot, head};
        head = entry;
        ++m_count;
    }

    void Erase(uint32_t fixture) {
        if (m_heads.empty()) return;
        for (uint32_t* link = &m_heads[BucketOf(fixture)]; *link != noSlot; link = &m_entries[*link].next) {
            const uint32_t entry = *link;
            if (m_entries[entry].fixture != fixture) continue;
            *link = m_entries[entry].next;
            m_entries[entry].next = m_free;
            m_free = entry;
            --m_count;
            return;
        }
    }

    [[nodiscard]] size_t GetMemoryBytes() const {
        return m_heads.capacity() * sizeof(uint32_t) + m_entries.capacity() * sizeof(Entry);
    }

private:
    struct Entry {
        uint32_t fixture = 0, slot = 0, next = noSlot;
    };

    [[nodiscard]] uint32_t BucketOf(uint32_t fixture) const { return (fixture * 2654435769u) >> m_shift; }

    void Grow() {
        m_heads.assign(std::max<size_t>(16, 2 * m_heads.size()), noSlot);
        m_shift = 32;
        for (size_t size = m_heads.size(); size > 1; size /= 2) --m_shift;
        std::vector<Entry> old;
        old.swap(m_entries);
        m_entries.reserve(m_heads.size());
        // The free list is empty whenever the table is full, so every entry is alive.
        for (const Entry& entry : old) {
            uint32_t& head = m_heads[BucketOf(entry.fixture)];
            m_entries.push_back({entry.fixture, entry.slot, head});
            head = static_cast<uint32_t>(m_entries.size() - 1);
        }
    }

    std::vector<uint32_t> m_heads;  ///< a power of two
    std::vector<Entry> m_entries;
    uint32_t m_free = noSlot;
    uint32_t m_shift = 32;
    size_t m_count = 0;
};

/// Direct index with the hash table behind it for large fixture indices.
class FixtureTable {
public:
    /// First index that is hashed; bounds the array at 16 MiB whatever indices the caller uses.
    static constexpr uint32_t directLimit = 1u << 22;

    /// The slot, or noSlot if the fixture is not here.
    [[nodiscard]] uint32_t Find(uint32_t fixture) const {
        if (fixture < m_direct.size()) return m_direct[fixture];
        return fixture < directLimit ? noSlot : m_sparse.Find(fixture);
    }

    void Set(uint32_t fixture, uint32_t slot) {
        if (fixture >= directLimit) {
            m_sparse.Set(fixture, slot);
            return;
        }
        if (fixture >= m_direct.size()) {
            const size_t doubled = std::min<size_t>(directLimit, 2 * m_direct.size());
            m_direct.resize(std::max<size_t>(fixture + 1, doubled), noSlot);
        }
        m_direct[fixture] = slot;
    }

    void Erase(uint32_t fixture) {
        if (fixture >= directLimit) {
            m_sparse.Erase(fixture);
        } else if (fixture < m_direct.size()) {
            m_direct[fixture] = noSlot;
        }
    }

    [[nodiscard]] size_t GetMemoryBytes() const {
        return m_direct.capacity() * sizeof(uint32_t) + m_sparse.GetMemoryBytes();
    }

private:
    std::vector<uint32_t> m_direct;
    FixtureNodeTable m_sparse;
};

}  // namespace scree::broadphase
