// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of fixtures. Shapes are values in pools of their type.

#pragma once

#include <iterator>
#include <vector>

#include "base/slots.h"
#include "scree/convex_shape.h"
#include "scree/fixture.h"
#include "scree/shape.h"
#include "state/indices.h"
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
        const Column<FixtureIndex, FixtureIndex>* next;
        FixtureIndex row;

        FixtureIndex operator*() const { return row; }
        Iterator& operator++() {
            row = (*next)[row];
            return *this;
        }
        bool operator!=(std::default_sentinel_t) const { return IsSome(row); }
    };
    const Column<FixtureIndex, FixtureIndex>* next;
    FixtureIndex head;

    [[nodiscard]] Iterator begin() const { return {next, head}; }
    [[nodiscard]] static std::default_sentinel_t end() { return {}; }
};

struct FixtureTable {
    Slots<FixtureIndex> slots;
    Column<FixtureIndex, BodyIndex> body;
    Column<FixtureIndex, Shape*> shape;  ///< rows with equal shapes share one
    Column<FixtureIndex, Shape::Type> type;
    Column<FixtureIndex, uint8_t> isSensor;
    Column<FixtureIndex, Filter> filter;
    Column<FixtureIndex, Material> material;
    Column<FixtureIndex, FixtureIndex> next;  ///< fixture of the same body, −1 none
    Column<FixtureIndex, FixtureInfo> info;
    StableColumn<FixtureIndex, Fixture> handles;

    int nextChainId = 0;

    /// The list of fixtures that begins with `head`, as a range of rows.
    [[nodiscard]] FixtureList From(FixtureIndex head) const { return {&next, head}; }
    /// The row of an equal shape in the pool of its type, −1 if none is known. All that are in pools are valid; `value`
    /// may be anything.
    [[nodiscard]] int FindShape(const Shape& value) const;
    /// Adds a row; the shape is no chain. `knownShape` is what FindShape gave for it.
    FixtureIndex Add(WorldState* state, BodyIndex bodyIndex, const FixtureDef& def, int knownShape);
    void Remove(FixtureIndex fixture);
    /// Takes back the newest Add that was not taken back yet: the rows are as they were before it.
    void UndoAdd(FixtureIndex fixture);
    /// Gives a row that has none a shape like `value`, no chain.
    void SetShape(FixtureIndex fixture, const Shape& value);
    /// The row's shape, not shared with other rows from now on: it may be changed.
    Shape* GetOwnShape(FixtureIndex fixture);
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
    int TakeShape(const Shape& value, int knownShape);
    void PutShape(FixtureIndex fixture, Shape::Type shapeType, int row);

    Column<FixtureIndex, int> m_shapeRow;  ///< in the pool of its type
    ShapePool<CircleShape> m_circles;
    ShapePool<EdgeShape> m_edges;
    ShapePool<PolygonShape> m_polygons;
    ShapePool<ConvexShape> m_convexes;
};

}  // namespace scree
