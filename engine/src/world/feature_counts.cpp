// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Who uses which feature.

#include "world/feature_counts.h"

#include <bit>
#include <cmath>

#include "world/world_state.h"

namespace scree {

namespace {

void Count(FeatureUsers& users, Features features, int sign = 1) {
    for (uint32_t bits = features.bits; bits != 0; bits &= bits - 1) {
        users[static_cast<size_t>(std::countr_zero(bits))] += sign;
    }
}

void Count(FeatureCounts& counts, Features features, int sign) {
    Count(counts.users, features, sign);
    if (sign > 0) {
        counts.used = counts.used | features;
        return;
    }
    for (uint32_t bits = features.bits; bits != 0; bits &= bits - 1) {
        const auto at = static_cast<size_t>(std::countr_zero(bits));
        if (counts.users[at] == 0) counts.used = counts.used.Without(static_cast<Feature>(at));
    }
}

bool IsDefault(const Filter& filter) {
    constexpr Filter plain;
    return filter.categoryBits == plain.categoryBits && filter.maskBits == plain.maskBits &&
           filter.groupIndex == plain.groupIndex;
}

bool HasForce(const ForceRow& row) { return row.force.x != 0.0f || row.force.y != 0.0f || row.torque != 0.0f; }

/// What the fields of a body decide.
struct BodyFacts {
    BodyType type;
    bool fixedRotation, autoSleep, bullet, isLocked;
    float linearDamping, angularDamping, gravityScale;
};
Features FeaturesOf(const BodyFacts& body) {
    Features f;
    if (body.type == staticBody) return f;
    f.Add(Feature::rotation, !body.fixedRotation).Add(Feature::sleeping, body.autoSleep);
    if (body.type == kinematicBody) return f.Add(Feature::kinematicBodies);
    return f.Add(Feature::continuousBullet, body.bullet)
        .Add(Feature::motionLocks, body.isLocked)
        .Add(Feature::damping, body.linearDamping != 0.0f || body.angularDamping != 0.0f)
        .Add(Feature::gravityScale, body.gravityScale != 1.0f);
}

/// What the fields of a fixture decide.
struct FixtureFacts {
    Shape::Type shape;
    BodyType bodyType;
    bool isSensor;
    const Material& material;
    const Filter& filter;
    uint8_t reports;
};
Features FeaturesOf(const FixtureFacts& fixture) {
    const Material& m = fixture.material;
    Features f;
    f.Add(Feature::polygons, fixture.shape == Shape::e_polygon || fixture.shape == Shape::e_convex)
        .Add(Feature::edges, fixture.shape == Shape::e_edge || fixture.shape == Shape::e_chain)
        .Add(Feature::filters, !IsDefault(fixture.filter))
        .Add(Feature::events, fixture.reports != 0)
        .Add(Feature::friction, m.friction != 0.0f || m.frictionRule == MixRule::custom)
        .Add(Feature::restitution, m.restitution != 0.0f || m.restitutionRule == MixRule::custom)
        .Add(Feature::tangentSpeed, m.tangentSpeed != 0.0f)
        .Add(Feature::rollingResistance, m.rollingResistance != 0.0f)
        .Add(Feature::sensors, fixture.isSensor)
        .Add(Feature::continuousStatic, !fixture.isSensor && fixture.bodyType != dynamicBody);
    return f;
}

/// What the world's own settings use.
Features FeaturesOfSettings(const WorldState& s) {
    return FeaturesOf(s.def).Add(Feature::events, s.listener != nullptr).Add(Feature::filters, s.filter != nullptr);
}

}  // namespace

Features UsedOf(const FeatureUsers& users) {
    Features used;
    for (size_t i = 0; i < users.size(); ++i) used.Add(static_cast<Feature>(i), users[i] > 0);
    return used;
}

Features FeaturesOf(const Filter& filter) { return Features{}.Add(Feature::filters, !IsDefault(filter)); }

Features FeaturesOf(const BodyDef& def) {
    Features f =
        FeaturesOf(BodyFacts{def.type, def.fixedRotation || def.locks.angle, def.allowSleep, def.bullet,
                             def.locks.x || def.locks.y, def.linearDamping, def.angularDamping, def.gravityScale});
    if (def.type == staticBody) return f;
    return f.Add(Feature::rotation, def.angularVelocity != 0.0f);
}

Features FeaturesOf(const FixtureDef& def, BodyType bodyType) {
    return FeaturesOf(
        FixtureFacts{def.shape->GetType(), bodyType, def.isSensor, MaterialOf(def), def.filter, def.reports});
}

Features FeaturesOfBody(const BodyTable& bodies, BodyIndex body) {
    const MotionRow& motion = bodies.motion[body];
    return FeaturesOf(BodyFacts{bodies.type[body], bodies.Has(body, BodyFlag::fixedRotation),
                                bodies.Has(body, BodyFlag::autoSleep), bodies.Has(body, BodyFlag::bullet),
                                bodies.Has(body, BodyFlag::lockX | BodyFlag::lockY), motion.linearDamping,
                                motion.angularDamping, motion.gravityScale});
}

Features FeaturesOfFixture(const FixtureTable& fixtures, const BodyTable& bodies, FixtureIndex fixture) {
    return FeaturesOf(FixtureFacts{fixtures.type[fixture], bodies.type[fixtures.body[fixture]],
                                   fixtures.isSensor[fixture] != 0, fixtures.material[fixture],
                                   fixtures.filter[fixture], fixtures.info[fixture].reports});
}

Features FeaturesOfJoint(const JointTable& joints, JointIndex joint) {
    const JointInfo& info = joints.info[joint];
    Features f;
    JointTable::WithStore(joints, info.type, [&](const auto& store) { f = FeaturesOfRow(store.rows[info.row]); });
    return f.Add(Feature::events, info.HasThreshold());
}

Features FeaturesOfContact(const ContactTable& contacts, ContactIndex contact) {
    const ContactMaterial& material = contacts.material[contact];
    const Manifold& m = contacts.manifold[contact];
    Features f;
    f.Add(Feature::friction, material.friction != 0.0f)
        .Add(Feature::restitution, material.restitution != 0.0f)
        .Add(Feature::tangentSpeed, material.tangentSpeed != 0.0f);
    for (int i = 0; i < m.pointCount; ++i) f.Add(Feature::friction, m.points[i].tangentImpulse != 0.0f);
    return f;
}

Features FeaturesOf(const WorldDef& def) {
    Features f;
    return f.Add(Feature::speedLimit, std::isfinite(def.maxTranslation) || std::isfinite(def.maxRotation))
        .Add(Feature::multiThreading, def.workerCount > 1 || def.tasks.enqueue != nullptr);
}

Features AllowedFeatures(const WorldDef& def) {
    return def.featureMode == FeatureMode::fixed ? def.features & compiledFeatures : compiledFeatures;
}

Features UnderSettings(Features features, const WorldDef& def) {
    if (!def.allowSleep) features = features.Without(Feature::sleeping);
    if (!def.continuousPhysics) {
        features = features.Without(Feature::continuousStatic).Without(Feature::continuousBullet);
    }
    return features;
}

void AddBodyFeatures(WorldState& s, BodyIndex body, int sign) {
    const Features features = FeaturesOfBody(s.bodies, body);
    Count(s.featureCounts, features, sign);
    if (sign > 0 && s.IsLocked()) NeedKernels(s, features);
}

void AddFixtureFeatures(WorldState& s, FixtureIndex fixture, int sign) {
    const FeatureUsers& users = s.featureCounts.users;
    const Features features = FeaturesOfFixture(s.fixtures, s.bodies, fixture);
    Count(s.featureCounts, features, sign);
    // When the last fixture with a feature is gone, contacts may still have it.
    const auto isGone = [&](Feature feature) {
        return features.Has(feature) && users[static_cast<size_t>(feature)] == 0;
    };
    if (sign < 0 && (isGone(Feature::friction) || isGone(Feature::restitution))) s.featureCounts.contactsEdited = true;
}

void RecountFeatures(WorldState& s) {
    s.featureCounts = {};
    s.featureCounts.contactsEdited = true;
    for (const BodyIndex b : s.bodies.slots.Rows()) {
        if (!s.bodies.slots.IsAlive(b)) continue;
        AddBodyFeatures(s, b, 1);
        s.featureCounts.forces = s.featureCounts.forces || HasForce(s.bodies.GetForce(b));
    }
    for (const FixtureIndex f : s.fixtures.slots.Rows()) {
        if (s.fixtures.slots.IsAlive(f)) AddFixtureFeatures(s, f, 1);
    }
}

FeatureUsers CountFeatureUsers(const WorldState& s) {
    FeatureUsers users{};
    for (const BodyIndex b : s.bodies.slots.Rows()) {
        if (!s.bodies.slots.IsAlive(b)) continue;
        Features f = UnderSettings(FeaturesOfBody(s.bodies, b), s.def);
        if (s.bodies.type[b] != staticBody) {
            f.Add(Feature::rotation, s.bodies.velocity[b].w != 0.0f);
            f.Add(Feature::sleeping, !s.bodies.Has(b, BodyFlag::awake));
            f.Add(Feature::forces, HasForce(s.bodies.GetForce(b)));
        }
        Count(users, f);
    }
    for (const FixtureIndex f : s.fixtures.slots.Rows()) {
        if (s.fixtures.slots.IsAlive(f)) Count(users, UnderSettings(FeaturesOfFixture(s.fixtures, s.bodies, f), s.def));
    }
    for (const JointIndex j : s.joints.slots.Rows()) {
        if (s.joints.slots.IsAlive(j)) Count(users, FeaturesOfJoint(s.joints, j));
    }
    for (const ContactIndex c : s.contacts.flags.Rows()) {
        if (!s.contacts.IsAlive(c)) continue;
        const ContactPair& pair = s.contacts.pair[c];
        const Features given = FeaturesOfFixture(s.fixtures, s.bodies, pair.fixtureA) |
                               FeaturesOfFixture(s.fixtures, s.bodies, pair.fixtureB);
        Count(users, FeaturesOfContact(s.contacts, c) - given);
    }
    Count(users, FeaturesOfSettings(s));
    return users;
}

namespace {

/// What contacts use beyond their fixtures; clears the mark once there is nothing.
Features UsedByContacts(WorldState& s, Features byFixtures) {
    Features used;
    for (const ContactIndex c : s.contacts.flags.Rows()) {
        if (s.contacts.IsAlive(c)) used = used | FeaturesOfContact(s.contacts, c);
    }
    used = used.Without(Feature::tangentSpeed);  // no kernel depends on it
    if (byFixtures.Contains(used)) s.featureCounts.contactsEdited = false;
    return used;
}

Features NeededFeatures(WorldState& s) {
    if (s.def.featureMode == FeatureMode::full) return compiledFeatures;
    if (s.def.featureMode == FeatureMode::fixed) return AllowedFeatures(s.def);
    Features used = s.featureCounts.used | FeaturesOfSettings(s);
    used.Add(Feature::forces, s.featureCounts.forces);
    const bool isSettled = used.Has(Feature::friction) && used.Has(Feature::restitution);
    return s.featureCounts.contactsEdited && !isSettled ? used | UsedByContacts(s, used) : used;
}

KernelSet NeededKernels(WorldState& s) {
    KernelSet kernels = ChooseKernels(NeededFeatures(s));
    kernels.continuous = kernels.continuous && s.def.continuousPhysics;
    return kernels;
}

}  // namespace

void PrepareKernels(WorldState& s) {
    s.kernels = NeededKernels(s);
    if (s.kernels.bodyForces) s.bodies.EnsureForces();
    if (s.def.exactDrift) EnsureRows(s.bodies.startVelocity, s.bodies.velocity.size());
}

bool NeedsContinuous(WorldState& s) {
    s.kernels.continuous = NeededKernels(s).continuous;
    return s.kernels.continuous || (s.def.continuousPhysics && s.continuousScratch.resuming);
}

void NeedKernels(WorldState& s, Features features) {
    const KernelSet more = ChooseKernels(features);
    s.kernels.bodyForces = s.kernels.bodyForces || more.bodyForces;
    if (s.kernels.bodyForces) s.bodies.EnsureForces();
    s.kernels.friction = s.kernels.friction || more.friction;
    s.kernels.restitution = s.kernels.restitution || more.restitution;
}

std::string GetName(const KernelSet& kernels) {
    std::string text;
    const auto add = [&](bool on, const char* name) {
        if (on) text += (text.empty() ? "" : ", ") + std::string(name);
    };
    add(kernels.bodyForces, "forces");
    add(kernels.speedLimit, "speed limit");
    add(kernels.friction, "friction");
    add(kernels.restitution, "restitution");
    add(kernels.continuous, "continuous");
    add(kernels.rolling, "rolling");
    add(kernels.locks, "locks");
    return text.empty() ? "none" : text;
}

BodyFeatureEdit::BodyFeatureEdit(WorldState& state, BodyIndex body, bool withFixtures)
    : m_state(state), m_body(body), m_withFixtures(withFixtures) {
    Add(-1);
}

BodyFeatureEdit::~BodyFeatureEdit() { Add(1); }

void BodyFeatureEdit::Add(int sign) {
    AddBodyFeatures(m_state, m_body, sign);
    if (!m_withFixtures) return;
    for (const FixtureIndex f : m_state.fixtures.From(m_state.bodies.fixtureHead[m_body])) {
        AddFixtureFeatures(m_state, f, sign);
    }
}

}  // namespace scree
