// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A fixture attaches a shape to a body and gives it material, filter and sensor properties.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/errors.h"
#include "scree/events.h"
#include "scree/shape.h"

namespace scree {

class Body;
struct WorldState;
enum class FixtureIndex : int;  // state/indices.h

/// Application data of a fixture.
struct FixtureUserData {
    uintptr_t pointer = 0;
};

/// Which fixtures collide: equal non-zero groups decide (positive always, negative never), else the masks.
struct Filter {
    uint64_t categoryBits = 0x0001;
    uint64_t maskBits = ~uint64_t{0};
    int32_t groupIndex = 0;
};

/// How two materials make one number of a contact. If both fixtures name a rule, the later one in this list counts.
enum class MixRule : uint8_t {
    standard,  ///< of friction the geometric mean, of restitution the larger (MixFriction, MixRestitution)
    average,
    minimum,
    multiply,
    maximum,
    custom,  ///< by the world's MaterialMixer; without one the standard rule
};

/// Input of Body::CreateFixture.
struct FixtureDef {
    const Shape* shape = nullptr;  ///< required; copied; a ChainShape makes one edge per segment
    FixtureUserData userData;
    float friction = 0.2f;              ///< Coulomb coefficient, ≥ 0
    float restitution = 0.0f;           ///< usually 0…1
    float restitutionThreshold = 1.0f;  ///< closing speed below which nothing bounces, m/s
    float density = 0.0f;               ///< kg/m², ≥ 0
    bool isSensor = false;              ///< reports contacts but never pushes
    Filter filter;
    uint8_t reports = 0;             ///< what World::GetEvents tells of it: bits of Report
    float tangentSpeed = 0.0f;       ///< of a conveyor, m/s: by friction it carries what touches it clockwise around
    float rollingResistance = 0.0f;  ///< what stops a rolling disk: torque over normal force and radius, ≥ 0
    MixRule frictionRule = MixRule::standard;
    MixRule restitutionRule = MixRule::standard;
    uint64_t materialId = 0;  ///< the program's, for its MaterialMixer and listeners
};

/// A thin, stable handle on a fixture; made by Body::CreateFixture, dead after DestroyFixture or DestroyBody: then
/// every call is an error and gives 0, false or null.
class SCREE_API Fixture {
public:
    [[nodiscard]] Shape::Type GetType() const;
    /// The fixture's own copy, which may be changed between steps; the new form counts from the next step on (call
    /// Body::ResetMassData for the mass). Fixtures with equal shapes share one until this is called: to look only, take
    /// the const form, which costs nothing.
    [[nodiscard]] Shape* GetShape();
    /// Valid until the fixture is destroyed or the form above is first called on it.
    [[nodiscard]] const Shape* GetShape() const;
    /// Another form of the same type, as if it was written through GetShape; recordings hold this call and no such
    /// writes. Refused: another type, a degenerate shape, inside callbacks.
    ErrorCode SetShape(const Shape& shape);
    /// Sensors stop (or start) pushing at once; the body wakes up.
    ErrorCode SetSensor(bool sensor);
    [[nodiscard]] bool IsSensor() const;
    /// New filter; contacts are re-examined in the next step.
    ErrorCode SetFilterData(const Filter& filter);
    [[nodiscard]] Filter GetFilterData() const;
    /// What World::GetEvents tells of this fixture from now on: bits of Report. Refused: others, and in a world whose
    /// features are fixed without `events`.
    ErrorCode SetReports(uint8_t reports);
    [[nodiscard]] uint8_t GetReports() const;
    /// Re-examines the filters of this fixture's contacts in the next step.
    void Refilter();
    [[nodiscard]] Body* GetBody();
    [[nodiscard]] const Body* GetBody() const;
    /// Shared by the edges that one ChainShape made, unique in the world; −1 for other fixtures.
    [[nodiscard]] int GetChainId() const;
    /// Number of this edge in its chain, from 0; −1 for other fixtures.
    [[nodiscard]] int GetChainIndex() const;
    /// The next fixture of the same body, newest first; null at the end.
    [[nodiscard]] Fixture* GetNext();
    [[nodiscard]] const Fixture* GetNext() const;
    [[nodiscard]] FixtureUserData GetUserData() const;
    ErrorCode SetUserData(const FixtureUserData& data);
    [[nodiscard]] bool TestPoint(Vec2 p) const;
    bool RayCast(RayCastOutput* output, const RayCastInput& input) const;
    void GetMassData(MassData* massData) const;
    /// Takes effect at the next Body::ResetMassData. Refused: negative or not finite.
    ErrorCode SetDensity(float density);
    [[nodiscard]] float GetDensity() const;
    // A change of the material acts on the contacts that the fixture has, too, and wakes the bodies that touch it
    // there; a number that a contact was given itself stays. With `newContactsOnly` it acts as in Box2D 2.4.
    /// Refused: negative or not finite. O(contacts of the body), as all of these.
    ErrorCode SetFriction(float friction, bool newContactsOnly = false);
    [[nodiscard]] float GetFriction() const;
    /// Refused: not finite.
    ErrorCode SetRestitution(float restitution, bool newContactsOnly = false);
    [[nodiscard]] float GetRestitution() const;
    /// m/s. Refused: negative or not finite.
    ErrorCode SetRestitutionThreshold(float threshold, bool newContactsOnly = false);
    [[nodiscard]] float GetRestitutionThreshold() const;
    /// Of a conveyor, m/s: what touches it is carried clockwise around its shape, seen on top to the right. Of two such
    /// surfaces the speeds add up. Refused: not finite.
    ErrorCode SetTangentSpeed(float speed);
    [[nodiscard]] float GetTangentSpeed() const;
    /// The torque that slows the rolling of round shapes (disks, capsules, rounded polygons) is at most this times the
    /// normal force times the radius; of two materials the larger number counts. Between flat sides it does nothing.
    /// Refused: negative or not finite.
    ErrorCode SetRollingResistance(float resistance);
    [[nodiscard]] float GetRollingResistance() const;
    /// Refused: what is no MixRule.
    ErrorCode SetMixRules(MixRule friction, MixRule restitution);
    [[nodiscard]] MixRule GetFrictionRule() const;
    [[nodiscard]] MixRule GetRestitutionRule() const;
    ErrorCode SetMaterialId(uint64_t id);
    [[nodiscard]] uint64_t GetMaterialId() const;
    /// The box kept by the broad phase: tight, except in `fat-tree`.
    [[nodiscard]] AABB GetAABB() const;
    /// Dense number of this fixture in its world; reused after destruction.
    [[nodiscard]] int GetIndex() const { return static_cast<int>(m_index); }

    Fixture(WorldState* state, FixtureIndex index) : m_state(state), m_index(index) {}
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

private:
    [[nodiscard]] bool Lives(const char* accessor) const;

    WorldState* m_state;
    FixtureIndex m_index;
};

}  // namespace scree
