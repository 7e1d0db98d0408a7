// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scree_shape.h.

#include "testbed/engines/scree_shape.h"

#include <span>
#include <stdexcept>
#include <type_traits>

#include "scenes/outline.h"

namespace testbed {

namespace {

std::vector<scree::Vec2> Convert(std::span<const scenes::Vec2> points) {
    std::vector<scree::Vec2> out;
    for (const scenes::Vec2 v : points) out.push_back(ToScree(v));
    return out;
}

scree::ConvexShape MakeSupported(const scenes::Shape& shape) {
    scree::SupportDef def;
    def.data = &shape;
    def.support = [](const void* data, scree::Vec2 direction) {
        return ToScree(static_cast<const scenes::Shape*>(data)->support(FromScree(direction)));
    };
    def.boundingRadius = shape.radius;
    return scree::MakeFromSupport(def);
}

scree::ConvexShape MakeConvex(const scenes::Scene& scene, const scenes::Shape& shape) {
    const std::vector<scree::Vec2> points =
        Convert(shape.type == scenes::ShapeType::largePolygon ? scene.ChainVerticesOf(shape) : shape.Vertices());
    const int count = static_cast<int>(points.size());
    switch (shape.type) {
        case scenes::ShapeType::capsule:
            return scree::MakeCapsule(points[0], points[1], shape.radius);
        case scenes::ShapeType::roundedPolygon:
            return scree::MakeRoundedPolygon(points.data(), count, shape.radius);
        case scenes::ShapeType::ellipse:
            return scree::MakeEllipse(shape.halfExtents.x, shape.halfExtents.y, ToScree(shape.center), shape.angle);
        case scenes::ShapeType::sector:
            return scree::MakeCircleSector(shape.radius, shape.opening, ToScree(shape.center), shape.angle);
        case scenes::ShapeType::supported:
            return MakeSupported(shape);
        default:
            return scree::MakePolygon(points.data(), count);
    }
}

}  // namespace

ScreeShape MakeScreeShape(const scenes::Scene& scene, const scenes::Shape& shape) {
    if (scenes::IsFurtherConvex(shape.type)) {
        auto convex = std::make_shared<const scree::ConvexShape>(MakeConvex(scene, shape));
        if (!convex->Validate()) throw std::invalid_argument("scene shape is degenerate");
        return convex;
    }
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
            throw std::invalid_argument("a chain is not a single shape: take its children");
        default:
            break;
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
    return std::visit(
        []<typename S>(const S& s) -> const scree::Shape& {
            if constexpr (std::is_base_of_v<scree::Shape, S>) {
                return s;
            } else {
                return *s;
            }
        },
        shape);
}

}  // namespace testbed
