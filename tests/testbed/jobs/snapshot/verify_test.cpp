// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `snapshot verify` must fail when one way differs: a pixel, a state, a size, and a way that cannot finish.

#include "testbed/jobs/snapshot/verify.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "testbed/jobs/snapshot/check.h"

namespace testbed {
namespace {

constexpr std::array<VerifyWay, 4> ways{VerifyWay{Backend::cpu, 1}, VerifyWay{Backend::cpu, 1, true},
                                        VerifyWay{Backend::cpu, 2}, VerifyWay{Backend::osmesa, 2}};

std::vector<VerifyRun> Verify(const std::vector<SnapshotCase>& cases, const Distortion& distortion) {
    return VerifySnapshots(cases, ways, {}, 2, distortion);
}

/// What is found when one picture of one way is distorted: only that way, and only in that case.
void ExpectFound(const char* what, const std::function<void(SnapshotPicture&)>& distort) {
    const std::vector<SnapshotCase> cases = SelectCases(GetSnapshotCatalog(), "^joint-wheel/");
    ASSERT_GT(cases.size(), 2u);
    const std::size_t distorted = 1;
    for (std::size_t way = 1; way < ways.size(); ++way) {
        const std::vector<VerifyRun> runs =
            Verify(cases, [&](const VerifyWay& made, const SnapshotCase& snapshotCase, SnapshotPicture& picture) {
                const bool isIt =
                    made.GetName() == ways[way].GetName() && snapshotCase.GetId() == cases[distorted].GetId();
                if (isIt) distort(picture);
            });
        ASSERT_EQ(runs.size(), ways.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const std::vector<std::string> expected =
                i == distorted ? std::vector{ways[way].GetName()} : std::vector<std::string>{};
            EXPECT_EQ(FindDeviants(runs, i), expected) << what << ", " << cases[i].GetId();
        }
    }
}

TEST(SnapshotVerify, FindsTheWayWhosePictureDiffersInOneBitOfOnePixel) {
    ExpectFound("a pixel", [](SnapshotPicture& picture) { picture.image.pixels[12345].g ^= 1; });
}

TEST(SnapshotVerify, FindsTheWayWhoseStateDiffersUnderEqualPixels) {
    ExpectFound("a state", [](SnapshotPicture& picture) { picture.sidecar["state_hash"] = "0123456789abcdef"; });
}

TEST(SnapshotVerify, FindsTheWayWhosePictureHasAnotherShape) {
    ExpectFound("a shape", [](SnapshotPicture& picture) { std::swap(picture.image.width, picture.image.height); });
}

TEST(SnapshotVerify, AWayThatCannotFinishIsNoEqualWay) {
    const std::vector<SnapshotCase> cases = SelectCases(GetSnapshotCatalog(), "^joint-wheel/");
    const std::vector<VerifyRun> runs = Verify(cases, [](const VerifyWay& way, const SnapshotCase&, SnapshotPicture&) {
        if (way.threads == 2 && way.backend == Backend::cpu) throw std::runtime_error("out of paint");
    });
    EXPECT_EQ(runs[2].problem, "out of paint");
    EXPECT_TRUE(runs[2].hashes.empty());
    EXPECT_EQ(runs[0].hashes.size(), cases.size());
}

}  // namespace
}  // namespace testbed
