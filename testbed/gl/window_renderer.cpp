// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Few state changes and one upload per primitive: a software rasteriser spends its time on pixels and vertices. Counts
// and layers go through targets of their own: counts are numbers, and the fragments of a layer replace each other.

#include "testbed/gl/window_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include "testbed/gl/gl_program.h"
#include "testbed/gl/gui_renderer.h"
#include "testbed_generated/shader_sources.h"

namespace testbed {

namespace {

struct LayerVertex {
    float x, y;
    Color color;
};

constexpr size_t maxRects = size_t{1} << 24;  // whole numbers that a 32-bit float holds exactly

}  // namespace

struct WindowRenderer::State {
    GladGLContext gl{};
    GuiRenderer gui;
    GLuint boxProgram = 0, triangleProgram = 0, countProgram = 0, layerProgram = 0;
    GLuint emptyArray = 0, boxArray = 0, boxBuffer = 0, layerArray = 0, layerBuffer = 0, paletteTexture = 0;
    GlTarget screen, countTarget, layerTarget;
    std::vector<float> corners;
    std::vector<LayerVertex> vertices;

    void Load(FindFunction find, void* user);
    void BindScreen() { screen.Bind(gl, GL_RGBA8, screen.width, screen.height); }
    /// The viewport is a square whose side is a power of two, so that corners reach the rasteriser without rounding.
    void SetViewport(GLuint program, int width, int height, float unitsPerPixel) const;
    /// Runs a program over all pixels of an area of the screen; it reads `texture` as unit 0.
    void Cover(GLuint program, const PixelBox& area, GLuint texture);
    [[nodiscard]] GLint At(GLuint program, const char* name) const { return gl.GetUniformLocation(program, name); }
};

void WindowRenderer::State::Load(FindFunction find, void* user) {
    LoadGl(gl, find, user);
    gui.Load(gl);
    boxProgram = LinkProgram(gl, shaders::boxesVertex, shaders::boxesFragment);
    triangleProgram = LinkProgram(gl, shaders::trianglesVertex, shaders::trianglesFragment);
    countProgram = LinkProgram(gl, shaders::screenVertex, shaders::countsFragment);
    layerProgram = LinkProgram(gl, shaders::screenVertex, shaders::layersFragment);
    gl.GenVertexArrays(1, &emptyArray);

    gl.GenVertexArrays(1, &boxArray);
    gl.BindVertexArray(boxArray);
    gl.GenBuffers(1, &boxBuffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, boxBuffer);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 2 * sizeof(float), nullptr);

    gl.GenVertexArrays(1, &layerArray);
    gl.BindVertexArray(layerArray);
    gl.GenBuffers(1, &layerBuffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, layerBuffer);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(LayerVertex), nullptr);
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(LayerVertex),
                           reinterpret_cast<const void*>(offsetof(LayerVertex, color)));

    gl.GenTextures(1, &paletteTexture);
    gl.BindTexture(GL_TEXTURE_2D, paletteTexture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_DITHER);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
}

void WindowRenderer::State::SetViewport(GLuint program, int width, int height, float unitsPerPixel) const {
    const auto side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(width, height))));
    gl.Viewport(0, 0, side, side);
    gl.Uniform1f(At(program, "inverseHalfSide"), 2.0f / (static_cast<float>(side) * unitsPerPixel));
}

