// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where detection writes its pairs: a growing view of the caller's vector that applies the pair rule without a branch.
// The rule "different bodies, at least one dynamic" is one comparison, because all fixtures that are not dynamic carry
// the same group and dynamic ones the group of their body.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/broad_phase.h"

namespace scree::broadphase {

/// What detection must know of a box besides its bounds.
struct ItemId {
    uint32_t fixture;
    uint32_t group;  ///< fixtures of equal group never pair
};

/// The group of everything that is not dynamic.
inline constexpr uint32_t fixedGroup = 0xFFFFFFFFu;

constexpr uint32_t GroupOf(uint32_t body, Motion motion) { return motion == Motion::dynamic ? body : fixedGroup; }

class PairSink {
public:
    /// Writes from out[first] on.
    explicit PairSink(std::vector<Pair>& out, size_t first = 0) : m_out(out), m_count(first) {}
    PairSink(const PairSink&) = delete;
    PairSink& operator=(const PairSink&) = delete;

    /// Room for `extra` more pairs at the end; the caller writes there and then calls Commit with how many it kept.
    Pair* Reserve(size_t extra) {
        if (m_count + extra > m_out.size()) Grow(m_count + extra);
        return m_out.data() + m_count;
    }
    void Commit(size_t count) { m_count += count; }

    /// Appends the pair if the groups differ.
    void Emit(ItemId a, ItemId b) {
        *Reserve(1) = {std::min(a.fixture, b.fixture), std::max(a.fixture, b.fixture)};
        m_count += a.group != b.group ? 1 : 0;
    }

    /// Behind the last pair written.
    [[nodiscard]] size_t End() const { return m_count; }

    /// Cuts the vector to the pairs written.
    void Finish() { m_out.resize(m_count); }

private:
    void Grow(size_t needed) {
        size_t size = std::max<size_t>({needed, 2 * m_out.size(), 16});  // few: they are cleared first
        // A warm call must not allocate only because doubling overshoots.
        if (needed <= m_out.capacity()) size = std::min(size, m_out.capacity());
        m_out.resize(size);
    }

    std::vector<Pair>& m_out;
    size_t m_count;
};

}  // namespace scree::broadphase
