// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The renderer without GL, and the choice between it and the one with.

#include "testbed/render/renderer.h"

#include <algorithm>

#include "testbed/render/gl_renderer.h"
#include "testbed/render/rasterizer.h"

namespace testbed {

namespace {

class CpuRenderer final : public Renderer {
public:
    [[nodiscard]] CountImage Count(std::span<const PixelRect> rects, int width, int height) override {
        return CountRects(rects, width, height);
    }
    void Draw(std::span<const Triangle> triangles, Image& samples) override {
        std::fill(samples.pixels.begin(), samples.pixels.end(), Color{0, 0, 0, 0});
        RasterizeTriangles(triangles, samples);
    }
    [[nodiscard]] Backend GetBackend() const override { return Backend::cpu; }
    [[nodiscard]] std::string GetName() const override { return "built in"; }
    [[nodiscard]] std::string GetVersion() const override { return ""; }
};

}  // namespace

std::unique_ptr<Renderer> MakeRenderer(Backend backend, const ContextOptions& options) {
    if (backend == Backend::cpu) return std::make_unique<CpuRenderer>();
    return std::make_unique<GlRenderer>(MakeContext(backend, options));
}

}  // namespace testbed
