// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Supersampled layers onto pictures, in integers: every pixel takes the mean of its samples, each weighted by its
// opacity, over what was there.

#pragma once

#include "testbed/picture/image.h"

namespace testbed {

/// `samples` is `supersampling` times as wide and as high as the opaque `picture`, its colours not premultiplied.
/// Throws std::invalid_argument when the sizes do not fit.
void CompositeSamples(const Image& samples, int supersampling, Image& picture);

/// The same for the picture's rows from `top` on, as many as there are samples for.
void CompositeRows(const Image& samples, int supersampling, Image& picture, int top);

/// A colour over a pixel of which it covers `coverage` of 255; the colour's opacity counts.
void BlendPixel(Color& below, Color color, uint8_t coverage);

/// One colour over a rectangle, clipped to the picture; the colour's opacity counts.
void BlendRect(Image& picture, const PixelBox& box, Color color);

}  // namespace testbed
