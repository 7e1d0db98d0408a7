#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Panels: corners in pixels, top row first.

layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 color;
uniform vec2 inverseHalfSize;
out vec2 texturePlace;
out vec4 vertexColor;

void main() {
    texturePlace = place;
    vertexColor = color;
    gl_Position = vec4(corner * inverseHalfSize - 1.0, 0.0, 1.0);
}
