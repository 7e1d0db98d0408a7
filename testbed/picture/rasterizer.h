// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Triangles to pixels on the CPU, equal to OpenGL's result sample for sample. Edge functions are integers on a grid of
// 1/256 pixel (Pineda, "A parallel algorithm for polygon rasterization", 1988), and samples on an edge follow the same
// rule as in OpenGL.

#pragma once

#include <span>

#include "testbed/picture/draw_list.h"
#include "testbed/picture/image.h"

namespace testbed {

/// Draws over `image`, in order, each triangle replacing what it covers.
void RasterizeTriangles(std::span<const Triangle> triangles, Image& image);

}  // namespace testbed
