// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which static fixtures a body can meet: kept per body for a ball in which its centre may go, however it turns. While
// it stays inside, continuous collision need not ask the broad phase; in free space there is nothing to look at at all.
// A ball costs one query and serves for the steps until the body leaves it.
//
// Beside it, for a body that was shown to meet none of them: how far it may get from where it was without meeting one.
// What rests or creeps about its place costs a comparison a step.

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "broad_phase/broad_phase.h"
#include "state/bodies.h"
#include "state/fixtures.h"

namespace scree {

class NearStatics {
public:
    struct Tables {
        const BodyTable& bodies;
        const FixtureTable& fixtures;
        const BroadPhase& broadPhase;  ///< PrepareStatic was called
        float lengthScale;             ///< factor on the tolerances
    };

    /// To be called when a static fixture comes, moves or changes. O(1).
    void ForgetAll() { m_rows.clear(), m_balls.clear(), m_calm.clear(), m_crowds.clear(), m_freeCrowds.clear(); }
    /// To be called when the body gets a fixture or another centre of mass.
    void Forget(BodyIndex body) {
        const Row row = RowOf(body);
        if (IsNone(row)) return;
        Empty(m_balls[row]);
        m_calm[row] = Calm();
    }
    /// From now on nothing is known of any body: a program holds a shape that it may change at any time.
    void Disable() { m_enabled = false; }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_rows, m_balls, m_calm, m_crowds, m_freeCrowds); }
    void Trim() { m_rows = {}, m_balls = {}, m_calm = {}, m_crowds = {}, m_freeCrowds = {}; }

    /// The static fixtures, in ascending order, that the body can meet on its way from startPosition to position; all
    /// others are out of its way. Nothing if that is not known, as in worlds with bodies far from the origin. Valid
    /// until the next call.
    std::optional<std::span<const FixtureIndex>> Find(BodyIndex body, const Tables& tables);
    /// The same for several threads, each with other bodies: nothing too where the body, or a crowd near it, has no row
    /// yet. Valid until the next call for the body.
    std::optional<std::span<const FixtureIndex>> FindApart(BodyIndex body, const Tables& tables);
    /// The same without asking the broad phase: nothing where Find would have to. Safe for several threads.
    [[nodiscard]] std::optional<std::span<const FixtureIndex>> Get(BodyIndex body, const BodyTable& bodies) const;

    /// The farthest that a fixture of the body, if it is no sensor, reaches from the centre of mass, m. Negative: that
    /// is not known. Safe for several threads.
    [[nodiscard]] float GetReach(BodyIndex body) const {
        const Row row = RowOf(body);
        return m_enabled && IsSome(row) ? m_balls[row].reach : -1.0f;
    }

    /// To be called before NoteCalm and StaysCalm. What was noted with other answers of `atOutlines` is forgotten.
    void PrepareCalm(bool atOutlines);
    /// Notes that the body, where it is at the end of the step, was shown to meet no static fixture while none of its
    /// points moves by more than `slack`. Its core reaches `reach` from its centre. Only for a body that Get has
    /// answered.
    void NoteCalm(BodyIndex body, const BodyTable& bodies, float reach, float slack);
    /// True if the body stays within what was noted on its whole way.
    [[nodiscard]] bool StaysCalm(BodyIndex body, const BodyTable& bodies) const {
        const Row row = RowOf(body);
        if (!m_enabled || IsNone(row)) return false;
        const Calm& calm = m_calm[row];
        const auto isWithin = [&](const Position& p) {
            const float left = calm.slack - Abs(p.a - calm.angle) * calm.reach;
            return left >= 0.0f && DistanceSquared(p.c, calm.centre) <= left * left;
        };
        return isWithin(bodies.startPosition[body]) && isWithin(bodies.position[body]);
    }

private:
    /// Of a body that was asked about. Levels are mostly static bodies, about which nobody asks.
    enum class Row : int { none = -1 };
    /// In a ball, and in a crowd: among the short segments of a chain.
    static constexpr int mostFixtures = 8, mostInCrowd = 48;

    struct Ball {
        Vec2 centre = vec2Zero;
        float radius = -1.0f;  ///< m; negative: there is no ball yet
        float reach = -1.0f;   ///< of the body, m; negative: not known
        float steps = 0.0f;    ///< how many ahead its centre was
        int count = 0;         ///< of fixtures; more than mostInCrowd: too many to keep
        int crowd = -1;        ///< where they are if they are more than mostFixtures
        FixtureIndex fixtures[mostFixtures];
    };
    struct Crowd {
        FixtureIndex fixtures[mostInCrowd];
    };

    struct Calm {
        Vec2 centre = vec2Zero;
        float angle = 0.0f, reach = 0.0f;
        float slack = -1.0f;  ///< m; negative: nothing is known
    };

    [[nodiscard]] Row RowOf(BodyIndex body) const { return m_rows.Has(body) ? m_rows[body] : Row::none; }
    /// The row of the body, made if there is none.
    Row NeedRow(BodyIndex body, const BodyTable& bodies);
    /// A ball in place of `old`, whose fixtures are in `found`.
    [[nodiscard]] static Ball MakeBall(BodyIndex body, const Tables& tables, const Ball& old, Crowd& found);
    [[nodiscard]] static Ball MakeBall(BodyIndex body, const Tables& tables, float reach, float steps, Crowd& found);
    [[nodiscard]] static bool NeedsCrowd(const Ball& ball) {
        return ball.count > mostFixtures && ball.count <= mostInCrowd;
    }
    /// There is no ball any more.
    void Empty(Ball& ball);
    [[nodiscard]] static bool IsInside(const Ball& ball, BodyIndex body, const BodyTable& bodies);
    [[nodiscard]] std::optional<std::span<const FixtureIndex>> Read(const Ball& ball) const;

    Column<BodyIndex, Row> m_rows;
    Column<Row, Ball> m_balls;
    Column<Row, Calm> m_calm;
    std::vector<Crowd> m_crowds;
    std::vector<int> m_freeCrowds;
    bool m_atOutlines = false;  ///< what m_calm is about
    bool m_enabled = true;
};

}  // namespace scree
