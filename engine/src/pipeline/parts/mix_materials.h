// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The materials of two fixtures → that of their contact.

#pragma once

#include "scree/world_callbacks.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// Asks the mixer (null: none) where a rule says so.
ContactMaterial MixMaterials(FixtureIndex fixtureA, FixtureIndex fixtureB, const FixtureTable& fixtures,
                             MaterialMixer* mixer);

}  // namespace scree
