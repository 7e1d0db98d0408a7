// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which fields of each structure belong to the state of a world: one list per structure (base/field_list.h). The writer
// and the reader of images and the state hash walk it. Joints list theirs in state/joint_rows.h.

#pragma once

#include <type_traits>

#include "base/field_list.h"
#include "scree/chain_shape.h"
#include "scree/convex_shape.h"
#include "world/world_state.h"

namespace scree {

/// Structures that list their fields themselves.
template <typename Self, typename Visit>
requires requires(Self& self, Visit& visit) { std::remove_const_t<Self>::Fields(self, visit); }
void Fields(Self& self, Visit& visit) { std::remove_const_t<Self>::Fields(self, visit); }

template <Is<Vec2> Self, typename Visit>
void Fields(Self& v, Visit& visit) {
    auto& [x, y] = v;
    visit(x, y);
}
template <Is<Rot> Self, typename Visit>
void Fields(Self& q, Visit& visit) {
    auto& [s, c] = q;
    visit(s, c);
}
template <Is<Transform> Self, typename Visit>
void Fields(Self& xf, Visit& visit) {
    auto& [p, q] = xf;
    visit(p, q);
}
template <Is<AABB> Self, typename Visit>
void Fields(Self& box, Visit& visit) {
    auto& [lowerBound, upperBound] = box;
    visit(lowerBound, upperBound);
}
template <typename Self, typename Visit>
requires Is<Self, BodyUserData> || Is<Self, FixtureUserData> || Is<Self, JointUserData>
void Fields(Self& data, Visit& visit) {
    auto& [pointer] = data;
    uint64_t number = pointer;  // as wide on every machine
    visit(number);
    if constexpr (!std::is_const_v<Self>) pointer = static_cast<uintptr_t>(number);
}

template <Is<SoftStepDef> Self, typename Visit>
void Fields(Self& def, Visit& visit) {
    auto& [contactHertz, contactDampingRatio, contactPushSpeed] = def;
    visit(contactHertz, contactDampingRatio, contactPushSpeed);
}
/// Workers and features change no result. Of the broad phases only `fat-tree` does: it finds pairs of larger boxes.
template <Is<WorldDef> Self, typename Visit>
void Fields(Self& def, Visit& visit) {
    auto& [gravity, broadPhase, staticShareThreshold, allowSleep, warmStarting, translationCap, rotationCap,
           continuousPhysics, subStepping, exactDrift, lengthScale, farDistance, solver, softStep, workerCount, tasks,
           featureMode, features] = def;
    visit(gravity), visit.Stored(broadPhase, staticShareThreshold);
    visit.Hashed(broadPhase == BroadPhaseKind::fatTree);
    visit(allowSleep, warmStarting, translationCap, rotationCap, continuousPhysics, subStepping, exactDrift, solver);
    visit(softStep, lengthScale, farDistance);
    visit.LeftOut(workerCount, tasks, featureMode, features);
}

template <Is<Velocity> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [v, w, unused] = row;
    visit(v, w), visit.LeftOut(unused);
}
template <Is<Position> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [c, a, aRest] = row;
    visit(c, a, aRest);
}
template <Is<PositionRest> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [end, start] = row;
    visit(end, start);
}
template <Is<MassRow> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [invMass, invI, localCenter] = row;
    visit(invMass, invI, localCenter);
}
template <Is<ForceRow> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [force, torque, unused] = row;
    visit(force, torque), visit.LeftOut(unused);
}
template <Is<MotionRow> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [linearDamping, angularDamping, gravityScale, mass] = row;
    visit(linearDamping, angularDamping, gravityScale, mass);
}
template <Is<BodyDemand> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [overlap, jointGap, pullRate, substeps, wanted] = row;
    visit(overlap, jointGap, pullRate, substeps, wanted);
}
template <Is<BodyInfo> Self, typename Visit>
void Fields(Self& info, Visit& visit) {
    auto& [inertia, fixtureCount, jointCount, listPrev, listNext, moverRow, userData] = info;
    visit(inertia, fixtureCount, jointCount, listPrev, listNext, moverRow), visit.Stored(userData);
}

template <Is<Filter> Self, typename Visit>
void Fields(Self& filter, Visit& visit) {
    auto& [categoryBits, maskBits, groupIndex] = filter;
    visit(categoryBits, maskBits, groupIndex);
}
template <Is<Material> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [friction, restitution, restitutionThreshold, tangentSpeed, rollingResistance, frictionRule,
           restitutionRule] = row;
    visit(friction, restitution, restitutionThreshold, tangentSpeed, rollingResistance, frictionRule, restitutionRule);
}
template <Is<FixtureInfo> Self, typename Visit>
void Fields(Self& info, Visit& visit) {
    auto& [density, chainId, chainIndex, inBroadPhase, reports, materialId, userData] = info;
    visit(density, chainId, chainIndex, inBroadPhase), visit.Stored(reports, materialId, userData);
}

