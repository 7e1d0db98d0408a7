// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of capture_scree.h.

#include "testbed/engines/capture_scree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "scenes/build.h"
#include "scree/contact.h"
#include "scree/convex_shape.h"
#include "scree/inspect.h"
#include "scree/pulley_joint.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/state_hash.h"

namespace testbed {
namespace {

scenes::BodyType TypeOf(const scree::Body& body) {
    switch (body.GetType()) {
        case scree::staticBody:
            return scenes::BodyType::isStatic;
        case scree::kinematicBody:
            return scenes::BodyType::kinematic;
        case scree::dynamicBody:
            return scenes::BodyType::dynamic;
    }
    throw std::logic_error("a body of unknown type");
}

scenes::JointType TypeOf(const scree::Joint& joint) {
    switch (joint.GetType()) {
        case scree::e_revoluteJoint:
            return scenes::JointType::revolute;
        case scree::e_prismaticJoint:
            return scenes::JointType::prismatic;
        case scree::e_distanceJoint:
        case scree::e_ropeJoint:
            return scenes::JointType::distance;
        case scree::e_pulleyJoint:
            return scenes::JointType::pulley;
        case scree::e_mouseJoint:
            return scenes::JointType::mouse;
        case scree::e_gearJoint:
            return scenes::JointType::gear;
        case scree::e_wheelJoint:
            return scenes::JointType::wheel;
        case scree::e_weldJoint:
            return scenes::JointType::weld;
        case scree::e_frictionJoint:
            return scenes::JointType::friction;
        case scree::e_motorJoint:
            return scenes::JointType::motor;
        case scree::e_unknownJoint:
            break;
    }
    throw std::logic_error("a joint of unknown type");
}

void SetVertices(scenes::Shape& shape, std::span<const scree::Vec2> vertices) {
    shape.vertexCount = static_cast<std::uint8_t>(vertices.size());
    std::ranges::transform(vertices, shape.vertices.begin(), [](scree::Vec2 v) { return FromScree(v); });
}

/// A shape as a scene would describe it; of a further convex shape only that it is one.
scenes::Shape ReadShape(const scree::Shape& shape) {
    scenes::Shape read;
    switch (shape.GetType()) {
        case scree::Shape::e_circle:
            read.center = FromScree(static_cast<const scree::CircleShape&>(shape).m_p);
            read.radius = shape.m_radius;
            return read;
        case scree::Shape::e_edge: {
            const auto& edge = static_cast<const scree::EdgeShape&>(shape);
            const scree::Vec2 ends[] = {edge.m_vertex1, edge.m_vertex2, edge.m_vertex0, edge.m_vertex3};
            read.type = scenes::ShapeType::edge;
            SetVertices(read, std::span(ends).first(edge.m_oneSided ? 4 : 2));
            return read;
        }
        case scree::Shape::e_polygon: {
            const auto& polygon = static_cast<const scree::PolygonShape&>(shape);
            read.type = scenes::ShapeType::polygon;
            SetVertices(read, std::span(polygon.m_vertices).first(static_cast<size_t>(polygon.m_count)));
            return read;
        }
        case scree::Shape::e_convex:
            read.type = scenes::ShapeType::supported;
            return read;
        case scree::Shape::e_chain:
            break;
    }
    throw std::logic_error("a fixture of unknown shape");
}

/// The outline of a further convex shape, at the directions of scenes::SampleOutline. Points of one corner, told apart
/// by rounding alone, count as one.
std::vector<Vec2> ReadOutline(const scree::ConvexShape& shape) {
    scree::Transform identity;
    identity.SetIdentity();
    scree::AABB box;
    shape.ComputeAABB(&box, identity);
    const float least = 1e-5f * (box.upperBound - box.lowerBound).Length();
    const auto isApart = [&](Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y) > least; };
    std::vector<Vec2> outline;
    for (int i = 0; i < outlineDirections; ++i) {
        // Half a step aside, so that none is the normal of an upright side, where either end would do.
        const double angle = 2.0 * scenes::pi * (i + 0.5) / outlineDirections;
        const scree::Vec2 direction{static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
        const Vec2 point = FromScree(shape.GetSupportPoint(direction) + shape.m_solidRadius * direction);
        if (outline.empty() || (isApart(point, outline.back()) && isApart(point, outline.front())))
            outline.push_back(point);
    }
    return outline;
}

/// Everything in a world, in the order of its own lists turned round.
struct OwnOrder {
    std::vector<const scree::Body*> bodies;
    std::unordered_map<const scree::Body*, int> indexOf;
    std::vector<ScreeProxy> proxies;
    std::vector<int> proxyOf;
    std::vector<const scree::Joint*> joints;

