// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Any sequence of calls with any numbers, on living and dead objects, with any number of workers. The laws follow.
// Nothing crashes. After each step those of laws.h hold, brute force among them, and events tell what has changed. The
// world saved at the end can be loaded and goes on to the same state. So does the world that goes back to what was
// saved on the way. The recording of all calls replays to the same hashes. What is loaded or replayed has another
// number of workers.

#pragma once

#include <array>
#include <bit>
#include <iterator>
#include <memory>
#include <tuple>
#include <type_traits>
#include <vector>

#include "scree/inspect.h"
#include "scree/rollback.h"
#include "scree/scree.h"
#include "state/limits.h"
#include "testbed/base/hash.h"
#include "tests/fuzz/event_laws.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/meddler.h"
#include "world/recorded_calls.h"
#include "world/world_state.h"

namespace fuzz {

using namespace scree;

/// They share all that can be shared, whether it pays or not.
inline void SetWorkers(World& world, int count) {
    world.SetWorkers(count);
    world.GetState().pool->ShareAlways();
}

class Calls {
public:
    explicit Calls(Input& input) : m_input(input), m_world(MakeDef(input)) {
        SetWorkers(m_world, 1 + m_input.Choose(mostWorkers));
        Meddle(m_world);
        m_world.SetReportMoves(true);
        if (m_isRecorded) StartRecording(m_world, m_recorder);
        MakeBody();
    }

    void Run() {
        constexpr int mostCalls = 120, mostSteps = 12;
        int steps = 0;
        for (int call = 0; call < mostCalls && !m_input.IsEmpty(); ++call) {
            const int kind = m_input.Choose(23);
            if (kind == 18) {
                KeepOrGoBack();
            } else if (kind > 18) {
                CallAny();
            } else if (kind >= 16) {
                MakeCrowd();
            } else if (kind < 3) {
                MakeBody();
            } else if (kind < 6) {
                MakeFixture();
            } else if (kind < 8) {
                MakeJoint();
            } else if (kind < 12) {
                Change();
            } else if (kind < 13) {
                Ask();
            } else if (kind < 14) {
                Destroy();
            } else if (steps++ < mostSteps) {
                StepByLaws();
            }
        }
        StopRecording(m_world);
        if (m_isRecorded) CheckReplay();
        CheckLoaded();
        CheckInPlace();
        for (const Kept& kept : m_kept) {
            GoBackTo(kept);
            CheckGoesOnLike(*Load(kept.image), "a restored world goes on alike");
        }
    }

    /// Of the states after all steps, and of all answers: the same on all machines.
    [[nodiscard]] uint64_t GetHash() const { return m_sum.Get(); }

private:
    static constexpr int mostWorkers = 4;

    /// The world on the way.
    struct Kept {
        std::vector<std::byte> image;
        int64_t moment;
        uint64_t hash;
    };

    static WorldDef MakeDef(Input& input) {
        WorldDef def;
        def.gravity = {static_cast<float>(input.Choose(21)) - 10.0f, static_cast<float>(input.Choose(21)) - 10.0f};
        def.broadPhase = static_cast<BroadPhaseKind>(input.Choose(static_cast<int>(std::size(broadPhaseNames))));
        const int flags = input.Choose(32);
        def.allowSleep = (flags & 1) == 0;
        def.warmStarting = (flags & 2) == 0;
        def.continuousPhysics = (flags & 4) == 0;
        def.subStepping = (flags & 8) != 0;
        def.exactDrift = (flags & 16) != 0;
        return def;
    }

    scree::Body* AnyBody() { return m_bodies[static_cast<size_t>(m_input.Byte()) % m_bodies.size()]; }

