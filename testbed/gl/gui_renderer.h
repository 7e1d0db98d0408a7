// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Draws the lists that Dear ImGui makes. Its own OpenGL backend opens libGL by itself, which fails under OSMesa and
// EGL; this one uses the functions it is given.

#pragma once

#include <vector>

#include "testbed/gl/gl_program.h"

struct ImDrawData;

namespace testbed {

class GuiRenderer {
public:
    /// Throws BackendError.
    void Load(const GladGLContext& gl);
    /// Coverage of the font's glyphs, one byte a pixel.
    void SetFont(const GladGLContext& gl, const unsigned char* coverage, int width, int height);
    /// Into the framebuffer in use, whose first row is the picture's top.
    void Draw(const GladGLContext& gl, const ImDrawData& data, int width, int height);

private:
    GLuint m_program = 0, m_array = 0, m_vertices = 0, m_indices = 0, m_font = 0;
};

}  // namespace testbed
