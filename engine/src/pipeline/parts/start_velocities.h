// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The velocities with which jointed bodies began the motion of a step: a time of impact stops them on their way.

#pragma once

#include <algorithm>
#include <cstdint>

#include "state/bodies.h"

namespace scree {

class StartVelocities {
public:
    /// Before a step: of no body anything is known.
    void Forget() {
        if (++m_step != 0) return;
        std::ranges::fill(m_noted, 0);
        m_step = 1;
    }
    /// Makes room for the bodies that Note may name.
    void Reserve(size_t bodies) { EnsureRows(m_velocity, bodies), EnsureRows(m_noted, bodies); }
    /// Several threads may note different bodies.
    void Note(BodyIndex body, const Velocity& velocity) {
        m_velocity[body] = velocity;
        m_noted[body] = m_step;
    }
    /// Null for a body that the step did not move.
    [[nodiscard]] const Velocity* Find(BodyIndex body) const {
        return m_noted.Has(body) && m_noted[body] == m_step ? &m_velocity[body] : nullptr;
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_velocity, m_noted); }

private:
    Column<BodyIndex, Velocity> m_velocity;
    Column<BodyIndex, uint32_t> m_noted;  ///< in which step, 0: in none
    uint32_t m_step = 1;
};

}  // namespace scree
