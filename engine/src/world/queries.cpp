// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// World queries: the broad phase gives candidates by their boxes, the geometry functions decide. They only read, so
// threads may ask at the same time; the forms that call the program hold the world locked meanwhile.

#include "scree/queries.h"

#include <algorithm>

#include "scree/distance.h"
#include "state/frames.h"
#include "world/guard.h"

namespace scree {

namespace {

bool Sees(const QueryFilter& filter, const FixtureTable& fixtures, FixtureIndex fixture) {
    if (!filter.includeSensors && fixtures.isSensor[fixture] != 0) return false;
    if (filter.ignored != nullptr && IndexOf(*filter.ignored) == fixtures.body[fixture]) return false;
    if (filter.maskBits != ~uint64_t{0} && (filter.maskBits & fixtures.filter[fixture].categoryBits) == 0) return false;
    return filter.accepts == nullptr || filter.accepts(&fixtures.handles[fixture], filter.context);
}

/// Programs may change a fixture that a const query gave them.
Fixture* HandleOf(const WorldState& s, FixtureIndex fixture) {
    return const_cast<Fixture*>(&s.fixtures.handles[fixture]);
}

BodyPlace PlaceOf(const WorldState& s, FixtureIndex fixture) { return {s.bodies, s.fixtures.body[fixture]}; }

bool Contains(const WorldState& s, FixtureIndex fixture, Vec2 point) {
    const BodyPlace place = PlaceOf(s, fixture);
    return s.fixtures.shape[fixture]->TestPoint(place.xf, point - place.frame);
}

/// Exact ray casts on the broad phase's candidates: visit(input, fixture, hit) answers as in World::RayCast.
template <typename Visit>
void CastRay(const WorldState& s, Vec2 p1, Vec2 p2, Visit visit) {
    s.broadPhase->RayCast({p1, p2, 1.0f}, [&](const RayCastInput& input, uint32_t proxy) {
        const FixtureIndex f = FixtureOf(proxy);
        RayCastOutput hit;
        const BodyPlace place = PlaceOf(s, f);
        const RayCastInput ray{input.p1 - place.frame, input.p2 - place.frame, input.maxFraction};
        if (!s.fixtures.shape[f]->RayCast(&hit, ray, place.xf)) return input.maxFraction;
        return visit(input, f, hit);
    });
}

Vec2 PointOnRay(const RayCastInput& input, float fraction) {
    return (1.0f - fraction) * input.p1 + fraction * input.p2;
}

Guard& CheckRay(Guard& guard, Vec2 p1, Vec2 p2) {
    guard.Require(p1.IsValid() && p2.IsValid(), ErrorCode::nonFinite, "p1, p2", "give finite points");
    return guard.Require(DistanceSquared(p1, p2) > 0.0f, ErrorCode::outOfRange, "p1, p2", "give two different points");
}

/// A shape that can be compared with others: valid and no chain.
Guard& CheckConvex(Guard& guard, const Shape& shape, const Transform& xf) {
    guard.Accept(Check(shape));
    guard.Require(shape.GetType() != Shape::e_chain, ErrorCode::badShape, "shape",
                  "query with the chain's edges one by one");
    guard.Finite(xf.p, "xf").Finite(xf.q.s, "xf");
    return guard.Finite(xf.q.c, "xf");
}

/// The shape on its way against one fixture; fraction 0 and no normal if they overlap from the start.
std::optional<ShapeHit> CastAgainst(const WorldState& s, FixtureIndex f, const Shape& shape, const Transform& xf,
                                    Vec2 translation) {
    Fixture* fixture = HandleOf(s, f);
    ShapeCastInput input;
    input.proxyA.Set(s.fixtures.shape[f], 0);
    input.proxyB.Set(&shape, 0);
    const BodyPlace place = PlaceOf(s, f);
    input.transformA = place.xf;
    input.transformB = place.In(xf);
    input.translationB = translation;
    if (TestOverlap(s.fixtures.shape[f], 0, &shape, 0, input.transformA, input.transformB)) {
        DistanceInput near{input.proxyA, input.proxyB, input.transformA, input.transformB, true};
        SimplexCache cache;
        DistanceOutput closest;
        Distance(&closest, &cache, &near);
        return ShapeHit{fixture, place.frame + closest.pointA, vec2Zero, 0.0f};
    }
    ShapeCastOutput output;
    if (!ShapeCast(&output, &input)) return std::nullopt;
    return ShapeHit{fixture, place.frame + output.point, output.normal, output.lambda};
}

/// In the order of touch; ties by fixture index, so that no algorithm shows.
bool IsSooner(const ShapeHit& a, const ShapeHit& b) {
    return a.fraction != b.fraction ? a.fraction < b.fraction : a.fixture->GetIndex() < b.fixture->GetIndex();
}

/// What is in the way of the shape: visit(hit) returns how much of the way still matters, a negative number for as much
/// as before.
template <typename Visit>
void CastShape(const WorldState& s, const Shape& shape, const Transform& xf, Vec2 translation,
               const QueryFilter& filter, Visit visit) {
    /// Shapes count as touching before their boxes do, by less than that: cores are that thick at least.
    constexpr float thickness = 2.0f * polygonRadius;
    AABB start;
    shape.ComputeAABB(&start, xf);
    start.lowerBound -= {thickness, thickness}, start.upperBound += {thickness, thickness};
    const AABB swept = Union(start, {start.lowerBound + translation, start.upperBound + translation});
    const RayCastInput path{start.GetCenter(), start.GetCenter() + translation, 1.0f};
    s.broadPhase->CastBox(path, start.GetExtents(), [&](const RayCastInput&, uint32_t proxy) {
        const FixtureIndex f = FixtureOf(proxy);
        if (!Sees(filter, s.fixtures, f)) return -1.0f;
        if (!TestOverlap(s.broadPhase->GetBox(proxy), swept)) return -1.0f;
        const auto hit = CastAgainst(s, f, shape, xf, translation);
        return hit ? visit(*hit) : -1.0f;
    });
}

}  // namespace

ErrorCode World::PrepareQueries() {
    Guard guard(*m_state, "World::PrepareQueries");
    if (guard.Unlocked("call it outside of callbacks").Failed()) return guard.Code();
    m_state->broadPhase->PrepareQueries();
    return ErrorCode::ok;
}

ErrorCode World::QueryAABB(const AABB& aabb, FunctionRef<bool(Fixture*)> visit) const {
    const WorldState& s = *m_state;
    Guard guard(s, "World::QueryAABB");
    guard.NotNull(visit != nullptr, "visit", "pass a function");
    guard.Require(aabb.IsValid(), ErrorCode::outOfRange, "aabb", "give finite bounds with lower ≤ upper");
    if (guard.Failed()) return guard.Code();
    const WorldLock lock(s);
    s.broadPhase->Query(aabb, [&](uint32_t proxy) { return visit(HandleOf(s, FixtureOf(proxy))); });
    return ErrorCode::ok;
}

ErrorCode World::QueryAABB(QueryCallback* callback, const AABB& aabb) const {
    Guard guard(*m_state, "World::QueryAABB");
    if (guard.NotNull(callback != nullptr, "callback", "pass a QueryCallback").Failed()) return guard.Code();
    return QueryAABB(aabb, [callback](Fixture* fixture) { return callback->ReportFixture(fixture); });
}

ErrorCode World::RayCast(Vec2 p1, Vec2 p2, FunctionRef<float(Fixture*, Vec2, Vec2, float)> visit) const {
    const WorldState& s = *m_state;
    Guard guard(s, "World::RayCast");
    guard.NotNull(visit != nullptr, "visit", "pass a function");
    if (CheckRay(guard, p1, p2).Failed()) return guard.Code();
    const WorldLock lock(s);
    CastRay(s, p1, p2, [&](const RayCastInput& input, FixtureIndex f, const RayCastOutput& hit) {
        return visit(HandleOf(s, f), PointOnRay(input, hit.fraction), hit.normal, hit.fraction);
    });
    return ErrorCode::ok;
}

ErrorCode World::RayCast(RayCastCallback* callback, Vec2 p1, Vec2 p2) const {
    Guard guard(*m_state, "World::RayCast");
    if (guard.NotNull(callback != nullptr, "callback", "pass a RayCastCallback").Failed()) return guard.Code();
    return RayCast(p1, p2, [callback](Fixture* fixture, Vec2 point, Vec2 normal, float fraction) {
        return callback->ReportFixture(fixture, point, normal, fraction);
    });
}

std::optional<RayHit> World::RayCastClosest(Vec2 p1, Vec2 p2, const QueryFilter& filter) const {
    const WorldState& s = *m_state;
    Guard guard(s, "World::RayCastClosest");
    if (CheckRay(guard, p1, p2).Failed()) return std::nullopt;
    std::optional<RayHit> best;
    CastRay(s, p1, p2, [&](const RayCastInput& input, FixtureIndex f, const RayCastOutput& hit) {
        if (!Sees(filter, s.fixtures, f)) return -1.0f;
        Fixture* fixture = HandleOf(s, f);
        // The smaller index wins a tie, so that no algorithm shows.
        const bool nearer = !best || hit.fraction < best->fraction ||
                            (hit.fraction == best->fraction && fixture->GetIndex() < best->fixture->GetIndex());
        if (nearer) best = RayHit{fixture, PointOnRay(input, hit.fraction), hit.normal, hit.fraction};
        // A hit right at the start may not end the cast before ties are settled; −1 leaves the ray as it is.
        return hit.fraction > 0.0f ? hit.fraction : -1.0f;
    });
    return best;
}

ErrorCode World::RayCastAll(Vec2 p1, Vec2 p2, std::vector<RayHit>& hits, const QueryFilter& filter) const {
    const WorldState& s = *m_state;
    Guard guard(s, "World::RayCastAll");
    if (CheckRay(guard, p1, p2).Failed()) return guard.Code();
    hits.clear();
    CastRay(s, p1, p2, [&](const RayCastInput& input, FixtureIndex f, const RayCastOutput& hit) {
        if (Sees(filter, s.fixtures, f)) {
            hits.push_back({HandleOf(s, f), PointOnRay(input, hit.fraction), hit.normal, hit.fraction});
        }
        return -1.0f;
    });
    std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
        return a.fraction != b.fraction ? a.fraction < b.fraction : a.fixture->GetIndex() < b.fixture->GetIndex();
    });
    return ErrorCode::ok;
}

