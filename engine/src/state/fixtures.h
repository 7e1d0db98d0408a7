// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of fixtures. Shapes are values in pools of their type.

#pragma once

#include <deque>
#include <iterator>
#include <vector>

#include "base/slots.h"
#include "scree/convex_shape.h"
#include "scree/fixture.h"
#include "scree/shape.h"
#include "state/shape_pool.h"

namespace scree {

struct Material {
    float friction, restitution, restitutionThreshold;
    float tangentSpeed, rollingResistance;
    MixRule frictionRule, restitutionRule;
};

inline Material MaterialOf(const FixtureDef& def) {
    return {def.friction,          def.restitution,  def.restitutionThreshold, def.tangentSpeed,
            def.rollingResistance, def.frictionRule, def.restitutionRule};
}

/// What filter data say of two fixtures: the rule of ContactFilter.
inline bool ShouldCollide(const Filter& a, const Filter& b) {
    if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
    return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// Cold data of a fixture.
struct FixtureInfo {
    float density = 0.0f;
    int chainId = -1;     ///< shared by the edges of one chain
    int chainIndex = -1;  ///< of this edge in it
    bool inBroadPhase = false;
    uint8_t reports = 0;  ///< bits of Report
    uint64_t materialId = 0;
    FixtureUserData userData;
};

/// Rows that follow each other through a column of successors.
struct FixtureList {
    struct Iterator {
        const std::vector<int>* next;
        int row;

        int operator*() const { return row; }
        Iterator& operator++() {
            row = (*next)[static_cast<size_t>(row)];
            return *this;
        }
        bool operator!=(std::default_sentinel_t) const { return row >= 0; }
    };
    const std::vector<int>* next;
    int head;

    [[nodiscard]] Iterator begin() const { return {next, head}; }
    [[nodiscard]] static std::default_sentinel_t end() { return {}; }
};

struct FixtureTable {
    Slots slots;
    std::vector<int> body;
    std::vector<Shape*> shape;  ///< rows with equal shapes share one
    std::vector<Shape::Type> type;
    std::vector<uint8_t> isSensor;
    std::vector<Filter> filter;
    std::vector<Material> material;
    std::vector<int> next;  ///< fixture of the same body, −1 none
    std::vector<FixtureInfo> info;
    std::deque<Fixture> handles;

    int nextChainId = 0;

    /// The list of fixtures that begins with `head`, as a range of rows.
    [[nodiscard]] FixtureList From(int head) const { return {&next, head}; }
    /// Adds a row; the shape is no chain.
    int Add(WorldState* state, int bodyIndex, const FixtureDef& def);
    void Remove(int fixture);
    /// Takes back the newest Add that was not taken back yet: the rows are as they were before it.
    void UndoAdd(int fixture);
    /// Gives a row that has none a shape like `value`, no chain.
    void SetShape(int fixture, const Shape& value);
    /// The row's shape, not shared with other rows from now on: it may be changed.
    Shape* GetOwnShape(int fixture);
    [[nodiscard]] size_t GetMemoryBytes() const;
    /// Bytes of one row with its shape, a polygon assumed.
    [[nodiscard]] static size_t GetBytesPerRow();
    /// All but the shapes.
    template <typename Self, typename Visit>
    static void Fields(Self& t, Visit& visit) {
        auto& [slots, body, shape, type, isSensor, filter, material, next, info, handles, nextChainId, shapeRow,
               circles, edges, polygons, convexes] = t;
        visit(slots), visit.Rows(slots, body, type, isSensor, filter, material, next, info), visit(nextChainId);
        visit.LeftOut(shape, handles, shapeRow, circles, edges, polygons, convexes);
    }

private:
    /// Calls use(pool) with the pool of a type of shapes.
    template <typename Use>
    void WithPool(Shape::Type shapeType, Use&& use);
    /// A row of the pool with the shape's values, and its use as a fixture's shape.
    int TakeShape(const Shape& value);
    void PutShape(int fixture, Shape::Type shapeType, int row);

    std::vector<int> m_shapeRow;  ///< in the pool of its type
    ShapePool<CircleShape> m_circles;
    ShapePool<EdgeShape> m_edges;
    ShapePool<PolygonShape> m_polygons;
    ShapePool<ConvexShape> m_convexes;
};

}  // namespace scree
