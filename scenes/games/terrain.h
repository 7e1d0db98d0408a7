// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Ground of the games' levels: a chain of short segments.

#pragma once

#include <vector>

#include "scenes/build.h"

namespace scenes {

/// A static chain over x from 0 to `end`, a vertex every `grain` m. A chain collides on its right: the surface runs
/// from the far end to the near one.
template <typename Height>
void AddTerrain(Scene& scene, double end, double grain, Height&& heightAt) {
    std::vector<Vec2> surface;
    for (double x = end; x >= 0.0; x -= grain) surface.push_back(Point(x, heightAt(x)));
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Chain(scene, surface)).friction = 0.8f;
}

}  // namespace scenes
