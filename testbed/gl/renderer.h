// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The one interface behind which pixels are made: counts of rectangles, and layers of triangles. Every implementation
// gives the same pixels; the tests hold them equal.

#pragma once

#include <memory>
#include <span>
#include <string>

#include "testbed/gl/context.h"
#include "testbed/picture/counts.h"
#include "testbed/picture/draw_list.h"
#include "testbed/picture/image.h"

namespace testbed {

class Renderer {
public:
    virtual ~Renderer() = default;
    /// How many rectangles cover each pixel's centre. At most 2^24 rectangles.
    [[nodiscard]] virtual CountImage Count(std::span<const PixelRect> rects, int width, int height) = 0;
    /// Fills `samples` (its size is the target's, in samples) with transparent black and draws the triangles in order.
    virtual void Draw(std::span<const Triangle> triangles, Image& samples) = 0;
    /// The list's triangles over an opaque picture of its size.
    virtual void DrawOver(const DrawList& list, Image& picture);
    [[nodiscard]] virtual Backend GetBackend() const = 0;
    /// GL_RENDERER, or "built in".
    [[nodiscard]] virtual std::string GetName() const = 0;
    /// GL_VERSION, or empty.
    [[nodiscard]] virtual std::string GetVersion() const = 0;

private:
    Image m_samples;  ///< of DrawOver, kept for the next picture
};

/// Throws BackendError when the backend, or for `automatic` any GL backend, does not work here.
[[nodiscard]] std::unique_ptr<Renderer> MakeRenderer(Backend backend, const ContextOptions& options = {});

}  // namespace testbed
