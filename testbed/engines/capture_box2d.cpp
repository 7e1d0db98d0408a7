// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of capture_box2d.h.

#include "testbed/engines/capture_box2d.h"

#include <box2d/box2d.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/box2d_tree_dump.h"
#include "testbed/engines/pair_count.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace {

scenes::BodyType TypeOf(const b2Body& body) {
    switch (body.GetType()) {
        case b2_staticBody:
            return scenes::BodyType::isStatic;
        case b2_kinematicBody:
            return scenes::BodyType::kinematic;
        case b2_dynamicBody:
            return scenes::BodyType::dynamic;
    }
    throw std::logic_error("a body of unknown type");
}

scenes::JointType TypeOf(const b2Joint& joint) {
    switch (joint.GetType()) {
        case e_revoluteJoint:
            return scenes::JointType::revolute;
        case e_prismaticJoint:
            return scenes::JointType::prismatic;
        case e_distanceJoint:
        case e_ropeJoint:
            return scenes::JointType::distance;
        case e_pulleyJoint:
            return scenes::JointType::pulley;
        case e_mouseJoint:
            return scenes::JointType::mouse;
        case e_gearJoint:
            return scenes::JointType::gear;
        case e_wheelJoint:
            return scenes::JointType::wheel;
        case e_weldJoint:
            return scenes::JointType::weld;
        case e_frictionJoint:
            return scenes::JointType::friction;
        case e_motorJoint:
            return scenes::JointType::motor;
        case e_unknownJoint:
            break;
    }
    throw std::logic_error("a joint of unknown type");
}

void SetVertices(scenes::Shape& shape, std::span<const b2Vec2> vertices) {
    shape.vertexCount = static_cast<std::uint8_t>(vertices.size());
    std::ranges::transform(vertices, shape.vertices.begin(), [](b2Vec2 v) { return FromB2(v); });
}

scenes::Shape ReadEdge(const b2EdgeShape& edge) {
    const b2Vec2 ends[] = {edge.m_vertex1, edge.m_vertex2, edge.m_vertex0, edge.m_vertex3};
    scenes::Shape read;
    read.type = scenes::ShapeType::edge;
    SetVertices(read, std::span(ends).first(edge.m_oneSided ? 4 : 2));
    return read;
}

/// A child of a shape as a scene would describe it.
scenes::Shape ReadShape(const b2Shape& shape, int child) {
    scenes::Shape read;
    switch (shape.GetType()) {
        case b2Shape::e_circle:
            read.center = FromB2(static_cast<const b2CircleShape&>(shape).m_p);
            read.radius = shape.m_radius;
            return read;
        case b2Shape::e_edge:
            return ReadEdge(static_cast<const b2EdgeShape&>(shape));
        case b2Shape::e_polygon: {
            const auto& polygon = static_cast<const b2PolygonShape&>(shape);
            read.type = scenes::ShapeType::polygon;
            SetVertices(read, std::span(polygon.m_vertices).first(static_cast<size_t>(polygon.m_count)));
            return read;
        }
        case b2Shape::e_chain: {
            b2EdgeShape edge;
            static_cast<const b2ChainShape&>(shape).GetChildEdge(&edge, child);
            return ReadEdge(edge);
        }
        default:
            throw std::logic_error("a fixture of unknown shape");
    }
}

/// Everything in a world, in the order of its own lists turned round.
struct OwnOrder {
    std::vector<b2Body*> bodies;
    std::unordered_map<const b2Body*, int> indexOf;
    std::vector<Box2dProxy> proxies;
    std::unordered_map<const b2Fixture*, int> proxyOf;
    std::vector<b2Joint*> joints;

    explicit OwnOrder(b2World& world) {
        for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) bodies.push_back(b);
        std::ranges::reverse(bodies);
        for (b2Body* body : bodies) {
            indexOf.emplace(body, static_cast<int>(indexOf.size()));
            std::vector<b2Fixture*> fixtures;
            for (b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext()) fixtures.push_back(f);
            std::ranges::reverse(fixtures);
            for (b2Fixture* fixture : fixtures) {
                const int number = static_cast<int>(proxyOf.size());
                proxyOf.emplace(fixture, static_cast<int>(proxies.size()));
                const int children = fixture->GetShape()->GetChildCount();
                for (int child = 0; child < children; ++child) proxies.push_back({fixture, number, child});
            }
        }
        for (b2Joint* j = world.GetJointList(); j; j = j->GetNext()) joints.push_back(j);
        std::ranges::reverse(joints);
    }

    [[nodiscard]] Box2dListing GetListing() const {
        return {.bodies = bodies,
                .indexOf = [this](const b2Body* body) { return indexOf.at(body); },
                .proxies = proxies,
                .proxyOf = [this](const b2Fixture* fixture) { return proxyOf.at(fixture); },
                .joints = joints};
    }
};

