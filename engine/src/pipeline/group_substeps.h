// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage, only of steps with a tolerance: islands → groups of islands that take the same number of sub-steps.

#pragma once

#include <span>
#include <vector>

#include "scree/accuracy.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/islands.h"
#include "state/joints.h"

namespace scree {

/// Islands to be solved together.
struct SubstepGroup {
    int substeps = 0;
    IslandTable lists;  ///< without ranges of islands; in the order of the lists that were divided
};

/// The groups of a step, fewest sub-steps first. Keeps the room of earlier steps.
class SubstepGroups {
public:
    [[nodiscard]] std::span<SubstepGroup> Get() { return {m_groups.data(), m_count}; }
    [[nodiscard]] std::span<const SubstepGroup> Get() const { return {m_groups.data(), m_count}; }
    void Clear() { m_count = 0; }
    /// Per body: its number in the last such step; scratch.
    Column<BodyIndex, int>& Last() { return m_last; }
    [[nodiscard]] size_t GetMemoryBytes() const {
        size_t bytes = BytesOf(m_groups, m_last);
        for (const SubstepGroup& group : m_groups) bytes += group.lists.GetMemoryBytes();
        return bytes;
    }
    /// An empty group, in its place, unless there is one with that number.
    void Enter(int substeps);
    /// The group with a number that was entered.
    SubstepGroup& Find(int substeps);

private:
    std::vector<SubstepGroup> m_groups;
    size_t m_count = 0;
    Column<BodyIndex, int> m_last;
};

struct GroupInput {
    const IslandTable& islands;  ///< of the step
    const IslandTable& active;   ///< the same bodies, contacts and joints, in the order in which to solve them
    ContactTable& contacts;      ///< where springs get stiffer, overlap is marked to be pushed apart without speed
    const JointTable& joints;
    const Tolerance& tolerance;
    float slop;  ///< overlap that the solver means to leave, m
    float dt;    ///< of the step, s
};

/// Smallest of the numbers 1, 2, 3, 4, 6, 8, 12, … (two an octave, so that groups are few) that is no less than
/// `wanted`, within the tolerance's range.
int RoundUpSubsteps(float wanted, const Tolerance& tolerance);

/// Each island gets as many sub-steps as the most demanding of its bodies calls for, by what the last such step found;
/// isolated bodies get the least. Divides `active` into `groups`, fewest sub-steps first, and starts the bodies'
/// demands of this step anew.
void GroupBySubsteps(const GroupInput& input, BodyTable& bodies, SubstepGroups& groups);

}  // namespace scree
