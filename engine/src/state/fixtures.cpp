// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the fixture table.

#include "state/fixtures.h"

namespace scree {

int FixtureTable::Add(WorldState* state, int bodyIndex, const FixtureDef& def) {
    const int index = slots.Prepare();
    const auto i = static_cast<size_t>(index);
    // When memory runs out nothing has changed yet.
    ReserveRows(i + 1, body, shape, type, isSensor, filter, material, next, info, m_shapeRow);
    while (static_cast<int>(handles.size()) <= index) handles.emplace_back(state, static_cast<int>(handles.size()));
    const int shapeRow = TakeShape(*def.shape);

    slots.Allocate();
    EnsureRow(body, index);
    EnsureRow(shape, index);
    EnsureRow(type, index);
    EnsureRow(isSensor, index);
    EnsureRow(filter, index);
    EnsureRow(material, index);
    EnsureRow(next, index);
    EnsureRow(info, index);

    body[i] = bodyIndex;
    PutShape(index, def.shape->GetType(), shapeRow);
    isSensor[i] = def.isSensor ? 1 : 0;
    filter[i] = def.filter;
    material[i] = MaterialOf(def);
    next[i] = -1;
    info[i] = FixtureInfo{};
    info[i].density = def.density;
    info[i].reports = def.reports;
    info[i].materialId = def.materialId;
    info[i].userData = def.userData;
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

int FixtureTable::TakeShape(const Shape& value) {
    int row = -1;
    WithPool(value.GetType(), [&]<typename T>(ShapePool<T>& pool) { row = pool.Take(static_cast<const T&>(value)); });
    return row;
}

void FixtureTable::PutShape(int fixture, Shape::Type shapeType, int row) {
    const auto i = static_cast<size_t>(fixture);
    type[i] = shapeType;
    EnsureRow(m_shapeRow, fixture);
    m_shapeRow[i] = row;
    WithPool(shapeType, [&](auto& pool) { shape[i] = pool.At(row); });
}

void FixtureTable::SetShape(int fixture, const Shape& value) { PutShape(fixture, value.GetType(), TakeShape(value)); }

Shape* FixtureTable::GetOwnShape(int fixture) {
    const auto i = static_cast<size_t>(fixture);
    WithPool(type[i], [&](auto& pool) {
        m_shapeRow[i] = pool.MakeOwn(m_shapeRow[i]);
        shape[i] = pool.At(m_shapeRow[i]);
    });
    return shape[i];
}

void FixtureTable::Remove(int fixture) {
    const auto i = static_cast<size_t>(fixture);
    WithPool(type[i], [&](auto& pool) { pool.Release(m_shapeRow[i]); });
    shape[i] = nullptr;
    slots.Free(fixture);
}

void FixtureTable::UndoAdd(int fixture) {
    const auto i = static_cast<size_t>(fixture);
    WithPool(type[i], [&](auto& pool) { pool.Release(m_shapeRow[i]); });
    shape[i] = nullptr;
    slots.Undo(fixture);
    const auto shrink = [&](auto&... columns) { (columns.resize(static_cast<size_t>(slots.Size())), ...); };
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