    void MakeBody() {
        BodyDef def;
        def.type = static_cast<BodyType>(m_input.Choose(3));
        def.position = m_input.Point();
        def.angle = m_input.Number();
        def.linearVelocity = m_input.Point();
        def.angularVelocity = m_input.Number();
        const int flags = m_input.Choose(64);
        if ((flags & 1) != 0) def.linearDamping = m_input.Amount();
        if ((flags & 2) != 0) def.gravityScale = m_input.Number();
        def.bullet = (flags & 4) != 0;
        def.fixedRotation = (flags & 8) != 0;
        def.awake = (flags & 16) == 0;
        def.enabled = (flags & 48) != 48;
        if (Body* body = m_world.CreateBody(&def)) m_bodies.push_back(body);
        if (!m_bodies.empty()) MakeFixture();
    }

    void MakeFixture() {
        if (m_bodies.empty()) return;
        Body* body = AnyBody();
        FixtureDef def;
        def.density = m_input.Amount();
        const int flags = m_input.Choose(32);
        if ((flags & 1) != 0) def.friction = m_input.Amount();
        if ((flags & 2) != 0) def.restitution = m_input.Amount();
        def.isSensor = (flags & 12) == 12;
        def.reports = (flags & 16) != 0 ? Report::all : 0;
        WithShape([&](const Shape& shape) {
            def.shape = &shape;
            if (Fixture* fixture = body->CreateFixture(&def)) m_fixtures.push_back(fixture);
        });
    }

    /// Calls back with any shape, if it can be made.
    template <typename Function>
    void WithShape(const Function& add) {
        Vec2 points[8] = {};
        const int count = 1 + m_input.Choose(8);
        for (int i = 0; i < count; ++i) points[i] = m_input.Point();
        CircleShape circle;
        PolygonShape polygon;
        EdgeShape edge;
        ChainShape chain;
        switch (m_input.Choose(10)) {
            case 0:
                circle.m_p = points[0], circle.m_radius = m_input.Amount();
                return add(circle);
            case 1: {
                const auto [width, height, angle] = std::tuple{m_input.Amount(), m_input.Amount(), m_input.Number()};
                polygon.SetAsBox(width, height, points[0], angle);
                return add(polygon);
            }
            case 2:
                if (!polygon.Set(points, count)) return;
                return add(polygon);
            case 3:
                edge.SetTwoSided(points[0], points[1]);
                if (m_input.Flip()) edge.SetOneSided(points[2], points[0], points[1], points[3]);
                return add(edge);
            case 4:
                if (!chain.CreateLoop(points, count)) return;
                return add(chain);
            case 5:
                return add(MakeCapsule(points[0], points[1], m_input.Amount()));
            case 6:
                return add(MakeRoundedPolygon(points, count, m_input.Amount()));
            case 7: {
                const auto [width, height, angle] = std::tuple{m_input.Amount(), m_input.Amount(), m_input.Number()};
                return add(MakeEllipse(width, height, points[0], angle));
            }
            case 8: {
                const auto [radius, half, angle] = std::tuple{m_input.Amount(), m_input.Amount(), m_input.Number()};
                return add(MakeCircleSector(radius, half, points[0], angle));
            }
            default:
                return add(MakePolygon(points, count));
        }
    }

    /// A row of equal bodies that touch, overlap or hang on each other: what workers solve in lanes.
    void MakeCrowd() {
        BodyDef def;
        def.type = dynamicBody;
        def.position = m_input.Point();
        def.linearVelocity = m_input.Point();
        const int count = 1 + m_input.Choose(40), flags = m_input.Choose(8);
        const float width = 0.5f + 0.125f * static_cast<float>(m_input.Choose(8)), apart = m_input.Amount();
        CircleShape circle;
        circle.m_radius = 0.5f * width;
        PolygonShape box;
        box.SetAsBox(0.5f * width, 0.5f);
        FixtureDef fixture;
        fixture.shape = (flags & 1) != 0 ? static_cast<const Shape*>(&circle) : &box;
        fixture.density = 1.0f;
        fixture.filter.groupIndex = (flags & 2) != 0 ? -1 : 0;
        const bool hangs = (flags & 4) != 0, isChain = hangs && m_input.Flip();
        Body* last = nullptr;
        for (int i = 0; i < count; ++i, def.position.x += apart) {
            Body* body = m_world.CreateBody(&def);
            if (body == nullptr) return;
            body->CreateFixture(&fixture);
            m_bodies.push_back(body);
            if (hangs && last != nullptr) {
                RevoluteJointDef hinge;
                hinge.Initialize(last, body, def.position);
                if (Joint* joint = m_world.CreateJoint(&hinge)) AddJoint(joint);
            }
            last = isChain || i % 2 == 0 ? body : nullptr;
        }
    }

