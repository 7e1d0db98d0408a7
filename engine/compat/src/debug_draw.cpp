// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2World::DebugDraw: what is drawn for which flag, in Box2D 2.4's order and colours, from the lists that the program
// sees.

#include "world_data.h"

namespace {

b2Color ColorOf(const b2Body& body) {
    if (body.GetType() == b2_dynamicBody && body.GetMass() == 0.0f) return b2Color(1.0f, 0.0f, 0.0f);
    if (!body.IsEnabled()) return b2Color(0.5f, 0.5f, 0.3f);
    if (body.GetType() == b2_staticBody) return b2Color(0.5f, 0.9f, 0.5f);
    if (body.GetType() == b2_kinematicBody) return b2Color(0.5f, 0.5f, 0.9f);
    if (!body.IsAwake()) return b2Color(0.6f, 0.6f, 0.6f);
    return b2Color(0.9f, 0.7f, 0.7f);
}

void DrawShape(b2Draw& draw, const b2Shape& shape, const b2Transform& xf, const b2Color& color) {
    switch (shape.GetType()) {
        case b2Shape::e_circle: {
            const auto& circle = static_cast<const b2CircleShape&>(shape);
            draw.DrawSolidCircle(b2Mul(xf, circle.m_p), circle.m_radius, xf.q.GetXAxis(), color);
            break;
        }
        case b2Shape::e_edge: {
            const auto& edge = static_cast<const b2EdgeShape&>(shape);
            const b2Vec2 v1 = b2Mul(xf, edge.m_vertex1);
            const b2Vec2 v2 = b2Mul(xf, edge.m_vertex2);
            draw.DrawSegment(v1, v2, color);
            if (edge.m_oneSided) break;
            draw.DrawPoint(v1, 4.0f, color);
            draw.DrawPoint(v2, 4.0f, color);
            break;
        }
        case b2Shape::e_chain: {
            const auto& chain = static_cast<const b2ChainShape&>(shape);
            for (int32 i = 0; i + 1 < chain.m_count; ++i) {
                draw.DrawSegment(b2Mul(xf, chain.m_vertices[i]), b2Mul(xf, chain.m_vertices[i + 1]), color);
            }
            break;
        }
        default: {
            const auto& polygon = static_cast<const b2PolygonShape&>(shape);
            b2Vec2 vertices[b2_maxPolygonVertices];
            for (int32 i = 0; i < polygon.m_count; ++i) vertices[i] = b2Mul(xf, polygon.m_vertices[i]);
            draw.DrawSolidPolygon(vertices, polygon.m_count, color);
        }
    }
}

template <typename Visit>
void ForFixtures(const b2Body* bodies, Visit&& visit) {
    for (const b2Body* body = bodies; body != nullptr; body = body->GetNext()) {
        for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
            visit(*body, *fixture);
        }
    }
}

void DrawBox(b2Draw& draw, const b2AABB& box, const b2Color& color) {
    const b2Vec2 corners[4] = {box.lowerBound, b2Vec2(box.upperBound.x, box.lowerBound.y), box.upperBound,
                               b2Vec2(box.lowerBound.x, box.upperBound.y)};
    draw.DrawPolygon(corners, 4, color);
}

}  // namespace

void b2World::DebugDraw() {
    if (m_data->draw == nullptr) return;
    b2Draw& draw = *m_data->draw;
    const uint32 flags = draw.GetFlags();
    if (flags & b2Draw::e_shapeBit) {
        ForFixtures(GetBodyList(), [&](const b2Body& body, const b2Fixture& fixture) {
            DrawShape(draw, *fixture.GetShape(), body.GetTransform(), ColorOf(body));
        });
    }
    if (flags & b2Draw::e_jointBit) {
        for (const b2Joint* joint = m_data->joints; joint != nullptr; joint = joint->GetNext()) joint->Draw(&draw);
    }
    if (flags & b2Draw::e_pairBit) {
        for (const b2Contact* contact = GetContactList(); contact != nullptr; contact = contact->GetNext()) {
            const b2Vec2 centerA = contact->GetFixtureA()->GetAABB(contact->GetChildIndexA()).GetCenter();
            const b2Vec2 centerB = contact->GetFixtureB()->GetAABB(contact->GetChildIndexB()).GetCenter();
            draw.DrawSegment(centerA, centerB, b2Color(0.3f, 0.9f, 0.9f));
        }
    }
    if (flags & b2Draw::e_aabbBit) {
        ForFixtures(GetBodyList(), [&](const b2Body& body, const b2Fixture& fixture) {
            if (!body.IsEnabled()) return;
            for (int32 i = 0; i < b2Bridge::ChildCount(fixture); ++i) {
                DrawBox(draw, fixture.GetAABB(i), b2Color(0.9f, 0.3f, 0.9f));
            }
        });
    }
    if (flags & b2Draw::e_centerOfMassBit) {
        for (const b2Body* body = GetBodyList(); body != nullptr; body = body->GetNext()) {
            draw.DrawTransform(b2Transform(body->GetWorldCenter(), body->GetTransform().q));
        }
    }
}
