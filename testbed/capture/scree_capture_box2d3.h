// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Records worlds of Box2D 3 (3.2 or newer, C++11) by its C interface, for the program `scree` to look at elsewhere:
//
//   scree_capture::Track track(worldId, "session.track");    // once
//   b2World_Step(worldId, dt, 4); track.Step(dt);            // after every step
//   scree_capture::WriteScene(worldId, "level.scene.json");  // one moment
//
// Box2D 3 has no list of bodies: they are found by a query of everything, by their joints and as they move. A body that
// has neither a shape nor a joint and never moved is not in the track, nor is one that was disabled before. Scenes hold
// 16 bits of a filter, springs of distance, wheel and weld joints and drives; filter joints and the other springs are
// left out.

#pragma once

#include <box2d/box2d.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scree_capture_track.h"

namespace scree_capture {
inline namespace box2d3_engine {

// What the recorder walks through: objects with the names of Box2D 2.4, which ask Box2D 3.

struct Point {
    float x, y;
    void Set(float newX, float newY) {
        x = newX;
        y = newY;
    }
};
inline Point ToPoint(b2Vec2 v) {
    const Point point = {v.x, v.y};
    return point;
}
#ifdef BOX2D_DOUBLE_PRECISION
inline Point ToPoint(b2Pos p) {
    const Point point = {static_cast<float>(p.x), static_cast<float>(p.y)};
    return point;
}
#endif

struct Filter {
    std::uint16_t categoryBits, maskBits;
    std::int16_t groupIndex;
};

class Body;

class Fixture {
public:
    Fixture(b2ShapeId id, const Fixture* next) : m_id(id), m_next(next) {}

    b2ShapeId GetId() const { return m_id; }
    const Fixture* GetNext() const { return m_next; }
    float GetDensity() const { return b2Shape_GetDensity(m_id); }
    float GetFriction() const { return b2Shape_GetFriction(m_id); }
    float GetRestitution() const { return b2Shape_GetRestitution(m_id); }
    bool IsSensor() const { return b2Shape_IsSensor(m_id); }
    Filter GetFilterData() const {
        const b2Filter filter = b2Shape_GetFilter(m_id);
        const Filter data = {static_cast<std::uint16_t>(filter.categoryBits),
                             static_cast<std::uint16_t>(filter.maskBits), static_cast<std::int16_t>(filter.groupIndex)};
        return data;
    }

private:
    b2ShapeId m_id;
    const Fixture* m_next;
};

class Body {
public:
    explicit Body(b2BodyId id) : m_id(id), m_angle(TurnOf(id)) { ListShapes(); }

    b2BodyId GetId() const { return m_id; }
    bool IsThere() const { return b2Body_IsValid(m_id); }
    Body* GetNext() const { return m_next; }
    void SetNext(Body* next) { m_next = next; }
    int GetType() const { return static_cast<int>(b2Body_GetType(m_id)); }
    bool IsBullet() const { return b2Body_IsBullet(m_id); }
    bool IsSleepingAllowed() const { return b2Body_IsSleepEnabled(m_id); }
    bool IsAwake() const { return b2Body_IsAwake(m_id); }
    bool IsFixedRotation() const { return b2Body_GetMotionLocks(m_id).angularZ; }
    Point GetPosition() const { return ToPoint(b2Body_GetPosition(m_id)); }
    /// Not wrapped: it goes on from step to step.
    float GetAngle() const { return m_angle; }
    Point GetLinearVelocity() const { return ToPoint(b2Body_GetLinearVelocity(m_id)); }
    float GetAngularVelocity() const { return b2Body_GetAngularVelocity(m_id); }
    float GetLinearDamping() const { return b2Body_GetLinearDamping(m_id); }
    float GetAngularDamping() const { return b2Body_GetAngularDamping(m_id); }
    float GetGravityScale() const { return b2Body_GetGravityScale(m_id); }
    const void* GetUserData() const { return b2Body_GetUserData(m_id); }
    const Fixture* GetFixtureList() const { return m_fixtures.empty() ? nullptr : &m_fixtures.front(); }

    /// Adds what it turned since the last call, within half a turn.
    void FollowAngle() {
        const float turn = TurnOf(m_id);
        m_angle += std::remainder(turn - m_angle, 6.2831853f);
    }
    /// The newest first, as Box2D 2.4 lists them.
    void ListShapes() {
        std::vector<b2ShapeId> ids(static_cast<std::size_t>(b2Body_GetShapeCount(m_id)));
        ids.resize(static_cast<std::size_t>(b2Body_GetShapes(m_id, ids.data(), static_cast<int>(ids.size()))));
        bool isSame = ids.size() == m_fixtures.size();
        for (std::size_t i = 0; i < ids.size() && isSame; ++i) isSame = B2_ID_EQUALS(ids[i], m_fixtures[i].GetId());
        if (isSame) return;
        m_fixtures.clear();
        m_fixtures.reserve(ids.size());
        for (std::size_t i = 0; i < ids.size(); ++i) {
            m_fixtures.push_back(Fixture(ids[i], nullptr));
            if (i > 0) m_fixtures[i - 1] = Fixture(ids[i - 1], &m_fixtures[i]);
        }
        ++m_edition;
    }
    /// Changes with the shapes.
    std::uint64_t GetEdition() const { return m_edition; }
    const std::vector<Fixture>& GetFixtures() const { return m_fixtures; }

private:
    static float TurnOf(b2BodyId id) {
        const b2Rot q = b2Body_GetRotation(id);
        return std::atan2(q.s, q.c);
    }

    b2BodyId m_id;
    Body* m_next = nullptr;
    float m_angle;
    std::vector<Fixture> m_fixtures;
    std::uint64_t m_edition = 0;
};

class Joint {
public:
    Joint(b2JointId id, Body* a, Body* b) : m_id(id), m_a(a), m_b(b) {}

    b2JointId GetId() const { return m_id; }
    Joint* GetNext() const { return m_next; }
    void SetNext(Joint* next) { m_next = next; }
    Body* GetBodyA() const { return m_a; }
    Body* GetBodyB() const { return m_b; }
    bool GetCollideConnected() const { return b2Joint_GetCollideConnected(m_id); }

private:
    b2JointId m_id;
    Body *m_a, *m_b;
    Joint* m_next = nullptr;
};

struct WorldPoints {
    Point normal;
    Point points[2];
    float separations[2];
};

class Contact {
public:
    Contact(const b2ContactData& data, const Fixture* a, const Fixture* b) : m_data(data), m_a(a), m_b(b) {}

    Contact* GetNext() const { return m_next; }
    void SetNext(Contact* next) { m_next = next; }
    bool IsTouching() const { return true; }
    const Fixture* GetFixtureA() const { return m_a; }
    const Fixture* GetFixtureB() const { return m_b; }
    const b2Manifold& GetManifold() const { return m_data.manifold; }
    void GetWorldManifold(WorldPoints* world) const {
        const Point center = ToPoint(b2Body_GetWorldCenter(b2Shape_GetBody(m_data.shapeIdA)));
        world->normal = ToPoint(m_data.manifold.normal);
        for (int i = 0; i < m_data.manifold.pointCount; ++i) {
            const b2ManifoldPoint& point = m_data.manifold.points[i];
            world->points[i].Set(center.x + point.anchorA.x, center.y + point.anchorA.y);
            world->separations[i] = point.separation;
        }
    }

private:
    b2ContactData m_data;
    const Fixture *m_a, *m_b;
    Contact* m_next = nullptr;
};

/// A world of Box2D 3 as lists that are kept up from step to step.
class World {
public:
    World(b2WorldId id, bool readsContacts) : m_id(id), m_readsContacts(readsContacts) { Refresh(true); }

    Body* GetBodyList() const { return m_bodies.empty() ? nullptr : m_bodies.front().get(); }
    Joint* GetJointList() const { return m_joints.empty() ? nullptr : m_joints.front().get(); }
    Contact* GetContactList() { return m_contacts.empty() ? nullptr : &m_contacts.front(); }
    int GetContactCount() const { return b2World_GetCounters(m_id).contactCount; }
    Point GetGravity() const { return ToPoint(b2World_GetGravity(m_id)); }
    b2WorldId GetId() const { return m_id; }
    std::uint64_t CountObjects() const {
        const b2Counters counters = b2World_GetCounters(m_id);
        return (static_cast<std::uint64_t>(counters.bodyCount) << 42) ^
               (static_cast<std::uint64_t>(counters.shapeCount) << 21) ^
               static_cast<std::uint64_t>(counters.jointCount);
    }
    const Body* Find(b2BodyId id) const {
        const std::unordered_map<std::uint64_t, Body*>::const_iterator found = m_known.find(b2StoreBodyId(id));
        return found == m_known.end() ? nullptr : found->second;
    }

    /// After every step: what came and went, and how far bodies turned. `looksAtAll` without waiting for a count to
    /// change.
    void Refresh(bool looksAtAll) {
        const std::uint64_t count = CountObjects();
        bool isNew = looksAtAll || count != m_count;
        for (std::size_t i = 0; i < m_bodies.size() && !isNew; ++i) isNew = !m_bodies[i]->IsThere();
        const b2BodyEvents events = b2World_GetBodyEvents(m_id);
        for (int i = 0; i < events.moveCount && !isNew; ++i) isNew = Find(events.moveEvents[i].bodyId) == nullptr;
        if (isNew) ListAll(events);
        m_count = count;
        for (std::size_t i = 0; i < m_bodies.size(); ++i) m_bodies[i]->FollowAngle();
        if (m_readsContacts) ListContacts();
    }

private:
    static bool Take(b2ShapeId shape, void* context) {
        static_cast<std::vector<b2BodyId>*>(context)->push_back(b2Shape_GetBody(shape));
        return true;
    }

    /// The newest first. A body keeps its object for as long as it is there.
    void ListAll(const b2BodyEvents& events) {
        std::vector<b2BodyId> found;
        b2AABB everything;
        everything.lowerBound.x = everything.lowerBound.y = -1e9f;
        everything.upperBound.x = everything.upperBound.y = 1e9f;
        b2QueryFilter filter = b2DefaultQueryFilter();
        filter.categoryBits = filter.maskBits = ~std::uint64_t(0);
        (void)b2World_OverlapAABB(m_id, b2Pos_zero, everything, filter, &Take, &found);
        for (int i = 0; i < events.moveCount; ++i) found.push_back(events.moveEvents[i].bodyId);

        std::vector<std::unique_ptr<Body>> lasting;
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            if (m_bodies[i]->IsThere()) {
                lasting.push_back(std::move(m_bodies[i]));
            } else {
                m_known.erase(b2StoreBodyId(m_bodies[i]->GetId()));
            }
        }
        m_bodies.swap(lasting);
        AddNew(found);
        // A joint leads to bodies that no query finds.
        for (std::size_t begin = 0; begin < found.size();) {
            std::vector<b2BodyId> further;
            for (; begin < found.size(); ++begin) AddNeighbours(found[begin], further);
            AddNew(further);
            found.insert(found.end(), further.begin(), further.end());
        }
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            m_bodies[i]->ListShapes();
            m_bodies[i]->SetNext(i + 1 < m_bodies.size() ? m_bodies[i + 1].get() : nullptr);
        }
        MapShapes();
        ListJoints();
    }