    template <typename Def>
    void MakeJointOf(Def& def) {
        def.collideConnected = m_input.Flip();
        if (Joint* joint = m_world.CreateJoint(&def)) AddJoint(joint);
    }
    void AddJoint(Joint* joint) {
        m_joints.push_back(joint);
        m_jointsOfType[joint->GetType()].push_back(joint);
    }
    /// With two anchors, or an anchor and an axis.
    template <typename Def>
    void InitializeAt(Def& def, Body* a, Body* b) {
        const auto [first, second] = std::tuple{m_input.Point(), m_input.Point()};
        def.Initialize(a, b, first, second);
    }
    template <typename Def>
    void Slide(Def& def) {
        def.enableLimit = m_input.Flip(), def.enableMotor = m_input.Flip();
        def.lowerTranslation = m_input.Number(), def.upperTranslation = m_input.Number();
        def.motorSpeed = m_input.Number();
    }
    void MakeJoint() {
        if (m_bodies.empty()) return;
        Body *a = AnyBody(), *b = AnyBody();
        switch (m_input.Choose(10)) {
            case 0: {
                RevoluteJointDef def;
                def.Initialize(a, b, m_input.Point());
                def.enableLimit = m_input.Flip(), def.lowerAngle = m_input.Number(), def.upperAngle = m_input.Number();
                def.enableMotor = m_input.Flip(), def.motorSpeed = m_input.Number();
                def.maxMotorTorque = m_input.Amount();
                return MakeJointOf(def);
            }
            case 1: {
                DistanceJointDef def;
                InitializeAt(def, a, b);
                def.minLength = m_input.Amount(), def.maxLength = m_input.Amount();
                def.stiffness = m_input.Amount(), def.damping = m_input.Amount();
                return MakeJointOf(def);
            }
            case 2: {
                PrismaticJointDef def;
                InitializeAt(def, a, b);
                Slide(def);
                def.maxMotorForce = m_input.Amount();
                return MakeJointOf(def);
            }
            case 3: {
                WeldJointDef def;
                def.Initialize(a, b, m_input.Point());
                def.stiffness = m_input.Amount(), def.damping = m_input.Amount();
                return MakeJointOf(def);
            }
            case 4: {
                WheelJointDef def;
                InitializeAt(def, a, b);
                Slide(def);
                def.maxMotorTorque = m_input.Amount();
                def.stiffness = m_input.Amount(), def.damping = m_input.Amount();
                return MakeJointOf(def);
            }
            case 5: {
                MouseJointDef def;
                def.bodyA = a, def.bodyB = b, def.target = m_input.Point();
                def.maxForce = m_input.Amount(), def.stiffness = m_input.Amount(), def.damping = m_input.Amount();
                return MakeJointOf(def);
            }
            case 6: {
                PulleyJointDef def;
                const PulleyPoints points{m_input.Point(), m_input.Point(), m_input.Point(), m_input.Point()};
                def.Initialize(a, b, points, m_input.Number());
                return MakeJointOf(def);
            }
            case 7: {
                FrictionJointDef def;
                def.Initialize(a, b, m_input.Point());
                def.maxForce = m_input.Amount(), def.maxTorque = m_input.Amount();
                return MakeJointOf(def);
            }
            case 8: {
                MotorJointDef def;
                def.Initialize(a, b);
                def.maxForce = m_input.Amount(), def.maxTorque = m_input.Amount();
                def.correctionFactor = m_input.Amount();
                return MakeJointOf(def);
            }
            default: {
                if (m_joints.empty()) return;
                GearJointDef def;
                def.bodyA = a, def.bodyB = b, def.ratio = m_input.Number();
                def.joint1 = m_joints[m_input.Byte() % m_joints.size()];
                def.joint2 = m_joints[m_input.Byte() % m_joints.size()];
                return MakeJointOf(def);
            }
        }
    }

