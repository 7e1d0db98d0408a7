// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Dispatch by shape types.

#include "geometry/collide.h"

#include "scree/convex_shape.h"

namespace scree {

namespace {

/// Adapts a typed collision function to the table.
template <typename A, typename B, void (*Collide)(Manifold*, const A*, const Transform&, const B*, const Transform&)>
void Call(Manifold& manifold, const Shape& shapeA, const Transform& xfA, const Shape& shapeB, const Transform& xfB) {
    Collide(&manifold, static_cast<const A*>(&shapeA), xfA, static_cast<const B*>(&shapeB), xfB);
}

constexpr CollideFunction circles = Call<CircleShape, CircleShape, CollideCircles>;
constexpr CollideFunction polygonCircle = Call<PolygonShape, CircleShape, CollidePolygonAndCircle>;
constexpr CollideFunction polygons = Call<PolygonShape, PolygonShape, CollidePolygons>;
constexpr CollideFunction edgeCircle = Call<EdgeShape, CircleShape, CollideEdgeAndCircle>;
constexpr CollideFunction edgePolygon = Call<EdgeShape, PolygonShape, CollideEdgeAndPolygon>;

void Convex(Manifold& manifold, const Shape& shapeA, const Transform& xfA, const Shape& shapeB, const Transform& xfB) {
    CollideConvex(&manifold, &shapeA, xfA, &shapeB, xfB);
}

// Rows and columns in the order of Shape::Type: circle, edge, polygon, convex.
constexpr CollideEntry table[Shape::e_typeCount][Shape::e_typeCount] = {
    {{circles, false}, {edgeCircle, true}, {polygonCircle, true}, {Convex, true}},
    {{edgeCircle, false}, {nullptr, false}, {edgePolygon, false}, {Convex, false}},
    {{polygonCircle, false}, {edgePolygon, true}, {polygons, false}, {Convex, false}},
    {{Convex, false}, {Convex, true}, {Convex, true}, {Convex, false}},
};

}  // namespace

CollideEntry FindCollide(Shape::Type typeA, Shape::Type typeB) { return table[typeA][typeB]; }

}  // namespace scree