    void AddNew(std::vector<b2BodyId>& found) {
        std::vector<b2BodyId> fresh;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const std::uint64_t key = b2StoreBodyId(found[i]);
            if (!b2Body_IsValid(found[i]) || m_known.count(key) != 0) continue;
            m_known[key] = nullptr;
            fresh.push_back(found[i]);
        }
        // Slots are given by growing number until one is free again.
        std::sort(fresh.begin(), fresh.end(), [](b2BodyId a, b2BodyId b) { return a.index1 > b.index1; });
        std::vector<std::unique_ptr<Body>> bodies;
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            bodies.push_back(std::unique_ptr<Body>(new Body(fresh[i])));
            m_known[b2StoreBodyId(fresh[i])] = bodies.back().get();
        }
        for (std::size_t i = 0; i < m_bodies.size(); ++i) bodies.push_back(std::move(m_bodies[i]));
        m_bodies.swap(bodies);
        found = fresh;
    }

    static std::vector<b2JointId> JointsOf(b2BodyId body) {
        std::vector<b2JointId> joints(static_cast<std::size_t>(b2Body_GetJointCount(body)));
        joints.resize(static_cast<std::size_t>(b2Body_GetJoints(body, joints.data(), static_cast<int>(joints.size()))));
        return joints;
    }
    static void AddNeighbours(b2BodyId body, std::vector<b2BodyId>& further) {
        const std::vector<b2JointId> joints = JointsOf(body);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            further.push_back(b2Joint_GetBodyA(joints[i]));
            further.push_back(b2Joint_GetBodyB(joints[i]));
        }
    }

    /// A scene can hold it.
    static bool IsShown(b2JointId joint) {
        switch (b2Joint_GetType(joint)) {
            case b2_distanceJoint:
            case b2_motorJoint:
            case b2_prismaticJoint:
            case b2_revoluteJoint:
            case b2_weldJoint:
            case b2_wheelJoint:
                return true;
            default:
                return false;
        }
    }
    /// The newest first. A joint keeps its object for as long as it is there.
    void ListJoints() {
        std::vector<std::unique_ptr<Joint>> lasting;
        std::unordered_map<std::uint64_t, bool> known;
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            if (!b2Joint_IsValid(m_joints[i]->GetId())) continue;
            known[b2StoreJointId(m_joints[i]->GetId())] = true;
            lasting.push_back(std::move(m_joints[i]));
        }
        std::vector<b2JointId> fresh;
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const std::vector<b2JointId> joints = JointsOf(m_bodies[i]->GetId());
            for (std::size_t k = 0; k < joints.size(); ++k) {
                if (!IsShown(joints[k]) || !known.insert(std::make_pair(b2StoreJointId(joints[k]), true)).second)
                    continue;
                fresh.push_back(joints[k]);
            }
        }
        std::sort(fresh.begin(), fresh.end(), [](b2JointId a, b2JointId b) { return a.index1 > b.index1; });
        m_joints.clear();
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            m_joints.push_back(
                std::unique_ptr<Joint>(new Joint(fresh[i], m_known.at(b2StoreBodyId(b2Joint_GetBodyA(fresh[i]))),
                                                 m_known.at(b2StoreBodyId(b2Joint_GetBodyB(fresh[i]))))));
        }
        for (std::size_t i = 0; i < lasting.size(); ++i) m_joints.push_back(std::move(lasting[i]));
        for (std::size_t i = 0; i < m_joints.size(); ++i) {
            m_joints[i]->SetNext(i + 1 < m_joints.size() ? m_joints[i + 1].get() : nullptr);
        }
    }

    void MapShapes() {
        m_shapes.clear();
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const std::vector<Fixture>& fixtures = m_bodies[i]->GetFixtures();
            for (std::size_t k = 0; k < fixtures.size(); ++k)
                m_shapes[b2StoreShapeId(fixtures[k].GetId())] = &fixtures[k];
        }
    }

    /// Each is told by both bodies: that of shape A counts, or B where A is static and tells none.
    void ListContacts() {
        m_contacts.clear();
        std::vector<b2ContactData> data;
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const b2BodyId body = m_bodies[i]->GetId();
            if (b2Body_GetType(body) == b2_staticBody) continue;
            data.resize(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
            const int count = b2Body_GetContactData(body, data.data(), static_cast<int>(data.size()));
            for (int k = 0; k < count; ++k) {
                const b2ContactData& one = data[static_cast<std::size_t>(k)];
                const b2BodyId a = b2Shape_GetBody(one.shapeIdA);
                if (!B2_ID_EQUALS(a, body) && b2Body_GetType(a) != b2_staticBody) continue;
                const std::unordered_map<std::uint64_t, const Fixture*>::const_iterator
                    fixtureA = m_shapes.find(b2StoreShapeId(one.shapeIdA)),
                    fixtureB = m_shapes.find(b2StoreShapeId(one.shapeIdB));
                if (fixtureA == m_shapes.end() || fixtureB == m_shapes.end()) continue;
                m_contacts.push_back(Contact(one, fixtureA->second, fixtureB->second));
            }
        }
        for (std::size_t i = 0; i + 1 < m_contacts.size(); ++i) m_contacts[i].SetNext(&m_contacts[i + 1]);
    }

    b2WorldId m_id;
    bool m_readsContacts;
    std::uint64_t m_count = 0;
    std::vector<std::unique_ptr<Body>> m_bodies;
    std::unordered_map<std::uint64_t, Body*> m_known;
    std::unordered_map<std::uint64_t, const Fixture*> m_shapes;
    std::vector<std::unique_ptr<Joint>> m_joints;
    std::vector<Contact> m_contacts;
};

