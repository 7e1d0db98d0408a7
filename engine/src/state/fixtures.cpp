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
    EnsureRow(info, index);
    while (static_cast<int>(handles.size()) <= index) handles.emplace_back(state, static_cast<int>(handles.size()));

    body[i] = bodyIndex;
    SetShape(index, *def.shape);
    isSensor[i] = def.isSensor ? 1 : 0;
    filter[i] = def.filter;
    material[i] = {def.friction, def.restitution, def.restitutionThreshold};
    info[i] = FixtureInfo{};
    info[i].density = def.density;
    info[i].userData = def.userData;
    return index;
}

void FixtureTable::SetShape(int fixture, const Shape& value) {
    const auto i = static_cast<size_t>(fixture);
    type[i] = value.GetType();
    switch (type[i]) {
        case Shape::e_circle:
            shape[i] = m_circles.Add(static_cast<const CircleShape&>(value));
            break;
        case Shape::e_edge:
            shape[i] = m_edges.Add(static_cast<const EdgeShape&>(value));
            break;
        case Shape::e_convex:
            shape[i] = m_convexes.Add(static_cast<const ConvexShape&>(value));
            break;
        default:
            shape[i] = m_polygons.Add(static_cast<const PolygonShape&>(value));
            break;
    }
}

void FixtureTable::Remove(int fixture) {
    const auto i = static_cast<size_t>(fixture);
    switch (type[i]) {
        case Shape::e_circle:
            m_circles.free.push_back(static_cast<CircleShape*>(shape[i]));
            break;
        case Shape::e_edge:
            m_edges.free.push_back(static_cast<EdgeShape*>(shape[i]));
            break;
        case Shape::e_convex:
            m_convexes.free.push_back(static_cast<ConvexShape*>(shape[i]));
            break;
        default:
            m_polygons.free.push_back(static_cast<PolygonShape*>(shape[i]));
            break;
    }
    shape[i] = nullptr;
    slots.Free(fixture);
}

size_t FixtureTable::GetBytesPerRow() {
    return sizeof(int) + sizeof(Shape*) + sizeof(Shape::Type) + sizeof(uint8_t) + sizeof(Filter) + sizeof(Material) +
           sizeof(FixtureInfo) + sizeof(Fixture) + sizeof(PolygonShape);
}

size_t FixtureTable::GetMemoryBytes() const {
    const size_t row = GetBytesPerRow() - sizeof(PolygonShape);
    return body.size() * row + m_circles.items.size() * sizeof(CircleShape) + m_edges.items.size() * sizeof(EdgeShape) +
           m_polygons.items.size() * sizeof(PolygonShape) + m_convexes.items.size() * sizeof(ConvexShape);
}

}  // namespace scree
