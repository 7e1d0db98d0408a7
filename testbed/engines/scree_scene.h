// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene's bodies with their fixtures as those of ours, and the surfaces that move what touches them. Needs nothing
// but the engine and the scenes, so that the check of other platforms shares it (tests/platforms).

#pragma once

#include "scenes/scene.h"
#include "scree/function_ref.h"
#include "scree/world.h"
#include "scree/world_callbacks.h"

namespace testbed {

/// Called for each new fixture: its index in the scene, and which edge of a chain it is (else 0).
using NewFixture = scree::FunctionRef<void(scree::Fixture*, int sceneIndex, int child)>;

/// One of the scene's bodies with its fixtures; user data are the indices in the scene. Null if the world refuses it.
/// Throws std::invalid_argument for a degenerate shape.
scree::Body* CreateScreeBody(scree::World& world, const scenes::Scene& scene, int index, NewFixture note = nullptr);

/// The tangent speed of a contact is that of both surfaces together: it does not depend on which of them is A. The
/// scene must outlive it.
class Conveyor final : public scree::ContactListener {
public:
    explicit Conveyor(const scenes::Scene& scene) : m_scene(scene) {}
    void PreSolve(scree::Contact* contact, const scree::Manifold*) override;

private:
    [[nodiscard]] float SpeedOf(scree::Fixture* fixture) const;
    const scenes::Scene& m_scene;
};

}  // namespace testbed
