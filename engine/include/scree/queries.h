// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What world queries take and give. Every query runs against the broad phase in use, then against the exact shapes.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/math.h"

namespace scree {

class Body;
class Fixture;

/// Which fixtures a query sees.
struct QueryFilter {
    uint64_t maskBits = ~uint64_t{0};  ///< categories that are seen; all bits: also fixtures of no category
    bool includeSensors = true;
    const Body* ignored = nullptr;  ///< whose fixtures are not seen
    /// Also asked, about fixtures that are seen so far; null: nobody. It must not edit the world.
    bool (*accepts)(const Fixture* fixture, void* context) = nullptr;
    void* context = nullptr;
};

/// One fixture on a ray.
struct RayHit {
    Fixture* fixture;
    Vec2 point;      ///< where the ray enters
    Vec2 normal;     ///< unit, out of the fixture
    float fraction;  ///< of the ray, 0…1
};

/// One fixture in the way of a moving shape.
struct ShapeHit {
    Fixture* fixture;
    Vec2 point;      ///< of touch
    Vec2 normal;     ///< unit, out of the fixture; zero if the shape overlaps it from the start
    float fraction;  ///< of the translation, 0…1
};

/// Box2D 2.4's form of World::QueryAABB's visitor.
class SCREE_API QueryCallback {
public:
    virtual ~QueryCallback() = default;
    /// False ends the query.
    virtual bool ReportFixture(Fixture* fixture) = 0;
};

/// Box2D 2.4's form of World::RayCast's visitor.
class SCREE_API RayCastCallback {
public:
    virtual ~RayCastCallback() = default;
    /// −1 ignores the fixture, 0 ends the cast, `fraction` shortens the ray to this hit, 1 goes on.
    virtual float ReportFixture(Fixture* fixture, const Vec2& point, const Vec2& normal, float fraction) = 0;
};

}  // namespace scree