void CaptureFixtures(const Box2dListing& listing, std::vector<FixtureState>& fixtures) {
    fixtures.reserve(listing.proxies.size());
    for (const Box2dProxy& proxy : listing.proxies) {
        b2Body* body = proxy.fixture->GetBody();
        const b2Shape& shape = *proxy.fixture->GetShape();
        b2AABB tight;
        shape.ComputeAABB(&tight, body->GetTransform(), proxy.child);
        FixtureState state{.body = listing.indexOf(body),
                           .fixture = proxy.sceneIndex,
                           .child = proxy.child,
                           .shape = {},
                           .sensor = proxy.fixture->IsSensor(),
                           .tight = FromB2(tight)};
        if (listing.scene != nullptr) {
            const scenes::Fixture& fixture = listing.scene->fixtures[static_cast<size_t>(proxy.sceneIndex)];
            state.shape = Box2dShapeOf(*listing.scene, scenes::ChildOf(*listing.scene, fixture.shape, proxy.child));
        } else {
            state.shape = ReadShape(shape, proxy.child);
        }
        state.swept = state.tight;
        fixtures.push_back(std::move(state));
    }
}

void CaptureContacts(b2World& world, const Box2dListing& listing, std::vector<ContactState>& contacts) {
    contacts.reserve(static_cast<size_t>(world.GetContactCount()));
    for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) {
        ContactState state{};
        state.fixtureA = listing.proxyOf(c->GetFixtureA()) + c->GetChildIndexA();
        state.fixtureB = listing.proxyOf(c->GetFixtureB()) + c->GetChildIndexB();
        state.touching = c->IsTouching();
        const b2Manifold& manifold = *c->GetManifold();
        state.pointCount = manifold.pointCount;
        if (state.pointCount > 0) {
            b2WorldManifold points;
            c->GetWorldManifold(&points);
            state.normal = FromB2(points.normal);
            for (int k = 0; k < state.pointCount; ++k) {
                state.points[k] = FromB2(points.points[k]);
                state.separations[k] = points.separations[k];
                state.normalImpulses[k] = manifold.points[k].normalImpulse;
                state.tangentImpulses[k] = manifold.points[k].tangentImpulse;
            }
        }
        contacts.push_back(state);
    }
}

void CaptureJoints(const Box2dListing& listing, std::vector<JointState>& joints) {
    for (b2Joint* j : listing.joints) {
        JointState state{listing.indexOf(j->GetBodyA()), listing.indexOf(j->GetBodyB()), FromB2(j->GetAnchorA()),
                         FromB2(j->GetAnchorB()), TypeOf(*j)};
        if (state.type == scenes::JointType::pulley) {
            const auto& pulley = static_cast<const b2PulleyJoint&>(*j);
            state.groundAnchorA = FromB2(pulley.GetGroundAnchorA());
            state.groundAnchorB = FromB2(pulley.GetGroundAnchorB());
        }
        joints.push_back(state);
    }
}

void CaptureNodes(b2World& world, const Box2dListing& listing, bool pairs, Snapshot& snapshot) {
    const auto proxyOf = [&](void* userData) {
        const auto* proxy = static_cast<b2FixtureProxy*>(userData);
        return listing.proxyOf(proxy->fixture) + proxy->childIndex;
    };
    DumpBox2dTree(world.GetContactManager().m_broadPhase, proxyOf, snapshot.nodes);
    snapshot.treeHeight = world.GetTreeHeight();
    snapshot.leafSize = snapshot.nodes.empty() ? 0 : 1;
    if (pairs && !snapshot.fixtures.empty()) snapshot.pairsReported = CountPairs(LeafBoxes(snapshot));
}

}  // namespace

BodyState CaptureBody(const b2Body& body, int index) {
    return {.index = index,
            .type = TypeOf(body),
            .position = FromB2(body.GetPosition()),
            .sin = body.GetTransform().q.s,
            .cos = body.GetTransform().q.c,
            .angle = body.GetAngle(),
            .linearVelocity = FromB2(body.GetLinearVelocity()),
            .angularVelocity = body.GetAngularVelocity(),
            // Box2D flags static bodies that an island touched as awake, which means nothing.
            .awake = body.GetType() != b2_staticBody && body.IsAwake(),
            .bullet = body.IsBullet()};
}

void Capture(b2World& world, const Box2dListing& listing, Snapshot& snapshot, const CaptureParts& parts) {
    ClearWorld(snapshot);
    snapshot.engine = "box2d";
    snapshot.broadPhase = "b2DynamicTree";
    snapshot.contactCount = world.GetContactCount();
    for (const b2Contact* c = world.GetContactList(); c; c = c->GetNext()) snapshot.touchingCount += c->IsTouching();
    snapshot.bodies.reserve(listing.bodies.size());
    for (const b2Body* body : listing.bodies) {
        snapshot.bodies.push_back(CaptureBody(*body, static_cast<int>(snapshot.bodies.size())));
    }
    snapshot.stateHash = HashState(snapshot.bodies);
    if (parts.fixtures) CaptureFixtures(listing, snapshot.fixtures);
    if (parts.contacts) CaptureContacts(world, listing, snapshot.contacts);
    if (parts.joints) CaptureJoints(listing, snapshot.joints);
    if (parts.nodes) CaptureNodes(world, listing, parts.pairs, snapshot);
}

void Capture(b2World& world, Snapshot& snapshot, const CaptureParts& parts) {
    const OwnOrder order(world);
    Capture(world, order.GetListing(), snapshot, parts);
}

}  // namespace testbed