/// What the recorder asks of Box2D 3.
struct Api {
    typedef box2d3_engine::World World;
    typedef box2d3_engine::Body Body;
    typedef box2d3_engine::Fixture Fixture;
    typedef box2d3_engine::Joint Joint;
    typedef box2d3_engine::Contact Contact;
    typedef b2Manifold Manifold;
    typedef WorldPoints WorldManifold;
    typedef Point Vec2;
    typedef std::unordered_map<const Fixture*, detail::Place> Places;
    typedef detail::ListReader<Api> Reader;

    static const char* Writer() { return "scree_capture_box2d3.h"; }
    static std::string Engine() {
        const b2Version version = b2GetVersion();
        return "Box2D " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
               std::to_string(version.revision);
    }
    static int TypeOf(const Body& body) { return body.GetType(); }
    static float TangentSpeedOf(const Fixture&) { return 0.0f; }

    static std::uint64_t QuickIdentityOf(const World& world, const Body& body) { return IdentityOf(world, body); }
    static std::uint64_t IdentityOf(const World&, const Body& body) {
        return body.GetEdition() * 4 + static_cast<std::uint64_t>(body.GetType());
    }
    static std::uint64_t IdentityOf(const World&, const Joint&) { return 0; }  // an object is one joint's for life
    static std::uint64_t CountObjects(const World& world) { return world.CountObjects(); }

