// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fuzzers' laws on some inputs at random. tests/fuzz/run looks for inputs with a compiler's help; this holds the
// fuzzers to what they test.

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/fuzz/input.h"

#define SCREE_FUZZER(name) extern "C" int Fuzz_##name(const uint8_t* data, size_t size);
SCREE_FUZZERS
#undef SCREE_FUZZER

namespace fuzz {
namespace {

struct Fuzzer {
    const char* name;
    int (*run)(const uint8_t* data, size_t size);
};
#define SCREE_FUZZER(name) {#name, Fuzz_##name},
constexpr Fuzzer fuzzers[] = {SCREE_FUZZERS};
#undef SCREE_FUZZER

class Fuzzers : public testing::TestWithParam<Fuzzer> {
protected:
    void SetUp() override {
        onBroken = [](const char* law) { throw std::logic_error(law); };
    }
};

TEST_P(Fuzzers, FindNoBrokenLawInInputsAtRandom) {
    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    constexpr int inputs = 2000;
    constexpr size_t few = 16, most = 1024;  // of few edits more is left to go wrong
    std::vector<uint8_t> input;
    for (int i = 0; i < inputs; ++i) {
        input.resize(random() % (i % 2 == 0 ? few : most));
        for (uint8_t& byte : input) byte = static_cast<uint8_t>(random());
        ASSERT_NO_THROW(GetParam().run(input.data(), input.size())) << "seed " << seed << ", input " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Fuzzers, testing::ValuesIn(fuzzers),
                         [](const testing::TestParamInfo<Fuzzer>& fuzzer) { return fuzzer.param.name; });

TEST(FuzzLaws, AreKnownWhenBroken) {
    onBroken = [](const char* law) { throw std::logic_error(law); };
    EXPECT_NO_THROW(Demand(true, "what holds"));
    EXPECT_THROW(Demand(false, "what does not"), std::logic_error);
}

}  // namespace
}  // namespace fuzz
