// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Ends the step of solved bodies: eight at a time where finish_poses.h takes them, else one by one.

#pragma once

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/finish_poses.h"

namespace scree {

class PoseFinisher {
public:
    struct Options {
        bool keepsRests;  ///< of angles, as the soft step does
        bool hasLimit;    ///< caps still have to act
    };

    /// `delta`: motion of each body since the start of the step.
    PoseFinisher(const SolverSettings& settings, BodyTable& bodies, Column<BodyIndex, Velocity>& delta, Options options)
        : m_finish(bodies.IsFar() ? nullptr : GetFinishPoses()),
          m_task{&bodies.velocity.data()->v.x, &bodies.startPosition.data()->c.x,
                 &bodies.mass.data()->invMass, &delta.data()->v.x,
                 &bodies.position.data()->c.x, &bodies.transform.data()->p.x,
                 options.keepsRests,           options.hasLimit,
                 settings.maxTranslation,      settings.maxRotation} {}

    /// All bodies bodyAt(0) … bodyAt(count − 1), which differ. one(body) does the same for a single one, and counts.
    template <typename BodyAt, typename One>
    SolverCounts Finish(TaskPool& pool, size_t count, BodyAt&& bodyAt, One&& one) const {
        return CountRanges(pool, count, [&](int begin, int end) {
            SolverCounts counts;
            int at = begin;
            for (; m_finish != nullptr && at + lanes <= end; at += lanes) {
                int32_t eight[lanes];
                for (int i = 0; i < lanes; ++i) eight[i] = ToInt(bodyAt(ToSize(at + i)));
                if (m_finish(m_task, eight)) continue;
                for (int i = 0; i < lanes; ++i) counts += one(bodyAt(ToSize(at + i)));
            }
            for (; at < end; ++at) counts += one(bodyAt(ToSize(at)));
            return counts;
        });
    }

private:
    static constexpr int lanes = 8;

    FinishPosesFunction m_finish;
    FinishPosesTask m_task;
};

}  // namespace scree
