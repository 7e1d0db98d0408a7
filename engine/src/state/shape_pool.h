// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The shapes of one type at stable addresses. Equal circles and polygons are kept once, since worlds repeat few shapes.
// A shape that many fixtures share stays in the first-level cache, where copies would be fetched from memory in every
// step.

#pragma once

#include <array>
#include <cstring>
#include <vector>

#include "base/slots.h"
#include "scree/shape.h"

namespace scree {

/// Whether a type of shape is worth comparing, by which bits, and where these are remembered.
template <typename T>
struct ShapeBits {
    static constexpr bool areShared = false;
};

template <>
struct ShapeBits<CircleShape> {
    static constexpr bool areShared = true;
    using Bits = std::array<float, 3>;
    static Bits Of(const CircleShape& s) { return {s.m_radius, s.m_p.x, s.m_p.y}; }
};

template <>
struct ShapeBits<PolygonShape> {
    static constexpr bool areShared = true;
    using Bits = std::array<float, 4 + 4 * maxPolygonVertices>;
    static Bits Of(const PolygonShape& s) {
        Bits bits{s.m_radius, s.m_centroid.x, s.m_centroid.y, static_cast<float>(s.m_count)};
        const size_t count = ToSize(s.m_count);
        std::memcpy(&bits[4], s.m_vertices, count * sizeof(Vec2));
        std::memcpy(&bits[4 + 2 * maxPolygonVertices], s.m_normals, count * sizeof(Vec2));
        return bits;
    }
};

template <typename T>
class ShapePool {
public:
    /// The row of a shape with these bits, shared or new.
    int Take(const T& value) {
        if constexpr (ShapeBits<T>::areShared) {
            const auto bits = ShapeBits<T>::Of(value);
            int& known = m_known[PlaceOf(bits)];
            if (known >= 0) {
                const auto there = ShapeBits<T>::Of(m_items[known]);
                if (std::memcmp(&bits, &there, sizeof bits) == 0) {
                    ++m_users[known];
                    return known;
                }
            }
            return known = Add(value);
        } else {
            return Add(value);
        }
    }
    void Release(int row) {
        if (--m_users[row] > 0) return;
        Forget(row);
        m_free.push_back(row);
    }
    /// The row of a copy that its user may change: nobody else has it or will get it.
    int MakeOwn(int row) {
        if (m_users[row] == 1) {
            Forget(row);
            return row;
        }
        const T copy = m_items[row];
        const int own = Add(copy);
        --m_users[row];
        return own;
    }
    [[nodiscard]] T* At(int row) { return &m_items[row]; }
    [[nodiscard]] size_t GetMemoryBytes() const { return m_items.size() * (sizeof(T) + sizeof(int)); }

private:
    static constexpr size_t knownCount = 256;

    template <typename Bits>
    static size_t PlaceOf(const Bits& bits) {
        // Fibonacci hashing. Half of the numbers are enough: a polygon's normals, the second half, follow from the
        // rest.
        constexpr size_t size = std::tuple_size_v<Bits>, words = size < 8 ? size : size / 2;
        uint64_t sum = 0;
        for (size_t i = 0; i < words; i += 2) {
            uint64_t word = 0;
            std::memcpy(&word, &bits[i], i + 1 < words ? sizeof word : sizeof(float));
            sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
            sum ^= sum >> 32;
        }
        return static_cast<size_t>(sum >> 56);
    }

    int Add(const T& value) {
        if (m_free.empty()) {
            ReserveRows(m_items.size() + 1, m_users, m_free);  // when memory runs out nothing has changed
            m_items.push_back(value);
            m_users.push_back(1);
            return m_items.End() - 1;
        }
        const int row = m_free.back();
        m_free.pop_back();
        m_items[row] = value;
        m_users[row] = 1;
        return row;
    }

    /// Nobody shall share the row any more. Shapes that their users may have changed are not known, hence not found.
    void Forget(int row) {
        if constexpr (ShapeBits<T>::areShared) {
            int& known = m_known[PlaceOf(ShapeBits<T>::Of(m_items[row]))];
            if (known == row) known = -1;
        }
    }

    static constexpr std::array<int, knownCount> NoneKnown() {
        std::array<int, knownCount> none{};
        none.fill(-1);
        return none;
    }

    StableColumn<int, T> m_items;
    Column<int, int> m_users;  ///< per item; 0 if free
    std::vector<int> m_free;
    std::array<int, knownCount> m_known = NoneKnown();  ///< rows that may be shared, by the hash of their bits
};

}  // namespace scree
