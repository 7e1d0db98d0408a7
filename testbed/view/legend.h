// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the colours of layers mean, as swatches and words in a grid along a picture's lower edge. How many entries there
// are depends on the layers alone, so that the frames of an animation share one camera.

#pragma once

#include <string>
#include <vector>

#include "testbed/view/picture.h"

namespace testbed {

struct LegendEntry {
    std::vector<Color> swatches;  ///< one, or the colours that are taken in turn
    std::string text;             ///< fits its cell of the grid
};

/// Scales are those of `given`, or of the snapshot. `nodes`: those of the tree that are drawn.
[[nodiscard]] std::vector<LegendEntry> MakeLegend(const Snapshot& snapshot, const Layers& layers, Theme theme,
                                                  const std::optional<Peaks>& given = std::nullopt,
                                                  const NodeSelection& nodes = {});

/// Pixels for the text of an entry with so many swatches, at scale 1.
[[nodiscard]] int GetLegendTextRoom(int swatches);

/// Height of the legend's strip on a picture of this width, pixels; 0 without entries.
[[nodiscard]] int GetLegendHeight(const Layers& layers, int width);

void DrawLegend(Image& image, const std::vector<LegendEntry>& entries, Theme theme);

}  // namespace testbed
