// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The hash of all that a world's future depends on: a walk over the same lists of fields as the image's.

#include <bit>
#include <type_traits>
#include <vector>

#include "scree/inspect.h"
#include "world/state_fields.h"

namespace scree {

namespace {

/// Order-dependent 64-bit hash; the finaliser is MurmurHash3's (Appleby, 2011).
class StateHasher {
public:
    template <typename... T>
    void operator()(const T&... values) {
        (Add(values), ...);
    }
    /// Rows that are not alive hold left-overs.
    template <typename Table, typename... Columns>
    void Rows(const Table& rows, const Columns&... columns) {
        Add(rows.Size());
        for (const auto row : rows.Rows()) {
            if (rows.IsAlive(row)) (AddRow(columns, row), ...);
        }
    }
    template <typename... T>
    void Stored(const T&...) {}
    template <typename... T>
    void Hashed(const T&... values) {
        (Add(values), ...);
    }
    template <typename... T>
    void LeftOut(const T&...) {}

    [[nodiscard]] uint64_t Get() const { return m_hash; }

private:
    template <Index I, typename T>
    void AddRow(const Column<I, T>& column, I row) {
        Add(column.Has(row) ? column[row] : T());
    }
    template <typename T>
    void Add(const T& value) {
        if constexpr (std::is_same_v<T, float>) {
            constexpr uint32_t minusZero = 0x80000000u;
            const auto bits = std::bit_cast<uint32_t>(value);
            AddWord(bits == minusZero || value != value ? 0 : bits);
        } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
            AddWord(static_cast<uint64_t>(value));
        } else if constexpr (std::is_array_v<T>) {
            for (const auto& element : value) Add(element);
        } else {
            Fields(value, *this);
        }
    }
    template <AnyColumn T>
    void Add(const T& values) {
        AddWord(values.size());
        for (const auto& value : values) Add(value);
    }
    void AddWord(uint64_t word) {
        word ^= word >> 33;
        word *= 0xff51afd7ed558ccdull;
        word ^= word >> 33;
        m_hash = (m_hash ^ word) * 0x9E3779B97F4A7C15ull;
        m_hash ^= m_hash >> 29;
    }

    uint64_t m_hash = 0x5CEEull;
};

}  // namespace

uint64_t inspect::GetStateHash(const World& world) {
    StateHasher hash;
    VisitWorld(world.GetState(), hash);
    return hash.Get();
}

}  // namespace scree
