// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The picture of sliders.

#include "joint_draw.h"

namespace scree::box2d {

void DrawSlider(b2Draw& draw, const SliderPicture& slider) {
    draw.DrawSegment(slider.anchorA, slider.anchorB, darkGray);
    if (slider.hasLimit) {
        const b2Vec2 half = 0.5f * slider.axis.Skew();
        const b2Vec2 lower = slider.anchorA + slider.lower * slider.axis;
        const b2Vec2 upper = slider.anchorA + slider.upper * slider.axis;
        draw.DrawSegment(lower, upper, gray);
        draw.DrawSegment(lower - half, lower + half, green);
        draw.DrawSegment(upper - half, upper + half, red);
    } else {
        draw.DrawSegment(slider.anchorA - slider.axis, slider.anchorA + slider.axis, gray);
    }
    draw.DrawPoint(slider.anchorA, 5.0f, gray);
    draw.DrawPoint(slider.anchorB, 5.0f, blue);
}

}  // namespace scree::box2d
