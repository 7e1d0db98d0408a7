#version 330 core
// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One per box and pixel; additive blending into a 32-bit float target counts them, exactly up to 2^24.

layout(location = 0) out float count;

void main() {
    count = 1.0;
}
