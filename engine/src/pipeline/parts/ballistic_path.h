// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Isolated bodies, which nothing touches, in either solver: eight at a time where isolated_bodies.h takes them, else
// one by one. The same arithmetic without constraints, hence the same bits.

#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/isolated_bodies.h"

namespace scree {

class BallisticPath {
public:
    /// `substeps` of the soft step; 0: sequential impulses.
    BallisticPath(const SolverSettings& settings, BodyTable& bodies, int substeps)
        : m_settings(settings), m_bodies(bodies), m_moveIsolated(GetMoveIsolated()) {
        const bool isDriftExact = substeps == 0 && settings.exactDrift;  // sub-steps are exact by themselves
        m_byEight = !isDriftExact && !bodies.IsFar() && !settings.kernels.locks;
        if (bodies.velocity.empty()) return;  // columns without rows have no address
        m_task = {&bodies.velocity.data()->v.x,
                  &bodies.position.data()->c.x,
                  &bodies.startPosition.data()->c.x,
                  &bodies.transform.data()->p.x,
                  &bodies.mass.data()->invMass,
                  bodies.force.empty() ? nullptr : &bodies.force.data()->force.x,
                  &bodies.motion.data()->linearDamping,
                  settings.kernels.bodyForces,
                  settings.kernels.speedLimit,
                  substeps,
                  settings.dt,
                  settings.gravity.x,
                  settings.gravity.y,
                  settings.maxTranslation,
                  settings.maxRotation,
                  SleepSpeed(settings) * SleepSpeed(settings),
                  angularSleepTolerance * angularSleepTolerance};
    }

    /// Moves the bodies and updates their sleep. one(body) moves one to its end position; true if a cap acted.
    template <typename One>
    SolverCounts Move(TaskPool& pool, const std::vector<BodyIndex>& isolated, One&& one) const {
        return CountRanges(pool, isolated.size(),
                           [&](int begin, int end) { return MoveRange(Range(isolated, begin, end), one); });
    }

    /// The same for some of them, on one thread.
    template <typename One>
    SolverCounts MoveRange(std::span<const BodyIndex> rows, const One& one) const {
        SolverCounts counts;
        const auto moveOne = [&](BodyIndex body) {
            counts.capped += one(body) ? 1 : 0;
            counts.nonFinite += FinishPose(m_bodies, body) ? 1 : 0;
            Sleep(body);
        };
        size_t done = 0;
        for (; m_byEight && done + laneCount <= rows.size(); done += laneCount) {
            const std::span<const BodyIndex> eight = rows.subspan(done, laneCount);
            if (!MoveEight(eight)) std::ranges::for_each(eight, moveOne);
        }
        for (; done < rows.size(); ++done) moveOne(rows[done]);
        return counts;
    }

private:
    static constexpr size_t laneCount = 8;

    /// False if nothing was written.
    bool MoveEight(std::span<const BodyIndex> rows) const {
        int32_t plain[laneCount];
        for (size_t lane = 0; lane < laneCount; ++lane) plain[lane] = ToInt(rows[lane]);
        switch (m_moveIsolated(m_task, plain)) {
            case IsolatedMove::refused:
                return false;
            case IsolatedMove::fast:
                if (!m_settings.allowSleep) break;
                for (const BodyIndex body : rows) m_bodies.sleepTime[body] = 0.0f;
                break;
            case IsolatedMove::slow:
                for (const BodyIndex body : rows) Sleep(body);
                break;
        }
        return true;
    }

    void Sleep(BodyIndex body) const {
        if (!m_settings.allowSleep) return;
        if (UpdateSleepTimer(m_bodies, body, m_settings) >= timeToSleep) m_bodies.PutToSleep(body);
    }

    const SolverSettings& m_settings;
    BodyTable& m_bodies;
    MoveIsolatedFunction m_moveIsolated;
    bool m_byEight;
    IsolatedBodiesTask m_task{};
};

}  // namespace scree
