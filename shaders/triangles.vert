#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Corners in 1/256 of a sample, and a colour for the whole triangle. As in boxes.vert the viewport is a square whose
// side is a power of two, so that the corners reach the rasteriser without rounding.

layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 color;
uniform float inverseHalfSide;
flat out vec4 triangleColor;

void main() {
    triangleColor = color;
    gl_Position = vec4(corner * inverseHalfSide - 1.0, 0.0, 1.0);
}
