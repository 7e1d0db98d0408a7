// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which fields of each structure belong to the state of a world: one list per structure, walked by the writer and the
// reader of images. A new field of a structure is one entry here.

#pragma once

#include <concepts>
#include <type_traits>

#include "scree/chain_shape.h"
#include "scree/convex_shape.h"
#include "world/image.h"
#include "world/world_state.h"

namespace scree {

/// T or const T: a list serves both ways.
template <typename Self, typename T>
concept Is = std::same_as<std::remove_const_t<Self>, T>;

/// Structures that list their fields themselves.
template <typename Self, typename Visit>
requires requires(Self& self, Visit& visit) { std::remove_const_t<Self>::Fields(self, visit); }
void Fields(Self& self, Visit& visit) { std::remove_const_t<Self>::Fields(self, visit); }

template <Is<Vec2> Self, typename Visit>
void Fields(Self& v, Visit& visit) {
    visit(v.x), visit(v.y);
}
template <Is<AABB> Self, typename Visit>
void Fields(Self& box, Visit& visit) {
    visit(box.lowerBound), visit(box.upperBound);
}
template <Is<Transform> Self, typename Visit>
void Fields(Self& xf, Visit& visit) {
    visit(xf.p), visit(xf.q.s), visit(xf.q.c);
}

template <Is<WorldDef> Self, typename Visit>
void Fields(Self& def, Visit& visit) {
    visit(def.gravity), visit(def.broadPhase), visit(def.staticShareThreshold), visit(def.allowSleep);
    visit(def.warmStarting), visit(def.maxTranslation), visit(def.maxRotation), visit(def.continuousPhysics);
    visit(def.subStepping), visit(def.exactDrift), visit(def.solver), visit(def.softStep.contactHertz);
    visit(def.softStep.contactDampingRatio), visit(def.softStep.contactPushSpeed);
    visit(def.lengthScale), visit(def.farDistance);
}

template <Is<Velocity> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.v), visit(row.w);
}
template <Is<Position> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.c), visit(row.a), visit(row.aRest);
}
template <Is<PositionRest> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.end), visit(row.start);
}
template <Is<MassRow> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.invMass), visit(row.invI), visit(row.localCenter);
}
template <Is<ForceRow> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.force), visit(row.torque);
}
template <Is<MotionRow> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.linearDamping), visit(row.angularDamping), visit(row.gravityScale), visit(row.mass);
}
template <Is<BodyDemand> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.overlap), visit(row.jointGap), visit(row.pullRate), visit(row.substeps), visit(row.wanted);
}
template <Is<BodyInfo> Self, typename Visit>
void Fields(Self& info, Visit& visit) {
    visit(info.inertia), visit(info.fixtureCount), visit(info.jointCount);
    visit(info.listPrev), visit(info.listNext), visit(info.moverRow), visit(info.userData.pointer);
}
template <Is<BodyTable> Self, typename Visit>
void Fields(Self& t, Visit& visit) {
    visit(t.slots), visit(t.velocity), visit(t.startVelocity), visit(t.position), visit(t.startPosition);
    visit(t.rest);
    visit(t.transform), visit(t.mass), visit(t.force), visit(t.motion), visit(t.demand), visit(t.sleepTime);
    visit(t.flags), visit(t.type), visit(t.fixtureHead), visit(t.info), visit(t.movers), visit(t.listHead),
        visit(t.lastMover);
}

template <Is<Filter> Self, typename Visit>
void Fields(Self& filter, Visit& visit) {
    visit(filter.categoryBits), visit(filter.maskBits), visit(filter.groupIndex);
}
template <Is<Material> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.friction), visit(row.restitution), visit(row.restitutionThreshold);
}
template <Is<FixtureInfo> Self, typename Visit>
void Fields(Self& info, Visit& visit) {
    visit(info.density), visit(info.chainId), visit(info.chainIndex), visit(info.inBroadPhase);
    visit(info.userData.pointer);
}
/// All but the shapes and the boxes.
template <Is<FixtureTable> Self, typename Visit>
void Fields(Self& t, Visit& visit) {
    visit(t.slots), visit(t.body), visit(t.type), visit(t.isSensor), visit(t.filter), visit(t.material);
    visit(t.next), visit(t.info), visit(t.nextChainId);
}

