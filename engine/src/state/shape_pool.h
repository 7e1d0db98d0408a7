// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The shapes of one type at stable addresses. Equal ones are kept once, since worlds repeat few shapes. Edges are not:
// terrain repeats none. A shape that many fixtures share stays in the first-level cache, where copies would be fetched
// from memory in every step.

#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/slots.h"
#include "scree/convex_shape.h"
#include "scree/shape.h"

namespace scree {

/// A round of Fibonacci hashing.
inline uint64_t HashPair(uint64_t sum, float x, float y) {
    const uint64_t word = uint64_t{std::bit_cast<uint32_t>(x)} | uint64_t{std::bit_cast<uint32_t>(y)} << 32;
    sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
    return sum ^ sum >> 32;
}
inline bool AreSameBits(float a, float b) { return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b); }
inline bool AreSameBits(Vec2 a, Vec2 b) { return AreSameBits(a.x, b.x) && AreSameBits(a.y, b.y); }

/// Whether a type of shape is worth comparing, which of its values can be, and how their bits are.
template <typename T>
struct ShapeBits {
    static constexpr bool areShared = false;
};

template <>
struct ShapeBits<CircleShape> {
    static constexpr bool areShared = true;
    static bool IsComparable(const CircleShape& /*s*/) { return true; }
    static uint64_t Hash(const CircleShape& s) { return HashPair(HashPair(0, s.m_radius, s.m_p.x), s.m_p.y, 0.0f); }
    static bool AreEqual(const CircleShape& a, const CircleShape& b) {
        return AreSameBits(a.m_radius, b.m_radius) && AreSameBits(a.m_p, b.m_p);
    }
};

template <>
struct ShapeBits<PolygonShape> {
    static constexpr bool areShared = true;
    static bool IsComparable(const PolygonShape& s) { return s.m_count >= 0 && s.m_count <= maxPolygonVertices; }
    /// Normals follow from the rest.
    static uint64_t Hash(const PolygonShape& s) {
        uint64_t sum = HashPair(HashPair(0, s.m_radius, static_cast<float>(s.m_count)), s.m_centroid.x, s.m_centroid.y);
        for (int i = 0; i < s.m_count; ++i) sum = HashPair(sum, s.m_vertices[i].x, s.m_vertices[i].y);
        return sum;
    }
    static bool AreEqual(const PolygonShape& a, const PolygonShape& b) {
        if (a.m_count != b.m_count) return false;
        const auto areSame = [&](const Vec2* x, const Vec2* y) {
            return std::memcmp(x, y, ToSize(a.m_count) * sizeof(Vec2)) == 0;
        };
        return AreSameBits(a.m_radius, b.m_radius) && AreSameBits(a.m_centroid, b.m_centroid) &&
               areSame(a.m_vertices, b.m_vertices) && areSame(a.m_normals, b.m_normals);
    }
};

template <>
struct ShapeBits<ConvexShape> {
    static constexpr bool areShared = true;
    static bool IsComparable(const ConvexShape& s) {
        return s.m_count >= 0 && s.m_count <= maxConvexVertices && s.m_badField == nullptr;
    }
    /// The rest follows from these, or is told apart by comparing.
    static uint64_t Hash(const ConvexShape& s) {
        uint64_t sum = HashPair(0, s.m_radius, static_cast<float>(s.m_count));
        for (int i = 0; i < s.m_count; ++i) {
            sum = HashPair(sum, s.m_vertices[i].x, s.m_vertices[i].y);
            if (s.IsCurved(i)) sum = HashPair(sum, s.m_controls[i].x, s.m_controls[i].y);
        }
        return sum;
    }
    static bool AreEqual(const ConvexShape& a, const ConvexShape& b) {
        if (a.m_count != b.m_count || a.m_curvedSides != b.m_curvedSides) return false;
        const auto areSame = [&](const Vec2* x, const Vec2* y) {
            return std::memcmp(x, y, ToSize(a.m_count) * sizeof(Vec2)) == 0;
        };
        return AreSameBits(a.m_radius, b.m_radius) && AreSameBits(a.m_solidRadius, b.m_solidRadius) &&
               AreSameBits(a.m_error, b.m_error) && AreSameBits(a.m_unitMass.mass, b.m_unitMass.mass) &&
               AreSameBits(a.m_unitMass.center, b.m_unitMass.center) && AreSameBits(a.m_unitMass.I, b.m_unitMass.I) &&
               areSame(a.m_vertices, b.m_vertices) && areSame(a.m_normals, b.m_normals) &&
               areSame(a.m_controls, b.m_controls);
    }
};

template <typename T>
class ShapePool {
public:
    /// The row of a shape with these bits that may be shared, −1 if none is known. Any value may be asked for.
    [[nodiscard]] int Find(const T& value) const {
        if constexpr (ShapeBits<T>::areShared) {
            if (!ShapeBits<T>::IsComparable(value)) return -1;
            const int known = m_known[PlaceOf(value)];
            if (known >= 0 && ShapeBits<T>::AreEqual(value, m_items[known])) return known;
        }
        return -1;
    }
    /// One more user of a row that was found.
    void Share(int row) { ++m_users[row]; }
    /// A new row with a value that Find did not find.
    int Take(const T& value) {
        const int row = Add(value);
        if constexpr (ShapeBits<T>::areShared) m_known[PlaceOf(value)] = row;
        return row;
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

    static size_t PlaceOf(const T& value) { return static_cast<size_t>(ShapeBits<T>::Hash(value) >> 56); }

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
            if (!ShapeBits<T>::IsComparable(m_items[row])) return;  // whoever owns it may have put in anything
            int& known = m_known[PlaceOf(m_items[row])];
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
