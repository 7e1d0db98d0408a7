// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which joints can be solved side by side: joints that push the same body are in different batches, in their order. So
// solving batch after batch gives the bits of solving joint after joint. Joints that no pushed body connects may be in
// groups, each with batches of its own, so that a thread solves a group without waiting for others.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/joined_sets.h"
#include "constraints/joint_lane_task.h"
#include "state/bodies.h"
#include "state/joints.h"

namespace scree {

/// Who may solve the batches of a section.
enum class Sharing : uint8_t {
    whole,   ///< any thread, all of them in turn: such sections push different bodies
    parted,  ///< several threads, each some of them, once the sections before are done
    none,    ///< the caller: a body in them cannot be pushed, and all of them write to it
};

/// Batches up to `end` that are in no section before.
struct JointSection {
    int end;
    Sharing sharing;
};

class JointLevels {
public:
    /// The joints of a type in this list, by batch and place in it; none: to spare, behind the others of the batch. No
    /// joints where that does not pay, or far from the origin. Valid until the next call.
    std::span<const JointIndex> Sort(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies,
                                     const JointTable& table);
    /// The same in groups, where they are many.
    std::span<const JointIndex> SortByGroup(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies,
                                            const JointTable& table);
    /// What the last call returned, if it returned joints, and how many of the list are of the type.
    [[nodiscard]] std::span<const JointIndex> GetOrder() const { return m_order; }
    [[nodiscard]] size_t CountTaken() const { return m_taken.size(); }
    /// False if a body of the joint has turned so far that the kernels find its sine and cosine one by one.
    [[nodiscard]] static bool PaysToTurn(const JointInfo& joint, const BodyTable& bodies);
    [[nodiscard]] static bool IsPushed(BodyIndex body, const BodyTable& bodies) {
        return bodies.mass[body].invMass > 0.0f;
    }
    /// Of the batches, in their order.
    [[nodiscard]] std::span<const JointSection> GetSections() const { return m_sections; }
    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(m_taken, m_places, m_next, m_parts, m_depths, m_levels, m_order, m_sections) +
               m_connected.GetMemoryBytes();
    }
    void MatchRoomOf(const JointLevels& other) {
        MatchRoom(m_taken, other.m_taken), MatchRoom(m_places, other.m_places), MatchRoom(m_next, other.m_next);
        MatchRoom(m_parts, other.m_parts), MatchRoom(m_depths, other.m_depths), MatchRoom(m_levels, other.m_levels);
        MatchRoom(m_order, other.m_order), MatchRoom(m_sections, other.m_sections);
        m_connected.MatchRoomOf(other.m_connected);
    }

private:
    /// Of a joint.
    struct Place {
        int group = 0, level = 0;  ///< level: how many of its group must be solved first
        bool pushesBoth = false;
    };
    /// Joints that pushed bodies connect.
    struct Part {
        int count = 0;
        int group = -1;
        bool pushesAll = true;
    };
    /// The joints of one level of a group.
    struct Level {
        int count = 0;
        int next = 0;  ///< place of its next joint in m_order
        bool pushesAll = true;
    };

    void Take(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table);
    /// False where they are so many that their batches do not pay.
    bool FindLevels(const BodyTable& bodies, const JointTable& table);
    int FindGroups(const BodyTable& bodies, const JointTable& table);
    std::span<const JointIndex> Order(int groups);

    std::vector<JointIndex> m_taken;
    std::vector<Place> m_places;    ///< by joint
    Column<BodyIndex, int> m_next;  ///< level of the next joint that pushes the body
    JoinedSets<BodyIndex> m_connected;
    Column<BodyIndex, Part> m_parts;  ///< of the body that stands for it
    std::vector<int> m_depths;        ///< by group: how many levels, then the first of them
    std::vector<Level> m_levels;      ///< group by group
    std::vector<JointIndex> m_order;
    std::vector<JointSection> m_sections;
};

}  // namespace scree