template <Is<CircleShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(shape.m_radius), visit(shape.m_p);
}
template <Is<EdgeShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(shape.m_radius), visit(shape.m_vertex0), visit(shape.m_vertex1), visit(shape.m_vertex2);
    visit(shape.m_vertex3), visit(shape.m_oneSided);
}
template <Is<PolygonShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(shape.m_radius), visit(shape.m_centroid), visit(shape.m_count);
    for (int i = 0; i < shape.m_count && i < maxPolygonVertices; ++i) {
        visit(shape.m_vertices[i]), visit(shape.m_normals[i]);
    }
}
template <Is<MassData> Self, typename Visit>
void Fields(Self& data, Visit& visit) {
    visit(data.mass), visit(data.center), visit(data.I);
}
template <Is<ConvexShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(shape.m_radius), visit(shape.m_count), visit(shape.m_curvedSides), visit(shape.m_solidRadius);
    visit(shape.m_error), visit(shape.m_unitMass);
    for (int i = 0; i < shape.m_count && i < maxConvexVertices; ++i) {
        visit(shape.m_vertices[i]), visit(shape.m_normals[i]), visit(shape.m_controls[i]);
    }
}
template <Is<ChainShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(shape.m_radius), visit(shape.m_vertices), visit(shape.m_prevVertex), visit(shape.m_nextVertex);
}
/// Whether a shape that was read can be used without reading outside of it.
template <typename T>
bool IsSafe(const T&) {
    return true;
}
inline bool IsSafe(const PolygonShape& shape) { return shape.m_count >= 3 && shape.m_count <= maxPolygonVertices; }
inline bool IsSafe(const ConvexShape& shape) { return shape.m_count >= 1 && shape.m_count <= maxConvexVertices; }

/// Calls visit(std::type_identity<T>) for the shape class of a fixture's shape type; false for an unknown type.
template <typename Visit>
bool WithShapeType(Shape::Type type, Visit&& visit) {
    switch (type) {
        case Shape::e_circle:
            return visit(std::type_identity<CircleShape>{}), true;
        case Shape::e_edge:
            return visit(std::type_identity<EdgeShape>{}), true;
        case Shape::e_polygon:
            return visit(std::type_identity<PolygonShape>{}), true;
        case Shape::e_convex:
            return visit(std::type_identity<ConvexShape>{}), true;
        default:
            return false;
    }
}

template <Is<ContactPair> Self, typename Visit>
void Fields(Self& pair, Visit& visit) {
    visit(pair.fixtureA), visit(pair.fixtureB), visit(pair.bodyA), visit(pair.bodyB);
}
template <Is<ContactMaterial> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.friction), visit(row.restitution), visit(row.restitutionThreshold), visit(row.tangentSpeed);
}
template <Is<SteadyContact> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    visit(row.isKept);
    if (row.isKept == 0.0f) return;
    visit(row.turnA), visit(row.turnB), visit(row.between), visit(row.normal), visit(row.reach), visit(row.isSwapped);
    for (int i = 0; i < maxManifoldPoints; ++i) visit(row.arm[i]), visit(row.separation[i]);
}
/// Beyond its points a manifold holds left-overs.
template <Is<Manifold> Self, typename Visit>
void Fields(Self& m, Visit& visit) {
    visit(m.pointCount);
    if (m.pointCount <= 0 || m.pointCount > maxManifoldPoints) return;
    visit(m.type), visit(m.localNormal), visit(m.localPoint);
    for (int i = 0; i < m.pointCount; ++i) {
        auto& point = m.points[i];
        visit(point.localPoint), visit(point.normalImpulse), visit(point.tangentImpulse), visit(point.id.key);
    }
}

template <Is<JointLink> Self, typename Visit>
void Fields(Self& link, Visit& visit) {
    visit(link.prev), visit(link.next);
}
template <Is<JointInfo> Self, typename Visit>
void Fields(Self& info, Visit& visit) {
    visit(info.type), visit(info.collideConnected), visit(info.bodyA), visit(info.bodyB), visit(info.row);
    visit(info.gearCount), visit(info.listPrev), visit(info.listNext), visit(info.link[0]), visit(info.link[1]);
    visit(info.userData.pointer);
}

/// The settings and counters of a world beside its tables.
template <Is<WorldState> Self, typename Visit>
void Fields(Self& s, Visit& visit) {
    visit(s.pairsStale), visit(s.autoClearForces), visit(s.lastInverseDt), visit(s.continuousScratch.resuming);
}

}  // namespace scree
