// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Vertices up, one draw call, pixels down. Corners travel as floats on a grid that floats hold exactly; see
// shaders/boxes.vert for why the viewport is a power of two.

#include "testbed/gl/gl_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "testbed/gl/gl_program.h"
#include "testbed_generated/shader_sources.h"

namespace testbed {

namespace {

constexpr size_t maxCount = size_t{1} << 24;  // whole numbers that a 32-bit float holds exactly

struct TriangleVertex {
    float x, y;
    Color color;
};

}  // namespace

struct GlRenderer::State {
    std::unique_ptr<Context> context;
    GladGLContext gl{};
    GLuint boxProgram = 0, triangleProgram = 0;
    GLint boxScale = -1, triangleScale = -1;
    GLuint boxArray = 0, triangleArray = 0, boxBuffer = 0, boxIndices = 0, triangleBuffer = 0;
    size_t indexedBoxes = 0;  // boxes that boxIndices reaches
    GlTarget countTarget, layerTarget;
    std::vector<float> floats;
    std::vector<TriangleVertex> vertices;

    void Load();
    void MakeBuffers();
    void UploadIndices(size_t boxes);
    void SetViewport(GLint scaleLocation, int width, int height, float unitsPerPixel);
};

void GlRenderer::State::Load() {
    const auto find = [](void* user, const char* name) { return static_cast<const Context*>(user)->GetFunction(name); };
    LoadGl(gl, find, context.get());
    boxProgram = LinkProgram(gl, shaders::boxesVertex, shaders::boxesFragment);
    boxScale = gl.GetUniformLocation(boxProgram, "inverseHalfSide");
    triangleProgram = LinkProgram(gl, shaders::trianglesVertex, shaders::trianglesFragment);
    triangleScale = gl.GetUniformLocation(triangleProgram, "inverseHalfSide");
    MakeBuffers();
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_DITHER);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
}

void GlRenderer::State::MakeBuffers() {
    gl.GenVertexArrays(1, &boxArray);
    gl.BindVertexArray(boxArray);
    gl.GenBuffers(1, &boxBuffer);
    gl.GenBuffers(1, &boxIndices);
    gl.BindBuffer(GL_ARRAY_BUFFER, boxBuffer);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, boxIndices);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 2 * sizeof(float), nullptr);

    gl.GenVertexArrays(1, &triangleArray);
    gl.BindVertexArray(triangleArray);
    gl.GenBuffers(1, &triangleBuffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, triangleBuffer);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(TriangleVertex), nullptr);
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(TriangleVertex),
                           reinterpret_cast<const void*>(offsetof(TriangleVertex, color)));
}

void GlRenderer::State::UploadIndices(size_t boxes) {
    if (boxes <= indexedBoxes) return;
    std::vector<uint32_t> indices(boxes * 6);
    for (size_t i = 0; i < boxes; ++i) {
        constexpr std::array<uint32_t, 6> corners{0, 1, 2, 0, 2, 3};
        for (size_t k = 0; k < 6; ++k) indices[6 * i + k] = static_cast<uint32_t>(4 * i) + corners[k];
    }
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(uint32_t)), indices.data(),
                  GL_STATIC_DRAW);
    indexedBoxes = boxes;
}

void GlRenderer::State::SetViewport(GLint scaleLocation, int width, int height, float unitsPerPixel) {
    const auto side = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(width, height))));
    gl.Viewport(0, 0, side, side);
    gl.Uniform1f(scaleLocation, 2.0f / (static_cast<float>(side) * unitsPerPixel));
}

GlRenderer::GlRenderer(std::unique_ptr<Context> context) : m_state(std::make_unique<State>()) {
    m_state->context = std::move(context);
    m_state->context->MakeCurrent();
    m_state->Load();
}

// The context frees its objects when it goes.
GlRenderer::~GlRenderer() = default;

Backend GlRenderer::GetBackend() const { return m_state->context->GetBackend(); }

