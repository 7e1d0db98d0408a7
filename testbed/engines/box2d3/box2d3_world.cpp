// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d3_world.h.

#include "testbed/engines/box2d3/box2d3_world.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace testbed::box2d3 {
namespace {

b2BodyType MakeType(scenes::BodyType type) {
    switch (type) {
        case scenes::BodyType::kinematic:
            return b2_kinematicBody;
        case scenes::BodyType::dynamic:
            return b2_dynamicBody;
        default:
            return b2_staticBody;
    }
}

b2WorldDef MakeDef(const RunSpec& spec, float restitutionThreshold) {
    b2WorldDef def = b2DefaultWorldDef();
    def.restitutionThreshold = restitutionThreshold;
    def.gravity = ToB2(*spec.gravity);
    def.enableSleep = spec.sleeping;
    def.enableContinuous = spec.continuous;
    def.workerCount = spec.threads;
    def.contactHertz = spec.contactHertz.value_or(def.contactHertz);
    def.contactDampingRatio = spec.contactDamping.value_or(def.contactDampingRatio);
    def.contactSpeed = spec.pushSpeed.value_or(def.contactSpeed);
    return def;
}

/// Box2D 3 prints a line for each pair above its limit that it drops. In mild-n2 these are thousands a step, whose
/// printing would count as its time.
void TellOnce(const char* message) {
    static std::once_flag told;
    std::call_once(told, [message] {
        std::fprintf(stderr, "scree: box2d3 says: %s (what it says after that is not shown)\n", message);
    });
}

}  // namespace

World::World(const RunSpec& spec, float restitutionThreshold) {
    b2SetLogFcn(&TellOnce);
    const b2WorldDef def = MakeDef(spec, restitutionThreshold);
    m_id = b2CreateWorld(&def);
    b2World_EnableWarmStarting(m_id, spec.warmStarting);
}

void World::DestroyBody(int index) {
    b2DestroyBody(GetBody(index));
    m_bodies[static_cast<size_t>(index)] = b2_nullBodyId;
}

void World::RemakeBody(const scenes::Scene& scene, int index) {
    DestroyBody(index);
    const size_t proxies = m_proxies.size();
    AddBody(scene, scene.bodies[static_cast<size_t>(index)]);
    m_proxies.resize(proxies);
    m_bodies[static_cast<size_t>(index)] = m_bodies.back();
    m_bodies.pop_back();
    b2Body_SetUserData(m_bodies[static_cast<size_t>(index)], ToUserData(static_cast<size_t>(index)));
}

/// Chains and one-sided edges: a chain of Box2D 3, whose first and last points are the ghosts.
void World::CreateChain(const scenes::Scene& scene, b2BodyId body, const scenes::Fixture& fixture,
                        const b2ShapeDef& shapeDef) {
    std::vector<scenes::Vec2> points;
    const scenes::Shape& shape = fixture.shape;
    if (shape.type == scenes::ShapeType::edge) {
        points = {shape.vertices[2], shape.vertices[0], shape.vertices[1], shape.vertices[3]};
    } else {
        const auto vertices = scene.ChainVerticesOf(shape);
        if (!shape.IsLoop()) points.push_back(shape.vertices[0]);
        points.insert(points.end(), vertices.begin(), vertices.end());
        if (!shape.IsLoop()) points.push_back(shape.vertices[1]);
    }
    if (points.size() < 4) throw std::invalid_argument("box2d3 makes no loops of three edges");
    const auto list = std::make_unique<b2Vec2[]>(points.size());
    std::ranges::transform(points, list.get(), ToB2);
    b2ChainDef def = b2DefaultChainDef();
    def.points = list.get();
    def.count = static_cast<int>(points.size());
    def.materials = &shapeDef.material;
    def.materialCount = 1;
    def.filter = shapeDef.filter;
    def.isLoop = shape.IsLoop();
    const b2ChainId chain = b2CreateChain(body, &def);
    std::vector<b2ShapeId> segments(static_cast<size_t>(b2Chain_GetSegmentCount(chain)));
    b2Chain_GetSegments(chain, segments.data(), static_cast<int>(segments.size()));
    for (size_t i = 0; i < segments.size(); ++i) b2Shape_SetUserData(segments[i], ToUserData(m_proxies.size() + i));
}

