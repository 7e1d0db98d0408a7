// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which static fixtures a body can meet: kept per body for a ball in which its centre may go, however it turns. While
// it stays inside, continuous collision need not ask the broad phase; in free space there is nothing to look at at all.
// A ball costs one query and serves for the steps until the body leaves it.

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
        BroadPhase& broadPhase;
        float lengthScale;  ///< factor on the tolerances
    };

    /// To be called when a static fixture comes, moves or changes. O(1).
    void ForgetAll() { m_balls.clear(); }
    /// To be called when the body gets a fixture or another centre of mass.
    void Forget(int body) {
        if (static_cast<size_t>(body) < m_balls.size()) m_balls[static_cast<size_t>(body)] = Ball();
    }
    /// From now on nothing is known of any body: a program holds a shape that it may change at any time.
    void Disable() { m_enabled = false; }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_balls); }
    void Trim() { m_balls = {}; }

    /// The static fixtures, in ascending order, that the body can meet on its way from startPosition to position; all
    /// others are out of its way. Nothing if that is not known, as in worlds with bodies far from the origin. Valid
    /// until the next call.
    std::optional<std::span<const int>> Find(int body, const Tables& tables);

private:
    static constexpr int mostFixtures = 8;

    struct Ball {
        Vec2 centre = vec2Zero;
        float radius = -1.0f;  ///< m; negative: there is no ball yet
        int count = 0;         ///< of fixtures; more than mostFixtures: too many to keep
        int fixtures[mostFixtures];
    };

    static Ball MakeBall(int body, const Tables& tables);

    std::vector<Ball> m_balls;  ///< by body
    bool m_enabled = true;
};

}  // namespace scree
