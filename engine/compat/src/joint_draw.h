// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pictures that several joints share.

#pragma once

#include "../box2d/b2_draw.h"

namespace scree::box2d {

inline const b2Color gray(0.7f, 0.7f, 0.7f), green(0.3f, 0.9f, 0.3f), red(0.9f, 0.3f, 0.3f), blue(0.3f, 0.3f, 0.9f),
    darkGray(0.4f, 0.4f, 0.4f);

/// A joint that moves along an axis: anchors and axis in world coordinates, limits along the axis.
struct SliderPicture {
    b2Vec2 anchorA, anchorB, axis;
    bool hasLimit;
    float lower, upper;
};
void DrawSlider(b2Draw& draw, const SliderPicture& slider);

}  // namespace scree::box2d
