#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Corners of boxes in whole pixels. The viewport is a square whose side is a power of two, so that the division below
// and the viewport's multiplication are exact and every corner lands on the pixel grid.

layout(location = 0) in vec2 corner;
uniform float inverseHalfSide;

void main() {
    gl_Position = vec4(corner * inverseHalfSide - 1.0, 0.0, 1.0);
}
