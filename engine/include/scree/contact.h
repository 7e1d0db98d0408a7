// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A contact is a persistent pair of fixtures whose tight AABBs overlap; it may or may not be touching.

#pragma once

#include <cmath>
#include <limits>

#include "scree/api.h"
#include "scree/collision.h"
#include "scree/errors.h"
#include "scree/fixture.h"

namespace scree {

enum class ContactIndex : int;  // state/indices.h

/// A thin handle on a contact, alive until the pair's boxes part (EndContact is the last call for a touching one): then
/// every call is an error and gives 0, false or null, until the handle serves another contact. World::GetId tells two
/// contacts with the same handle apart.
class SCREE_API Contact {
public:
    /// In local coordinates; pointCount 0 when not touching.
    [[nodiscard]] Manifold GetManifold() const;
    /// Replaces the manifold until the next step computes it anew: meant for
    /// PreSolve. Refused: more than two points, or a number that is not finite.
    ErrorCode SetManifold(const Manifold& manifold);
    void GetWorldManifold(WorldManifold* worldManifold) const;
    [[nodiscard]] bool IsTouching() const;
    /// Disabling lasts for the current step only: meant for PreSolve.
    void SetEnabled(bool flag);
    [[nodiscard]] bool IsEnabled() const;
    /// The next contact of the world; null at the end.
    [[nodiscard]] Contact* GetNext();
    [[nodiscard]] const Contact* GetNext() const;
    [[nodiscard]] Fixture* GetFixtureA();
    [[nodiscard]] const Fixture* GetFixtureA() const;
    [[nodiscard]] Fixture* GetFixtureB();
    [[nodiscard]] const Fixture* GetFixtureB() const;
    // What a contact is given itself stays until it is reset, whatever happens to the fixtures' materials.
    /// Overrides the mixed friction until ResetFriction. Refused: negative or not finite.
    ErrorCode SetFriction(float friction);
    [[nodiscard]] float GetFriction() const;
    void ResetFriction();
    ErrorCode SetRestitution(float restitution);
    [[nodiscard]] float GetRestitution() const;
    void ResetRestitution();
    ErrorCode SetRestitutionThreshold(float threshold);
    [[nodiscard]] float GetRestitutionThreshold() const;
    void ResetRestitutionThreshold();
    /// Conveyor-belt speed along the tangent, m/s; at first the sum of the fixtures'.
    ErrorCode SetTangentSpeed(float speed);
    [[nodiscard]] float GetTangentSpeed() const;
    /// Number of this contact in its world while it lives; reused.
    [[nodiscard]] int GetIndex() const;

    Contact(WorldState* state, ContactIndex row) : m_state(state), m_row(row) {}
    Contact(const Contact&) = delete;
    Contact& operator=(const Contact&) = delete;

private:
    friend struct ContactTable;
    [[nodiscard]] bool Lives(const char* accessor) const;

    WorldState* m_state;
    ContactIndex m_row;
};

/// The standard rules of mixing two materials: geometric mean (finite, however large both are), the larger (0 if both
/// are below: what hits does not sink in), the smaller.
inline float MixFriction(float a, float b) { return Min(std::sqrt(a * b), std::numeric_limits<float>::max()); }
inline float MixRestitution(float a, float b) { return Max(a > b ? a : b, 0.0f); }
inline float MixRestitutionThreshold(float a, float b) { return a < b ? a : b; }

}  // namespace scree
