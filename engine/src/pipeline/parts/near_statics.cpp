// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The ball is centred a step ahead and some steps wide. A static fixture belongs to it unless it is farther from its
// centre than its radius and the body's reach together.

#include "pipeline/parts/near_statics.h"

#include <algorithm>

#include "geometry/reach.h"
#include "scree/settings.h"

namespace scree {

namespace {

/// The farthest that a fixture of the body reaches from its centre of mass, m.
float ReachOfBody(int body, const NearStatics::Tables& t) {
    float reach = 0.0f;
    const auto b = static_cast<size_t>(body);
    for (const int f : t.fixtures.From(t.bodies.fixtureHead[b])) {
        if (t.fixtures.isSensor[static_cast<size_t>(f)]) continue;
        reach = Max(reach, Reach(*t.fixtures.shape[static_cast<size_t>(f)], t.bodies.mass[b].localCenter));
    }
    return reach;
}

}  // namespace

NearStatics::Ball NearStatics::MakeBall(int body, const Tables& t) {
    const Vec2 to = t.bodies.position[static_cast<size_t>(body)].c;
    const Vec2 way = to - t.bodies.startPosition[static_cast<size_t>(body)].c;
    const float reach = ReachOfBody(body, t);
    Ball ball;
    ball.centre = to + way;
    ball.radius = 2.0f * way.Length() + 0.5f * reach;
    // A meeting is noticed within a slop of the surfaces; coordinates are rounded to their size.
    const float size = Abs(ball.centre.x) + Abs(ball.centre.y) + reach + ball.radius;
    const float far = reach + ball.radius + 2.0f * linearSlop * t.lengthScale + 1.0e-5f * size;
    const Vec2 extents{far, far};
    t.broadPhase.QueryStatic({ball.centre - extents, ball.centre + extents}, [&](uint32_t fixture) {
        const auto other = static_cast<size_t>(t.fixtures.body[fixture]);
        if (t.bodies.type[other] != staticBody || t.fixtures.isSensor[fixture]) return true;
        if (LeastDistance(*t.fixtures.shape[fixture], t.bodies.transform[other], ball.centre) > far) return true;
        if (ball.count < mostFixtures) ball.fixtures[ball.count] = static_cast<int>(fixture);
        return ++ball.count <= mostFixtures;
    });
    std::sort(ball.fixtures, ball.fixtures + std::min(ball.count, mostFixtures));
    return ball;
}

std::optional<std::span<const int>> NearStatics::Get(int body, const BodyTable& bodies) const {
    const auto b = static_cast<size_t>(body);
    if (!m_enabled || bodies.IsFar() || b >= m_balls.size()) return std::nullopt;
    const Ball& ball = m_balls[b];
    const float farthest = Max(DistanceSquared(bodies.startPosition[b].c, ball.centre),
                               DistanceSquared(bodies.position[b].c, ball.centre));
    const bool isInside = ball.radius >= 0.0f && farthest <= ball.radius * ball.radius;
    if (!isInside || ball.count > mostFixtures) return std::nullopt;
    return std::span<const int>(ball.fixtures, static_cast<size_t>(ball.count));
}

std::optional<std::span<const int>> NearStatics::Find(int body, const Tables& tables) {
    if (!m_enabled || tables.bodies.IsFar()) return std::nullopt;
    const auto b = static_cast<size_t>(body);
    if (b >= m_balls.size()) EnsureRows(m_balls, static_cast<size_t>(tables.bodies.slots.Size()));
    Ball& ball = m_balls[b];
    const float farthest = Max(DistanceSquared(tables.bodies.startPosition[b].c, ball.centre),
                               DistanceSquared(tables.bodies.position[b].c, ball.centre));
    if (!(ball.radius >= 0.0f && farthest <= ball.radius * ball.radius)) ball = MakeBall(body, tables);
    if (ball.count > mostFixtures) return std::nullopt;
    return std::span<const int>(ball.fixtures, static_cast<size_t>(ball.count));
}

void NearStatics::PrepareCalm(const BodyTable& bodies, bool atOutlines) {
    if (m_atOutlines != atOutlines) m_calm.clear();
    m_atOutlines = atOutlines;
    if (m_enabled && !bodies.IsFar()) EnsureRows(m_calm, static_cast<size_t>(bodies.slots.Size()));
}

void NearStatics::NoteCalm(int body, const BodyTable& bodies, float reach, float slack) {
    const auto b = static_cast<size_t>(body);
    const Ball& ball = m_balls[b];
    const Position& at = bodies.position[b];
    m_calm[b] = {at.c, at.a, reach, Min(slack, ball.radius - Distance(at.c, ball.centre))};
}

}  // namespace scree