ErrorCode World::QueryPoint(Vec2 point, FunctionRef<bool(Fixture*)> visit, const QueryFilter& filter) const {
    const WorldState& s = *m_state;
    Guard guard(s, "World::QueryPoint");
    if (guard.NotNull(visit != nullptr, "visit", "pass a function").Finite(point, "point").Failed())
        return guard.Code();
    const WorldLock lock(s);
    s.broadPhase->Query({point, point}, [&](uint32_t proxy) {
        const FixtureIndex f = FixtureOf(proxy);
        if (!Sees(filter, s.fixtures, f) || !Contains(s, f, point)) return true;
        return visit(HandleOf(s, f));
    });
    return ErrorCode::ok;
}

ErrorCode World::OverlapShape(const Shape& shape, const Transform& xf, FunctionRef<bool(Fixture*)> visit,
                              const QueryFilter& filter) const {
    const WorldState& s = *m_state;
    Guard guard(s, "World::OverlapShape");
    guard.NotNull(visit != nullptr, "visit", "pass a function");
    if (CheckConvex(guard, shape, xf).Failed()) return guard.Code();
    AABB box;
    shape.ComputeAABB(&box, xf);
    const WorldLock lock(s);
    s.broadPhase->Query(box, [&](uint32_t proxy) {
        const FixtureIndex f = FixtureOf(proxy);
        if (!Sees(filter, s.fixtures, f)) return true;
        const BodyPlace place = PlaceOf(s, f);
        if (!TestOverlap(s.fixtures.shape[f], 0, &shape, 0, place.xf, place.In(xf))) return true;
        return visit(HandleOf(s, f));
    });
    return ErrorCode::ok;
}