    explicit OwnOrder(const scree::World& world) {
        for (const scree::Body* b = world.GetBodyList(); b; b = b->GetNext()) bodies.push_back(b);
        std::ranges::reverse(bodies);
        for (const scree::Body* body : bodies) {
            indexOf.emplace(body, static_cast<int>(indexOf.size()));
            AddProxies(*body);
        }
        for (const scree::Joint* j = world.GetJointList(); j; j = j->GetNext()) joints.push_back(j);
        std::ranges::reverse(joints);
    }

    [[nodiscard]] ScreeListing GetListing() const {
        return {.bodies = bodies,
                .indexOf = [this](const scree::Body* body) { return indexOf.at(body); },
                .proxies = proxies,
                .proxyOf = proxyOf,
                .joints = joints};
    }

private:
    /// The edges of a chain count as one fixture of a scene.
    void AddProxies(const scree::Body& body) {
        std::vector<const scree::Fixture*> fixtures;
        for (const scree::Fixture* f = body.GetFixtureList(); f; f = f->GetNext()) fixtures.push_back(f);
        std::ranges::reverse(fixtures);
        for (const scree::Fixture* fixture : fixtures) {
            const int child = std::max(fixture->GetChainIndex(), 0);
            if (child == 0) ++m_fixtureCount;
            const auto slot = static_cast<size_t>(fixture->GetIndex());
            if (proxyOf.size() <= slot) proxyOf.resize(slot + 1, -1);
            proxyOf[slot] = static_cast<int>(proxies.size());
            proxies.push_back({fixture, m_fixtureCount - 1, child});
            if (fixture->GetType() == scree::Shape::e_convex) {
                proxies.back().outline = ReadOutline(static_cast<const scree::ConvexShape&>(*fixture->GetShape()));
            }
        }
    }

