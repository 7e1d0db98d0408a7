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
            const auto& v = shape.vertices;
            if (shape.IsOneSidedEdge()) {
                edge.SetOneSided(ToScree(v[2]), ToScree(v[0]), ToScree(v[1]), ToScree(v[3]));
            } else {
                edge.SetTwoSided(ToScree(v[0]), ToScree(v[1]));
            }
            return edge;
        }
        case scenes::ShapeType::chain:
            throw std::invalid_argument("a chain is no single shape: take its children");
    }
    throw std::invalid_argument("scene shape of unknown type");
}

scree::ChainShape MakeScreeChain(const scenes::Scene& scene, const scenes::Shape& shape) {
    std::vector<scree::Vec2> points;
    for (const scenes::Vec2 v : scene.ChainVerticesOf(shape)) points.push_back(ToScree(v));
    const int count = shape.chainVertexCount;
    scree::ChainShape chain;
    const bool isGood = shape.IsLoop() ? chain.CreateLoop(points.data(), count)
                                       : chain.CreateChain(points.data(), count, ToScree(shape.vertices[0]),
                                                           ToScree(shape.vertices[1]));
    if (!isGood) throw std::invalid_argument("scene chain is degenerate");
    return chain;
}

const scree::Shape& AsShape(const ScreeShape& shape) {
    return std::visit([](const auto& s) -> const scree::Shape& { return s; }, shape);
}

}  // namespace testbed
