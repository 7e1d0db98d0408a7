// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Collide and slide.

#include "scree/mover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/outline.h"
#include "scree/collision.h"
#include "scree/convex_shape.h"
#include "world/guard.h"

namespace scree {

namespace {

ConvexShape ShapeOf(const MoverCapsule& capsule, float margin) {
    return MakeCapsule(capsule.point1, capsule.point2, capsule.radius + margin);
}

Transform At(Vec2 position) {
    Transform xf;
    xf.Set(position, 0.0f);
    return xf;
}

Guard& CheckCapsule(Guard& guard, const MoverCapsule& capsule) {
    guard.Near(capsule.point1, "MoverCapsule::point1").Near(capsule.point2, "MoverCapsule::point2");
    return guard.Near(capsule.radius, "MoverCapsule::radius")
        .Require(capsule.radius > 0.0f, ErrorCode::outOfRange, "MoverCapsule::radius", "give a radius above 0");
}

/// The plane of one fixture; false if it is farther than the margin.
bool MakePlane(Fixture& fixture, const ConvexShape& grown, Vec2 position, float margin, float lengthScale,
               MoverPlane& plane) {
    const Shape& shape = *std::as_const(fixture).GetShape();
    const Transform xf = fixture.GetBody()->GetTransform(), at = At(position);
    Manifold manifold;
    manifold.pointCount = 0;
    CollideConvex(&manifold, &shape, xf, &grown, at);
    if (manifold.pointCount == 0) return false;
    WorldManifold world;
    world.Initialize(&manifold, xf, shape.m_radius, at, grown.m_radius);
    const int nearest = manifold.pointCount == 2 && world.separations[1] < world.separations[0] ? 1 : 0;
    const float separation = world.separations[nearest];
    const float skin = shape.m_radius - OutlineRadius(shape, lengthScale);
    // The point is midway between both surfaces.
    plane = {.fixture = &fixture,
             .normal = world.normal,
             .point = world.points[nearest] - (0.5f * separation + skin) * world.normal,
             .separation = separation + margin + skin};
    return true;
}

/// How much of its way a capsule can go until it is `margin` away from the outline of a fixture. 1 where it overlaps it
/// from the start.
float ShareTo(const WorldState& s, const Fixture& fixture, const MoverCapsule& capsule, Vec2 position, Vec2 translation,
              float margin) {
    const Shape& shape = *fixture.GetShape();
    const ConvexShape core = ShapeOf(capsule, 0.0f);
    const BodyPlace place(s.bodies, s.fixtures.body[FixtureIndex{fixture.GetIndex()}]);
    DistanceInput start;
    start.proxyA.Set(&shape, 0);
    start.proxyB.Set(&core, 0);
    start.transformA = place.xf;
    start.transformB = place.In(At(position));
    start.useRadii = false;
    SimplexCache cache;
    DistanceOutput nearest;
    Distance(&nearest, &cache, &start);
    const float radii = OutlineRadius(shape, s.def.lengthScale) + capsule.radius;
    const float gap = nearest.distance - radii;
    if (gap <= 0.0f) return 1.0f;
    if (gap <= margin + linearSlop) {
        // Too near for the cast. What is nearer than the margin may come nearer by half of that: along a wall rounding
        // must not stop the way.
        const Vec2 normal = (1.0f / nearest.distance) * (nearest.pointB - nearest.pointA);
        const float closing = -Dot(normal, translation);
        return closing > 0.0f ? Min(Max(gap - margin, 0.5f * gap) / closing, 1.0f) : 1.0f;
    }
    // A cast takes one default skin off both radii.
    ShapeCastInput input{start.proxyA, start.proxyB, start.transformA, start.transformB, translation};
    input.proxyA.m_radius = polygonRadius;
    input.proxyB.m_radius = radii + margin;
    ShapeCastOutput output;
    return ShapeCast(&output, &input) ? output.lambda : 1.0f;
}

/// A capsule on its way through a world: the parts of MoveMover.
class Walk {
public:
    Walk(World& world, const MoverDef& def) : m_world(world), m_def(def), m_level(Rot(def.maxSlope).c) {}

