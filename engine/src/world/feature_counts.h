// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which features the objects of a world use. Bodies and fixtures are counted as they come, change and go, so that a
// step knows in O(1) which kernels it needs; World::GetFeatureUsers counts everything anew.

#pragma once

#include "scree/features.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct WorldDef;
struct WorldState;

struct FeatureCounts {
    FeatureUsers users{};         ///< of what bodies and fixtures decide, whatever the world's settings
    Features used;                ///< those of them that have some
    bool forces = false;          ///< one was applied since the last ClearForces
    bool contactsEdited = false;  ///< contacts may use what their fixtures do not
};

/// The features that have users.
Features UsedOf(const FeatureUsers& users);
/// What one object uses, were every setting of the world on.
Features FeaturesOf(const BodyDef& def);
Features FeaturesOf(const Filter& filter);
Features FeaturesOf(const FixtureDef& def, BodyType bodyType);
Features FeaturesOfBody(const BodyTable& bodies, BodyIndex body);
Features FeaturesOfFixture(const FixtureTable& fixtures, const BodyTable& bodies, FixtureIndex fixture);
Features FeaturesOfJoint(const JointTable& joints, JointIndex joint);
/// Restitution, friction and tangent speed of its own; friction also while some of it is still in its impulses.
Features FeaturesOfContact(const ContactTable& contacts, ContactIndex contact);

template <typename Row>
Features FeaturesOfRow(const Row& row) {
    Features f{Feature::joints};
    if constexpr (requires { row.stiffness; }) f.Add(Feature::springs, row.stiffness > 0.0f);
    if constexpr (requires { row.spring; }) f.Add(Feature::springs, row.spring.enabled && row.spring.stiffness > 0.0f);
    if constexpr (requires { row.motor; }) f.Add(Feature::motors, row.motor.enabled);
    if constexpr (Row::type == e_motorJoint) f.Add(Feature::motors);
    if constexpr (Row::type == e_distanceJoint) {
        // A rod keeps its length without a limit, and a spring without bounds needs none.
        const bool bounded = row.limit.lower > row.shortest || row.limit.upper < std::numeric_limits<float>::max();
        f.Add(Feature::limits, bounded && row.limit.lower < row.limit.upper);
    } else if constexpr (requires { row.limit; }) {
        f.Add(Feature::limits, row.limit.enabled);
    }
    return f;
}

/// What a world must have to be made with this definition.
Features FeaturesOf(const WorldDef& def);
/// What a world may use: with a fixed set that, else what the library was built with.
Features AllowedFeatures(const WorldDef& def);
/// `features` without those that a world with these settings does not look at: sleeping where it is off, and so on.
Features UnderSettings(Features features, const WorldDef& def);

void AddBodyFeatures(WorldState& state, BodyIndex body, int sign);
void AddFixtureFeatures(WorldState& state, FixtureIndex fixture, int sign);
/// Counts bodies and fixtures anew, e.g. of a world that was read from an image.
void RecountFeatures(WorldState& state);
/// An exact count of everything.
FeatureUsers CountFeatureUsers(const WorldState& state);

/// Sets what the kernels of this step need, and makes their columns. O(1), O(contacts) while contacts may differ from
/// their fixtures.
void PrepareKernels(WorldState& state);
/// Whether the step needs its continuous stage. A listener of the solver may have made a bullet. A step that goes on
/// with the rest of the last one has its events to finish.
bool NeedsContinuous(WorldState& state);
/// A callback made an object use this while a step runs.
void NeedKernels(WorldState& state, Features features);

/// Brackets a change of one body, or of its fixtures with it.
class BodyFeatureEdit {
public:
    BodyFeatureEdit(WorldState& state, BodyIndex body, bool withFixtures = false);
    ~BodyFeatureEdit();
    BodyFeatureEdit(const BodyFeatureEdit&) = delete;
    BodyFeatureEdit& operator=(const BodyFeatureEdit&) = delete;

private:
    void Add(int sign);

    WorldState& m_state;
    BodyIndex m_body;
    bool m_withFixtures;
};

/// Brackets a change of one fixture.
class FixtureFeatureEdit {
public:
    FixtureFeatureEdit(WorldState& state, FixtureIndex fixture) : m_state(state), m_fixture(fixture) {
        AddFixtureFeatures(m_state, m_fixture, -1);
    }
    ~FixtureFeatureEdit() { AddFixtureFeatures(m_state, m_fixture, 1); }
    FixtureFeatureEdit(const FixtureFeatureEdit&) = delete;
    FixtureFeatureEdit& operator=(const FixtureFeatureEdit&) = delete;

private:
    WorldState& m_state;
    FixtureIndex m_fixture;
};

}  // namespace scree
