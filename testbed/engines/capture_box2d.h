// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Any world of Box2D as a Snapshot: one that the testbed loaded from a scene, or one that a program built for itself.

#pragma once

#include <functional>
#include <span>

#include "scenes/scene.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/snapshot.h"

class b2Body;
class b2Fixture;
class b2Joint;
class b2World;

namespace testbed {

/// Replaces all that the world itself knows. Scene, size, step, times, threads and memory stay as they are. Bodies,
/// joints and the fixtures of a body come oldest first. Shapes are read back from the engine: boxes as polygons.
/// O(world).
void Capture(b2World& world, Snapshot& snapshot, const CaptureParts& parts = {});

/// A fixture, its index into the scene's fixtures, and which child of it is meant.
struct Box2dProxy {
    b2Fixture* fixture;
    int sceneIndex;
    int child;
};

/// In which order a capture lists the objects of a world, and the scene that has their shapes.
struct Box2dListing {
    const scenes::Scene* scene = nullptr;  ///< null: shapes are read back
    std::span<b2Body* const> bodies;
    std::function<int(b2Body*)> indexOf;  ///< of a body in `bodies`
    std::span<const Box2dProxy> proxies;
    std::function<int(b2Fixture*)> proxyOf;  ///< index into `proxies` of a fixture's first child; the others follow
    std::span<b2Joint* const> joints;
};

/// The same for what is listed; contacts and nodes are always those of the whole world.
void Capture(b2World& world, const Box2dListing& listing, Snapshot& snapshot, const CaptureParts& parts);

[[nodiscard]] BodyState CaptureBody(const b2Body& body, int index);

}  // namespace testbed
