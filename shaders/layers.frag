#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The mean of a pixel's samples, weighted by their opacity: premultiplied, to be blended over what is there.

uniform sampler2D samples;
uniform int samplesAcross;
uniform ivec2 origin;
layout(location = 0) out vec4 color;

void main() {
    ivec2 first = (ivec2(gl_FragCoord.xy) - origin) * samplesAcross;
    vec4 sum = vec4(0.0);
    for (int y = 0; y < samplesAcross; ++y) {
        for (int x = 0; x < samplesAcross; ++x) {
            vec4 texel = texelFetch(samples, first + ivec2(x, y), 0);
            sum += vec4(texel.rgb * texel.a, texel.a);
        }
    }
    color = sum / float(samplesAcross * samplesAcross);
}