    int m_fixtureCount = 0;
};

void CaptureFixtures(const ScreeListing& listing, std::vector<FixtureState>& fixtures) {
    fixtures.reserve(listing.proxies.size());
    for (const ScreeProxy& proxy : listing.proxies) {
        const scree::Shape& shape = *proxy.fixture->GetShape();
        scree::AABB tight;
        shape.ComputeAABB(&tight, proxy.fixture->GetBody()->GetTransform());
        FixtureState state{.body = listing.indexOf(proxy.fixture->GetBody()),
                           .fixture = proxy.sceneIndex,
                           .child = proxy.child,
                           .shape = {},
                           .sensor = proxy.fixture->IsSensor(),
                           .tight = FromScree(tight)};
        if (listing.scene != nullptr) {
            const scenes::Fixture& fixture = listing.scene->fixtures[static_cast<size_t>(proxy.sceneIndex)];
            state.shape = scenes::ChildOf(*listing.scene, fixture.shape, proxy.child);
        } else {
            state.shape = ReadShape(shape);
        }
        state.outline = proxy.outline;
        state.swept = state.tight;
        fixtures.push_back(std::move(state));
    }
}

void CaptureContacts(const scree::World& world, const ScreeListing& listing, std::vector<ContactState>& contacts) {
    contacts.reserve(static_cast<size_t>(world.GetContactCount()));
    std::vector<int> colours;
    scree::inspect::GetContactColours(world, colours);
    const auto proxyOf = [&](const scree::Fixture* f) { return listing.proxyOf[static_cast<size_t>(f->GetIndex())]; };
    for (const scree::Contact* c = world.GetContactList(); c; c = c->GetNext()) {
        ContactState state{};
        state.fixtureA = proxyOf(c->GetFixtureA());
        state.fixtureB = proxyOf(c->GetFixtureB());
        state.touching = c->IsTouching();
        state.color = colours[static_cast<size_t>(c->GetIndex())];
        const scree::Manifold manifold = c->GetManifold();
        state.pointCount = manifold.pointCount;
        if (state.pointCount > 0) {
            scree::WorldManifold points;
            c->GetWorldManifold(&points);
            state.normal = FromScree(points.normal);
            for (int k = 0; k < state.pointCount; ++k) {
                state.points[k] = FromScree(points.points[k]);
                state.separations[k] = points.separations[k];
                state.normalImpulses[k] = manifold.points[k].normalImpulse;
                state.tangentImpulses[k] = manifold.points[k].tangentImpulse;
            }
        }
        contacts.push_back(state);
    }
}

void CaptureJoints(const ScreeListing& listing, std::vector<JointState>& joints) {
    for (const scree::Joint* j : listing.joints) {
        JointState state{listing.indexOf(j->GetBodyA()), listing.indexOf(j->GetBodyB()), FromScree(j->GetAnchorA()),
                         FromScree(j->GetAnchorB()), TypeOf(*j)};
        if (state.type == scenes::JointType::pulley) {
            const auto& pulley = static_cast<const scree::PulleyJoint&>(*j);
            state.groundAnchorA = FromScree(pulley.GetGroundAnchorA());
            state.groundAnchorB = FromScree(pulley.GetGroundAnchorB());
        }
        joints.push_back(state);
    }
}

void CaptureNodes(const scree::World& world, const ScreeListing& listing, Snapshot& snapshot) {
    std::vector<scree::BvhNode> nodes;
    scree::inspect::GetNodes(world, nodes);
    snapshot.leafSize = scree::inspect::GetLeafSize(world);
    snapshot.nodes.reserve(nodes.size());
    for (const scree::BvhNode& n : nodes) {
        const int fixture = n.fixture < 0 ? -1 : listing.proxyOf[static_cast<size_t>(n.fixture)];
        snapshot.nodes.push_back({FromScree(n.box), n.parent, n.child1, n.child2, fixture, n.level});
        snapshot.treeHeight = std::max(snapshot.treeHeight, n.level);
    }
}

}  // namespace

BodyState CaptureBody(const scree::Body& body, int index) {
    return {.index = index,
            .type = TypeOf(body),
            .position = FromScree(body.GetPosition()),
            .sin = body.GetTransform().q.s,
            .cos = body.GetTransform().q.c,
            .angle = body.GetAngle(),
            .linearVelocity = FromScree(body.GetLinearVelocity()),
            .angularVelocity = body.GetAngularVelocity(),
            .awake = body.GetType() != scree::staticBody && body.IsAwake(),
            .bullet = body.IsBullet()};
}

void Capture(const scree::World& world, const ScreeListing& listing, Snapshot& snapshot, const CaptureParts& parts) {
    ClearWorld(snapshot);
    snapshot.engine = "scree";
    snapshot.broadPhase = scree::GetName(scree::inspect::GetBroadPhase(world));
    snapshot.contactCount = world.GetContactCount();
    snapshot.pairsReported = world.GetReport().pairCount;
    for (const scree::Contact* c = world.GetContactList(); c; c = c->GetNext()) {
        snapshot.touchingCount += c->IsTouching();
    }
    snapshot.bodies.reserve(listing.bodies.size());
    for (const scree::Body* body : listing.bodies) {
        snapshot.bodies.push_back(CaptureBody(*body, static_cast<int>(snapshot.bodies.size())));
    }
    snapshot.stateHash = HashState(snapshot.bodies);
    if (parts.fixtures) CaptureFixtures(listing, snapshot.fixtures);
    if (parts.contacts) CaptureContacts(world, listing, snapshot.contacts);
    if (parts.joints) CaptureJoints(listing, snapshot.joints);
    if (parts.nodes) CaptureNodes(world, listing, snapshot);
}

void Capture(const scree::World& world, Snapshot& snapshot, const CaptureParts& parts) {
    const OwnOrder order(world);
    Capture(world, order.GetListing(), snapshot, parts);
}

}  // namespace testbed
