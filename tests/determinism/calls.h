// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sequences of calls with any numbers, as the fuzzer of tests/fuzz/calls.h makes them of bytes at random: what no scene
// does.

#pragma once

#include <cstdint>
#include <vector>

#include "testbed/base/hash.h"
#include "tests/fuzz/calls.h"

namespace determinism {

/// Of a group of ten sequences. Their laws are checked, too.
inline uint64_t HashOfCalls(uint64_t group) {
    // Numbers at random that are the same everywhere: Steele, Lea and Flood, Fast splittable pseudorandom number
    // generators (2014).
    uint64_t state = group;
    const auto random = [&state] {
        uint64_t z = state += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return z ^ z >> 31;
    };
    testbed::Fnv1a<uint64_t> sum;
    for (int sequence = 0; sequence < 10; ++sequence) {
        std::vector<uint8_t> bytes(random() % 2048);
        for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
        fuzz::Input input(bytes.data(), bytes.size());
        fuzz::Calls calls(input);
        calls.Run();
        sum.Add(calls.GetHash());
    }
    return sum.Get();
}

}  // namespace determinism
