// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kinds of rows that tables have.

#pragma once

#include <cstdint>

#include "base/index.h"

namespace scree {

enum class BodyIndex : int { none = -1 };
/// A position in the list of movers.
enum class MoverRow : int { none = -1 };
enum class FixtureIndex : int { none = -1 };
enum class ContactIndex : int { none = -1 };
/// Of a contact's handle (Contact::GetIndex): it stays while the contact moves to another row.
enum class ContactNumber : int { none = -1 };
enum class JointIndex : int { none = -1 };
/// A position in the table of one type of joints.
enum class JointRow : int { none = -1 };

/// The proxy of a fixture in the broad phase, and the other way; its owner there is the body.
constexpr uint32_t ProxyOf(FixtureIndex fixture) { return static_cast<uint32_t>(fixture); }
constexpr uint32_t OwnerOf(BodyIndex body) { return static_cast<uint32_t>(body); }
constexpr FixtureIndex FixtureOf(uint32_t proxy) { return FixtureIndex{static_cast<int>(proxy)}; }

}  // namespace scree
