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
    {"falling-squares", 16, 200, 0x1f5ba929a69a9c91, 0x7af4efd5080a9fcc},
    {"falling-circles", 16, 200, 0x423f558f6b452cd7, 0x0edd4c7e1f2b92c7},
    {"tumbler", 100, 150, 0x4e1fbec4f17f4f71, 0xb071afac360f9611},
    {"add-pair-400", 400, 40, 0x391bdaa5253195f7, 0x608feb4e4671bedf},
    {"mild-n2", 10, 60, 0x04c69be0b734bc53, 0x433c840371e76fb5},
    {"n2", 40, 60, 0x2430de8bc485e9f0, 0xba9c6e61d038f0b8},
    {"multi-fixture", 5, 60, 0x2586c8967129a7a0, 0x5e75a03200641f8b},
    {"mostly-static-single", 20, 60, 0x642b833134143ee0, 0x2a47fae2ab139346},
    {"big-mobile", 5, 120, 0xaf812665a3e6aba7, 0x767df767730ffa46},
    {"mixed", 300, 100, 0xd3f1702954dbd6b0, 0x25ab08daf7fa48e1},
    {"slow-explosion", 300, 100, 0x7ed2baff96f70b4f, 0x7ed2baff96f70b4f},
};

/// Of round_shapes.h: sequential impulses, and a step with a tolerance.
inline constexpr uint64_t goldenRound[2] = {0x17234de3d334fe00, 0xb2c0ab198194575d};

/// Of calls.h, a group each.
inline constexpr uint64_t goldenCalls[20] = {
    0x6838bf0f8f73e342, 0xcbea526988ab2529, 0xda19c09cad30348d, 0x9e530a409660dacf, 0x6227b0d4f4145602,
    0xdc143eb89e9ec84e, 0x0a637d7004a1dcc4, 0x8ad756215d5b3789, 0xa0e5e1e821ada8fc, 0x7ffe9a0b8f42dc91,
    0xb6773c24e8cc1002, 0xd5910ea1bf121d3f, 0xcd5561d06bb6ad0e, 0x249e3d6ad7371be6, 0x09fc546a48a37155,
    0x0a84cda8e3a412ef, 0xb000cbb36a254a90, 0x99879ed62e92d12d, 0x00556845171bc7d5, 0x87260f155950e859,
};

}  // namespace determinism
