// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One buffer per list and a scissor per command, as Dear ImGui's documentation of its draw data asks.

#include "testbed/gl/gui_renderer.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "testbed_generated/shader_sources.h"

namespace testbed {

void GuiRenderer::Load(const GladGLContext& gl) {
    m_program = LinkProgram(gl, shaders::guiVertex, shaders::guiFragment);
    gl.GenVertexArrays(1, &m_array);
    gl.BindVertexArray(m_array);
    gl.GenBuffers(1, &m_vertices);
    gl.GenBuffers(1, &m_indices);
    gl.BindBuffer(GL_ARRAY_BUFFER, m_vertices);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices);
    const auto at = [](size_t offset) { return reinterpret_cast<const void*>(offset); };
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, pos)));
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, uv)));
    gl.EnableVertexAttribArray(2);
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, col)));
}

void GuiRenderer::SetFont(const GladGLContext& gl, const unsigned char* coverage, int width, int height) {
    if (m_font == 0) gl.GenTextures(1, &m_font);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, m_font);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    // White, with the coverage as opacity.
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ONE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_ONE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_ONE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_A, GL_RED);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, coverage);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void GuiRenderer::Draw(const GladGLContext& gl, const ImDrawData& data, int width, int height) {
    gl.Viewport(0, 0, width, height);
    gl.UseProgram(m_program);
    gl.Uniform2f(gl.GetUniformLocation(m_program, "inverseHalfSize"), 2.0f / static_cast<float>(width),
                 2.0f / static_cast<float>(height));
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, m_font);
    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_SCISSOR_TEST);
    gl.BindVertexArray(m_array);
    gl.BindBuffer(GL_ARRAY_BUFFER, m_vertices);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.VtxBuffer.Size) * sizeof(ImDrawVert),
                      list.VtxBuffer.Data, GL_STREAM_DRAW);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.IdxBuffer.Size) * sizeof(ImDrawIdx),
                      list.IdxBuffer.Data, GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr) continue;  // no panel sets one
            const int x0 = std::max(0, static_cast<int>(command.ClipRect.x));
            const int y0 = std::max(0, static_cast<int>(command.ClipRect.y));
            const int x1 = std::min(width, static_cast<int>(command.ClipRect.z));
            const int y1 = std::min(height, static_cast<int>(command.ClipRect.w));
            if (x0 >= x1 || y0 >= y1) continue;
            gl.Scissor(x0, y0, x1 - x0, y1 - y0);
            gl.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                      sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                      reinterpret_cast<const void*>(size_t{command.IdxOffset} * sizeof(ImDrawIdx)),
                                      static_cast<GLint>(command.VtxOffset));
        }
    }
    gl.Disable(GL_SCISSOR_TEST);
    gl.Disable(GL_BLEND);
}

}  // namespace testbed
