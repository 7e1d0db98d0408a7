// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scree_scene.h.

#include "testbed/engines/scree_scene.h"

#include <cstdint>
#include <vector>

#include "testbed/engines/scree_shape.h"

namespace testbed {
namespace {

scree::BodyType MakeType(scenes::BodyType type) {
    switch (type) {
        case scenes::BodyType::isStatic:
            return scree::staticBody;
        case scenes::BodyType::kinematic:
            return scree::kinematicBody;
        case scenes::BodyType::dynamic:
            return scree::dynamicBody;
    }
    return scree::staticBody;
}

scree::BodyDef MakeBodyDef(const scenes::Body& body) {
    scree::BodyDef def;
    def.type = MakeType(body.type);
    def.bullet = body.bullet;
    def.allowSleep = body.allowSleep;
    def.awake = body.awake;
    def.fixedRotation = body.fixedRotation;
    def.position = ToScree(body.position);
    def.angle = body.angle;
    def.linearVelocity = ToScree(body.linearVelocity);
    def.angularVelocity = body.angularVelocity;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.gravityScale = body.gravityScale;
    return def;
}

scree::FixtureDef MakeFixtureDef(const scenes::Fixture& fixture, const scree::Shape& shape, size_t index) {
    scree::FixtureDef def;
    def.shape = &shape;
    def.density = fixture.density;
    def.friction = fixture.friction;
    def.restitution = fixture.restitution;
    def.isSensor = fixture.isSensor;
    const std::uint64_t mask = fixture.maskBits == 0xFFFF ? ~std::uint64_t{0} : fixture.maskBits;
    def.filter = {fixture.categoryBits, mask, fixture.groupIndex};
    def.userData.pointer = index;
    return def;
}

void CreateFixture(scree::Body& body, const scenes::Scene& scene, int sceneIndex, NewFixture note) {
    const auto index = static_cast<size_t>(sceneIndex);
    const scenes::Fixture& fixture = scene.fixtures[index];
    if (fixture.shape.type != scenes::ShapeType::chain) {
        const ScreeShape shape = MakeScreeShape(scene, fixture.shape);
        const scree::FixtureDef def = MakeFixtureDef(fixture, AsShape(shape), index);
        scree::Fixture* made = body.CreateFixture(&def);
        if (note != nullptr) note(made, sceneIndex, 0);
        return;
    }
    const scree::ChainShape chain = MakeScreeChain(scene, fixture.shape);
    const scree::FixtureDef def = MakeFixtureDef(fixture, chain, index);
    body.CreateFixture(&def);
    if (note == nullptr) return;
    // The list has the newest edge, the last one, first.
    std::vector<scree::Fixture*> edges(static_cast<size_t>(chain.GetChildCount()));
    scree::Fixture* edge = body.GetFixtureList();
    for (size_t left = edges.size(); left-- > 0; edge = edge->GetNext()) edges[left] = edge;
    for (size_t child = 0; child < edges.size(); ++child) note(edges[child], sceneIndex, static_cast<int>(child));
}

}  // namespace

scree::Body* CreateScreeBody(scree::World& world, const scenes::Scene& scene, int index, NewFixture note) {
    const scenes::Body& body = scene.bodies[static_cast<size_t>(index)];
    scree::BodyDef def = MakeBodyDef(body);
    def.userData.pointer = static_cast<size_t>(index);
    scree::Body* made = world.CreateBody(&def);
    if (made == nullptr) return nullptr;
    for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) {
        CreateFixture(*made, scene, i, note);
    }
    // A scene gives the velocity of the centre of mass, a body definition that of the origin; they differ in a spin.
    if (body.angularVelocity != 0.0f) made->SetLinearVelocity(ToScree(body.linearVelocity));
    return made;
}

void Conveyor::PreSolve(scree::Contact* contact, const scree::Manifold*) {
    contact->SetTangentSpeed(SpeedOf(contact->GetFixtureA()) + SpeedOf(contact->GetFixtureB()));
}

float Conveyor::SpeedOf(scree::Fixture* fixture) const {
    return m_scene.fixtures[fixture->GetUserData().pointer].tangentSpeed;
}

}  // namespace testbed
