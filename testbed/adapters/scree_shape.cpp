// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scree_shape.h.

#include "testbed/adapters/scree_shape.h"

#include <stdexcept>

namespace testbed {

ScreeShape MakeScreeShape(const scenes::Shape& shape) {
    switch (shape.type) {
        case scenes::ShapeType::circle: {
            scree::CircleShape circle;
            circle.m_p = ToScree(shape.center);
            circle.m_radius = shape.radius;
            return circle;
        }
        case scenes::ShapeType::box: {
            scree::PolygonShape box;
            box.SetAsBox(shape.halfExtents.x, shape.halfExtents.y, ToScree(shape.center), shape.angle);
            return box;
        }
        case scenes::ShapeType::polygon: {
            scree::Vec2 points[scenes::maxPolygonVertices];
            int count = 0;
            for (const scenes::Vec2 v : shape.Vertices()) points[count++] = ToScree(v);
            scree::PolygonShape polygon;
            if (!polygon.Set(points, count)) throw std::invalid_argument("scene polygon is degenerate");
            return polygon;
        }
        case scenes::ShapeType::edge: {
            scree::EdgeShape edge;
            edge.SetTwoSided(ToScree(shape.vertices[0]), ToScree(shape.vertices[1]));
            return edge;
        }
    }
    throw std::invalid_argument("scene shape of unknown type");
}

const scree::Shape& AsShape(const ScreeShape& shape) {
    return std::visit([](const auto& s) -> const scree::Shape& { return s; }, shape);
}

}  // namespace testbed
