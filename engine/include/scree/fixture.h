// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A fixture attaches a shape to a body and gives it material, filter and sensor properties.

#pragma once

#include <cstdint>

#include "scree/errors.h"
#include "scree/shape.h"

namespace scree {

class Body;
struct WorldState;

/// Application data of a fixture.
struct FixtureUserData {
    uintptr_t pointer = 0;
};

/// Which fixtures collide: equal non-zero groups decide (positive always, negative never), else the masks.
struct Filter {
    uint16_t categoryBits = 0x0001;
    uint16_t maskBits = 0xFFFF;
    int16_t groupIndex = 0;
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
};

/// A thin, stable handle on a fixture; made by Body::CreateFixture, dead after DestroyFixture or DestroyBody: then
/// every call is an error and gives 0, false or null.
class Fixture {
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
    /// For new contacts only, as in Box2D. Refused: negative or not finite.
    ErrorCode SetFriction(float friction);
    [[nodiscard]] float GetFriction() const;
    /// For new contacts only. Refused: not finite.
    ErrorCode SetRestitution(float restitution);
    [[nodiscard]] float GetRestitution() const;
    /// For new contacts only, m/s. Refused: negative or not finite.
    ErrorCode SetRestitutionThreshold(float threshold);
    [[nodiscard]] float GetRestitutionThreshold() const;
    /// The box kept by the broad phase: tight, except in `fat-tree`.
    [[nodiscard]] AABB GetAABB() const;
    /// Dense number of this fixture in its world; reused after destruction.
    [[nodiscard]] int GetIndex() const { return m_index; }

    Fixture(WorldState* state, int index) : m_state(state), m_index(index) {}
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

private:
    [[nodiscard]] bool Lives(const char* accessor) const;

    WorldState* m_state;
    int m_index;
};

}  // namespace scree
