// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whether tables that were read from an image fit together: every index names something alive, every list is whole,
// every number that the broad phase sorts is finite.

#pragma once

#include "world/world_state.h"

namespace scree {

/// A fixture's box in the broad phase.
[[nodiscard]] bool IsPossible(const AABB& box);
/// Bodies and fixtures; call it before anything is made from them.
[[nodiscard]] bool AreBodiesConsistent(const BodyTable& bodies);
[[nodiscard]] bool AreFixturesConsistent(const FixtureTable& fixtures, const BodyTable& bodies);
/// Contacts and joints against bodies and fixtures, after their own Restore.
[[nodiscard]] bool AreContactsConsistent(const ContactTable& contacts, const FixtureTable& fixtures);
[[nodiscard]] bool AreJointsConsistent(const JointTable& joints, const BodyTable& bodies);

}  // namespace scree
