// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Layers on the CPU in bands of rows. The samples of a band stay in the processor's cache from clearing to compositing.
// Those of a whole picture (33 MB at 1920×1080 and 2×2 samples) would go through memory four times. Bands are
// independent, so threads share them; pixels do not depend on how many.

#pragma once

#include "testbed/picture/draw_list.h"
#include "testbed/picture/image.h"

namespace testbed {

/// The list's triangles over the opaque `picture`, whose size is the list's: the same pixels as RasterizeTriangles into
/// samples and CompositeSamples. `threads` ≥ 1.
void DrawInBands(const DrawList& list, int threads, Image& picture);

}  // namespace testbed
