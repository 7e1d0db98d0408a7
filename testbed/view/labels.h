// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The words and numbers on overlap pictures, and where they stand: a strip above and one below a pane, captions and a
// common colour bar under a comparison.

#pragma once

#include <span>
#include <string>

#include "testbed/picture/palette.h"
#include "testbed/view/annotate.h"
#include "testbed/view/camera.h"
#include "testbed/view/picture.h"

namespace testbed {

/// Space that the strips of a picture take, and a small margin around the bodies.
[[nodiscard]] Margins GetPictureMargins(const PictureOptions& options);

/// "tiles   size 200   step 90".
[[nodiscard]] std::string MakeTitle(const Snapshot& snapshot);
/// "scree   unified   22101 bodies".
[[nodiscard]] std::string MakeEngineText(const Snapshot& snapshot);
/// "22100 internal nodes".
[[nodiscard]] std::string MakeNodesText(const OverlapStats& stats, const PictureOptions& options);
/// "overlap max 12   mean 3.40   p99 9   sibling overlap 0.01".
[[nodiscard]] std::string MakeStatsText(const OverlapStats& stats, const std::string& note);

/// A strip along the picture's upper edge with one line: `left` at its left end, `right` at its right end.
void DrawHeader(Image& image, const std::string& left, const std::string& right, Theme theme = Theme::dark);

/// The bar of a count scale with numbered ticks, its end first. In the alpha style it ends where more layers no longer
/// change the colour.
[[nodiscard]] ColorBar MakeCountBar(const PixelBox& box, uint32_t scaleMax, const PictureOptions& options);

/// The strips of overlap panes: title, numbers and colour bar, in letters of one size.
void DrawPaneLabels(std::span<const PaneInput> inputs, std::span<OverlapPane> panes, uint32_t scaleMax,
                    const PictureOptions& options);

/// The strip along the lower edge of a difference picture whose colours end at ±`end`.
void DrawDifferenceFooter(Image& image, const DifferenceStats& stats, int64_t end, const std::string& firstName,
                          const std::string& secondName, Theme theme);

/// Height of the lower strip of both, pixels.
[[nodiscard]] int GetFooterHeight(int width);

/// Panes beside each other in a row of a comparison: all up to three, then as many as rows.
[[nodiscard]] int GetCompareColumns(std::size_t panes);

/// Scale of all letters of a comparison, by the width of one pane alone: all frames of an animation are of one size.
[[nodiscard]] int GetCompareScale(int paneWidth);

/// Puts pane pictures of one size beside each other under a title, with captions and the common colour bar.
[[nodiscard]] Image MakeCompare(std::span<const PaneInput> inputs, std::span<const OverlapPane> panes,
                                std::span<const Image> pictures, uint32_t scaleMax, const PictureOptions& options);

/// Pixels between the panes of a comparison.
inline constexpr int compareGap = 8;

}  // namespace testbed
