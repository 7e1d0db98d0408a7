// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Checks of what users pass in. Each says which field is wrong; nothing is changed before all have passed.

#pragma once

#include "world/world_state.h"

namespace scree {

/// The first wrong field of an input, or ok.
struct Finding {
    ErrorCode code = ErrorCode::ok;
    const char* field = "";
    const char* cure = "";
    explicit operator bool() const { return code != ErrorCode::ok; }
};

Finding Check(const BodyDef& def);
/// `isShapeKnown`: the shape is as one that was checked before.
Finding Check(const FixtureDef& def, bool isShapeKnown);
Finding Check(const WorldDef& def);
Finding Check(const Shape& shape);
Finding Check(const ChainShape& chain);
/// The mass that a density gives to a shape is 0 or one to calculate with.
Finding CheckMass(const Shape& shape, float density, const char* field);
/// One of MixRule.
Finding CheckRule(MixRule rule, const char* field);
/// Bits of Report and no others.
Finding CheckReports(uint8_t reports, const char* field);

/// True if the handle is alive and belongs to this world.
bool Owns(const WorldState& state, const Body* body);
bool Owns(const WorldState& state, const Fixture* fixture);
bool Owns(const WorldState& state, const Joint* joint);
bool Owns(const WorldState& state, const Contact* contact);

}  // namespace scree