/// The type stands in the table of fixtures.
template <Is<Shape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    auto& [type, radius] = shape;
    visit(radius), visit.LeftOut(type);
}
/// A shape's base, const if the shape is.
template <typename Self>
auto& BaseOf(Self& shape) {
    return static_cast<std::conditional_t<std::is_const_v<Self>, const Shape, Shape>&>(shape);
}
template <Is<CircleShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(BaseOf(shape)), VisitOwn<Shape>(shape, visit, shape.m_p);
}
template <Is<EdgeShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    NamesAllOf<Shape>(shape, shape.m_vertex1, shape.m_vertex2, shape.m_vertex0, shape.m_vertex3, shape.m_oneSided);
    visit(BaseOf(shape), shape.m_vertex0, shape.m_vertex1, shape.m_vertex2, shape.m_vertex3, shape.m_oneSided);
}
/// Behind its vertices a polygon holds left-overs.
template <Is<PolygonShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    NamesAllOf<Shape>(shape, shape.m_centroid, shape.m_vertices, shape.m_normals, shape.m_count);
    visit(BaseOf(shape), shape.m_centroid, shape.m_count);
    for (int i = 0; i < shape.m_count && i < maxPolygonVertices; ++i) visit(shape.m_vertices[i], shape.m_normals[i]);
}
template <Is<MassData> Self, typename Visit>
void Fields(Self& data, Visit& visit) {
    auto& [mass, center, inertia] = data;
    visit(mass, center, inertia);
}
template <Is<ConvexShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    NamesAllOf<Shape>(shape, shape.m_count, shape.m_curvedSides, shape.m_solidRadius, shape.m_error, shape.m_unitMass,
                      shape.m_badField, shape.m_vertices, shape.m_normals, shape.m_controls);
    visit(BaseOf(shape), shape.m_count, shape.m_curvedSides, shape.m_solidRadius, shape.m_error, shape.m_unitMass);
    for (int i = 0; i < shape.m_count && i < maxConvexVertices; ++i) {
        visit(shape.m_vertices[i], shape.m_normals[i], shape.m_controls[i]);
    }
    visit.LeftOut(shape.m_badField);
}
template <Is<ChainShape> Self, typename Visit>
void Fields(Self& shape, Visit& visit) {
    visit(BaseOf(shape)), VisitOwn<Shape>(shape, visit, shape.m_vertices, shape.m_prevVertex, shape.m_nextVertex);
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
    auto& [fixtureA, fixtureB, bodyA, bodyB] = pair;
    visit(fixtureA, fixtureB, bodyA, bodyB);
}
template <Is<ContactMaterial> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [friction, restitution, restitutionThreshold, tangentSpeed] = row;
    visit(friction, restitution, restitutionThreshold, tangentSpeed);
}
template <Is<ContactFeature> Self, typename Visit>
void Fields(Self& feature, Visit& visit) {
    auto& [indexA, indexB, typeA, typeB] = feature;
    visit(indexA, indexB, typeA, typeB);
}
template <Is<ManifoldPoint> Self, typename Visit>
void Fields(Self& point, Visit& visit) {
    auto& [localPoint, normalImpulse, tangentImpulse, id] = point;
    visit(localPoint, normalImpulse, tangentImpulse, id.cf);
}
template <Is<SteadyContact> Self, typename Visit>
void Fields(Self& row, Visit& visit) {
    auto& [turnA, turnB, between, normal, isKept, reach, arm, separation, isSwapped, initialOverlap] = row;
    constexpr float kept = 1.0f, overlapping = 2.0f, set = 4.0f;
    float marks = isKept > 0.0f ? kept : isKept < 0.0f ? set : 0.0f;
    if (initialOverlap != 0.0f) marks += overlapping;
    visit(marks);
    const bool overlaps = marks == overlapping || marks == kept + overlapping || marks == set + overlapping;
    if constexpr (!std::is_const_v<Self>) {
        isKept = marks == kept || marks == kept + overlapping ? 1.0f : marks >= set ? -1.0f : 0.0f;
        if (!overlaps) initialOverlap = 0.0f;
    }
    if (overlaps) visit(initialOverlap);
    if (isKept <= 0.0f) return;
    visit(turnA, turnB, between, normal, reach, isSwapped, arm, separation);
}
/// Beyond its points a manifold holds left-overs.
template <Is<Manifold> Self, typename Visit>
void Fields(Self& m, Visit& visit) {
    auto& [points, localNormal, localPoint, type, pointCount] = m;
    visit(pointCount);
    if (pointCount <= 0 || pointCount > maxManifoldPoints) return;
    visit(type, localNormal, localPoint);
    for (int i = 0; i < pointCount; ++i) visit(points[i]);
}

