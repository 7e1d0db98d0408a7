// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Numbers for objects: hands out dense indices, the most recently freed first, and remembers which are alive and how
// often each was freed.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/index.h"

namespace scree {

/// Room for `count` rows in columns that grow by and by, so that adding them cannot fail.
template <AnyColumn... T>
void ReserveRows(size_t count, T&... columns) {
    const auto reserve = [count](auto& column) {
        constexpr size_t least = 16, small = 1024;  // rows; longer ones grow by half, or much would be left empty
        const size_t room = column.capacity();
        if (count > room) column.reserve(std::max({count, least, room < small ? 2 * room : room + room / 2}));
    };
    (reserve(columns), ...);
}

/// One more row T() in each of columns that have the same number of rows and room for one more (ReserveRows).
template <AnyColumn... T>
void AppendRow(T&... columns) {
    (columns.emplace_back(), ...);
}

template <Index I>
class Slots {
public:
    /// The index that Allocate is going to give. Whatever fails must fail here: Allocate and Free do not after it.
    I Prepare() {
        if (!m_free.empty()) return m_free.back();
        ReserveRows(m_alive.size() + 1, m_alive, m_generation, m_free);
        return I{Size()};
    }
    /// A free index; Size() grows by one when none was free.
    I Allocate() {
        ++m_count;
        if (!m_free.empty()) {
            const I index = m_free.back();
            m_free.pop_back();
            m_alive[index] = 1;
            return index;
        }
        m_alive.push_back(1);
        m_generation.push_back(0);
        return I{Size() - 1};
    }
    void Free(I index) {
        m_alive[index] = 0;
        ++m_generation[index];
        m_free.push_back(index);
        --m_count;
    }
    /// Takes back the newest Allocate that was not taken back yet: the slots are as they were before it.
    void Undo(I index) {
        --m_count;
        if (m_generation[index] == 0) {  // Allocate made it
            m_alive.pop_back();
            m_generation.pop_back();
            return;
        }
        m_alive[index] = 0;
        m_free.push_back(index);
    }
    [[nodiscard]] bool IsAlive(I index) const { return m_alive.Has(index) && m_alive[index] != 0; }
    /// How often the index was freed; tells an object from its successors.
    [[nodiscard]] uint32_t GetGeneration(I index) const { return m_generation[index]; }
    /// One more than the largest index ever handed out.
    [[nodiscard]] int Size() const { return static_cast<int>(m_alive.size()); }
    /// Every index that was handed out.
    [[nodiscard]] IndexRange<I> Rows() const { return m_alive.Rows(); }
    /// Objects alive.
    [[nodiscard]] int Count() const { return m_count; }

    template <typename Self, typename Visit>
    static void Fields(Self& slots, Visit& visit) {
        auto& [alive, generation, free, count] = slots;
        visit(alive, generation, free, count);
    }
    /// For numbers that were read: every column has the same length, and the free ones are those not alive.
    [[nodiscard]] bool IsConsistent() const {
        if (m_generation.size() != m_alive.size() || m_count < 0) return false;
        if (m_free.size() + ToSize(m_count) != m_alive.size()) return false;
        Column<I, uint8_t> used = m_alive;  // each number exactly once, as one alive or as a free one
        for (const I index : m_free) {
            if (!used.Has(index) || used[index] != 0) return false;
            used[index] = 1;
        }
        for (const uint8_t flag : used) {
            if (flag != 1) return false;
        }
        return true;
    }

private:
    Column<I, uint8_t> m_alive;
    Column<I, uint32_t> m_generation;
    std::vector<I> m_free;
    int m_count = 0;
};

/// Grows a column to `count` rows where it has fewer, by copies of `fill` if that is given, else by T().
template <AnyColumn Rows, typename... Fill>
void EnsureRows(Rows& column, size_t count, const Fill&... fill) {
    if (count <= column.size()) return;
    if (count == column.size() + 1) {
        column.emplace_back(fill...);  // the usual case, and several times as fast
    } else {
        column.resize(count, fill...);
    }
}
/// The same so that the row `index` exists.
template <Index I, typename T, typename... Fill>
void EnsureRow(Column<I, T>& column, I index, const Fill&... fill) {
    EnsureRows(column, ToSize(index) + 1, fill...);
}

}  // namespace scree
