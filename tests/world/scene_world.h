// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene of the catalogue as a bare world of the engine, every body there from the start: for tests of what the
// engine does to any world.

#pragma once

#include <memory>

#include "scenes/catalog.h"
#include "scree/scree.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_shape.h"

namespace scree::test {

/// A size of a scene at which many steps take little time.
inline int SmallSize(const scenes::SceneInfo& info) {
    if (!info.hasSize) return info.defaultSize;
    const int small = info.sweep ? info.sweep->begin : info.minSize;
    return std::min(std::max(small, std::min(info.defaultSize, 20)), info.maxSize);
}

inline void AddFixtures(Body& body, const scenes::Scene& scene, int index) {
    for (const scenes::Fixture& fixture : scene.FixturesOf(index)) {
        FixtureDef def;
        def.density = fixture.density;
        def.friction = fixture.friction;
        def.restitution = fixture.restitution;
        def.isSensor = fixture.isSensor;
        const uint64_t mask = fixture.maskBits == 0xFFFF ? ~uint64_t{0} : fixture.maskBits;
        def.filter = {fixture.categoryBits, mask, fixture.groupIndex};
        if (fixture.shape.type == scenes::ShapeType::chain) {
            const ChainShape chain = testbed::MakeScreeChain(scene, fixture.shape);
            def.shape = &chain;
            body.CreateFixture(&def);
        } else {
            const testbed::ScreeShape shape = testbed::MakeScreeShape(scene, fixture.shape);
            def.shape = &testbed::AsShape(shape);
            body.CreateFixture(&def);
        }
    }
}

/// Puts the scene's bodies and joints into an empty world.
inline void LoadScene(World& world, const scenes::Scene& scene) {
    testbed::ScreeBodies bodies;
    for (const scenes::Body& body : scene.bodies) {
        BodyDef def;
        def.type = body.type == scenes::BodyType::isStatic    ? staticBody
                   : body.type == scenes::BodyType::kinematic ? kinematicBody
                                                              : dynamicBody;
        def.bullet = body.bullet;
        def.allowSleep = body.allowSleep;
        def.awake = body.awake;
        def.fixedRotation = body.fixedRotation;
        def.position = testbed::ToScree(body.position);
        def.angle = body.angle;
        def.linearVelocity = testbed::ToScree(body.linearVelocity);
        def.angularVelocity = body.angularVelocity;
        def.gravityScale = body.gravityScale;
        bodies.push_back(world.CreateBody(&def));
        AddFixtures(*bodies.back(), scene, static_cast<int>(bodies.size()) - 1);
    }
    testbed::ScreeJoints joints;
    for (const scenes::Joint& joint : scene.joints) {
        joints.push_back(testbed::CreateScreeJoint(world, joint, bodies, joints));
    }
}

inline WorldDef DefOf(const scenes::Scene& scene, BroadPhaseKind kind) {
    WorldDef def;
    def.gravity = testbed::ToScree(scene.gravity);
    def.broadPhase = kind;
    return def;
}

inline void StepScene(World& world, const scenes::Scene& scene) {
    world.Step(scene.timeStep, scene.velocityIterations, scene.positionIterations);
}

}  // namespace scree::test
