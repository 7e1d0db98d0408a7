// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// To derive from in order to draw a world: b2World::DebugDraw calls it.

#pragma once

#include "b2_api.h"
#include "b2_math.h"

/// Red, green, blue and opacity, 0…1.
struct B2_API b2Color {
    b2Color() {}
    b2Color(float rIn, float gIn, float bIn, float aIn = 1.0f) { Set(rIn, gIn, bIn, aIn); }

    void Set(float rIn, float gIn, float bIn, float aIn = 1.0f) {
        r = rIn;
        g = gIn;
        b = bIn;
        a = aIn;
    }

    float r, g, b, a;
};

class B2_API b2Draw {
public:
    b2Draw();
    virtual ~b2Draw() {}

    /// What is drawn.
    enum {
        e_shapeBit = 0x0001,
        e_jointBit = 0x0002,
        e_aabbBit = 0x0004,
        e_pairBit = 0x0008,
        e_centerOfMassBit = 0x0010
    };

    void SetFlags(uint32 flags);
    uint32 GetFlags() const;
    void AppendFlags(uint32 flags);
    void ClearFlags(uint32 flags);

    virtual void DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) = 0;
    virtual void DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) = 0;
    virtual void DrawCircle(const b2Vec2& center, float radius, const b2Color& color) = 0;
    virtual void DrawSolidCircle(const b2Vec2& center, float radius, const b2Vec2& axis, const b2Color& color) = 0;
    virtual void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) = 0;
    virtual void DrawTransform(const b2Transform& xf) = 0;
    virtual void DrawPoint(const b2Vec2& p, float size, const b2Color& color) = 0;

protected:
    uint32 m_drawFlags;
};
