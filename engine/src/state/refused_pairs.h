// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The pairs of fixtures that the program's filter has refused and whose boxes
// still overlap. It is asked when a pair begins, not again in every step. Two
// sorted lists are compared per pair finding; without a filter both are empty.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "state/indices.h"

namespace scree {

class RefusedPairs {
public:
    /// The larger index is in the high half.
    static uint64_t KeyOf(FixtureIndex fixture1, FixtureIndex fixture2) {
        // std::minmax would give references, here to what is gone at the end of the line.
        const uint32_t proxy1 = ProxyOf(fixture1), proxy2 = ProxyOf(fixture2);
        return static_cast<uint64_t>(std::max(proxy1, proxy2)) << 32 | std::min(proxy1, proxy2);
    }
    static FixtureIndex LowOf(uint64_t key) { return FixtureOf(static_cast<uint32_t>(key)); }
    static FixtureIndex HighOf(uint64_t key) { return FixtureOf(static_cast<uint32_t>(key >> 32)); }

    [[nodiscard]] bool Has(uint64_t key) const { return std::binary_search(m_keys.begin(), m_keys.end(), key); }
    /// The filter is asked again about the pairs of this fixture, or about all,
    /// in the next pair finding.
    void Forget(FixtureIndex fixture) {
        if (!m_keys.empty()) m_forgotten.push_back(fixture);
    }
    void Clear() { m_keys.clear(), m_forgotten.clear(); }

    /// A pair finding begins. `fresh` are its pairs without a contact, sorted: those known to be refused are taken out
    /// of it, and of the pairs for which `isSearched(low, high)` holds only they stay known.
    template <typename Predicate>
    void TakeOut(std::vector<uint64_t>& fresh, Predicate isSearched) {
        ApplyForgotten();
        if (m_keys.empty()) return;
        m_kept.clear(), m_rest.clear();
        std::set_difference(fresh.begin(), fresh.end(), m_keys.begin(), m_keys.end(), std::back_inserter(m_rest));
        for (const uint64_t key : m_keys) {
            const bool isFound = std::binary_search(fresh.begin(), fresh.end(), key);
            if (isFound || !isSearched(LowOf(key), HighOf(key))) m_kept.push_back(key);
        }
        m_keys.swap(m_kept);
        fresh.swap(m_rest);
    }
    void Add(uint64_t key) { m_keys.insert(std::upper_bound(m_keys.begin(), m_keys.end(), key), key); }
    /// Many at once, in any order.
    void Add(const std::vector<uint64_t>& keys) {
        if (keys.empty()) return;
        m_keys.insert(m_keys.end(), keys.begin(), keys.end());
        std::sort(m_keys.begin(), m_keys.end());
    }

    [[nodiscard]] size_t GetMemoryBytes() const {
        return (m_keys.capacity() + m_kept.capacity() + m_rest.capacity()) * sizeof(uint64_t) +
               m_forgotten.capacity() * sizeof(FixtureIndex);
    }

private:
    void ApplyForgotten() {
        if (m_forgotten.empty()) return;
        std::sort(m_forgotten.begin(), m_forgotten.end());
        const auto forgotten = [this](FixtureIndex fixture) {
            return std::binary_search(m_forgotten.begin(), m_forgotten.end(), fixture);
        };
        std::erase_if(m_keys, [&](uint64_t key) { return forgotten(HighOf(key)) || forgotten(LowOf(key)); });
        m_forgotten.clear();
    }

    std::vector<uint64_t> m_keys;  ///< sorted
    std::vector<uint64_t> m_kept, m_rest;
    std::vector<FixtureIndex> m_forgotten;
};

}  // namespace scree