void World::CreateFixture(const scenes::Scene& scene, b2BodyId body, int sceneIndex) {
    const scenes::Fixture& fixture = scene.fixtures[static_cast<size_t>(sceneIndex)];
    b2ShapeDef def = b2DefaultShapeDef();
    def.userData = ToUserData(m_proxies.size());
    def.material.friction = fixture.friction;
    def.material.restitution = fixture.restitution;
    def.material.tangentSpeed = fixture.tangentSpeed;
    def.density = fixture.density;
    def.isSensor = fixture.isSensor;
    def.filter.categoryBits = fixture.categoryBits;
    // The bits of 2.4 fill sixteen; a mask of all of them means everything.
    def.filter.maskBits = fixture.maskBits == 0xFFFF ? ~uint64_t{0} : uint64_t{fixture.maskBits};
    def.filter.groupIndex = fixture.groupIndex;
    if (fixture.shape.type == scenes::ShapeType::chain || fixture.shape.IsOneSidedEdge()) {
        CreateChain(scene, body, fixture, def);
    } else {
        struct Maker {
            b2BodyId body;
            const b2ShapeDef* def;
            void operator()(const b2Circle& s) const { b2CreateCircleShape(body, def, &s); }
            void operator()(const b2Capsule& s) const { b2CreateCapsuleShape(body, def, &s); }
            void operator()(const b2Polygon& s) const { b2CreatePolygonShape(body, def, &s); }
            void operator()(const b2Segment& s) const { b2CreateSegmentShape(body, def, &s); }
        };
        std::visit(Maker{body, &def}, MakeShape(scene, fixture.shape));
    }
    for (int child = 0; child < fixture.shape.ChildCount(); ++child) {
        m_proxies.push_back({static_cast<int>(m_bodies.size()) - 1, sceneIndex, child, fixture.isSensor,
                             MakeShape(scene, scenes::ChildOf(scene, fixture.shape, child))});
    }
}

void World::AddBody(const scenes::Scene& scene, const scenes::Body& body, double placeX, double placeY) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = MakeType(body.type);
    def.position = b2ToPos(ToB2(body.position));
    using Coordinate = decltype(def.position.x);
    def.position.x = static_cast<Coordinate>(placeX + double{def.position.x});
    def.position.y = static_cast<Coordinate>(placeY + double{def.position.y});
    def.rotation = b2MakeRot(body.angle);
    def.linearVelocity = ToB2(body.linearVelocity);
    def.angularVelocity = body.angularVelocity;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.gravityScale = body.gravityScale;
    def.enableSleep = body.allowSleep;
    def.isAwake = body.awake;
    def.isBullet = body.bullet;
    def.motionLocks.angularZ = body.fixedRotation;
    def.userData = ToUserData(m_bodies.size());
    const b2BodyId made = b2CreateBody(m_id, &def);
    m_bodies.push_back(made);
    for (int i = body.firstFixture; i < body.firstFixture + body.fixtureCount; ++i) CreateFixture(scene, made, i);
    // A scene gives the velocity of the centre of mass.
    if (body.angularVelocity != 0.0f) b2Body_SetLinearVelocity(made, ToB2(body.linearVelocity));
}

BodyState CaptureBody(const World& world, const scenes::Scene& scene, int index) {
    const b2BodyId body = world.GetBody(index);
    const b2WorldTransform pose = b2Body_GetTransform(body);
    const scenes::Body& made = scene.bodies[static_cast<size_t>(index)];
    return {.index = index,
            .type = made.type,
            .position = {static_cast<float>(pose.p.x), static_cast<float>(pose.p.y)},
            .sin = pose.q.s,
            .cos = pose.q.c,
            .angle = b2Rot_GetAngle(pose.q),
            .linearVelocity = FromB2(b2Body_GetLinearVelocity(body)),
            .angularVelocity = b2Body_GetAngularVelocity(body),
            .awake = made.type != scenes::BodyType::isStatic && b2Body_IsAwake(body),
            .bullet = made.bullet};
}

}  // namespace testbed::box2d3
