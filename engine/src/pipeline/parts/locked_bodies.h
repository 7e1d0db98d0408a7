// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies that do not move along x or y (MotionLocks). The solvers take such a body for free and put its velocity there
// back to 0 after every pass. So, as they are iterated, constraints come to what they are against a wall, and the body
// does not move at all.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "scree/features.h"
#include "state/bodies.h"

namespace scree {

/// Whether a body is locked by these flags (BodyFlag).
inline bool IsLockedBy(const BodyTable& bodies, BodyIndex body, uint16_t flags) {
    return bodies.type[body] == dynamicBody && bodies.Has(body, flags);
}

class LockedBodies {
public:
    /// Those of a list; none without the feature.
    void Gather(const KernelSet& kernels, std::span<const BodyIndex> list, const BodyTable& bodies) {
        m_x.clear(), m_y.clear();
        if (!kernels.locks) return;
        for (const BodyIndex body : list) {
            if (IsLockedBy(bodies, body, BodyFlag::lockX)) m_x.push_back(body);
            if (IsLockedBy(bodies, body, BodyFlag::lockY)) m_y.push_back(body);
        }
    }
    [[nodiscard]] bool IsEmpty() const { return m_x.empty() && m_y.empty(); }
    /// In a column of velocities, or of motions since the start of the step.
    void Stop(Column<BodyIndex, Velocity>& column) const {
        for (const BodyIndex body : m_x) column[body].v.x = 0.0f;
        for (const BodyIndex body : m_y) column[body].v.y = 0.0f;
    }
    /// Takes back what position passes did.
    void Return(BodyTable& bodies) const {
        for (const BodyIndex body : m_x) {
            bodies.position[body].c.x = bodies.startPosition[body].c.x;
            if (bodies.IsFar()) bodies.rest[body].end.x = bodies.rest[body].start.x;
        }
        for (const BodyIndex body : m_y) {
            bodies.position[body].c.y = bodies.startPosition[body].c.y;
            if (bodies.IsFar()) bodies.rest[body].end.y = bodies.rest[body].start.y;
        }
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_x, m_y); }
    void MatchRoomOf(const LockedBodies& other) { MatchRoom(m_x, other.m_x), MatchRoom(m_y, other.m_y); }

private:
    std::vector<BodyIndex> m_x, m_y;
};

/// The same for one body by itself.
inline void StopLocked(const BodyTable& bodies, BodyIndex body, Velocity& v) {
    if (IsLockedBy(bodies, body, BodyFlag::lockX)) v.v.x = 0.0f;
    if (IsLockedBy(bodies, body, BodyFlag::lockY)) v.v.y = 0.0f;
}

}  // namespace scree
