// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Checks of definitions and handles.

#include "world/validate.h"

#include "state/limits.h"

namespace scree {

namespace {

bool IsFinite(float value) { return std::isfinite(value); }
bool IsFinite(Vec2 value) { return value.IsValid(); }

Finding NotFinite(const char* field) { return {ErrorCode::nonFinite, field, "give a finite number"}; }
Finding Negative(const char* field) { return {ErrorCode::outOfRange, field, "give a number of at least 0"}; }

/// Finite and not negative.
Finding CheckAmount(float value, const char* field) {
    if (!std::isfinite(value)) return NotFinite(field);
    if (value < 0.0f) return Negative(field);
    return {};
}

/// The first finding of a list, or none.
template <typename... Findings>
Finding First(Findings... findings) {
    Finding result;
    ((result.code == ErrorCode::ok ? void(result = findings) : void()), ...);
    return result;
}

Finding CheckFinite(bool finite, const char* field) { return finite ? Finding{} : NotFinite(field); }

/// Finite, and no farther than squares and boxes stay finite.
template <typename T>
Finding CheckNear(T value, const char* field) {
    if (IsInRange(value)) return {};
    if (Finding wrong = CheckFinite(IsFinite(value), field)) return wrong;
    return {ErrorCode::outOfRange, field, "give numbers of at most 1e18"};
}
Finding CheckNear(std::span<const Vec2> vertices, const char* field) {
    for (const Vec2 vertex : vertices) {
        if (const Finding wrong = CheckNear(vertex, field)) return wrong;
    }
    return {};
}

/// Of what is computed from vertices in range, and rounded.
template <typename T>
Finding CheckAbout(T value, const char* field) {
    return CheckNear(0.5f * value, field);
}

/// Those of single points are 0.
Finding CheckNormals(std::span<const Vec2> normals, const char* field) {
    constexpr float most = 1.01f;
    for (const Vec2 normal : normals) {
        if (!(normal.LengthSquared() <= most)) return {ErrorCode::badShape, field, "give normals of length 1"};
    }
    return {};
}

Finding CheckPolygon(const PolygonShape& polygon) {
    if (polygon.m_count < 3 || polygon.m_count > maxPolygonVertices) {
        return {ErrorCode::badShape, "PolygonShape::m_count", "call Set or SetAsBox first; 3 to 8 vertices"};
    }
    if (!polygon.Validate())
        return {ErrorCode::badShape, "PolygonShape::m_vertices", "give a convex, counter-clockwise polygon"};
    const size_t count = ToSize(polygon.m_count);
    return First(CheckNear(std::span(polygon.m_vertices, count), "PolygonShape::m_vertices"),
                 CheckNormals(std::span(polygon.m_normals, count), "PolygonShape::m_normals"),
                 CheckAbout(polygon.m_centroid, "PolygonShape::m_centroid"));
}

Finding CheckConvex(const ConvexShape& convex) {
    if (convex.m_badField != nullptr) return {ErrorCode::badShape, convex.m_badField, "see convex_shape.h"};
    if (convex.m_count < 1 || convex.m_count > maxConvexVertices)
        return {ErrorCode::badShape, "ConvexShape::m_count", "use a Make function; 1 to 64 vertices"};
    if (!convex.Validate())
        return {ErrorCode::badShape, "ConvexShape::m_vertices", "give a convex, counter-clockwise core"};
    if (convex.m_solidRadius > convex.m_radius)
        return {ErrorCode::badShape, "ConvexShape::m_solidRadius", "give at most the radius"};
    const size_t count = ToSize(convex.m_count);
    if (const Finding wrong = CheckNear(std::span(convex.m_vertices, count), "ConvexShape::m_vertices")) return wrong;
    for (const Vec2 control : std::span(convex.m_controls, count)) {
        if (const Finding wrong = CheckAbout(control, "ConvexShape::m_controls")) return wrong;
    }
    return First(CheckNormals(std::span(convex.m_normals, count), "ConvexShape::m_normals"),
                 CheckAmount(convex.m_solidRadius, "ConvexShape::m_solidRadius"),
                 CheckAmount(convex.m_error, "ConvexShape::m_error"), CheckNear(convex.m_error, "ConvexShape::m_error"),
                 CheckAbout(convex.m_unitMass.center, "ConvexShape::m_unitMass"));
}

Finding CheckEdge(const EdgeShape& edge) {
    const bool finite = edge.m_vertex1.IsValid() && edge.m_vertex2.IsValid() &&
                        (!edge.m_oneSided || (edge.m_vertex0.IsValid() && edge.m_vertex3.IsValid()));
    if (!finite) return NotFinite("EdgeShape::m_vertex");
    if (DistanceSquared(edge.m_vertex1, edge.m_vertex2) == 0.0f) {
        return {ErrorCode::badShape, "EdgeShape::m_vertex2", "give two different end points"};
    }
    return First(CheckNear(edge.m_vertex1, "EdgeShape::m_vertex"), CheckNear(edge.m_vertex2, "EdgeShape::m_vertex"));
}

}  // namespace

Finding Check(const ChainShape& chain) {
    if (chain.m_vertices.size() < 2)
        return {ErrorCode::badShape, "ChainShape::m_vertices", "call CreateLoop or CreateChain first"};
    if (!chain.m_prevVertex.IsValid()) return NotFinite("ChainShape::m_prevVertex");
    if (!chain.m_nextVertex.IsValid()) return NotFinite("ChainShape::m_nextVertex");
    for (int i = 0; i < chain.GetChildCount(); ++i) {
        EdgeShape edge;
        chain.GetChildEdge(&edge, i);
        if (const Finding bad = CheckEdge(edge)) return {bad.code, "ChainShape::m_vertices", bad.cure};
    }
    return {};
}

Finding Check(const Shape& shape) {
    if (const Finding radius = CheckAmount(shape.m_radius, "Shape::m_radius")) return radius;
    if (const Finding radius = CheckNear(shape.m_radius, "Shape::m_radius")) return radius;
    switch (shape.GetType()) {
        case Shape::e_circle: {
            const auto& circle = static_cast<const CircleShape&>(shape);
            if (!circle.m_p.IsValid()) return NotFinite("CircleShape::m_p");
            if (circle.m_radius <= 0.0f) return {ErrorCode::badShape, "CircleShape::m_radius", "give a radius above 0"};
            return CheckNear(circle.m_p, "CircleShape::m_p");
        }
        case Shape::e_edge:
            return CheckEdge(static_cast<const EdgeShape&>(shape));
        case Shape::e_polygon:
            return CheckPolygon(static_cast<const PolygonShape&>(shape));
        case Shape::e_convex:
            return CheckConvex(static_cast<const ConvexShape&>(shape));
        case Shape::e_chain:
            return Check(static_cast<const ChainShape&>(shape));
        default:
            return {ErrorCode::badShape, "Shape::m_type", "use a shape of this library"};
    }
}

Finding Check(const BodyDef& def) {
    if (def.type != staticBody && def.type != kinematicBody && def.type != dynamicBody) {
        return {ErrorCode::outOfRange, "BodyDef::type", "use staticBody, kinematicBody or dynamicBody"};
    }
    if (const Finding wrong = CheckNear(def.position, "BodyDef::position")) return wrong;
    if (const Finding wrong = CheckNear(def.positionRest, "BodyDef::positionRest")) return wrong;
    if (const Finding wrong = CheckNear(def.angle, "BodyDef::angle")) return wrong;
    if (const Finding wrong = CheckNear(def.linearVelocity, "BodyDef::linearVelocity")) return wrong;
    if (const Finding wrong = CheckNear(def.angularVelocity, "BodyDef::angularVelocity")) return wrong;
    if (const Finding wrong = CheckAmount(def.linearDamping, "BodyDef::linearDamping")) return wrong;
    if (const Finding wrong = CheckAmount(def.angularDamping, "BodyDef::angularDamping")) return wrong;
    return CheckFinite(std::isfinite(def.gravityScale), "BodyDef::gravityScale");
}

Finding CheckRule(MixRule rule, const char* field) {
    return rule <= MixRule::custom ? Finding{} : Finding{ErrorCode::outOfRange, field, "give one of MixRule"};
}

Finding CheckReports(uint8_t reports, const char* field) {
    if ((reports & ~Report::all) == 0) return {};
    return {ErrorCode::outOfRange, field, "use bits of Report"};
}

Finding Check(const FixtureDef& def, bool isShapeKnown) {
    if (def.shape == nullptr) return {ErrorCode::nullArgument, "FixtureDef::shape", "point it at a shape"};
    if (!isShapeKnown) {
        if (const Finding wrong = Check(*def.shape)) return wrong;
    }
    if (const Finding wrong = CheckAmount(def.friction, "FixtureDef::friction")) return wrong;
    if (!std::isfinite(def.restitution)) return NotFinite("FixtureDef::restitution");
    if (const Finding wrong = CheckAmount(def.restitutionThreshold, "FixtureDef::restitutionThreshold")) return wrong;
    if (const Finding wrong = CheckNear(def.tangentSpeed, "FixtureDef::tangentSpeed")) return wrong;
    if (const Finding wrong = CheckAmount(def.rollingResistance, "FixtureDef::rollingResistance")) return wrong;
    if (const Finding wrong = CheckRule(def.frictionRule, "FixtureDef::frictionRule")) return wrong;
    if (const Finding wrong = CheckRule(def.restitutionRule, "FixtureDef::restitutionRule")) return wrong;
    if (const Finding wrong = CheckAmount(def.density, "FixtureDef::density")) return wrong;
    if (const Finding wrong = CheckReports(def.reports, "FixtureDef::reports")) return wrong;
    return CheckMass(*def.shape, def.density, "FixtureDef::density");
}

Finding CheckMass(const Shape& shape, float density, const char* field) {
    if (density == 0.0f) return {};
    MassData data;
    shape.ComputeMass(&data, density);
    if (data.mass == 0.0f) return {};
    if (!(data.mass >= leastMass && data.mass <= mostMass))
        return {ErrorCode::outOfRange, field, "give a density that makes a mass of 0 or of 1e-30 to 1e30 kg"};
    if (!data.center.IsValid() || !(data.I <= mostInertia))
        return {ErrorCode::outOfRange, field, "give a shape and a density that make an inertia of at most 1e36 kg m^2"};
    return {};
}

Finding Check(const WorldDef& def) {
    if (!def.gravity.IsValid()) return NotFinite("WorldDef::gravity");
    if (static_cast<size_t>(def.broadPhase) >= broadPhaseNames.size()) {
        return {ErrorCode::outOfRange, "WorldDef::broadPhase", "use a BroadPhaseKind"};
    }
    if (!(def.staticShareThreshold >= 0.0f && def.staticShareThreshold <= 1.0f))
        return {ErrorCode::outOfRange, "WorldDef::staticShareThreshold", "give a share from 0 to 1"};
    if (!(def.softStep.contactHertz > 0.0f) || !std::isfinite(def.softStep.contactHertz))
        return {ErrorCode::outOfRange, "WorldDef::softStep.contactHertz", "give a frequency above 0"};
    if (!(def.softStep.contactDampingRatio > 0.0f) || !std::isfinite(def.softStep.contactDampingRatio))
        return {ErrorCode::outOfRange, "WorldDef::softStep.contactDampingRatio", "give a ratio above 0"};
    if (!(def.softStep.contactPushSpeed > 0.0f))
        return {ErrorCode::outOfRange, "WorldDef::softStep.contactPushSpeed", "give a speed above 0"};
    if (def.workerCount < 1 || def.workerCount > maxWorkers)
        return {ErrorCode::outOfRange, "WorldDef::workerCount", "give 1 to maxWorkers"};
    if ((def.tasks.enqueue == nullptr) != (def.tasks.finish == nullptr))
        return {ErrorCode::nullArgument, "WorldDef::tasks", "give both enqueue and finish, or neither"};
    if (def.tasks.tasksPerWorker < 0 || def.tasks.tasksPerWorker > maxWorkers / def.workerCount)
        return {ErrorCode::outOfRange, "WorldDef::tasks.tasksPerWorker", "give 0 to maxWorkers / workerCount"};
    if (def.featureMode > FeatureMode::fixed)
        return {ErrorCode::outOfRange, "WorldDef::featureMode", "give one of FeatureMode"};
    const Features missing = FeaturesOf(def) - AllowedFeatures(def);
    if (!missing.IsEmpty())
        return {ErrorCode::missingFeature, GetName(missing.First()),
                "add it to WorldDef::features, or do not ask for it"};
    if (def.solver > SolverKind::softStep) return {ErrorCode::outOfRange, "WorldDef::solver", "give one of SolverKind"};
    if (!(def.maxTranslation > 0.0f))
        return {ErrorCode::outOfRange, "WorldDef::maxTranslation", "give a length above 0"};
    if (!(def.lengthScale >= 1e-6f && def.lengthScale <= 1e6f))
        return {ErrorCode::outOfRange, "WorldDef::lengthScale", "give a length from 1e-6 to 1e6 m"};
    if (!(def.farDistance >= 0.0f))
        return {ErrorCode::outOfRange, "WorldDef::farDistance", "give a distance of at least 0"};
    if (!(def.maxRotation > 0.0f)) return {ErrorCode::outOfRange, "WorldDef::maxRotation", "give an angle above 0"};
    return {};
}

bool Owns(const WorldState& state, const Body* body) {
    if (body == nullptr) return false;
    const BodyIndex index = IndexOf(*body);
    return state.bodies.slots.IsAlive(index) && &state.bodies.handles[index] == body;
}

bool Owns(const WorldState& state, const Fixture* fixture) {
    if (fixture == nullptr) return false;
    const FixtureIndex index = IndexOf(*fixture);
    return state.fixtures.slots.IsAlive(index) && &state.fixtures.handles[index] == fixture;
}

bool Owns(const WorldState& state, const Joint* joint) {
    if (joint == nullptr) return false;
    const JointIndex index = IndexOf(*joint);
    return state.joints.slots.IsAlive(index) && state.joints.handles[index] == joint;
}

bool Owns(const WorldState& state, const Contact* contact) { return state.contacts.Owns(contact); }

}  // namespace scree
