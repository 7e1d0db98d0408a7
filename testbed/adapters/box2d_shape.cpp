// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d_shape.h.

#include "testbed/adapters/box2d_shape.h"

#include <stdexcept>

namespace testbed {

Box2dShape MakeBox2dShape(const scenes::Shape& shape) {
    switch (shape.type) {
        case scenes::ShapeType::circle: {
            b2CircleShape circle;
            circle.m_p = ToB2(shape.center);
            circle.m_radius = shape.radius;
            return circle;
        }
        case scenes::ShapeType::box: {
            b2PolygonShape box;
            box.SetAsBox(shape.halfExtents.x, shape.halfExtents.y, ToB2(shape.center), shape.angle);
            return box;
        }
        case scenes::ShapeType::polygon: {
            b2Vec2 points[scenes::maxPolygonVertices];
            int count = 0;
            for (const scenes::Vec2 v : shape.Vertices()) points[count++] = ToB2(v);
            b2PolygonShape polygon;
            polygon.Set(points, count);
            return polygon;
        }
        case scenes::ShapeType::edge: {
            b2EdgeShape edge;
            edge.SetTwoSided(ToB2(shape.vertices[0]), ToB2(shape.vertices[1]));
            return edge;
        }
    }
    throw std::invalid_argument("scene shape of unknown type");
}

const b2Shape& AsB2Shape(const Box2dShape& shape) {
    return std::visit([](const auto& s) -> const b2Shape& { return s; }, shape);
}

}  // namespace testbed