    void Change() {
        if (m_bodies.empty()) return;
        Body* body = AnyBody();
        switch (m_input.Choose(23)) {
            case 0: {
                const auto [at, angle] = std::tuple{m_input.Point(), m_input.Number()};
                return static_cast<void>(body->SetTransform(at, angle));
            }
            case 1:
                return static_cast<void>(body->SetLinearVelocity(m_input.Point()));
            case 2:
                return static_cast<void>(body->SetAngularVelocity(m_input.Number()));
            case 3: {
                const auto [force, at, wakes] = std::tuple{m_input.Point(), m_input.Point(), m_input.Flip()};
                return static_cast<void>(body->ApplyForce(force, at, wakes));
            }
            case 4: {
                const auto [impulse, at, wakes] = std::tuple{m_input.Point(), m_input.Point(), m_input.Flip()};
                return static_cast<void>(body->ApplyLinearImpulse(impulse, at, wakes));
            }
            case 5: {
                const auto [impulse, wakes] = std::tuple{m_input.Number(), m_input.Flip()};
                return static_cast<void>(body->ApplyAngularImpulse(impulse, wakes));
            }
            case 6:
                return static_cast<void>(body->SetType(static_cast<BodyType>(m_input.Choose(4))));
            case 7:
                return static_cast<void>(body->SetEnabled(m_input.Flip()));
            case 8:
                return static_cast<void>(body->SetAwake(m_input.Flip()));
            case 9:
                return static_cast<void>(body->SetBullet(m_input.Flip()));
            case 10:
                return static_cast<void>(body->SetFixedRotation(m_input.Flip()));
            case 11: {
                MassData mass;
                mass.mass = m_input.Amount(), mass.center = m_input.Point(), mass.I = m_input.Amount();
                return static_cast<void>(body->SetMassData(&mass));
            }
            case 12:
                return static_cast<void>(body->SetGravityScale(m_input.Number()));
            case 13:
                return static_cast<void>(m_world.SetGravity(m_input.Point()));
            case 14:
                return static_cast<void>(m_world.ShiftOrigin(m_input.Point()));
            case 15:
                return static_cast<void>(m_world.TrimMemory());
            case 16:
                return static_cast<void>(m_world.SetAllowSleeping(m_input.Flip()));
            case 17:
                return static_cast<void>(m_world.SetContinuousPhysics(m_input.Flip()));
            case 18:
                return SetWorkers(m_world, 1 + m_input.Choose(mostWorkers));
            default:
                return ChangeFixture();
        }
    }

    template <typename T>
    T Take() {
        if constexpr (std::is_same_v<T, bool>) {
            return m_input.Flip();
        } else if constexpr (std::is_same_v<T, float>) {
            return m_input.Number();
        } else if constexpr (std::is_same_v<T, Vec2>) {
            return m_input.Point();
        } else if constexpr (std::is_same_v<T, MotionLocks>) {
            return {m_input.Flip(), m_input.Flip(), m_input.Flip()};
        } else if constexpr (std::is_same_v<T, Filter>) {
            return {m_input.Byte(), m_input.Byte(), 0};
        } else if constexpr (std::is_same_v<T, Manifold>) {
            return TakeManifold();
        } else {
            return static_cast<T>(m_input.Choose(8));
        }
    }