void WindowRenderer::State::Cover(GLuint program, const PixelBox& area, GLuint texture) {
    BindScreen();
    gl.UseProgram(program);
    gl.Viewport(area.x0, area.y0, area.x1 - area.x0, area.y1 - area.y0);
    gl.Uniform2i(At(program, "origin"), area.x0, area.y0);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.BindVertexArray(emptyArray);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

WindowRenderer::WindowRenderer(FindFunction find, void* user) : m_state(std::make_unique<State>()) {
    m_state->Load(find, user);
}

// The context frees its objects when it goes.
WindowRenderer::~WindowRenderer() = default;

void WindowRenderer::SetFont(const unsigned char* coverage, int width, int height) {
    m_state->gui.SetFont(m_state->gl, coverage, width, height);
}

void WindowRenderer::Begin(int width, int height, Color background) {
    State& s = *m_state;
    s.screen.Bind(s.gl, GL_RGBA8, width, height);
    s.gl.ClearColor(static_cast<float>(background.r) / 255, static_cast<float>(background.g) / 255,
                    static_cast<float>(background.b) / 255, 1);
    s.gl.Clear(GL_COLOR_BUFFER_BIT);
}

void WindowRenderer::DrawCounts(const PixelBox& area, std::span<const PixelRect> rects,
                                std::span<const Color> palette) {
    State& s = *m_state;
    const GladGLContext& gl = s.gl;
    const int width = area.x1 - area.x0, height = area.y1 - area.y0;
    s.countTarget.Bind(gl, GL_R32F, width, height);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    s.corners.clear();
    for (const PixelRect& rect : rects.first(std::min(rects.size(), maxRects))) {
        const PixelBox box = SnapRect(rect, width, height);
        if (box.x0 >= box.x1 || box.y0 >= box.y1) continue;
        const auto x0 = static_cast<float>(box.x0), y0 = static_cast<float>(box.y0);
        const auto x1 = static_cast<float>(box.x1), y1 = static_cast<float>(box.y1);
        s.corners.insert(s.corners.end(), {x0, y0, x1, y0, x1, y1, x0, y0, x1, y1, x0, y1});
    }
    if (!s.corners.empty()) {
        gl.BindVertexArray(s.boxArray);
        gl.BindBuffer(GL_ARRAY_BUFFER, s.boxBuffer);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(s.corners.size() * sizeof(float)), s.corners.data(),
                      GL_STREAM_DRAW);
        gl.UseProgram(s.boxProgram);
        s.SetViewport(s.boxProgram, width, height, 1);
        gl.Enable(GL_BLEND);
        gl.BlendEquation(GL_FUNC_ADD);
        gl.BlendFunc(GL_ONE, GL_ONE);
        gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(s.corners.size() / 2));
    }
    gl.Disable(GL_BLEND);
    gl.ActiveTexture(GL_TEXTURE1);
    gl.BindTexture(GL_TEXTURE_2D, s.paletteTexture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(palette.size()), 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  palette.data());
    gl.UseProgram(s.countProgram);
    gl.Uniform1i(s.At(s.countProgram, "palette"), 1);
    s.Cover(s.countProgram, area, s.countTarget.texture);
}

void WindowRenderer::DrawLayers(const PixelBox& area, const DrawList& list) {
    State& s = *m_state;
    const GladGLContext& gl = s.gl;
    if (list.triangles.empty()) return;
    const int width = list.width * list.supersampling, height = list.height * list.supersampling;
    s.layerTarget.Bind(gl, GL_RGBA8, width, height);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Disable(GL_BLEND);
    s.vertices.clear();
    s.vertices.reserve(list.triangles.size() * 3);
    for (const Triangle& triangle : list.triangles) {
        for (const FixedPoint& point : {triangle.a, triangle.b, triangle.c}) {
            s.vertices.push_back({static_cast<float>(point.x), static_cast<float>(point.y), triangle.color});
        }
    }
    gl.BindVertexArray(s.layerArray);
    gl.BindBuffer(GL_ARRAY_BUFFER, s.layerBuffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(s.vertices.size() * sizeof(LayerVertex)), s.vertices.data(),
                  GL_STREAM_DRAW);
    gl.UseProgram(s.triangleProgram);
    s.SetViewport(s.triangleProgram, width, height, static_cast<float>(fixedPointOne));
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(s.vertices.size()));

    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.UseProgram(s.layerProgram);
    gl.Uniform1i(s.At(s.layerProgram, "samplesAcross"), list.supersampling);
    s.Cover(s.layerProgram, area, s.layerTarget.texture);
    gl.Disable(GL_BLEND);
}

void WindowRenderer::DrawPanels(const ImDrawData& data) {
    m_state->BindScreen();
    m_state->gui.Draw(m_state->gl, data, m_state->screen.width, m_state->screen.height);
}

void WindowRenderer::Present() {
    const GladGLContext& gl = m_state->gl;
    const int width = m_state->screen.width, height = m_state->screen.height;
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, m_state->screen.framebuffer);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, width, height, 0, height, width, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Image WindowRenderer::Read() {
    m_state->BindScreen();
    Image image(m_state->screen.width, m_state->screen.height, {0, 0, 0, 255});
    m_state->gl.ReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    for (Color& pixel : image.pixels) pixel.a = 255;
    return image;
}

}  // namespace testbed
