// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two pictures compared pixel by pixel under a rule (tolerance and mask), and the picture of their difference.

#pragma once

#include "testbed/render/image.h"
#include "testbed/report/snapshot_result.h"

namespace testbed {

/// Decoded pixels, all four channels. Throws std::invalid_argument for pictures of different sizes. O(pixels).
[[nodiscard]] PixelDifference ComparePixels(const Image& expected, const Image& actual, const CompareRule& rule);

/// The expected picture in dim grey; changed pixels from yellow (small) to red (large difference), tolerated ones blue,
/// differences under the mask green. Both pictures of one size, as in ComparePixels.
[[nodiscard]] Image MakeDifferencePicture(const Image& expected, const Image& actual, const CompareRule& rule);

}  // namespace testbed