ErrorCode World::ShapeCast(const Shape& shape, const Transform& xf, Vec2 translation, std::vector<ShapeHit>& hits,
                           const QueryFilter& filter) const {
    Guard guard(*m_state, "World::ShapeCast");
    if (CheckConvex(guard, shape, xf).Finite(translation, "translation").Failed()) return guard.Code();
    hits.clear();
    CastShape(*m_state, shape, xf, translation, filter, [&](const ShapeHit& hit) {
        hits.push_back(hit);
        return -1.0f;
    });
    std::sort(hits.begin(), hits.end(), IsSooner);
    return ErrorCode::ok;
}

std::optional<ShapeHit> World::ShapeCastClosest(const Shape& shape, const Transform& xf, Vec2 translation,
                                                const QueryFilter& filter) const {
    Guard guard(*m_state, "World::ShapeCastClosest");
    if (CheckConvex(guard, shape, xf).Finite(translation, "translation").Failed()) return std::nullopt;
    std::optional<ShapeHit> best;
    CastShape(*m_state, shape, xf, translation, filter, [&](const ShapeHit& hit) {
        if (!best || IsSooner(hit, *best)) best = hit;
        // What overlaps from the start may not end the cast before ties are settled.
        return hit.fraction > 0.0f ? hit.fraction : -1.0f;
    });
    return best;
}

}  // namespace scree
