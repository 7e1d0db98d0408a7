// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The velocities with which jointed bodies began the motion of a step: a time of impact stops them on their way.

#pragma once

#include <vector>

#include "state/bodies.h"

namespace scree {

class StartVelocities {
public:
    /// Before a step: of no body anything is known.
    void Forget() {
        for (const BodyIndex body : m_known) m_isKnown[body] = 0;
        m_known.clear();
    }
    /// Makes room for the bodies that Note may name.
    void Reserve(size_t bodies) { EnsureRows(m_velocity, bodies), EnsureRows(m_isKnown, bodies); }
    void Note(BodyIndex body, const Velocity& velocity) {
        m_velocity[body] = velocity;
        if (m_isKnown[body] != 0) return;
        m_isKnown[body] = 1;
        m_known.push_back(body);
    }
    /// Null for a body that the step did not move.
    [[nodiscard]] const Velocity* Find(BodyIndex body) const {
        return m_isKnown.Has(body) && m_isKnown[body] != 0 ? &m_velocity[body] : nullptr;
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_velocity, m_isKnown, m_known); }

private:
    Column<BodyIndex, Velocity> m_velocity;
    Column<BodyIndex, uint8_t> m_isKnown;
    std::vector<BodyIndex> m_known;
};

}  // namespace scree