    /// Goes by `wish` as far as it can along what it meets. Returns the planes that were in the way. For one who walks
    /// what is too steep to stand on is a wall.
    const std::vector<MoverPlane>& Slide(Vec2& position, Vec2 wish, bool walks) {
        constexpr int rounds = 5;
        const Vec2 target = position + wish;
        m_met.clear();
        for (int round = 0; round < rounds; ++round) {
            const Vec2 left = target - position;
            // Far enough ahead that all that is met in this round is a plane.
            (void)CollideMover(m_world, m_def.capsule, position, 2.0f * m_def.skin, m_def.filter, m_planes);
            for (MoverPlane& plane : m_planes) {
                plane.separation -= m_def.skin;
                if (walks) MakeUpright(plane);
            }
            const Vec2 way = SolvePlanes(left, m_planes);
            for (const MoverPlane& plane : m_planes) {
                if (plane.push > 0.0f) m_met.push_back(plane);
            }
            const float share = Cast(position, way);
            const Vec2 step = share * way;
            position += step;
            if (step.LengthSquared() < 0.01f * m_def.skin * m_def.skin) break;
        }
        return m_met;
    }
    void MakeUpright(MoverPlane& plane) const {
        const float rise = Dot(plane.normal, m_def.up);
        if (rise <= 0.0f || rise >= m_level) return;
        plane.normal -= rise * m_def.up;
        plane.separation /= plane.normal.Normalize();
    }
    [[nodiscard]] float Cast(Vec2 position, Vec2 way) const {
        return CastMover(m_world, m_def.capsule, position, way, m_def.skin, m_def.filter);
    }
    [[nodiscard]] bool IsGround(Vec2 normal) const { return Dot(normal, m_def.up) >= m_level; }
    /// The flattest ground within `reach` below the position; null without one.
    const MoverPlane* FindGround(Vec2 position, float reach) {
        (void)CollideMover(m_world, m_def.capsule, position, m_def.skin + reach, m_def.filter, m_planes);
        const MoverPlane* best = nullptr;
        for (const MoverPlane& plane : m_planes) {
            if (!IsGround(plane.normal)) continue;
            if (best == nullptr || Dot(plane.normal, m_def.up) > Dot(best->normal, m_def.up)) best = &plane;
        }
        return best;
    }
    /// Down onto ground that is at most `height` below; false if there is none. Who stands stays.
    bool Lower(Vec2& position, float height) {
        if (FindGround(position, m_def.skin) != nullptr) return true;
        const Vec2 down = -(height + m_def.skin) * m_def.up;
        const float share = Cast(position, down);
        if (share >= 1.0f) return false;
        const Vec2 there = position + share * down;
        if (FindGround(there, m_def.skin) == nullptr) return false;
        position = there;
        return true;
    }
    /// Tries to go on by `wish` from a step's height above. True if that brings it farther, onto ground.
    bool StepUp(Vec2& position, Vec2 start, Vec2 wish) {
        const Vec2 way = wish - Dot(wish, m_def.up) * m_def.up;
        const float length = way.Length();
        if (length == 0.0f || m_def.stepHeight == 0.0f) return false;
        const Vec2 ahead = (1.0f / length) * way;
        const float before = Dot(position - start, ahead);
        if (before > 0.9f * length) return false;
        const Vec2 up = m_def.stepHeight * m_def.up;
        const float rise = Cast(start, up);
        Vec2 there = start + rise * up;
        // At least so far that the edge is under what it can stand on.
        const float onEdge = m_def.capsule.radius * (1.0f - std::sqrt(1.0f - m_level * m_level)) + 2.0f * m_def.skin;
        const Vec2 reach = (Max(length, onEdge) + m_def.skin) * ahead;
        const float share = Cast(there, reach);
        there += share * reach;
        if (Dot(there - start, ahead) <= before + 0.1f * length) return false;
        if (!Lower(there, rise * m_def.stepHeight)) return false;
        if (Dot(there - start, m_def.up) <= m_def.skin) return false;  // no step: level ground was in the way of a wall
        position = there;
        return true;
    }

private:
    World& m_world;
    const MoverDef& m_def;
    float m_level;  ///< least cosine of a normal of ground
    std::vector<MoverPlane> m_planes, m_met;
};

float GapOf(const MoverPlane& plane, Vec2 way) { return Dot(plane.normal, way) + plane.separation; }

/// Of the points on plane `at` that the planes before it allow, the nearest to `wish`, with the pushes that lead to it.
/// None if there is no such point, or if planes that face each other are so near to parallel that it lies far away. As
/// the sum of squares is convex, a point that a further plane forbids moves onto that plane. Source: Seidel,
/// "Small-Dimensional Linear Programming and Convex Hulls Made Easy", 1991, here for a quadratic aim.
std::optional<Vec2> SolveOnPlane(Vec2 wish, std::span<MoverPlane> planes, size_t at) {
    constexpr float leastSine = 0.05f;
    MoverPlane& plane = planes[at];
    const Vec2 foot = wish - GapOf(plane, wish) * plane.normal, along = plane.normal.Skew();
    float low = -std::numeric_limits<float>::max(), high = -low;
    size_t lowest = at, highest = at;
    for (size_t j = 0; j < at; ++j) {
        planes[j].push = 0.0f;
        const float sine = Dot(planes[j].normal, along), gap = GapOf(planes[j], foot);
        if (Abs(sine) < leastSine && Dot(planes[j].normal, plane.normal) < 0.0f && gap < 0.0f) return std::nullopt;
        if (sine == 0.0f) continue;
        const float bound = -gap / sine;
        if (sine > 0.0f && bound > low) low = bound, lowest = j;
        if (sine < 0.0f && bound < high) high = bound, highest = j;
    }
    if (low > high) return std::nullopt;
    const float place = Clamp(0.0f, low, high);
    const Vec2 way = foot + place * along, pushed = way - wish;
    plane.push = Max(Dot(plane.normal, pushed), 0.0f);
    const size_t corner = low > 0.0f ? lowest : high < 0.0f ? highest : at;
    if (corner != at) {
        const float sine = Cross(plane.normal, planes[corner].normal);
        plane.push = Max(Cross(pushed, planes[corner].normal) / sine, 0.0f);
        planes[corner].push = Max(Cross(plane.normal, pushed) / sine, 0.0f);
    }
    return way;
}

/// Where planes leave no room: gives way to all of them in turn (Hildreth's method, 1957).
Vec2 SolveTight(Vec2 wish, std::span<MoverPlane> planes) {
    constexpr int mostRounds = 32;
    constexpr float tolerance = 1e-6f;  // m
    for (MoverPlane& plane : planes) plane.push = 0.0f;
    Vec2 way = wish;
    for (int round = 0; round < mostRounds; ++round) {
        float change = 0.0f;
        for (MoverPlane& plane : planes) {
            const float push = Max(plane.push - GapOf(plane, way), 0.0f);
            way += (push - plane.push) * plane.normal;
            change = Max(change, Abs(push - plane.push));
            plane.push = push;
        }
        if (change < tolerance) break;
    }
    return way;
}

}  // namespace

ErrorCode CollideMover(const World& world, const MoverCapsule& capsule, Vec2 position, float margin,
                       const QueryFilter& filter, std::vector<MoverPlane>& planes) {
    planes.clear();
    Guard guard(world.GetState(), "CollideMover");
    CheckCapsule(guard, capsule).Near(position, "position").Amount(margin, "margin");
    if (guard.Failed()) return guard.Code();
    const ConvexShape grown = ShapeOf(capsule, margin);
    const auto add = [&](Fixture* fixture) {
        MoverPlane plane;
        const float scale = world.GetState().def.lengthScale;
        if (MakePlane(*fixture, grown, position, margin, scale, plane) && plane.separation <= margin) {
            planes.push_back(plane);
        }
        return true;
    };
    const ErrorCode code = world.OverlapShape(grown, At(position), add, filter);
    // The order of the query is the broad phase's.
    std::sort(planes.begin(), planes.end(),
              [](const MoverPlane& a, const MoverPlane& b) { return a.fixture->GetIndex() < b.fixture->GetIndex(); });
    return code;
}

Vec2 SolvePlanes(Vec2 wish, std::span<MoverPlane> planes) {
    for (MoverPlane& plane : planes) plane.push = 0.0f;
    Vec2 way = wish;
    for (size_t i = 0; i < planes.size(); ++i) {
        if (GapOf(planes[i], way) >= 0.0f) continue;
        const auto nearest = SolveOnPlane(wish, planes, i);
        if (!nearest) return SolveTight(wish, planes);
        way = *nearest;
    }
    return way;
}

Vec2 ClipVelocity(Vec2 velocity, std::span<const MoverPlane> planes) {
    constexpr int rounds = 8;
    for (int round = 0; round < rounds; ++round) {
        bool changed = false;
        for (const MoverPlane& plane : planes) {
            const float into = Dot(plane.normal, velocity);
            if (plane.push == 0.0f || into >= 0.0f) continue;
            velocity -= into * plane.normal;
            changed = true;
        }
        if (!changed) break;
    }
    return velocity;
}

float CastMover(const World& world, const MoverCapsule& capsule, Vec2 position, Vec2 translation, float margin,
                const QueryFilter& filter) {
    Guard guard(world.GetState(), "CastMover");
    CheckCapsule(guard, capsule).Near(position, "position").Near(translation, "translation").Amount(margin, "margin");
    if (guard.Failed()) return 0.0f;
    if (translation.Length() == 0.0f) return 1.0f;
    std::vector<ShapeHit> hits;
    const ConvexShape grown = ShapeOf(capsule, margin);
    if (world.ShapeCast(grown, At(position), translation, hits, filter) != ErrorCode::ok) return 0.0f;
    float share = 1.0f;
    for (const ShapeHit& hit : hits) {
        share = Min(share, ShareTo(world.GetState(), *hit.fixture, capsule, position, translation, margin));
    }
    return share;
}

MoverState MoveMover(World& world, const MoverDef& def, const MoverState& state, float timeStep) {
    Guard guard(world.GetState(), "MoveMover");
    CheckCapsule(guard, def.capsule).Near(state.position, "MoverState::position");
    guard.Near(state.velocity, "MoverState::velocity").Amount(def.stepHeight, "MoverDef::stepHeight");
    guard.Require(Abs(def.up.Length() - 1.0f) < 1e-3f, ErrorCode::outOfRange, "MoverDef::up", "give a unit vector");
    guard.Require(def.maxSlope >= 0.0f && def.maxSlope <= 0.5f * pi, ErrorCode::outOfRange, "MoverDef::maxSlope",
                  "give an angle from 0 to π/2");
    guard.Require(def.skin > 0.0f && std::isfinite(def.skin), ErrorCode::outOfRange, "MoverDef::skin",
                  "give a distance above 0");
    guard.Require(timeStep > 0.0f && std::isfinite(timeStep), ErrorCode::outOfRange, "timeStep",
                  "give the time of the move, in seconds");
    if (guard.Failed()) return state;

    Walk walk(world, def);
    MoverState moved = state;
    const Fixture* ground = state.isGrounded ? world.Find(state.ground) : nullptr;
    const Vec2 carried =
        ground == nullptr ? vec2Zero : ground->GetBody()->GetLinearVelocityFromWorldPoint(state.groundPoint);
    if (!(carried == vec2Zero)) (void)walk.Slide(moved.position, timeStep * carried, false);

    // Who walks goes along the ground, up or down, as fast as on the level.
    constexpr float jumpSpeed = 0.01f;  // m/s
    const float rising = Dot(state.velocity, def.up);
    const bool jumps = state.isGrounded && rising > jumpSpeed && Dot(state.velocity, state.groundNormal) > jumpSpeed;
    const bool rises = !state.isGrounded && rising > 0.0f;
    const bool walks = state.isGrounded && !jumps;
    Vec2 wish = timeStep * state.velocity;
    if (walks) {
        const Vec2 along = state.groundNormal.Skew();
        const float way = Dot(along, wish);
        wish = Abs(way) < 1e-3f * wish.Length() ? vec2Zero : (way < 0.0f ? -wish.Length() : wish.Length()) * along;
    }
    const Vec2 start = moved.position;
    const std::vector<MoverPlane> met = walk.Slide(moved.position, wish, walks);
    const bool hasStepped = walks && walk.StepUp(moved.position, start, wish);
    if (!hasStepped) moved.velocity = ClipVelocity(state.velocity, met);
    if (walks && !hasStepped) (void)walk.Lower(moved.position, def.stepHeight);

    const bool leaves = Dot(moved.velocity, def.up) > 0.0f && (jumps || rises);
    const MoverPlane* under = leaves ? nullptr : walk.FindGround(moved.position, def.skin);
    moved.isGrounded = under != nullptr;
    moved.groundNormal = under != nullptr ? under->normal : vec2Zero;
    moved.groundPoint = under != nullptr ? under->point : vec2Zero;
    moved.ground = under != nullptr ? world.GetId(under->fixture) : FixtureId{};
    if (state.isGrounded && !moved.isGrounded) moved.velocity += carried;
    return moved;
}

}  // namespace scree
