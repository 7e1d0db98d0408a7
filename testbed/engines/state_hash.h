// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One hash of a world's visible state for every engine: bodies in, 64 bits out. Equal hashes mean the same poses,
// velocities and awake bits, bit for bit; −0 counts as 0, since no picture and no later result can tell them apart.

#pragma once

#include <cstdint>
#include <span>

#include "testbed/engines/snapshot.h"

namespace testbed {

/// Hash over position, angle, velocities and awake bit in the order given, which must be that of the body index.
/// O(bodies).
[[nodiscard]] uint64_t HashState(std::span<const BodyState> bodies);

}  // namespace testbed
