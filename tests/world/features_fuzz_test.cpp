// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Leaving out what nobody uses changes no bit. The features of small random worlds come and go in mid-run. They are
// stepped with everything on, with what they use at the moment, and with a fixed set of what they use at any time. The
// state hash is the same after every step. How often each feature was on and off is counted.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/world/life.h"

namespace scree::test {
namespace {

constexpr int stepCount = 24;
constexpr int worldCount = 1200;

TEST(FeaturesFuzz, LeavingOutWhatNobodyUsesChangesNoBit) {
    std::array<int, featureCount> on{}, off{};
    int kernelsDiffer = 0, kernelChanges = 0;
    for (uint32_t seed = 0; seed < worldCount && !HasFailure(); ++seed) {
        Life automatic(seed, FeatureMode::automatic, Features::All());
        Life full(seed, FeatureMode::full, Features::All());
        std::vector<uint64_t> hashes;
        KernelSet before = automatic.GetKernels();
        for (int step = 0; step < stepCount; ++step) {
            hashes.push_back(automatic.Step());
            ASSERT_EQ(hashes.back(), full.Step()) << "full, world " << seed << ", step " << step;
            automatic.ExpectCountsHold();
            kernelsDiffer += automatic.GetKernels() == full.GetKernels() ? 0 : 1;
            kernelChanges += step > 0 && !(automatic.GetKernels() == before) ? 1 : 0;
            before = automatic.GetKernels();
            const Features used = automatic.GetUsedInStep();
            for (size_t i = 0; i < on.size(); ++i) ++(used.Has(static_cast<Feature>(i)) ? on : off)[i];
        }
        Life minimal(seed, FeatureMode::fixed, automatic.GetUsed());
        for (int step = 0; step < stepCount; ++step) {
            ASSERT_EQ(hashes[static_cast<size_t>(step)], minimal.Step())
                << "minimal, world " << seed << ", step " << step;
        }
    }
    for (size_t i = 0; i < on.size(); ++i) {
        std::printf("%-18s on in %6d steps, off in %6d\n", featureNames[i], on[i], off[i]);
        EXPECT_GT(on[i], worldCount / 20) << featureNames[i];
        EXPECT_GT(off[i], worldCount / 20) << featureNames[i];
    }
    std::printf("smaller kernels than full in %d of %d steps; changed in mid-run %d times\n", kernelsDiffer,
                worldCount * stepCount, kernelChanges);
    EXPECT_GT(kernelsDiffer, worldCount * stepCount / 4);
    EXPECT_GT(kernelChanges, worldCount);
}

}  // namespace
}  // namespace scree::test
