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
inline constexpr uint64_t goldenRound[2] = {0x17234de3d334fe00, 0x972087452472fa9d};

/// Of calls.h, a group each.
inline constexpr uint64_t goldenCalls[20] = {
    0x93daff95d6b73c48, 0x11814f3edcecfd63, 0xc68eb2cd36c4aee6, 0x73e5258e14bcf003, 0xcef7eefa3553e7c6,
    0x6afe45b761bb38dd, 0xd0a63b216bbe1c84, 0xff917fc42ea775b0, 0x90306ec14116ec84, 0x341eecf829c05eaa,
    0x1ed296fdd48acb1a, 0x8068237ac38f956c, 0x4ea3889ab0e840f9, 0x4e691a09f2989907, 0xf51f3335f576262e,
    0x0a84cda8e3a412ef, 0xf0f9cf56dd91d0e7, 0x1898ae5ef62b2d11, 0xdf625e89cf0b4184, 0x3670d1ee16961186,
};

}  // namespace determinism
