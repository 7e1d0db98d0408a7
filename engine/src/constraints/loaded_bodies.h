// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies that bear loads far beyond their own weight. The spring of a contact is as stiff as its lighter body is heavy.
// So a load of a hundred such masses sinks a hundred times as deep as one of them. For one step such a body gets the
// inertia with which its contacts hold the load at half a slop. What momentum it then gains beyond its own is given
// back to the load. This follows shock propagation, which gives lower bodies more mass (Guendelman, Bridson, Fedkiw,
// "Nonconvex Rigid Bodies with Stacking", SIGGRAPH 2003). Here the mass is set by the stiffness that the load calls
// for.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/task_pool.h"
#include "scree/world_callbacks.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct LoadInput {
    TaskPool& pool;
    const FixtureTable& fixtures;
    const ContactTable& contacts;
    const JointTable& joints;
    std::span<const BodyIndex> bodies;
    std::span<const ContactIndex> list;  ///< contacts
    Vec2 gravity;
    float dt;            ///< of the step, s
    float stiffness;     ///< of a contact's spring by the mass of its bodies, 1/s²
    float depth;         ///< to which a load may sink, m
    bool raisesJointed;  ///< sub-steps are short enough for that
};

class LoadedBodies {
public:
    /// Finds the bodies and raises their masses until Lower.
    void Raise(const LoadInput& input, BodyTable& bodies);
    [[nodiscard]] bool IsEmpty() const { return m_raised.empty(); }
    /// Gives masses back, and to loads what they have lost. Velocities are those of the end of the step, `impulses` the
    /// sums of the contacts over it, by position in the list.
    void Lower(BodyTable& bodies, std::span<const ContactImpulse> impulses);

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_raised, m_rowOf, m_presses, m_paths); }

private:
    struct Raised {
        BodyIndex body;
        BodyIndex load;    ///< the heaviest that it bears
        Vec2 normal;       ///< to the body from the one above it
        Vec2 loadArm;      ///< from the load's centre to where it presses, if it is the one above; else 0
        int at;            ///< position in the list of the contact with the one above
        float mass;        ///< that it is solved with, kg
        MassRow own;       ///< what it has by itself
        Velocity unaided;  ///< to which forces alone bring it by the end of the step
    };

    /// A contact of two bodies that can be pushed.
    struct Path {
        int at;  ///< position in the list
        BodyIndex a, b;
    };

    static Vec2 FindLost(const BodyTable& bodies, const Raised& raised, const ContactImpulse& impulse);

    std::vector<Raised> m_raised;
    Column<BodyIndex, int> m_rowOf;        ///< of m_raised, −1 none; all −1 between steps
    Column<BodyIndex, uint8_t> m_presses;  ///< 1: a load, or raised for one; all 0 between steps

    std::vector<Path> m_paths;  ///< scratch of the search

    friend class LoadSearch;
};

}  // namespace scree