    static void ReadState(const Body& body, detail::State& state) {
        const Point position = body.GetPosition(), velocity = body.GetLinearVelocity();
        state.Set(position, body.GetAngle(), velocity, body.GetAngularVelocity());
        state.awake = body.GetType() != 0 && body.IsAwake();
    }

    /// The list has the newest first.
    static void SortByAge(std::vector<Body*>& bodies) { std::reverse(bodies.begin(), bodies.end()); }
    static bool GoOn(const Fixture&, const Fixture&) { return false; }

    template <typename Scene>
    static void WriteShape(Scene& scene, const std::vector<const Fixture*>& group) {
        const b2ShapeId id = group.front()->GetId();
        switch (b2Shape_GetType(id)) {
            case b2_circleShape: {
                const b2Circle circle = b2Shape_GetCircle(id);
                scene.Text("type", "circle");
                scene.Always("radius", circle.radius);
                scene.Vector("center", ToPoint(circle.center), 0.0f, 0.0f);
                break;
            }
            case b2_capsuleShape: {
                const b2Capsule capsule = b2Shape_GetCapsule(id);
                const Point ends[] = {ToPoint(capsule.center1), ToPoint(capsule.center2)};
                scene.Text("type", "capsule");
                scene.Points("vertices", ends, 2);
                scene.Always("radius", capsule.radius);
                break;
            }
            case b2_polygonShape:
                WritePolygon(scene, b2Shape_GetPolygon(id));
                break;
            case b2_chainSegmentShape: {
                const b2ChainSegment chain = b2Shape_GetChainSegment(id);
                const Point ends[] = {ToPoint(chain.segment.point1), ToPoint(chain.segment.point2),
                                      ToPoint(chain.ghost1), ToPoint(chain.ghost2)};
                scene.Text("type", "edge");
                scene.Points("vertices", ends, 4);
                break;
            }
            default: {
                const b2Segment segment = b2Shape_GetSegment(id);
                const Point ends[] = {ToPoint(segment.point1), ToPoint(segment.point2)};
                scene.Text("type", "edge");
                scene.Points("vertices", ends, 2);
                break;
            }
        }
    }

