// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The renderer over OpenGL 3.3 core: counts by additive blending into an R32F framebuffer, layers into an RGBA8 one.
// Row 0 of the framebuffer is the top row of the picture, so that what is read back needs no flip.

#pragma once

#include <memory>
#include <span>

#include "testbed/gl/renderer.h"

namespace testbed {

class GlRenderer final : public Renderer {
public:
    /// Takes the context over. Throws BackendError when the driver lacks something or refuses a shader.
    explicit GlRenderer(std::unique_ptr<Context> context);
    ~GlRenderer() override;
    GlRenderer(const GlRenderer&) = delete;
    GlRenderer& operator=(const GlRenderer&) = delete;

    [[nodiscard]] CountImage Count(std::span<const PixelRect> rects, int width, int height) override;
    void Draw(std::span<const Triangle> triangles, Image& samples) override;
    [[nodiscard]] Backend GetBackend() const override;
    [[nodiscard]] std::string GetName() const override;
    [[nodiscard]] std::string GetVersion() const override;

    /// Counts boxes that are snapped already; they lie inside the picture. Public so that tests can snap wrongly.
    [[nodiscard]] CountImage CountBoxes(std::span<const PixelBox> boxes, int width, int height);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace testbed
