#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The triangle's colour, replacing what was there: blending happens later, in integers.

flat in vec4 triangleColor;
layout(location = 0) out vec4 color;

void main() {
    color = triangleColor;
}
