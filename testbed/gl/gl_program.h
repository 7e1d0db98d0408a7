// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What every renderer needs of OpenGL: its functions, programs from sources, and a texture to draw into.

#pragma once

#include <glad/gl.h>

#include "testbed/gl/context.h"

namespace testbed {

/// Loads OpenGL 3.3. Throws BackendError when the driver offers less.
void LoadGl(GladGLContext& gl, FindFunction find, void* user);

/// Throws BackendError with the driver's words.
[[nodiscard]] GLuint LinkProgram(const GladGLContext& gl, const char* vertexSource, const char* fragmentSource);

/// A framebuffer object with one colour texture that takes the size that is asked for.
struct GlTarget {
    GLuint framebuffer = 0, texture = 0;
    int width = 0, height = 0;

    /// Makes it the framebuffer in use. Throws BackendError when the driver cannot make one of this size.
    void Bind(const GladGLContext& gl, GLint format, int wantedWidth, int wantedHeight);
};

}  // namespace testbed