template <Is<JointLink> Self, typename Visit>
void Fields(Self& link, Visit& visit) {
    auto& [prev, next] = link;
    visit(prev, next);
}
template <Is<JointInfo> Self, typename Visit>
void Fields(Self& info, Visit& visit) {
    auto& [type, collideConnected, bodyA, bodyB, row, gearCount, listPrev, listNext, link, forceThreshold,
           torqueThreshold, breaks, userData] = info;
    visit(type, collideConnected, bodyA, bodyB, row, gearCount, listPrev, listNext, link);
    visit(forceThreshold, torqueThreshold, breaks), visit.Stored(userData);
}

/// Of a sub-stepped step that is not over yet: the part that each body has behind it, and how it moved.
template <Is<ToiScratch> Self, typename Visit>
void Fields(Self& scratch, Visit& visit) {
    auto& [pairs, firstPair, alpha, ballistic, touched, found, lookers, nearTargets, candidates, screened, ofWorkers,
           sweptBoxes, hitters, isPassedOver, times, knownTo, round, nearStatics, events, resuming, audit] = scratch;
    visit(resuming);
    if (resuming) visit(alpha, ballistic);
    visit.LeftOut(pairs, firstPair, touched, found, lookers, nearTargets, candidates, screened, ofWorkers, sweptBoxes,
                  hitters, isPassedOver, times, knownTo, round);
    visit.LeftOut(nearStatics, events, audit);
}
/// The settings and counters of a world beside its tables.
template <Is<WorldState> Self, typename Visit>
void Fields(Self& s, Visit& visit) {
    auto& [world, def, bodies, fixtures, contacts, joints, broadPhase, broadPhaseKind, pool, pairs, editedPairs,
           isEdited, edited, islands, active, substepGroups, narrowPhaseScratch, islandScratch, solverScratch,
           continuousScratch, restScratches, log, destructionListener, listener, heard, filter, mixer, errorHandler,
           errorContext, draw, recorder, definitions, featureCounts, kernels, locks, autoClearForces, lastInverseDt,
           idleSubsteps, report, distanceWork, measureErrors, isolatedPath, directJoints] = s;
    visit(isEdited, autoClearForces, lastInverseDt);
    std::conditional_t<std::is_const_v<Self>, const ToiScratch, ToiScratch>& toi = continuousScratch;
    visit(toi);
    visit.LeftOut(def, bodies, fixtures, contacts, joints);  // walked by themselves
    visit.LeftOut(world, pool, log, destructionListener, listener, heard, filter, mixer, errorHandler, errorContext,
                  draw, recorder, definitions);
    // Made anew from the rest, of the last step only, for measurements, or without a bearing on results.
    visit.LeftOut(broadPhase, broadPhaseKind, pairs, editedPairs, edited, islands, active, substepGroups,
                  narrowPhaseScratch, islandScratch, solverScratch, restScratches, featureCounts, kernels, locks,
                  idleSubsteps, report, distanceWork, measureErrors, isolatedPath, directJoints);
}

/// The shapes of the living fixtures, and the boxes of those in the broad phase.
template <typename Visit>
void VisitShapesAndBoxes(const WorldState& s, Visit& visit) {
    for (const FixtureIndex fixture : s.fixtures.slots.Rows()) {
        if (!s.fixtures.slots.IsAlive(fixture)) continue;
        WithShapeType(s.fixtures.type[fixture], [&]<typename T>(std::type_identity<T>) {
            visit(static_cast<const T&>(*s.fixtures.shape[fixture]));
        });
        if (s.fixtures.info[fixture].inBroadPhase) visit(s.broadPhase->GetBox(ProxyOf(fixture)));
    }
}

/// All that a world's future depends on, in the order of an image.
template <typename Visit>
void VisitWorld(const WorldState& s, Visit& visit) {
    visit(s.def, s.bodies, s.fixtures);
    VisitShapesAndBoxes(s, visit);
    visit(s.contacts, s.joints, s);
}

}  // namespace scree
