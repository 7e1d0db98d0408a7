// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The renderer without GL, and the choice between it and the one with.

#include "testbed/gl/renderer.h"

#include <algorithm>
#include <thread>

#include "testbed/gl/gl_renderer.h"
#include "testbed/picture/composite.h"
#include "testbed/picture/layer_bands.h"
#include "testbed/picture/rasterizer.h"

namespace testbed {

namespace {

constexpr int mostThreads = 8;  // more would wait for memory

class CpuRenderer final : public Renderer {
public:
    [[nodiscard]] CountImage Count(std::span<const PixelRect> rects, int width, int height) override {
        return CountRects(rects, width, height);
    }
    void Draw(std::span<const Triangle> triangles, Image& samples) override {
        std::fill(samples.pixels.begin(), samples.pixels.end(), Color{0, 0, 0, 0});
        RasterizeTriangles(triangles, samples);
    }
    void DrawOver(const DrawList& list, Image& picture) override { DrawInBands(list, m_threads, picture); }
    [[nodiscard]] Backend GetBackend() const override { return Backend::cpu; }
    [[nodiscard]] std::string GetName() const override { return "built in"; }
    [[nodiscard]] std::string GetVersion() const override { return ""; }

private:
    int m_threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, mostThreads);
};

}  // namespace

void Renderer::DrawOver(const DrawList& list, Image& picture) {
    const int width = list.width * list.supersampling, height = list.height * list.supersampling;
    if (m_samples.width != width || m_samples.height != height) m_samples = Image(width, height, Color{0, 0, 0, 0});
    Draw(list.triangles, m_samples);
    CompositeSamples(m_samples, list.supersampling, picture);
}

std::unique_ptr<Renderer> MakeRenderer(Backend backend, const ContextOptions& options) {
    if (backend == Backend::cpu) return std::make_unique<CpuRenderer>();
    return std::make_unique<GlRenderer>(MakeContext(backend, options));
}

}  // namespace testbed
