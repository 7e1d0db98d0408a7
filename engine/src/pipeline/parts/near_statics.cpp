// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The ball is centred one or some steps ahead and about as wide. A static fixture belongs to it unless it is farther
// from its centre than its radius and the body's reach together.

#include "pipeline/parts/near_statics.h"

#include <algorithm>

#include "geometry/reach.h"
#include "scree/settings.h"

namespace scree {

namespace {

/// The farthest that a fixture of the body reaches from its centre of mass, m.
float ReachOfBody(BodyIndex body, const NearStatics::Tables& t) {
    float reach = 0.0f;
    for (const FixtureIndex f : t.fixtures.From(t.bodies.fixtureHead[body])) {
        if (t.fixtures.isSensor[f]) continue;
        reach = Max(reach, Reach(*t.fixtures.shape[f], t.bodies.mass[body].localCenter));
    }
    return reach;
}

}  // namespace

NearStatics::Row NearStatics::NeedRow(BodyIndex body, const BodyTable& bodies) {
    EnsureRows(m_rows, ToSize(bodies.slots.Size()), Row::none);
    Row& row = m_rows[body];
    if (IsSome(row)) return row;
    ReserveRows(m_balls.size() + 1, m_balls, m_calm);
    m_balls.emplace_back();
    m_calm.emplace_back();
    row = ToIndex<Row>(m_balls.size() - 1);
    return row;
}

void NearStatics::Empty(Ball& ball) {
    if (ball.crowd >= 0) m_freeCrowds.push_back(ball.crowd);
    ball = Ball();
}

/// Balls of what flies through empty space grow, so that it seldom needs a new one.
NearStatics::Ball NearStatics::MakeBall(BodyIndex body, const Tables& t, const Ball& old, Crowd& found) {
    constexpr float fewest = 1.0f, most = 7.0f;
    const bool wasFree = old.radius >= 0.0f && old.count == 0;
    const float reach = old.reach < 0.0f ? ReachOfBody(body, t) : old.reach;
    const float steps = wasFree ? Min(2.0f * old.steps + 1.0f, most) : fewest;
    const Ball ball = MakeBall(body, t, reach, steps, found);
    return steps > fewest && ball.count > 0 ? MakeBall(body, t, reach, fewest, found) : ball;
}

/// The ball is centred so many steps ahead.
NearStatics::Ball NearStatics::MakeBall(BodyIndex body, const Tables& t, float reach, float steps, Crowd& found) {
    const Vec2 to = t.bodies.position[body].c;
    const Vec2 way = to - t.bodies.startPosition[body].c;
    Ball ball;
    ball.reach = reach;
    ball.steps = steps;
    ball.centre = to + steps * way;
    ball.radius = (1.0f + steps) * way.Length() + 0.5f * reach;
    // A meeting is noticed within a slop of the surfaces; coordinates are rounded to their size.
    const float size = Abs(ball.centre.x) + Abs(ball.centre.y) + reach + ball.radius;
    const float far = reach + ball.radius + 2.0f * linearSlop * t.lengthScale + 1.0e-5f * size;
    const Vec2 extents{far, far};
    t.broadPhase.QueryStatic({ball.centre - extents, ball.centre + extents}, [&](uint32_t proxy) {
        const FixtureIndex fixture = FixtureOf(proxy);
        const BodyIndex other = t.fixtures.body[fixture];
        if (t.bodies.type[other] != staticBody || t.fixtures.isSensor[fixture]) return true;
        if (LeastDistance(*t.fixtures.shape[fixture], t.bodies.transform[other], ball.centre) > far) return true;
        if (ball.count < mostInCrowd) found.fixtures[ball.count] = fixture;
        return ++ball.count <= mostInCrowd;
    });
    if (ball.count > mostInCrowd) return ball;
    std::sort(found.fixtures, found.fixtures + ball.count);
    std::copy_n(found.fixtures, std::min(ball.count, mostFixtures), ball.fixtures);
    return ball;
}

bool NearStatics::IsInside(const Ball& ball, BodyIndex body, const BodyTable& bodies) {
    const float farthest = Max(DistanceSquared(bodies.startPosition[body].c, ball.centre),
                               DistanceSquared(bodies.position[body].c, ball.centre));
    return ball.radius >= 0.0f && farthest <= ball.radius * ball.radius;
}

std::optional<std::span<const FixtureIndex>> NearStatics::Read(const Ball& ball) const {
    if (ball.count > mostInCrowd) return std::nullopt;
    const FixtureIndex* const fixtures = ball.crowd >= 0 ? m_crowds[ToSize(ball.crowd)].fixtures : ball.fixtures;
    return std::span<const FixtureIndex>(fixtures, ToSize(ball.count));
}

std::optional<std::span<const FixtureIndex>> NearStatics::Get(BodyIndex body, const BodyTable& bodies) const {
    const Row row = RowOf(body);
    if (!m_enabled || bodies.IsFar() || IsNone(row)) return std::nullopt;
    const Ball& ball = m_balls[row];
    return IsInside(ball, body, bodies) ? Read(ball) : std::nullopt;
}

std::optional<std::span<const FixtureIndex>> NearStatics::Find(BodyIndex body, const Tables& tables) {
    if (!m_enabled || tables.bodies.IsFar()) return std::nullopt;
    Ball& ball = m_balls[NeedRow(body, tables.bodies)];
    if (IsInside(ball, body, tables.bodies)) return Read(ball);
    Crowd found;
    const Ball made = MakeBall(body, tables, ball, found);
    Empty(ball);
    ball = made;
    if (NeedsCrowd(ball)) {
        if (m_freeCrowds.empty()) {
            m_freeCrowds.push_back(static_cast<int>(m_crowds.size()));
            m_crowds.emplace_back();
        }
        ball.crowd = m_freeCrowds.back();
        m_freeCrowds.pop_back();
        std::copy_n(found.fixtures, ball.count, m_crowds[ToSize(ball.crowd)].fixtures);
    }
    return Read(ball);
}

std::optional<std::span<const FixtureIndex>> NearStatics::FindApart(BodyIndex body, const Tables& tables) {
    const Row row = RowOf(body);
    if (!m_enabled || tables.bodies.IsFar() || IsNone(row)) return std::nullopt;
    Ball& ball = m_balls[row];
    if (IsInside(ball, body, tables.bodies)) return Read(ball);
    if (ball.crowd >= 0) return std::nullopt;
    Crowd found;
    const Ball made = MakeBall(body, tables, ball, found);
    if (NeedsCrowd(made)) return std::nullopt;
    ball = made;
    return Read(ball);
}

void NearStatics::PrepareCalm(bool atOutlines) {
    if (m_atOutlines != atOutlines) std::ranges::fill(m_calm, Calm());
    m_atOutlines = atOutlines;
}

void NearStatics::NoteCalm(BodyIndex body, const BodyTable& bodies, float reach, float slack) {
    const Row row = m_rows[body];
    const Ball& ball = m_balls[row];
    const Position& at = bodies.position[body];
    m_calm[row] = {at.c, at.a, reach, Min(slack, ball.radius - Distance(at.c, ball.centre))};
}

}  // namespace scree
