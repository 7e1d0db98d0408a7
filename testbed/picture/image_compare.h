// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two pictures compared pixel by pixel under a rule (tolerance and mask), and the picture of their difference.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbed/picture/image.h"

namespace testbed {

/// x0 ≤ x < x1, y0 ≤ y < y1, pixels, y down.
struct PixelArea {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    friend bool operator==(const PixelArea&, const PixelArea&) = default;
};

/// How two pictures are compared.
struct CompareRule {
    int tolerance = 0;            ///< largest difference of a channel that does not count, 0 … 255
    std::vector<PixelArea> mask;  ///< pixels in any of these do not count
    std::string source = "default";
    std::string reason;  ///< why the rule is not the default
};

/// What the comparison of two pictures of one size found.
struct PixelDifference {
    int64_t changed = 0;    ///< pixels that count and differ by more than the tolerance
    int64_t tolerated = 0;  ///< pixels that differ, but not by more
    int64_t masked = 0;     ///< pixels that differ under the mask
    int maxDifference = 0;  ///< largest difference of a channel over the changed pixels
    PixelArea box;          ///< around the changed pixels; empty without any
};

/// Decoded pixels, all four channels. Throws std::invalid_argument for pictures of different sizes. O(pixels).
[[nodiscard]] PixelDifference ComparePixels(const Image& expected, const Image& actual, const CompareRule& rule);

/// The expected picture in dim grey; changed pixels from yellow (small) to red (large difference), tolerated ones blue,
/// differences under the mask green. Both pictures of one size, as in ComparePixels.
[[nodiscard]] Image MakeDifferencePicture(const Image& expected, const Image& actual, const CompareRule& rule);

}  // namespace testbed