    static const char* NameOf(const Joint& joint) {
        switch (b2Joint_GetType(joint.GetId())) {
            case b2_revoluteJoint:
                return "revolute";
            case b2_prismaticJoint:
                return "prismatic";
            case b2_weldJoint:
                return "weld";
            case b2_wheelJoint:
                return "wheel";
            case b2_motorJoint:
                return IsMouse(joint.GetId()) ? "mouse" : "friction";
            default:
                return "distance";
        }
    }

    template <typename Scene>
    static void WriteJoint(Scene& scene, Joint& joint, const detail::Numbers&) {
        const b2JointId id = joint.GetId();
        const b2Transform frameA = b2Joint_GetLocalFrameA(id), frameB = b2Joint_GetLocalFrameB(id);
        const b2JointType type = b2Joint_GetType(id);
        if (type == b2_motorJoint && IsMouse(id)) {
            WriteMouse(scene, joint, frameA.p, frameB.p);
            return;
        }
        scene.Vector("localAnchorA", ToPoint(frameA.p), 0.0f, 0.0f);
        scene.Vector("localAnchorB", ToPoint(frameB.p), 0.0f, 0.0f);
        if (type == b2_revoluteJoint || type == b2_prismaticJoint || type == b2_weldJoint) {
            scene.Number("referenceAngle", std::atan2(frameA.q.s, frameA.q.c) - std::atan2(frameB.q.s, frameB.q.c),
                         0.0f);
        }
        const Point axis = {frameA.q.c, frameA.q.s};
        switch (type) {
            case b2_revoluteJoint:
                WriteLimits(scene, b2RevoluteJoint_IsLimitEnabled(id), "lowerAngle", b2RevoluteJoint_GetLowerLimit(id),
                            "upperAngle", b2RevoluteJoint_GetUpperLimit(id));
                WriteMotor(scene, b2RevoluteJoint_IsMotorEnabled(id), b2RevoluteJoint_GetMotorSpeed(id));
                scene.Number("maxMotorTorque", b2RevoluteJoint_GetMaxMotorTorque(id), 0.0f);
                break;
            case b2_prismaticJoint:
                scene.Vector("localAxisA", axis, 1.0f, 0.0f);
                WriteLimits(scene, b2PrismaticJoint_IsLimitEnabled(id), "lowerTranslation",
                            b2PrismaticJoint_GetLowerLimit(id), "upperTranslation", b2PrismaticJoint_GetUpperLimit(id));
                WriteMotor(scene, b2PrismaticJoint_IsMotorEnabled(id), b2PrismaticJoint_GetMotorSpeed(id));
                scene.Number("maxMotorForce", b2PrismaticJoint_GetMaxMotorForce(id), 0.0f);
                break;
            case b2_wheelJoint:
                scene.Vector("localAxisA", axis, 1.0f, 0.0f);
                WriteLimits(scene, b2WheelJoint_IsLimitEnabled(id), "lowerTranslation", b2WheelJoint_GetLowerLimit(id),
                            "upperTranslation", b2WheelJoint_GetUpperLimit(id));
                WriteMotor(scene, b2WheelJoint_IsMotorEnabled(id), b2WheelJoint_GetMotorSpeed(id));
                scene.Number("maxMotorTorque", b2WheelJoint_GetMaxMotorTorque(id), 0.0f);
                if (b2WheelJoint_IsSpringEnabled(id)) {
                    WriteSpring(scene, b2WheelJoint_GetSpringHertz(id), b2WheelJoint_GetSpringDampingRatio(id),
                                MassOf(id));
                }
                break;
            case b2_weldJoint:
                WriteSpring(scene, b2WeldJoint_GetAngularHertz(id), b2WeldJoint_GetAngularDampingRatio(id),
                            InertiaOf(id));
                break;
            case b2_motorJoint:
                scene.Number("maxForce", b2MotorJoint_GetMaxVelocityForce(id), 0.0f);
                scene.Number("maxTorque", b2MotorJoint_GetMaxVelocityTorque(id), 0.0f);
                break;
            default:
                WriteDistance(scene, id);
                break;
        }
    }

