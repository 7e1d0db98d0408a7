// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fast box that add-pair and add-pair-400 shoot into resting circles.

#pragma once

#include "scenes/build.h"

namespace scenes {

/// A resting circle of the cloud that the box hits.
inline void AddCloudCircle(Scene& scene, Vec2 position) {
    AddBody(scene, BodyType::dynamic, position);
    AddFixture(scene, Circle(0.1), 0.01);
}

/// The box, 32 m left of the cloud at 150 m/s. It is no bullet. Engines that cap the motion at 2 m a step, as Box2D 2.4
/// does, move it at 120 m/s.
inline void AddFastBox(Scene& scene) {
    AddBody(scene, BodyType::dynamic, Point(-40.0, 5.0)).linearVelocity = Point(150.0, 0.0);
    AddFixture(scene, Box(1.5, 1.5), 1.0);
}

}  // namespace scenes