    Manifold TakeManifold() {
        Manifold manifold{};
        manifold.type = static_cast<Manifold::Type>(m_input.Choose(4));
        manifold.pointCount = static_cast<int8_t>(m_input.Choose(4));
        manifold.localNormal = m_input.Point(), manifold.localPoint = m_input.Point();
        for (ManifoldPoint& point : manifold.points) {
            point.localPoint = m_input.Point();
            point.normalImpulse = m_input.Number(), point.tangentImpulse = m_input.Number();
            point.id.cf.indexA = m_input.Byte();  // its place in the key is the processor's
        }
        return manifold;
    }

    template <typename Object>
    Object* Any() {
        if constexpr (std::is_same_v<Object, World>) {
            return &m_world;
        } else if constexpr (std::is_same_v<Object, Contact>) {
            const int count = m_world.GetContactCount();
            Contact* contact = m_world.GetContactList();
            for (int i = count > 0 ? m_input.Byte() % count : 0; i > 0; --i) contact = contact->GetNext();
            return contact;
        } else if constexpr (std::is_same_v<Object, Body>) {
            return OneOf(m_bodies);
        } else if constexpr (std::is_same_v<Object, Fixture>) {
            return OneOf(m_fixtures);
        } else if constexpr (std::is_same_v<Object, Joint>) {
            return OneOf(m_joints);
        } else {
            return static_cast<Object*>(OneOf(m_jointsOfType[TypeOf(static_cast<Object*>(nullptr))]));
        }
    }
    template <typename Object>
    Object* OneOf(const std::vector<Object*>& objects) {
        return objects.empty() ? nullptr : objects[m_input.Byte() % objects.size()];
    }
    static JointType TypeOf(const RevoluteJoint*) { return e_revoluteJoint; }
    static JointType TypeOf(const PrismaticJoint*) { return e_prismaticJoint; }
    static JointType TypeOf(const DistanceJoint*) { return e_distanceJoint; }
    static JointType TypeOf(const MouseJoint*) { return e_mouseJoint; }
    static JointType TypeOf(const GearJoint*) { return e_gearJoint; }
    static JointType TypeOf(const WheelJoint*) { return e_wheelJoint; }
    static JointType TypeOf(const WeldJoint*) { return e_weldJoint; }
    static JointType TypeOf(const FrictionJoint*) { return e_frictionJoint; }
    static JointType TypeOf(const MotorJoint*) { return e_motorJoint; }

    template <typename Result, typename Object, typename... Arguments>
    void CallOnAny(Result (Object::*method)(Arguments...)) {
        Object* object = Any<Object>();
        const std::tuple<std::decay_t<Arguments>...> arguments{Take<std::decay_t<Arguments>>()...};
        if (object == nullptr) return;
        std::apply([&](const auto&... argument) { (object->*method)(argument...); }, arguments);
    }

    /// Of what a recording has.
    void CallAny() {
        using Call = void (*)(Calls&);
#define SCREE_CALL(method) [](Calls& calls) { calls.CallOnAny(&method); },
        constexpr Call all[] = {SCREE_RECORDED_CALLS(SCREE_CALL)};
#undef SCREE_CALL
        all[m_input.Choose(static_cast<int>(std::size(all)))](*this);
    }

    void ChangeFixture() {
        if (m_fixtures.empty()) return;
        Fixture* fixture = m_fixtures[m_input.Byte() % m_fixtures.size()];
        switch (m_input.Choose(6)) {
            case 5:
                return WithShape([&](const Shape& shape) { fixture->SetShape(shape); });
            case 0:
                return static_cast<void>(fixture->SetSensor(m_input.Flip()));
            case 1:
                return static_cast<void>(fixture->SetFilterData({m_input.Byte(), m_input.Byte(), 0}));
            case 2:
                return static_cast<void>(fixture->SetDensity(m_input.Amount()));
            case 3:
                return static_cast<void>(fixture->SetFriction(m_input.Amount()));
            default:
                return static_cast<void>(fixture->SetRestitution(m_input.Amount()));
        }
    }

