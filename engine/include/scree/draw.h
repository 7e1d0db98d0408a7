// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The listener for World::DebugDraw, in Box2D 2.4's form: derive from it, draw what arrives.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/math.h"

namespace scree {

/// Red, green, blue, opacity, each 0…1.
struct Color {
    Color() = default;
    Color(float red, float green, float blue, float opacity = 1.0f) : r(red), g(green), b(blue), a(opacity) {}
    void Set(float red, float green, float blue, float opacity = 1.0f) { *this = Color(red, green, blue, opacity); }

    float r = 0.0f, g = 0.0f, b = 0.0f, a = 1.0f;
};

/// Receives the shapes of a world. All coordinates are world coordinates in m; vertices are counter-clockwise.
class SCREE_API Draw {
public:
    /// What DebugDraw shows.
    enum Flag : uint32_t {
        e_shapeBit = 0x0001,         ///< fixtures, coloured by the state of their body
        e_jointBit = 0x0002,         ///< joints
        e_aabbBit = 0x0004,          ///< the boxes that the broad phase keeps
        e_pairBit = 0x0008,          ///< contacts, as lines between the boxes' centres
        e_centerOfMassBit = 0x0010,  ///< frames at the centres of mass
    };

    virtual ~Draw() = default;

    void SetFlags(uint32_t flags) { m_drawFlags = flags; }
    [[nodiscard]] uint32_t GetFlags() const { return m_drawFlags; }
    void AppendFlags(uint32_t flags) { m_drawFlags |= flags; }
    void ClearFlags(uint32_t flags) { m_drawFlags &= ~flags; }

    virtual void DrawPolygon(const Vec2* vertices, int vertexCount, const Color& color) = 0;
    virtual void DrawSolidPolygon(const Vec2* vertices, int vertexCount, const Color& color) = 0;
    virtual void DrawCircle(const Vec2& center, float radius, const Color& color) = 0;
    /// `axis` is a unit vector that turns with the body.
    virtual void DrawSolidCircle(const Vec2& center, float radius, const Vec2& axis, const Color& color) = 0;
    virtual void DrawSegment(const Vec2& p1, const Vec2& p2, const Color& color) = 0;
    virtual void DrawTransform(const Transform& xf) = 0;
    /// `size` in pixels.
    virtual void DrawPoint(const Vec2& p, float size, const Color& color) = 0;

protected:
    uint32_t m_drawFlags = 0;
};

}  // namespace scree
