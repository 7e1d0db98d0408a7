// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of fixtures. Shapes are values in pools of their type, so that a loop over fixtures reads them in a row.

#pragma once

#include <deque>
#include <vector>

#include "base/slots.h"
#include "scree/convex_shape.h"
#include "scree/fixture.h"
#include "scree/shape.h"

namespace scree {

struct Material {
    float friction, restitution, restitutionThreshold;
};

/// What filter data say of two fixtures: the rule of ContactFilter.
inline bool ShouldCollide(const Filter& a, const Filter& b) {
    if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
    return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// Cold data of a fixture.
struct FixtureInfo {
    float density = 0.0f;
    int next = -1;        ///< next fixture of the body
    int chainId = -1;     ///< shared by the edges of one chain
    int chainIndex = -1;  ///< of this edge in it
    bool inBroadPhase = false;
    FixtureUserData userData;
};

struct FixtureTable {
    Slots slots;
    std::vector<int> body;
    std::vector<Shape*> shape;
    std::vector<Shape::Type> type;
    std::vector<uint8_t> isSensor;
    std::vector<Filter> filter;
    std::vector<Material> material;
    std::vector<FixtureInfo> info;
    std::deque<Fixture> handles;

    int nextChainId = 0;

    /// Adds a row; the shape is no chain.
    int Add(WorldState* state, int bodyIndex, const FixtureDef& def);
    void Remove(int fixture);
    /// Gives a row that has none a copy of `value`, no chain.
    void SetShape(int fixture, const Shape& value);
    [[nodiscard]] size_t GetMemoryBytes() const;
    /// Bytes of one row with its shape, a polygon assumed.
    [[nodiscard]] static size_t GetBytesPerRow();

private:
    /// Objects of one type with stable addresses; freed ones are used again.
    template <typename T>
    struct Pool {
        std::deque<T> items;
        std::vector<T*> free;

        T* Add(const T& value) {
            if (free.empty()) return &items.emplace_back(value);
            T* item = free.back();
            free.pop_back();
            *item = value;
            return item;
        }
    };

    Pool<CircleShape> m_circles;
    Pool<EdgeShape> m_edges;
    Pool<PolygonShape> m_polygons;
    Pool<ConvexShape> m_convexes;
};

}  // namespace scree
