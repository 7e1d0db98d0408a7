// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of the fixture table.

#include "state/fixtures.h"

namespace scree {

int FixtureTable::Add(WorldState* state, int bodyIndex, const FixtureDef& def) {
    const int index = slots.Allocate();
    const auto i = static_cast<size_t>(index);
    EnsureRow(body, index);
    EnsureRow(shape, index);
    EnsureRow(type, index);
    EnsureRow(isSensor, index);
    EnsureRow(filter, index);
    EnsureRow(material, index);
    EnsureRow(next, index);
    EnsureRow(info, index);
    while (static_cast<int>(handles.size()) <= index) handles.emplace_back(state, static_cast<int>(handles.size()));

    body[i] = bodyIndex;
    SetShape(index, *def.shape);
    isSensor[i] = def.isSensor ? 1 : 0;
    filter[i] = def.filter;
    material[i] = {def.friction, def.restitution, def.restitutionThreshold};
    next[i] = -1;
    info[i] = FixtureInfo{};
    info[i].density = def.density;
    info[i].userData = def.userData;
    return index;
}

template <typename Use>
void FixtureTable::WithPool(int fixture, Use&& use) {
    const auto i = static_cast<size_t>(fixture);
    switch (type[i]) {
        case Shape::e_circle:
            use(m_circles, m_shapeRow[i]);
            break;
        case Shape::e_edge:
            use(m_edges, m_shapeRow[i]);
            break;
        case Shape::e_convex:
            use(m_convexes, m_shapeRow[i]);
            break;
        default:
            use(m_polygons, m_shapeRow[i]);
            break;
    }
}

void FixtureTable::SetShape(int fixture, const Shape& value) {
    const auto i = static_cast<size_t>(fixture);
    type[i] = value.GetType();
    EnsureRow(m_shapeRow, fixture);
    WithPool(fixture, [&]<typename T>(ShapePool<T>& pool, int& row) {
        row = pool.Take(static_cast<const T&>(value));
        shape[i] = pool.At(row);
    });
}

Shape* FixtureTable::GetOwnShape(int fixture) {
    const auto i = static_cast<size_t>(fixture);
    WithPool(fixture, [&](auto& pool, int& row) {
        row = pool.MakeOwn(row);
        shape[i] = pool.At(row);
    });
    return shape[i];
}

void FixtureTable::Remove(int fixture) {
    WithPool(fixture, [](auto& pool, int row) { pool.Release(row); });
    shape[static_cast<size_t>(fixture)] = nullptr;
    slots.Free(fixture);
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
