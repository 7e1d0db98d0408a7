// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Small islands in the lanes of the vector kernels (lane_kernels.h): packs their rows and bodies, and takes
// back what became of them. Bits are those of contact_rows.h island by island.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/leave_raw.h"
#include "constraints/contact_rows.h"
#include "constraints/lane_kernels.h"

namespace scree {

/// Where the rows of a group come from.
struct LaneInput {
    const BodyTable& bodies;
    const FixtureTable& fixtures;
    const ContactTable& contacts;
    float impulseScale;  ///< dt / last dt; 0 without warm starting
    bool restitution;    ///< some contact may bounce
};

class IslandLanes {
public:
    /// An island: all its bodies, and its contacts in the order in which they are solved. They are the contacts
    /// `first`, `first` + 1 … of its lane, which no other island has.
    struct Member {
        std::span<const BodyIndex> bodies;
        std::span<const ContactIndex> contacts;
        int lane, first;
    };

    /// Rows of all contacts, from the bodies' present positions and velocities. `slotOf` is scratch with a row per
    /// body; groups that are solved at once may share it.
    void Prepare(const LaneInput& input, std::span<const Member> members, Column<BodyIndex, int>& slotOf);
    void SolveVelocities(int iterations, bool warmStart, bool friction, BodyTable& bodies);
    /// Writes the impulses back into the manifolds.
    void StoreImpulses(Column<ContactIndex, Manifold>& manifold) const;
    /// Stops in each island as soon as its smallest separation is at least `tolerance`; those islands are solved.
    void SolvePositions(int iterations, float tolerance, const PushApart& how, BodyTable& bodies);
    /// Calls visit(body, rotation) for the dynamic bodies, after SolvePositions.
    template <typename Visit>
    void ForEachRotation(const BodyTable& bodies, Visit&& visit) const {
        for (const Slot& slot : m_bodies) {
            if (bodies.type[slot.body] != dynamicBody) continue;
            Rot q;
            q.s = m_rotation[slot.row][0], q.c = m_rotation[slot.row][1];
            visit(slot.body, q);
        }
    }
    [[nodiscard]] bool IsSolved(size_t member) const { return m_isSolved[member] != 0; }
    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(m_members, m_isSolved, m_contacts, m_named, m_bodies, m_velocity, m_position, m_rotation);
    }
    void MatchRoomOf(const IslandLanes& other) {
        MatchRoom(m_members, other.m_members), MatchRoom(m_isSolved, other.m_isSolved);
        MatchRoom(m_contacts, other.m_contacts), MatchRoom(m_named, other.m_named);
        MatchRoom(m_bodies, other.m_bodies), MatchRoom(m_velocity, other.m_velocity);
        MatchRoom(m_position, other.m_position), MatchRoom(m_rotation, other.m_rotation);
    }

private:
    /// A body of a lane. Those that contacts cannot push have a slot for each contact with them.
    struct Slot {
        size_t row;
        BodyIndex body;
    };

    /// Slots of the bodies that contacts push, and room for all.
    void TakeBodies(const BodyTable& bodies, Column<BodyIndex, int>& slotOf);
    /// Names the contacts with this number in all lanes, with slots for their bodies.
    void Name(const LaneInput& input, size_t number, const Column<BodyIndex, int>& slotOf, LaneNames& names);
    [[nodiscard]] LaneTask MakeTask();
    /// Ends the position passes of islands that are within tolerance. False if none is left.
    bool EndSolved(float tolerance);

    std::vector<Member> m_members;
    std::vector<uint8_t> m_isSolved;  ///< per member: its positions are within tolerance
    std::vector<LaneContact, LeaveRaw<LaneContact>> m_contacts;
    std::vector<ContactIndex> m_named;  ///< by number and lane
    std::vector<Slot> m_bodies;
    std::array<size_t, islandLanes> m_slotCount{};
    std::vector<Velocity> m_velocity;  ///< by slot and lane
    std::vector<Position> m_position;
    struct alignas(16) Row : std::array<float, 4> {};
    std::vector<Row> m_rotation;
};

}  // namespace scree
