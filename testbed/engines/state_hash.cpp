// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of state_hash.h. Each 32-bit word is mixed in by xor and the finaliser of SplitMix64, so that every
// bit and the order count. Source: Steele, Lea, Flood: "Fast splittable pseudorandom number generators", OOPSLA 2014.

#include "testbed/engines/state_hash.h"

#include <bit>

namespace testbed {
namespace {

uint64_t Mix(uint64_t h) {
    h += 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
    return h ^ (h >> 31);
}

uint64_t Bits(float value) { return std::bit_cast<uint32_t>(value == 0.0f ? 0.0f : value); }

}  // namespace

uint64_t HashState(std::span<const BodyState> bodies) {
    uint64_t hash = bodies.size();
    for (const BodyState& b : bodies) {
        hash = Mix(hash ^ (Bits(b.position.x) | Bits(b.position.y) << 32));
        hash = Mix(hash ^ (Bits(b.linearVelocity.x) | Bits(b.linearVelocity.y) << 32));
        hash = Mix(hash ^ (Bits(b.angle) | Bits(b.angularVelocity) << 32));
        hash = Mix(hash ^ (b.awake ? 1u : 0u));
    }
    return hash;
}

}  // namespace testbed
