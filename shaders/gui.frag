#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Panels: the vertex colour times the font's texture, whose white corner serves plain shapes.

in vec2 texturePlace;
in vec4 vertexColor;
uniform sampler2D font;
layout(location = 0) out vec4 color;

void main() {
    color = vertexColor * texture(font, texturePlace);
}
