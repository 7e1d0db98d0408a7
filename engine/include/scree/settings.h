// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Constants of the simulation, with Box2D 2.4's names and values (without the b2_ prefix). Lengths in m, angles in rad,
// times in s. They describe what counts as "touching", "at rest" or "fast" for objects between 0.1 m and 10 m.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr float pi = 3.14159265359f;

/// Most points a contact manifold can hold.
inline constexpr int maxManifoldPoints = 2;
/// Most vertices of a polygon shape.
inline constexpr int maxPolygonVertices = 8;
/// Most vertices of a ConvexShape.
inline constexpr int maxConvexVertices = 64;

/// Margin of a fattened AABB, m (algorithm `fat-tree` only; every other algorithm keeps tight boxes).
inline constexpr float aabbExtension = 0.1f;
/// Factor on the displacement by which a fattened AABB is stretched ahead (algorithm `fat-tree` only).
inline constexpr float aabbMultiplier = 4.0f;

/// Allowed overlap or separation, m: small enough to be invisible, large enough to keep contacts alive.
inline constexpr float linearSlop = 0.005f;
/// Allowed angular error of joints, rad.
inline constexpr float angularSlop = 2.0f / 180.0f * pi;
/// Skin around polygons and edges, m: the solver keeps shapes apart by about this radius per polygon.
inline constexpr float polygonRadius = 2.0f * linearSlop;

/// Largest position correction of one position iteration, m; prevents overshoot.
inline constexpr float maxLinearCorrection = 0.2f;
/// Largest angular correction of one position iteration, rad.
inline constexpr float maxAngularCorrection = 8.0f / 180.0f * pi;
/// Speed cap of Box2D 2.4, m per step. `WorldDef::maxTranslation` is unlimited unless set to this.
inline constexpr float maxTranslation = 2.0f;
/// Spin cap of Box2D 2.4, rad per step. `WorldDef::maxRotation` is unlimited unless set to this.
inline constexpr float maxRotation = 0.5f * pi;
/// Share of the overlap that one position iteration removes.
inline constexpr float baumgarte = 0.2f;

/// The same for the position iterations after a continuous-collision event.
inline constexpr float toiBaumgarte = 0.75f;
/// Most continuous-collision events of one pair in a step; a body that would need more waits for the next step.
inline constexpr int maxSubSteps = 8;

/// A body must be slow for this long before it may sleep, s.
inline constexpr float timeToSleep = 0.5f;
/// Speed below which a body counts as slow, m/s.
inline constexpr float linearSleepTolerance = 0.01f;
/// Spin below which a body counts as slow, rad/s.
inline constexpr float angularSleepTolerance = 2.0f / 180.0f * pi;

}  // namespace scree
