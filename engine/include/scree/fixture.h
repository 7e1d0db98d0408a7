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

/// Which fixtures collide: with equal non-zero groups always (positive) or never (negative), else by the masks.
struct Filter {
    uint64_t categoryBits = 0x0001;
    uint64_t maskBits = ~uint64_t{0};
    int32_t groupIndex = 0;
};

/// How the numbers of two fixtures are combined for a contact. If the rules differ, the later one in this list counts.
enum class MixRule : uint8_t {
    standard,  ///< friction: geometric mean; restitution: the larger one (MixFriction, MixRestitution)
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
    uint8_t reports = 0;             ///< what World::GetEvents reports of it: bits of Report
    float tangentSpeed = 0.0f;       ///< of a conveyor, m/s: friction carries what touches it clockwise around
    float rollingResistance = 0.0f;  ///< slows rolling: torque divided by normal force and radius, ≥ 0
    MixRule frictionRule = MixRule::standard;
    MixRule restitutionRule = MixRule::standard;
    uint64_t materialId = 0;  ///< for the program's MaterialMixer and listeners
};

/// A handle of a fixture, created by Body::CreateFixture and valid until DestroyFixture or DestroyBody. Afterwards
/// every call reports an error and returns 0, false or null.
class SCREE_API Fixture {
public:
    [[nodiscard]] Shape::Type GetType() const;
    /// The fixture's own copy of the shape, which may be changed between steps. Changes act from the next step on, but
    /// bounding box and pairs follow only when the body moves: SetShape is better. Call Body::ResetMassData for the
    /// mass. Fixtures with equal shapes share one copy until this is called, so use the const form to read.
    [[nodiscard]] Shape* GetShape();
    /// Valid until the fixture is destroyed, or until the non-const form is called for the first time.
    [[nodiscard]] const Shape* GetShape() const;
    /// Replaces the shape by another one of the same type. Its body wakes, and so does what it touches; call
    /// Body::ResetMassData for the mass. Recordings contain this call, but no changes by GetShape. Refused: another
    /// type, a degenerate shape, inside callbacks.
    ErrorCode SetShape(const Shape& shape);
    /// The fixture becomes a sensor, or a solid one again, at once. The body wakes up.
    ErrorCode SetSensor(bool sensor);
    [[nodiscard]] bool IsSensor() const;
    /// Sets a new filter; contacts are filtered again in the next step.
    ErrorCode SetFilterData(const Filter& filter);
    [[nodiscard]] Filter GetFilterData() const;
    /// What World::GetEvents reports of this fixture from now on: bits of Report. Refused: other bits, and in a world
    /// whose fixed features lack `events`.
    ErrorCode SetReports(uint8_t reports);
    [[nodiscard]] uint8_t GetReports() const;
    /// The contacts of this fixture are filtered again in the next step.
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
    /// kg/m²; takes effect at the next Body::ResetMassData. Refused: negative, NaN or infinite.
    ErrorCode SetDensity(float density);
    [[nodiscard]] float GetDensity() const;
    // A change of the material also acts on existing contacts, and wakes the bodies that touch the fixture. A value
    // that was set for a single contact stays. With `newContactsOnly` a change acts as in Box2D 2.4.
    /// Refused: negative, NaN or infinite. O(contacts of the body), like the setters below.
    ErrorCode SetFriction(float friction, bool newContactsOnly = false);
    [[nodiscard]] float GetFriction() const;
    /// Refused: NaN or infinite.
    ErrorCode SetRestitution(float restitution, bool newContactsOnly = false);
    [[nodiscard]] float GetRestitution() const;
    /// m/s. Refused: negative, NaN or infinite.
    ErrorCode SetRestitutionThreshold(float threshold, bool newContactsOnly = false);
    [[nodiscard]] float GetRestitutionThreshold() const;
    /// Of a conveyor, m/s. Friction carries what touches it clockwise around its shape, so on top to the right. For two
    /// such surfaces the speeds add up. Refused: NaN or infinite.
    ErrorCode SetTangentSpeed(float speed);
    [[nodiscard]] float GetTangentSpeed() const;
    /// The torque that slows the rolling of round shapes (disks, capsules, rounded polygons) is at most this number
    /// times normal force times radius. Of two fixtures the larger number counts. Between flat sides it does nothing.
    /// Refused: negative, NaN or infinite.
    ErrorCode SetRollingResistance(float resistance);
    [[nodiscard]] float GetRollingResistance() const;
    /// Refused: a value that is not a MixRule.
    ErrorCode SetMixRules(MixRule friction, MixRule restitution);
    [[nodiscard]] MixRule GetFrictionRule() const;
    [[nodiscard]] MixRule GetRestitutionRule() const;
    ErrorCode SetMaterialId(uint64_t id);
    [[nodiscard]] uint64_t GetMaterialId() const;
    /// The bounding box in the broad phase: tight, except in `fat-tree`.
    [[nodiscard]] AABB GetAABB() const;
    /// Number of this fixture in its world, from 0; used again after destruction.
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
