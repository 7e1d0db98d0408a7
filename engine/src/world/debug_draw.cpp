// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// World::DebugDraw: bodies, joints, contacts, boxes and centres of mass → calls of a Draw, in Box2D 2.4's order and
// colours.

#include "scree/draw.h"

#include "scree/settings.h"
#include "world/draw_joint.h"
#include "world/guard.h"

namespace scree {

namespace {

Color ColorOf(const BodyTable& bodies, BodyIndex body) {
    if (bodies.type[body] == dynamicBody && bodies.motion[body].mass == 0.0f)
        return {1.0f, 0.0f, 0.0f};  // will not move: an oversight
    if (!bodies.Has(body, BodyFlag::enabled)) return {0.5f, 0.5f, 0.3f};
    if (bodies.type[body] == staticBody) return {0.5f, 0.9f, 0.5f};
    if (bodies.type[body] == kinematicBody) return {0.5f, 0.5f, 0.9f};
    if (!bodies.Has(body, BodyFlag::awake)) return {0.6f, 0.6f, 0.6f};
    return {0.9f, 0.7f, 0.7f};
}

void DrawConvex(const ConvexShape& convex, const Transform& xf, const Color& color, Draw& draw) {
    if (convex.m_count == 1) {
        draw.DrawSolidCircle(Mul(xf, convex.m_vertices[0]), convex.m_radius, Mul(xf.q, Vec2{1.0f, 0.0f}), color);
        return;
    }
    // Round corners get an arc each; a skin is not drawn.
    const int arcs = convex.m_solidRadius > 0.0f ? (convex.m_count <= 8 ? 8 : 1) : 0;
    Vec2 outline[2 * maxConvexVertices];
    int count = 0;
    for (int i = 0; i < convex.m_count; ++i) {
        const Vec2 before = convex.m_normals[i > 0 ? i - 1 : convex.m_count - 1];
        const float corner = Atan2(std::fabs(Cross(before, convex.m_normals[i])), Dot(before, convex.m_normals[i]));
        for (int k = 0; k <= arcs; ++k) {
            const Rot turn(arcs > 0 ? corner * static_cast<float>(k) / static_cast<float>(arcs) : 0.0f);
            outline[count++] = Mul(xf, convex.m_vertices[i] + convex.m_solidRadius * Mul(turn, before));
        }
    }
    draw.DrawSolidPolygon(outline, count, color);
}

void DrawShape(const Shape& shape, const Transform& xf, bool inChain, const Color& color, Draw& draw) {
    switch (shape.GetType()) {
        case Shape::e_circle: {
            const auto& circle = static_cast<const CircleShape&>(shape);
            draw.DrawSolidCircle(Mul(xf, circle.m_p), circle.m_radius, Mul(xf.q, Vec2{1.0f, 0.0f}), color);
            break;
        }
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            const Vec2 v1 = Mul(xf, edge.m_vertex1);
            const Vec2 v2 = Mul(xf, edge.m_vertex2);
            draw.DrawSegment(v1, v2, color);
            if (edge.m_oneSided || inChain) break;
            constexpr float endSize = 4.0f;
            draw.DrawPoint(v1, endSize, color);
            draw.DrawPoint(v2, endSize, color);
            break;
        }
        case Shape::e_polygon: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            Vec2 vertices[maxPolygonVertices];
            for (int i = 0; i < polygon.m_count; ++i) vertices[i] = Mul(xf, polygon.m_vertices[i]);
            draw.DrawSolidPolygon(vertices, polygon.m_count, color);
            break;
        }
        case Shape::e_convex:
            DrawConvex(static_cast<const ConvexShape&>(shape), xf, color, draw);
            break;
        default:
            break;
    }
}

void DrawBox(const AABB& box, const Color& color, Draw& draw) {
    const Vec2 corners[4] = {
        box.lowerBound, {box.upperBound.x, box.lowerBound.y}, box.upperBound, {box.lowerBound.x, box.upperBound.y}};
    draw.DrawPolygon(corners, 4, color);
}

/// Calls visit(body) in the order of the body list.
template <typename Visit>
void ForEachBody(const BodyTable& bodies, Visit visit) {
    for (BodyIndex b = bodies.listHead; IsSome(b); b = bodies.info[b].listNext) visit(b);
}

template <typename Visit>
void ForEachFixture(const WorldState& s, BodyIndex body, Visit visit) {
    for (const FixtureIndex f : s.fixtures.From(s.bodies.fixtureHead[body])) visit(f);
}

void DrawShapes(const WorldState& s, Draw& draw) {
    ForEachBody(s.bodies, [&](BodyIndex body) {
        const Color color = ColorOf(s.bodies, body);
        ForEachFixture(s, body, [&](FixtureIndex f) {
            DrawShape(*s.fixtures.shape[f], s.bodies.transform[body], s.fixtures.info[f].chainId >= 0, color, draw);
        });
    });
}

void DrawPairs(WorldState& s, Draw& draw) {
    const Color color{0.3f, 0.9f, 0.9f};
    for (ContactIndex c = s.contacts.LastAliveBelow(s.contacts.flags.End()); IsSome(c);
         c = s.contacts.LastAliveBelow(c)) {
        const ContactPair& pair = s.contacts.pair[c];
        draw.DrawSegment(s.fixtures.handles[pair.fixtureA].GetAABB().GetCenter(),
                         s.fixtures.handles[pair.fixtureB].GetAABB().GetCenter(), color);
    }
}

void DrawBoxes(const WorldState& s, Draw& draw) {
    const Color color{0.9f, 0.3f, 0.9f};
    ForEachBody(s.bodies, [&](BodyIndex body) {
        ForEachFixture(s, body, [&](FixtureIndex f) {
            if (s.fixtures.info[f].inBroadPhase) DrawBox(s.broadPhase->GetBox(ProxyOf(f)), color, draw);
        });
    });
}

void DrawCenters(const WorldState& s, Draw& draw) {
    ForEachBody(s.bodies, [&](BodyIndex body) {
        draw.DrawTransform({s.bodies.position[body].c, s.bodies.transform[body].q});
    });
}

}  // namespace

void World::SetDebugDraw(Draw* draw) { m_state->draw = draw; }

void World::DebugDraw() {
    WorldState& s = *m_state;
    if (s.draw == nullptr) return;
    Draw& draw = *s.draw;
    const WorldLock lock(s);
    const uint32_t flags = draw.GetFlags();
    if ((flags & Draw::e_shapeBit) != 0) DrawShapes(s, draw);
    if ((flags & Draw::e_jointBit) != 0) {
        for (Joint* joint = GetJointList(); joint != nullptr; joint = joint->GetNext()) DrawJoint(*joint, draw);
    }
    if ((flags & Draw::e_pairBit) != 0) DrawPairs(s, draw);
    if ((flags & Draw::e_aabbBit) != 0) DrawBoxes(s, draw);
    if ((flags & Draw::e_centerOfMassBit) != 0) DrawCenters(s, draw);
}

}  // namespace scree
