// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the fixture table.

#include "state/fixtures.h"

namespace scree {

FixtureIndex FixtureTable::Add(WorldState* state, BodyIndex bodyIndex, const FixtureDef& def, int knownShape) {
    const FixtureIndex index = slots.Prepare();
    const size_t rows = ToSize(index) + 1;
    // When memory runs out nothing has changed yet.
    ReserveRows(rows, body, shape, type, isSensor, filter, material, next, info, m_shapeRow);
    while (handles.size() < rows) handles.emplace_back(state, handles.End());
    const int shapeRow = TakeShape(*def.shape, knownShape);

    slots.Allocate();
    if (body.size() < rows) AppendRow(body, shape, type, isSensor, filter, material, next, info);

    body[index] = bodyIndex;
    PutShape(index, def.shape->GetType(), shapeRow);
    isSensor[index] = def.isSensor ? 1 : 0;
    filter[index] = def.filter;
    material[index] = MaterialOf(def);
    next[index] = FixtureIndex::none;
    info[index] = FixtureInfo{};
    info[index].density = def.density;
    info[index].reports = def.reports;
    info[index].materialId = def.materialId;
    info[index].userData = def.userData;
    return index;
}

template <typename Use>
void FixtureTable::WithPool(Shape::Type shapeType, Use&& use) {
    switch (shapeType) {
        case Shape::e_circle:
            return use(m_circles);
        case Shape::e_edge:
            return use(m_edges);
        case Shape::e_convex:
            return use(m_convexes);
        default:
            return use(m_polygons);
    }
}

int FixtureTable::FindShape(const Shape& value) const {
    switch (value.GetType()) {
        case Shape::e_circle:
            return m_circles.Find(static_cast<const CircleShape&>(value));
        case Shape::e_polygon:
            return m_polygons.Find(static_cast<const PolygonShape&>(value));
        case Shape::e_convex:
            return m_convexes.Find(static_cast<const ConvexShape&>(value));
        default:
            return -1;  // shapes of other types are not shared
    }
}

int FixtureTable::TakeShape(const Shape& value, int knownShape) {
    int row = knownShape;
    WithPool(value.GetType(), [&]<typename T>(ShapePool<T>& pool) {
        if (row >= 0) return pool.Share(row);
        row = pool.Take(static_cast<const T&>(value));
    });
    return row;
}

void FixtureTable::PutShape(FixtureIndex fixture, Shape::Type shapeType, int row) {
    type[fixture] = shapeType;
    EnsureRow(m_shapeRow, fixture);
    m_shapeRow[fixture] = row;
    WithPool(shapeType, [&](auto& pool) { shape[fixture] = pool.At(row); });
}

void FixtureTable::SetShape(FixtureIndex fixture, const Shape& value) {
    PutShape(fixture, value.GetType(), TakeShape(value, FindShape(value)));
}

Shape* FixtureTable::GetOwnShape(FixtureIndex fixture) {
    WithPool(type[fixture], [&](auto& pool) {
        m_shapeRow[fixture] = pool.MakeOwn(m_shapeRow[fixture]);
        shape[fixture] = pool.At(m_shapeRow[fixture]);
    });
    return shape[fixture];
}

void FixtureTable::Remove(FixtureIndex fixture) {
    WithPool(type[fixture], [&](auto& pool) { pool.Release(m_shapeRow[fixture]); });
    shape[fixture] = nullptr;
    slots.Free(fixture);
}

void FixtureTable::UndoAdd(FixtureIndex fixture) {
    WithPool(type[fixture], [&](auto& pool) { pool.Release(m_shapeRow[fixture]); });
    shape[fixture] = nullptr;
    slots.Undo(fixture);
    const auto shrink = [&](auto&... columns) { (columns.resize(ToSize(slots.Size())), ...); };
    shrink(body, shape, type, isSensor, filter, material, next, info, m_shapeRow);
}

size_t FixtureTable::GetBytesPerRow() {
    return 3 * sizeof(int) + sizeof(Shape*) + sizeof(Shape::Type) + sizeof(uint8_t) + sizeof(Filter) +
           sizeof(Material) + sizeof(FixtureInfo) + sizeof(Fixture) + sizeof(PolygonShape);
}

size_t FixtureTable::GetMemoryBytes() const {
    const size_t row = GetBytesPerRow() - sizeof(PolygonShape);
    return body.size() * row + m_circles.GetMemoryBytes() + m_edges.GetMemoryBytes() + m_polygons.GetMemoryBytes() +
           m_convexes.GetMemoryBytes();
}

}  // namespace scree