    typedef std::pair<const Fixture*, const Fixture*> ContactSides;
    static ContactSides SidesOf(const Contact& contact) {
        return ContactSides(contact.GetFixtureA(), contact.GetFixtureB());
    }
    static std::pair<detail::Place, detail::Place> PlacesOf(const ContactSides& sides, const Places& places) {
        return std::make_pair(places.at(sides.first), places.at(sides.second));
    }
    static const Manifold& ManifoldOf(const Contact& contact) { return contact.GetManifold(); }

    static void WriteNodes(const World&, const Places&, detail::Bytes&) {}  // its trees are not in the interface

    static void WriteStages(const World& world, detail::CborWriter& out) {
        const b2Profile profile = b2World_GetProfile(world.GetId());
        const std::pair<const char*, float> stages[] = {
            {"step", profile.step},        {"broadphase", profile.pairs + profile.refit},
            {"collide", profile.collide},  {"solve", profile.solve},
            {"solveTOI", profile.bullets}, {"sensors", profile.sensors}};
        for (const std::pair<const char*, float>& stage : stages) {
            out.Key(stage.first);
            out.Value(stage.second);
        }
    }

private:
    /// A spring without a drive.
    static bool IsMouse(b2JointId id) {
        return b2MotorJoint_GetLinearHertz(id) > 0.0f && !(b2MotorJoint_GetMaxVelocityForce(id) > 0.0f);
    }
    static float Together(float a, float b) { return a > 0.0f && b > 0.0f ? a * b / (a + b) : (a > 0.0f ? a : b); }
    static float MassOf(b2JointId id) {
        return Together(b2Body_GetMass(b2Joint_GetBodyA(id)), b2Body_GetMass(b2Joint_GetBodyB(id)));
    }
    static float InertiaOf(b2JointId id) {
        return Together(b2Body_GetRotationalInertia(b2Joint_GetBodyA(id)),
                        b2Body_GetRotationalInertia(b2Joint_GetBodyB(id)));
    }
    /// The spring on which `inertia` oscillates at `hertz`.
    template <typename Scene>
    static void WriteSpring(Scene& scene, float hertz, float dampingRatio, float inertia) {
        const float omega = 6.2831853f * hertz;
        scene.Number("stiffness", inertia * omega * omega, 0.0f);
        scene.Number("damping", 2.0f * inertia * dampingRatio * omega, 0.0f);
    }
    template <typename Scene>
    static void WriteLimits(Scene& scene, bool isOn, const char* lower, float least, const char* upper, float most) {
        scene.Flag("enableLimit", isOn, false);
        scene.Number(lower, least, 0.0f);
        scene.Number(upper, most, 0.0f);
    }
    template <typename Scene>
    static void WriteMotor(Scene& scene, bool isOn, float speed) {
        scene.Flag("enableMotor", isOn, false);
        scene.Number("motorSpeed", speed, 0.0f);
    }
    template <typename Scene>
    static void WriteMouse(Scene& scene, const Joint& joint, b2Vec2 anchorA, b2Vec2 anchorB) {
        const b2JointId id = joint.GetId();
        scene.Vector("localAnchorB", ToPoint(anchorB), 0.0f, 0.0f);
        scene.Vector("target", ToPoint(b2Body_GetWorldPoint(joint.GetBodyA()->GetId(), anchorA)), 0.0f, 0.0f);
        scene.Number("maxForce", b2MotorJoint_GetMaxSpringForce(id), 0.0f);
        WriteSpring(scene, b2MotorJoint_GetLinearHertz(id), b2MotorJoint_GetLinearDampingRatio(id),
                    b2Body_GetMass(joint.GetBodyB()->GetId()));
    }
    template <typename Scene>
    static void WriteDistance(Scene& scene, b2JointId id) {
        const float length = b2DistanceJoint_GetLength(id);
        const bool isSpring = b2DistanceJoint_IsSpringEnabled(id), hasLimit = b2DistanceJoint_IsLimitEnabled(id);
        if (isSpring) {
            detail::WriteLengths(scene, length, hasLimit ? b2DistanceJoint_GetMinLength(id) : 0.0f,
                                 hasLimit ? b2DistanceJoint_GetMaxLength(id) : FLT_MAX);
            WriteSpring(scene, b2DistanceJoint_GetSpringHertz(id), b2DistanceJoint_GetSpringDampingRatio(id),
                        MassOf(id));
        } else {
            detail::WriteLengths(scene, length, length, length);
        }
    }
    template <typename Scene>
    static void WritePolygon(Scene& scene, const b2Polygon& polygon) {
        Point vertices[B2_MAX_POLYGON_VERTICES];
        for (int i = 0; i < polygon.count; ++i) vertices[i] = ToPoint(polygon.vertices[i]);
        scene.Text("type", polygon.radius > 0.0f ? "roundedPolygon" : "polygon");
        scene.Points("vertices", vertices, polygon.count);
        scene.Number("radius", polygon.radius, 0.0f);
    }
};

