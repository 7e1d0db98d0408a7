// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// State hashes that every build on every machine must give: testbed::HashState of the bodies after some steps of small
// scenes, and those of round_shapes.h and calls.h. The scenes run as Box2D runs them (caps on, continuous off). After a
// deliberate change of the engine's arithmetic tests/determinism/renew.py writes the hashes anew.

#pragma once

#include <cstdint>

namespace determinism {

struct GoldenHash {
    const char* scene;
    int size;
    int steps;
    uint64_t hash;      ///< sequential impulses
    uint64_t softHash;  ///< soft step, 4 sub-steps
};

inline constexpr GoldenHash golden[] = {
    {"tiles", 30, 60, 0x09305017abf583e2, 0xbf1e3b62fdc337e0},
    {"falling-squares", 16, 200, 0x1f5ba929a69a9c91, 0xd557bf33c504416e},
    {"falling-circles", 16, 200, 0x423f558f6b452cd7, 0x0edd4c7e1f2b92c7},
    {"tumbler", 100, 150, 0x4e1fbec4f17f4f71, 0x46c04218739f8809},
    {"add-pair-400", 400, 40, 0x391bdaa5253195f7, 0x608feb4e4671bedf},
    {"mild-n2", 10, 60, 0x04c69be0b734bc53, 0x9fcd38d97b203760},
    {"n2", 40, 60, 0x2430de8bc485e9f0, 0xba9c6e61d038f0b8},
    {"multi-fixture", 5, 60, 0x2586c8967129a7a0, 0x5e75a03200641f8b},
    {"mostly-static-single", 20, 60, 0x642b833134143ee0, 0x2a47fae2ab139346},
    {"big-mobile", 5, 120, 0xaf812665a3e6aba7, 0x767df767730ffa46},
    {"mixed", 300, 100, 0xd3f1702954dbd6b0, 0x25ab08daf7fa48e1},
    {"slow-explosion", 300, 100, 0x7ed2baff96f70b4f, 0x7ed2baff96f70b4f},
};

/// Of round_shapes.h: sequential impulses, and a step with a tolerance.
inline constexpr uint64_t goldenRound[2] = {0x17234de3d334fe00, 0x4d5af872b8b5d624};

/// Of calls.h, a group each.
inline constexpr uint64_t goldenCalls[20] = {
    0xb14deeb4c79bf44a, 0xd724453616839944, 0xb93d76a09544eaa6, 0x4a7f557e73b5b30f, 0x1f750245cea766bb,
    0x0c9a6315761520e9, 0x383e12c2b89aca64, 0xdd2deefc1246312b, 0x1c281a7d93d29fb0, 0x6f9800d1bba50d30,
    0xd424528a5c8a7eac, 0xd8ba60e09fa68901, 0xf0b3730ae4042ab6, 0xa7959b6bfde92c76, 0x09fc546a48a37155,
    0x1e4f9b5bbc3ff501, 0x947386094e88e28a, 0x781b049f56100d6e, 0x884b4ce2d2fa9cc3, 0xaf963ace72554861,
};

}  // namespace determinism