    void Ask() {
        const Vec2 a = m_input.Point(), b = m_input.Point();
        std::vector<RayHit> hits;
        const bool isNear = !m_world.GetState().bodies.IsFar();
        if (m_world.RayCastAll(a, b, hits) == ErrorCode::ok && isNear) CheckRays(m_world, a, b, hits);
        for (const RayHit& hit : hits) NoteHit(hit);
        const auto note = [&](Fixture* fixture) {
            m_sum.Add(m_world.GetId(fixture).index);
            return true;
        };
        m_world.QueryAABB({a, b}, note);
        m_world.QueryPoint(a, note);
        if (isNear) CheckQueries(m_world, {a, b}, a);
        CircleShape circle;
        circle.m_radius = m_input.Amount();
        std::vector<ShapeHit> casts;
        const Transform from(a, Rot(0.5f));
        if (m_world.ShapeCast(circle, from, b, casts) == ErrorCode::ok && isNear)
            CheckCasts(m_world, circle, from, b, casts);
        for (const ShapeHit& hit : casts) NoteHit(hit);
    }
    template <typename Hit>
    void NoteHit(const Hit& hit) {
        for (const float number : {hit.fraction, hit.point.x, hit.point.y, hit.normal.x, hit.normal.y})
            m_sum.Add(std::bit_cast<uint32_t>(number));
    }

    void Destroy() {
        const int kind = m_input.Choose(8);
        if (kind < 4) {
            if (Joint* joint = OneOf(m_joints)) m_world.DestroyJoint(joint);
        } else if (kind < 6) {
            if (Body* body = OneOf(m_bodies)) m_world.DestroyBody(body);
        } else if (Fixture* fixture = OneOf(m_fixtures)) {
            Body* body = fixture->GetBody();
            if (body == nullptr) body = OneOf(m_bodies);
            if (body != nullptr) kind == 6 ? body->DestroyFixture(fixture) : body->DestroyChain(fixture);
        }
    }

    /// Returns the time step.
    float Step(World& world) {
        constexpr float steps[] = {1.0f / 60.0f, 1.0f / 60.0f, 1.0f / 30.0f, 0.0f, 1e-4f, 0.5f};
        const float dt = steps[m_input.Choose(6)];
        switch (m_input.Choose(4)) {
            case 0: {
                const auto [velocities, positions] = std::tuple{1 + m_input.Choose(8), m_input.Choose(4)};
                world.Step(dt, velocities, positions);
                return dt;
            }
            case 1:
                world.Step(dt, 1 + m_input.Choose(6));
                return dt;
            case 2:
                world.Step(dt, Tolerance{});
                return dt;
            default: {
                const auto [any, velocities, positions] =
                    std::tuple{m_input.Number(), m_input.Choose(3), m_input.Choose(3)};
                world.Step(any, velocities, positions);
                return any;
            }
        }
    }

    void Meddle(World& world) {
        world.SetErrorHandler([](const Error&, void* isRefused) { *static_cast<bool*>(isRefused) = true; },
                              &m_isRefused);
        if (m_isHeard) world.SetContactListener(&m_meddler);
        if (m_isFiltered) world.SetContactFilter(&m_meddler);
    }

    /// Unlike the world's own.
    [[nodiscard]] int OtherWorkers() const { return m_world.GetWorkerCount() == 1 ? mostWorkers : 1; }

    void StepByLaws() {
        m_isRefused = false;
        const int joints = m_world.GetJointCount();
        m_eventLaws.BeginStep(m_world);
        const bool goesOn = m_world.GetState().continuousScratch.resuming;  // sub-stepping: it gathers nobody
        const float dt = Step(m_world);
        m_sum.Add(inspect::GetStateHash(m_world));
        CheckFinite(m_world);
        CheckLists(m_world);
        m_isRefused ? m_eventLaws.Forget() : m_eventLaws.Check(m_world);
        // What callbacks edit, or a joint that breaks, shows in the next step.
        if (m_isRefused || m_isHeard || m_isFiltered || m_world.GetJointCount() < joints) return;
        if (!m_world.GetState().bodies.IsFar())
            CheckBoxes(m_world, inspect::GetBroadPhase(m_world) != BroadPhaseKind::fatTree);
        CheckContacts(m_world);
        if (dt >= scree::shortestStep && !goesOn) CheckSleep(m_world);
    }

