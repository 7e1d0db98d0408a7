// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d_shape.h.

#include "testbed/engines/box2d_shape.h"

#include <stdexcept>
#include <vector>

#include "scenes/outline.h"

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
            const auto& v = shape.vertices;
            if (shape.IsOneSidedEdge()) {
                edge.SetOneSided(ToB2(v[2]), ToB2(v[0]), ToB2(v[1]), ToB2(v[3]));
            } else {
                edge.SetTwoSided(ToB2(v[0]), ToB2(v[1]));
            }
            return edge;
        }
        case scenes::ShapeType::chain:
            throw std::invalid_argument("a chain is not a single shape: take its children");
        default:
            break;
    }
    throw std::invalid_argument("scene shape of unknown type");
}

scenes::Shape Box2dShapeOf(const scenes::Scene& scene, const scenes::Shape& shape) {
    return scenes::IsFurtherConvex(shape.type) ? scenes::PolygonInstead(scene, shape) : shape;
}

void MakeBox2dChain(const scenes::Scene& scene, const scenes::Shape& shape, b2ChainShape& chain) {
    std::vector<b2Vec2> points;
    for (const scenes::Vec2 v : scene.ChainVerticesOf(shape)) points.push_back(ToB2(v));
    if (shape.IsLoop()) {
        chain.CreateLoop(points.data(), shape.chainVertexCount);
    } else {
        chain.CreateChain(points.data(), shape.chainVertexCount, ToB2(shape.vertices[0]), ToB2(shape.vertices[1]));
    }
}

const b2Shape& AsB2Shape(const Box2dShape& shape) {
    return std::visit([](const auto& s) -> const b2Shape& { return s; }, shape);
}

}  // namespace testbed
