#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A pixel's count through a table of colours; counts beyond the table take its last colour.

uniform sampler2D counts;
uniform sampler2D palette;
uniform ivec2 origin;
layout(location = 0) out vec4 color;

void main() {
    int count = int(texelFetch(counts, ivec2(gl_FragCoord.xy) - origin, 0).r);
    color = vec4(texelFetch(palette, ivec2(min(count, textureSize(palette, 0).x - 1), 0), 0).rgb, 1.0);
}