/// Records a world; the same calls as with Box2D 2.4, bodies by their ids.
class Track {
public:
    Track(b2WorldId world, const std::string& path, const Options& options = Options())
        : m_world(world, options.contacts), m_track(m_world, path, options) {}

    void Step(float dt) {
        m_world.Refresh(m_mustLook);
        m_mustLook = false;
        m_track.Step(dt);
    }
    void Name(b2BodyId body, const std::string& name) {
        m_world.Refresh(m_world.Find(body) == nullptr);
        m_track.Name(m_world.Find(body), name);
    }
    void Mark(const std::string& text) { m_track.Mark(text); }
    void KeepLast(double seconds) { m_track.KeepLast(seconds); }
    bool Save() { return m_track.Save(); }
    bool Save(const std::string& path) { return m_track.Save(path); }
    /// All objects are looked at anew in the next step: after a shape was replaced by another.
    void Refresh() {
        m_mustLook = true;
        m_track.Refresh();
    }
    void Flush() { m_track.Flush(); }
    void Close() { m_track.Close(); }
    std::string GetError() { return m_track.GetError(); }
    int GetSkippedSteps() const { return m_track.GetSkippedSteps(); }

private:
    World m_world;
    detail::BasicTrack<Api> m_track;
    bool m_mustLook = false;
};

/// Writes a world as a scene file; false if it cannot be written.
inline bool WriteScene(b2WorldId world, const std::string& path, const Options& options = Options()) {
    World lists(world, false);
    return detail::WriteSceneFile<Api>(lists, path, options);
}

}  // namespace box2d3_engine
}  // namespace scree_capture
