// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Any world of ours as a Snapshot, through its public headers alone: one that the testbed loaded from a scene, or one
// that a program built for itself.

#pragma once

#include <functional>
#include <span>
#include <vector>

#include "scenes/scene.h"
#include "scree/world.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/snapshot.h"

namespace testbed {

/// Replaces all that the world itself knows. Scene, size, step, times, threads and memory stay as they are. Bodies come
/// static ones first, oldest first; fixtures with their bodies, oldest first; joints oldest first. Shapes are read back
/// from the engine: boxes as polygons, the further convex shapes by their outlines. O(world).
void Capture(const scree::World& world, Snapshot& snapshot, const CaptureParts& parts = {});

/// A fixture of the engine, the index of its fixture in the scene, and which edge of that it is.
struct ScreeProxy {
    const scree::Fixture* fixture;
    int sceneIndex;
    int child;
    std::vector<Vec2> outline{};  ///< of a further convex shape
};

/// In which order a capture lists the objects of a world, and the scene that has their shapes.
struct ScreeListing {
    const scenes::Scene* scene = nullptr;  ///< null: shapes are read back
    std::span<const scree::Body* const> bodies;
    std::function<int(const scree::Body*)> indexOf;  ///< of a body in `bodies`
    std::span<const ScreeProxy> proxies;
    std::span<const int> proxyOf;  ///< Fixture::GetIndex → index into `proxies`
    std::span<const scree::Joint* const> joints;
};

/// The same for what is listed; contacts and nodes are always those of the whole world.
void Capture(const scree::World& world, const ScreeListing& listing, Snapshot& snapshot, const CaptureParts& parts);

[[nodiscard]] BodyState CaptureBody(const scree::Body& body, int index);

}  // namespace testbed
