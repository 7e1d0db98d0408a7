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

/// A handle of a contact, valid while the bounding boxes of its fixtures overlap; of a touching one until EndContact.
/// Afterwards every call reports an error and returns 0, false or null, until another contact gets the handle.
/// World::GetId distinguishes contacts with the same handle.
class SCREE_API Contact {
public:
    /// In local coordinates; pointCount is 0 if the fixtures do not touch.
    [[nodiscard]] Manifold GetManifold() const;
    /// Replaces the manifold until the next step computes it again; meant for PreSolve. Without points it disables the
    /// contact for the current step. Refused: more than two points, an unknown type, NaN or infinity.
    ErrorCode SetManifold(const Manifold& manifold);
    void GetWorldManifold(WorldManifold* worldManifold) const;
    [[nodiscard]] bool IsTouching() const;
    /// Disables the contact for the current step only; meant for PreSolve.
    void SetEnabled(bool flag);
    [[nodiscard]] bool IsEnabled() const;
    /// The next contact of the world; null at the end.
    [[nodiscard]] Contact* GetNext();
    [[nodiscard]] const Contact* GetNext() const;
    [[nodiscard]] Fixture* GetFixtureA();
    [[nodiscard]] const Fixture* GetFixtureA() const;
    [[nodiscard]] Fixture* GetFixtureB();
    [[nodiscard]] const Fixture* GetFixtureB() const;
    // A value that is set for a contact stays until it is reset, even if the materials of the fixtures change.
    /// Replaces the mixed friction until ResetFriction. Refused: negative, NaN or infinite.
    ErrorCode SetFriction(float friction);
    [[nodiscard]] float GetFriction() const;
    void ResetFriction();
    ErrorCode SetRestitution(float restitution);
    [[nodiscard]] float GetRestitution() const;
    void ResetRestitution();
    ErrorCode SetRestitutionThreshold(float threshold);
    [[nodiscard]] float GetRestitutionThreshold() const;
    void ResetRestitutionThreshold();
    /// Speed of a conveyor along the tangent, m/s; initially the sum of the fixtures' speeds.
    ErrorCode SetTangentSpeed(float speed);
    [[nodiscard]] float GetTangentSpeed() const;
    /// Number of this contact in its world, from 0; used again after it ended.
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

/// The standard rules of mixing two materials. Friction: the geometric mean, always finite. Restitution: the larger
/// one, at least 0. Threshold: the smaller one.
inline float MixFriction(float a, float b) { return Min(std::sqrt(a * b), std::numeric_limits<float>::max()); }
inline float MixRestitution(float a, float b) { return Max(a > b ? a : b, 0.0f); }
inline float MixRestitutionThreshold(float a, float b) { return a < b ? a : b; }

}  // namespace scree