std::string GlRenderer::GetName() const {
    m_state->context->MakeCurrent();
    return reinterpret_cast<const char*>(m_state->gl.GetString(GL_RENDERER));
}

std::string GlRenderer::GetVersion() const {
    m_state->context->MakeCurrent();
    return reinterpret_cast<const char*>(m_state->gl.GetString(GL_VERSION));
}

CountImage GlRenderer::Count(std::span<const PixelRect> rects, int width, int height) {
    std::vector<PixelBox> boxes;
    boxes.reserve(rects.size());
    for (const PixelRect& rect : rects) {
        const PixelBox box = SnapRect(rect, width, height);
        if (box.x0 < box.x1) boxes.push_back(box);
    }
    return CountBoxes(boxes, width, height);
}

CountImage GlRenderer::CountBoxes(std::span<const PixelBox> boxes, int width, int height) {
    if (boxes.size() > maxCount) throw std::invalid_argument("more than 2^24 boxes in one picture");
    State& state = *m_state;
    const GladGLContext& gl = state.gl;
    state.context->MakeCurrent();
    state.countTarget.Bind(gl, GL_R32F, width, height);
    gl.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    if (!boxes.empty()) {
        state.floats.clear();
        for (const PixelBox& box : boxes) {
            const auto x0 = static_cast<float>(box.x0), y0 = static_cast<float>(box.y0);
            const auto x1 = static_cast<float>(box.x1), y1 = static_cast<float>(box.y1);
            state.floats.insert(state.floats.end(), {x0, y0, x1, y0, x1, y1, x0, y1});
        }
        gl.BindVertexArray(state.boxArray);
        state.UploadIndices(boxes.size());
        gl.BindBuffer(GL_ARRAY_BUFFER, state.boxBuffer);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(state.floats.size() * sizeof(float)),
                      state.floats.data(), GL_STREAM_DRAW);
        gl.UseProgram(state.boxProgram);
        state.SetViewport(state.boxScale, width, height, 1.0f);
        gl.Enable(GL_BLEND);
        gl.BlendEquation(GL_FUNC_ADD);
        gl.BlendFunc(GL_ONE, GL_ONE);
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(boxes.size() * 6), GL_UNSIGNED_INT, nullptr);
    }
    CountImage image{width, height, {}};
    state.floats.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
    gl.ReadPixels(0, 0, width, height, GL_RED, GL_FLOAT, state.floats.data());
    image.counts.resize(state.floats.size());
    std::transform(state.floats.begin(), state.floats.end(), image.counts.begin(),
                   [](float count) { return static_cast<uint32_t>(static_cast<int32_t>(count)); });
    return image;
}

void GlRenderer::Draw(std::span<const Triangle> triangles, Image& samples) {
    State& state = *m_state;
    const GladGLContext& gl = state.gl;
    state.context->MakeCurrent();
    state.layerTarget.Bind(gl, GL_RGBA8, samples.width, samples.height);
    gl.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    if (!triangles.empty()) {
        state.vertices.clear();
        state.vertices.reserve(triangles.size() * 3);
        for (const Triangle& triangle : triangles) {
            for (const FixedPoint& point : {triangle.a, triangle.b, triangle.c}) {
                state.vertices.push_back({static_cast<float>(point.x), static_cast<float>(point.y), triangle.color});
            }
        }
        gl.BindVertexArray(state.triangleArray);
        gl.BindBuffer(GL_ARRAY_BUFFER, state.triangleBuffer);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(state.vertices.size() * sizeof(TriangleVertex)),
                      state.vertices.data(), GL_STREAM_DRAW);
        gl.UseProgram(state.triangleProgram);
        state.SetViewport(state.triangleScale, samples.width, samples.height, static_cast<float>(fixedPointOne));
        gl.Disable(GL_BLEND);
        gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(state.vertices.size()));
    }
    gl.ReadPixels(0, 0, samples.width, samples.height, GL_RGBA, GL_UNSIGNED_BYTE, samples.pixels.data());
}

}  // namespace testbed
