// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Explosions and wind over the public interface.

#include "scree/forces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "scree/distance.h"
#include "world/guard.h"

namespace scree {

namespace {

/// Corners of the outline in the order of its turns, in body coordinates; disks and arcs by chords.
std::vector<Vec2> OutlineOf(const Shape& shape) {
    std::vector<Vec2> outline;
    if (shape.GetType() == Shape::e_polygon) {
        const auto& polygon = static_cast<const PolygonShape&>(shape);
        outline.assign(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
    } else if (shape.GetType() == Shape::e_circle || shape.GetType() == Shape::e_convex) {
        constexpr int directions = 32;
        for (int i = 0; i < directions; ++i) {
            const Rot turn(2.0f * pi * static_cast<float>(i) / directions);
            const Vec2 direction{turn.c, turn.s};
            if (shape.GetType() == Shape::e_circle) {
                outline.push_back(static_cast<const CircleShape&>(shape).m_p + shape.m_radius * direction);
            } else {
                const auto& convex = static_cast<const ConvexShape&>(shape);
                outline.push_back(convex.GetSupportPoint(direction) + convex.m_solidRadius * direction);
            }
        }
    }
    return outline;
}

/// How wide a fixture is across a direction, m.
float WidthAcross(const Shape& shape, Vec2 direction) {
    const Vec2 across = direction.Skew();
    float low = 0.0f, high = 0.0f;
    bool isFirst = true;
    const auto add = [&](float x) {
        low = isFirst ? x : Min(low, x);
        high = isFirst ? x : Max(high, x);
        isFirst = false;
    };
    if (shape.GetType() == Shape::e_edge) {
        const auto& edge = static_cast<const EdgeShape&>(shape);
        add(Dot(edge.m_vertex1, across)), add(Dot(edge.m_vertex2, across));
    }
    for (const Vec2 point : OutlineOf(shape)) add(Dot(point, across));
    return high - low;
}

/// The point of a fixture nearest to another, world coordinates.
Vec2 NearestPoint(const Fixture& fixture, Vec2 point) {
    CircleShape dot;
    dot.m_radius = 0.0f;
    DistanceInput input{};
    input.proxyA.Set(fixture.GetShape(), 0);
    input.proxyB.Set(&dot, 0);
    input.transformA = fixture.GetBody()->GetTransform();
    input.transformB.Set(point, 0.0f);
    input.useRadii = true;
    SimplexCache cache;
    DistanceOutput output;
    Distance(&output, &cache, &input);
    return output.pointA;
}

/// One fixture's share of an explosion.
void Push(Fixture& fixture, const ExplosionDef& def) {
    Body& body = *fixture.GetBody();
    const Vec2 nearest = NearestPoint(fixture, def.position);
    Vec2 way = nearest - def.position;
    const float distance = way.Normalize();
    if (distance > def.radius + def.falloff) return;
    if (distance < linearSlop) {  // the centre is inside
        way = body.GetWorldCenter() - def.position;
        if (way.Normalize() < linearSlop) way = {0.0f, 1.0f};
    }
    const float strength = distance > def.radius ? (def.radius + def.falloff - distance) / def.falloff : 1.0f;
    const float width = WidthAcross(*std::as_const(fixture).GetShape(), body.GetLocalVector(way));
    body.ApplyLinearImpulse((strength * width * def.impulsePerWidth) * way, nearest, true);
}

}  // namespace

ErrorCode Explode(World& world, const ExplosionDef& def) {
    Guard guard(world.GetState(), "Explode");
    guard.Unlocked("call it outside of Step and callbacks").Near(def.position, "ExplosionDef::position");
    guard.Amount(def.radius, "ExplosionDef::radius").Amount(def.falloff, "ExplosionDef::falloff");
    if (guard.Finite(def.impulsePerWidth, "ExplosionDef::impulsePerWidth").Failed()) return guard.Code();
    CircleShape reach;
    reach.m_radius = Max(def.radius + def.falloff, linearSlop);
    Transform xf;
    xf.Set(def.position, 0.0f);
    std::vector<Fixture*> reached;
    const auto note = [&](Fixture* fixture) {
        if (fixture->GetBody()->GetType() == dynamicBody) reached.push_back(fixture);
        return true;
    };
    const ErrorCode code = world.OverlapShape(reach, xf, note, def.filter);
    if (code != ErrorCode::ok) return code;
    // The order of the query is the broad phase's.
    std::sort(reached.begin(), reached.end(),
              [](const Fixture* a, const Fixture* b) { return a->GetIndex() < b->GetIndex(); });
    for (Fixture* fixture : reached) Push(*fixture, def);
    return ErrorCode::ok;
}

ErrorCode ApplyWind(Fixture* fixture, const WindDef& wind) {
    if (fixture == nullptr) return ErrorCode::nullArgument;  // no world whose handler could hear of it
    Body* body = fixture->GetBody();
    if (body == nullptr) return ErrorCode::foreignHandle;  // told by GetBody
    Guard guard(body->GetWorld()->GetState(), "ApplyWind");
    if (guard.Near(wind.velocity, "WindDef::velocity").Amount(wind.density, "WindDef::density").Failed())
        return guard.Code();
    if (body->GetType() != dynamicBody || (!body->IsAwake() && !wind.wake)) return ErrorCode::ok;
    const std::vector<Vec2> outline = OutlineOf(*std::as_const(*fixture).GetShape());
    Vec2 force = vec2Zero;
    float torque = 0.0f;
    for (size_t i = 0; i < outline.size(); ++i) {
        const Vec2 from = outline[i], to = outline[(i + 1) % outline.size()];
        const Vec2 middle = 0.5f * (from + to);
        // The outline goes counter-clockwise: outwards is to the right. Its length is that of the side.
        const Vec2 side = body->GetWorldVector(Cross(to - from, 1.0f));
        const float length = side.Length();
        if (length == 0.0f) continue;
        const Vec2 normal = (1.0f / length) * side;
        const float speed = -Dot(normal, wind.velocity - body->GetLinearVelocityFromLocalPoint(middle));
        if (speed <= 0.0f) continue;
        const Vec2 push = (-wind.density * length * speed * speed) * normal;
        force += push;
        torque += Cross(body->GetWorldVector(middle - body->GetLocalCenter()), push);
    }
    if (force == vec2Zero && torque == 0.0f) return ErrorCode::ok;
    const ErrorCode code = body->ApplyForceToCenter(force, wind.wake);
    return code == ErrorCode::ok ? body->ApplyTorque(torque, wind.wake) : code;
}

}  // namespace scree
