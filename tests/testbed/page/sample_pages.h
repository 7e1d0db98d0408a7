// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Reports for tests of the pages. One has every kind of block. The other is a comparison of pictures with every kind of
// result, made from two runs of one scene, the second with less gravity.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "testbed/jobs/snapshot/result.h"
#include "testbed/page/page.h"

namespace testbed {

/// Needs the folder for a picture that the page embeds.
[[nodiscard]] Page MakeSamplePage(const std::filesystem::path& folder);

/// How many tree nodes cover a pixel in both pictures of the case `sampleOverlapId`, from the run itself.
struct SampleCount {
    int x, y;
    unsigned expected, actual;
};

inline constexpr const char* sampleOverlapId = "tumbler/step-0120-overlap";

struct SampleComparison {
    SnapshotOrigin origin;
    std::vector<SnapshotResult> results;
    std::vector<SampleCount> counts;  ///< grown, fallen, kept; outside the labels
};

/// Leaves expected/, actual/ and diff/ in the folder.
[[nodiscard]] SampleComparison MakeSampleComparison(const std::filesystem::path& folder);

}  // namespace testbed
