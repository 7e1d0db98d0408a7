// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The conditions that there are. Lengths in m, times in s, speeds in m/s and rad/s. What needs contacts finds nothing
// in motions that were recorded without them.

#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "testbed/moments/expression.h"
#include "testbed/moments/moment.h"

namespace testbed {

/// A dynamic body whose middle went through a static shape with which it collides, and that did not come back within
/// half a second. A body that is pushed out has not tunnelled, nor has one that the program puts elsewhere.
[[nodiscard]] std::unique_ptr<Condition> MakeTunnelCondition();
/// Two bodies deeper in each other than `depth` for longer than `longer` s, by their contacts.
[[nodiscard]] std::unique_ptr<Condition> MakeOverlapCondition(double depth, double longer);
/// A body faster than this, of its centre of mass.
[[nodiscard]] std::unique_ptr<Condition> MakeSpeedCondition(double speed);
/// A body that turns faster than this, either way.
[[nodiscard]] std::unique_ptr<Condition> MakeSpinCondition(double speed);
/// A body with a pose or a velocity that is no number.
[[nodiscard]] std::unique_ptr<Condition> MakeNonFiniteCondition();
/// A body whose position leaves the box; one that starts outside does not.
[[nodiscard]] std::unique_ptr<Condition> MakeEscapeCondition(const Box& box);
/// A step that took `factor` times the median, with the stage that grew most and the bodies with the most new pairs,
/// the largest box and the most contacts. A session may have been recorded without contacts: `hasContacts`.
[[nodiscard]] std::unique_ptr<Condition> MakeSpikeCondition(double factor, bool hasContacts = true);
/// Anchors of a revolute or weld joint farther apart than this.
[[nodiscard]] std::unique_ptr<Condition> MakeJointGapCondition(double gap);
/// A body that stays where it is and yet shakes. Within a second it leaves a box of a twentieth of its size in neither
/// direction. It turns back ten times or more, and goes faster than 1 cm/s on average.
[[nodiscard]] std::unique_ptr<Condition> MakeJitterCondition();
/// A body that is awake for this long although it stays within its own size.
[[nodiscard]] std::unique_ptr<Condition> MakeAwakeCondition(double seconds);
/// A body with more than this many touching contacts.
[[nodiscard]] std::unique_ptr<Condition> MakePileOnCondition(int contacts);
/// Steps on end after which an expression holds, with the bodies that it names. `name` is what its moments are called.
[[nodiscard]] std::unique_ptr<Condition> MakeWhenCondition(const std::string& name, Expression expression);
/// The first step after which a body is not where it is in another session, with the one that differs most. It differs
/// by more than `distance` m (0: any bit of pose or velocity). `other` gives the other session's state after the same
/// step, null behind its end.
[[nodiscard]] std::unique_ptr<Condition> MakeDivergeCondition(double distance,
                                                              std::function<const Snapshot*(int step)> other);
/// Texts that the program left in what it recorded. `marks` gives those of a step.
[[nodiscard]] std::unique_ptr<Condition> MakeMarkCondition(std::function<std::span<const std::string>(int step)> marks);

}  // namespace testbed
