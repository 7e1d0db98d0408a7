// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d3_shape.h.

#include "testbed/engines/box2d3/box2d3_shape.h"

#include <stdexcept>

#include "scenes/outline.h"

namespace testbed::box2d3 {

scenes::Shape ShownShape(const scenes::Scene& scene, const scenes::Shape& shape) {
    const bool isOwn = !scenes::IsFurtherConvex(shape.type) || shape.type == scenes::ShapeType::capsule;
    return isOwn ? shape : scenes::PolygonInstead(scene, shape);
}

Shape MakeShape(const scenes::Scene& scene, const scenes::Shape& original) {
    const scenes::Shape shape = ShownShape(scene, original);
    switch (shape.type) {
        case scenes::ShapeType::circle:
            return b2Circle{ToB2(shape.center), shape.radius};
        case scenes::ShapeType::capsule:
            return b2Capsule{ToB2(shape.vertices[0]), ToB2(shape.vertices[1]), shape.radius};
        case scenes::ShapeType::box:
            return b2MakeOffsetBox(shape.halfExtents.x, shape.halfExtents.y, ToB2(shape.center),
                                   b2MakeRot(shape.angle));
        case scenes::ShapeType::polygon: {
            b2Vec2 points[scenes::maxPolygonVertices];
            int count = 0;
            for (const scenes::Vec2 v : shape.Vertices()) points[count++] = ToB2(v);
            const b2Hull hull = b2ComputeHull(points, count);
            if (hull.count < 3) throw std::invalid_argument("Box2D 3 cannot make a polygon of these vertices");
            return b2MakePolygon(&hull, 0.0f);
        }
        case scenes::ShapeType::edge:
            return b2Segment{ToB2(shape.vertices[0]), ToB2(shape.vertices[1])};
        default:
            throw std::invalid_argument("a chain is not a single shape: take its children");
    }
}

b2AABB ComputeBox(const Shape& shape, b2WorldTransform pose) {
    struct Visitor {
        b2WorldTransform pose;
        b2AABB operator()(const b2Circle& s) const { return b2ComputeCircleAABB(&s, pose); }
        b2AABB operator()(const b2Capsule& s) const { return b2ComputeCapsuleAABB(&s, pose); }
        b2AABB operator()(const b2Polygon& s) const { return b2ComputePolygonAABB(&s, pose); }
        b2AABB operator()(const b2Segment& s) const { return b2ComputeSegmentAABB(&s, pose); }
    };
    return std::visit(Visitor{pose}, shape);
}

}  // namespace testbed::box2d3