    void CheckReplay() {
        const int others = OtherWorkers();
        const ReplayReport replay =
            Replay(m_recorder.GetBytes(), [&](World& world) { SetWorkers(world, others), Meddle(world); });
        Demand(replay.valid, "a recording can be replayed");
        Demand(replay.firstDifference == 0, "a replay leads to the same hashes");
        Demand(inspect::GetStateHash(*replay.world) == inspect::GetStateHash(m_world),
               "a replay ends in the same state");
    }

    /// While the world is recorded it cannot go back.
    void KeepOrGoBack() {
        if (!m_isRecorded && !m_kept.empty() && m_input.Flip()) {
            GoBackTo(m_kept[m_input.Byte() % m_kept.size()]);
        } else {
            m_kept.push_back({SaveWorld(m_world), m_rollback.Save(), inspect::GetStateHash(m_world)});
        }
    }
    /// By its image or its moment.
    void GoBackTo(const Kept& kept) {
        const bool byMoment = m_rollback.Has(kept.moment) && kept.moment % 2 == 0;
        const SnapshotError error = byMoment ? m_rollback.Restore(kept.moment) : RestoreWorld(m_world, kept.image);
        Demand(error == SnapshotError::ok, "what was saved can be restored");
        m_eventLaws.Forget();
        Demand(inspect::GetStateHash(m_world) == kept.hash, "what was restored has the state that was saved");
    }

    [[nodiscard]] std::unique_ptr<World> Load(std::span<const std::byte> image) {
        SnapshotError error{};
        std::unique_ptr<World> loaded = LoadWorld(image, &error);
        if (loaded == nullptr) std::fprintf(stderr, "%s\n", GetName(error));
        Demand(loaded != nullptr, "what was saved can be loaded");
        SetWorkers(*loaded, OtherWorkers());
        Meddle(*loaded);
        return loaded;
    }
    void CheckGoesOnLike(World& other, const char* law) {
        for (int i = 0; i < 2; ++i) m_world.Step(1.0f / 60.0f, 4), other.Step(1.0f / 60.0f, 4);
        Demand(inspect::GetStateHash(other) == inspect::GetStateHash(m_world), law);
    }

    void CheckLoaded() {
        const std::unique_ptr<World> loaded = Load(SaveWorld(m_world));
        Demand(inspect::GetStateHash(*loaded) == inspect::GetStateHash(m_world),
               "what was loaded has the state that was saved");
        CheckGoesOnLike(*loaded, "a loaded world goes on alike");
    }

    /// A copy looks at all contacts without moving anything, and not at what soft steps keep of them.
    void CheckInPlace() {
        const std::unique_ptr<World> copy = Load(SaveWorld(m_world));
        copy->SetContactListener(nullptr);
        if (copy->GetState().bodies.IsFar() || copy->GetState().continuousScratch.resuming) return;
        copy->Step(0.0f, 8, 3);
        CheckTouching(*copy);
    }

    Input& m_input;
    World m_world;
    const bool m_isRecorded = m_input.Flip(), m_isHeard = m_input.Flip(), m_isFiltered = m_input.Flip();
    bool m_isRefused = false;  ///< some call since this was cleared
    Meddler m_meddler;
    EventLaws m_eventLaws;
    Recorder m_recorder;
    std::vector<Body*> m_bodies;
    std::vector<Fixture*> m_fixtures;  ///< dead ones too: their calls must be refused
    std::vector<Joint*> m_joints;
    std::array<std::vector<Joint*>, e_motorJoint + 1> m_jointsOfType;
    std::vector<Kept> m_kept;
    Rollback m_rollback{m_world, 4};
    testbed::Fnv1a<uint64_t> m_sum;
};

}  // namespace fuzz
