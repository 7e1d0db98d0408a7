// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Triangles to pixels on the CPU, equal to OpenGL's result sample for sample: integer edge functions on the 1/256 grid
// (Pineda, "A parallel algorithm for polygon rasterization", 1988) and the same rule for samples on an edge.

#pragma once

#include <span>

#include "testbed/picture/draw_list.h"
#include "testbed/picture/image.h"

namespace testbed {

/// Draws over `image`, in order, each triangle replacing what it covers.
void RasterizeTriangles(std::span<const Triangle> triangles, Image& image);

}  // namespace testbed
