// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in our engine, through its public headers alone: loading, stepping, times by stage, capture. The
// solver's time includes finding islands, as Box2D's does.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "scenes/outline.h"
#include "scree/distance_joint.h"
#include "scree/friction_joint.h"
#include "scree/gear_joint.h"
#include "scree/inspect.h"
#include "scree/motor_joint.h"
#include "scree/mouse_joint.h"
#include "scree/prismatic_joint.h"
#include "scree/pulley_joint.h"
#include "scree/revolute_joint.h"
#include "scree/snapshot.h"
#include "scree/weld_joint.h"
#include "scree/wheel_joint.h"
#include "scree/world.h"
#include "testbed/base/stopwatch.h"
#include "testbed/capture/scree_capture.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/engines/feature_facts.h"
#include "testbed/engines/inspect_objects.h"
#include "testbed/engines/loop_meter.h"
#include "testbed/engines/saved_world.h"
#include "testbed/engines/scene_run.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_scene.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/scree_step.h"
#include "testbed/engines/track_output.h"
#include "testbed/engines/world_scene.h"
#include "testbed/input/body_names.h"

namespace testbed {
namespace {

/// A refused call means a scene that cannot be loaded as described: nothing to go on with.
void ThrowError(const scree::Error& error, void*) {
    throw std::invalid_argument(std::string(error.function) + ": " + error.field + ": " + scree::GetName(error.code) +
                                "; " + error.cure);
}

/// The engine gives user data by a reference only, for writing too.
int BodyIndexOf(const scree::Body* body) {
    return static_cast<int>(const_cast<scree::Body*>(body)->GetUserData().pointer);
}

/// Classes of joints, for inspect_objects.h.
struct ScreeJointTypes {
    using Revolute = scree::RevoluteJoint;
    using Distance = scree::DistanceJoint;
    using Friction = scree::FrictionJoint;
    using Gear = scree::GearJoint;
    using Motor = scree::MotorJoint;
    using Mouse = scree::MouseJoint;
    using Prismatic = scree::PrismaticJoint;
    using Pulley = scree::PulleyJoint;
    using Weld = scree::WeldJoint;
    using Wheel = scree::WheelJoint;
};

class ScreeRun final : public SceneRun {
public:
    ScreeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs)
        : SceneRun(scene, spec, needs), m_conveyor(GetScene()) {
        const scree::WorldDef def = MakeScreeWorldDef(GetSpec());
        m_bodies.reserve(scene.bodies.size());
        m_proxies.reserve(scene.fixtures.size());
        m_proxyOf.reserve(scene.fixtures.size());
        m_joints.reserve(scene.joints.size());
        Create([&] {
            m_world = std::make_unique<scree::World>(def);
            m_world->SetErrorHandler(ThrowError, nullptr);
            scree::inspect::SetDirectJoints(*m_world, GetSpec().directJoints);
            if (needs.loops != nullptr) m_world->SetWorkers(GetSpec().threads, needs.loops->GetCallbacks());
            if (HasConveyor()) m_world->SetContactListener(&m_conveyor);
            Load();
        });
    }

    ScreeRun(const SavedWorld& saved, const RunSpec& spec, const RunNeeds& needs)
        : SceneRun(saved.scene, spec, needs), m_conveyor(GetScene()) {
        Create([&] {
            m_world = scree::LoadWorld(*saved.image);
            if (m_world == nullptr) throw std::invalid_argument("the image of the world cannot be read");
            m_world->SetErrorHandler(ThrowError, nullptr);
        });
        CheckSettings();
        m_world->SetWorkers(GetSpec().threads);
        ApplyToWorld(GetSpec());
        FindObjects();
        SetLoaded();
    }

    void Record(const std::string& path, const TrackContents& contents) override {
        m_track.Begin(*m_world, path, contents, GetSpec(), NamesIn(GetScene()));
    }
    void EndRecord() override { m_track.End(); }

    [[nodiscard]] RunValues ValuesOfBody(int body) const override {
        return testbed::ValuesOfBody(*m_bodies[static_cast<size_t>(body)]);
    }
    [[nodiscard]] RunValues ValuesOfFixture(int fixture) const override {
        return testbed::ValuesOfFixture(*m_proxies[static_cast<size_t>(fixture)].fixture);
    }
    [[nodiscard]] RunValues ValuesOfJoint(int joint) const override {
        const auto index = static_cast<size_t>(joint);
        return testbed::ValuesOfJoint<ScreeJointTypes>(*m_joints[index], GetScene().joints[index].type,
                                                       1.0f / GetTimeStep());
    }
    [[nodiscard]] std::shared_ptr<const RunImage> Save() const override;
    void Restore(const RunImage& image) override;

    [[nodiscard]] const scree::World& GetWorld() const { return *m_world; }
    [[nodiscard]] int GetContactCount() const override { return m_world->GetContactCount(); }
    [[nodiscard]] StepCounts CountStep() override {
        const scree::StepReport& report = m_world->GetReport();
        return {report.awakeBodyCount, report.touchingCount, report.contactCount};
    }

protected:
    void CreateBody(const scenes::Body& body) override;
    void CreateJoint(const scenes::Joint& joint) override;
    StepTimes StepEngine(bool newFixtures) override;
    void CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) override;
    void ApplyToWorld(const RunSpec& spec) override;
    void CreateDrag(int body, Vec2 localPoint) override;
    void MoveDragTo(Vec2 target) override { m_drag->SetTarget(ToScree(target)); }
    void DestroyDrag() override;
    void RecordStep() override { m_track.Step(GetTimeStep(), m_bodies); }
    void EditBody(int body, const BodyEdit& edit) override {
        ApplyEdit(*m_bodies[static_cast<size_t>(body)], edit, [](Vec2 v) { return ToScree(v); });
    }
    [[nodiscard]] scenes::Scene DescribeWorld() const override {
        return DescribeAsScene<scree_capture::own_engine::Api>(*m_world);
    }

private:
    /// Handles by the indices of the scene. The lists of an image may be longer than those now, where it lies ahead.
    struct Lists {
        ScreeBodies bodies;
        std::vector<ScreeProxy> proxies;
        std::vector<int> proxyOf;
        ScreeJoints joints;
    };
    struct Image final : RunImage {
        WorldImage bytes;
        State state;
        std::shared_ptr<const Lists> lists;
        scree::Body* dragGround = nullptr;
        scree::MouseJoint* drag = nullptr;

        [[nodiscard]] std::size_t GetBytes() const override { return sizeof *this + bytes.size(); }
    };

    /// Those of a saved world that cannot change any more are as wanted.
    void CheckSettings() const;
    /// Bodies, fixtures and joints of a saved world, in the order of its scene.
    void FindObjects();
    void AddProxy(ScreeProxy proxy);
    /// Of fixtures that have none yet.
    void AddOutlines();

    Conveyor m_conveyor;
    std::unique_ptr<scree::World> m_world;
    ScreeBodies m_bodies;                          ///< by body index
    std::vector<ScreeProxy> m_proxies;             ///< by index into Snapshot::fixtures
    std::vector<int> m_proxyOf;                    ///< Fixture::GetIndex → index into Snapshot::fixtures
    ScreeJoints m_joints;                          ///< by joint index
    mutable std::shared_ptr<const Lists> m_lists;  ///< a copy of these four for images; null: they have changed
    scree::Body* m_dragGround = nullptr;           ///< carries the spring that drags
    scree::MouseJoint* m_drag = nullptr;
    TrackOutput<scree_capture::own_engine::Track, scree::World> m_track;  ///< ends before the world
};

void ScreeRun::AddProxy(ScreeProxy proxy) {
    const auto slot = static_cast<size_t>(proxy.fixture->GetIndex());
    if (m_proxyOf.size() <= slot) m_proxyOf.resize(slot + 1, -1);
    m_proxyOf[slot] = static_cast<int>(m_proxies.size());
    m_proxies.push_back(std::move(proxy));
}

void ScreeRun::CheckSettings() const {
    const RunSpec own = DescribeScreeWorld(*m_world);
    for (const std::string_view name :
         {"caps", "contactHertz", "contactDamping", "pushSpeed", "lengthScale", "features", "broadPhase"}) {
        const SettingKey& key = FindSettingKey(name);
        if (key.print(own) == key.print(GetSpec())) continue;
        throw std::invalid_argument(fmt::format(
            "{}={}: the saved world has {}, which cannot change in it; `scree convert` makes a scene of it, "
            "which any setting can run",
            name, key.print(GetSpec()), key.print(own)));
    }
}

void ScreeRun::FindObjects() {
    using Writer =
        scree_capture::detail::SceneWriter<scree_capture::own_engine::Api, scree_capture::detail::JsonWriter>;
    for (scree::Body* body = m_world->GetBodyList(); body; body = body->GetNext()) m_bodies.push_back(body);
    scree_capture::own_engine::Api::SortByAge(m_bodies);
    for (size_t i = 0; i < m_bodies.size(); ++i) {
        m_bodies[i]->SetUserData({i});
        int sceneIndex = GetScene().bodies[i].firstFixture;
        for (const auto& group : Writer::FixturesOf(*m_bodies[i])) {
            for (size_t child = 0; child < group.size(); ++child) {
                AddProxy({group[child], sceneIndex, static_cast<int>(child)});
            }
            ++sceneIndex;
        }
    }
    for (scree::Joint* joint = m_world->GetJointList(); joint; joint = joint->GetNext()) m_joints.push_back(joint);
    std::ranges::reverse(m_joints);
}

void ScreeRun::CreateBody(const scenes::Body&) {
    m_lists.reset();
    const auto index = static_cast<int>(m_bodies.size());
    m_bodies.push_back(CreateScreeBody(*m_world, GetScene(), index, [&](scree::Fixture* fixture, int scene, int child) {
        AddProxy({fixture, scene, child});
    }));
}

void ScreeRun::CreateJoint(const scenes::Joint& joint) {
    m_lists.reset();
    m_joints.push_back(CreateScreeJoint(*m_world, joint, m_bodies, m_joints));
}

StepTimes ScreeRun::StepEngine(bool) {
    const Stopwatch watch;
    const scree::StepReport report = StepScree(*m_world, GetSpec().solver, GetTimeStep());
    const scree::Profile& p = report.profile;
    return {.broadPhase = double{p.broadPhase},
            .narrowPhase = double{p.narrowPhase},
            .solver = double{p.islands} + p.solver,
            .islands = double{p.islands},
            .continuous = double{p.continuous},
            .step = watch.GetMilliseconds()};
}

void ScreeRun::ApplyToWorld(const RunSpec& spec) {
    m_world->SetGravity(ToScree(*spec.gravity));
    m_world->SetAllowSleeping(spec.sleeping);
    m_world->SetWarmStarting(spec.warmStarting);
    m_world->SetContinuousPhysics(spec.continuous);
    scree::inspect::SetDirectJoints(*m_world, spec.directJoints);
}

void ScreeRun::CreateDrag(int body, Vec2 localPoint) {
    const scree::BodyDef groundDef;
    if (!m_dragGround) m_dragGround = m_world->CreateBody(&groundDef);
    scree::Body* dragged = m_bodies[static_cast<size_t>(body)];
    scree::MouseJointDef def;
    def.bodyA = m_dragGround;
    def.bodyB = dragged;
    def.target = dragged->GetWorldPoint(ToScree(localPoint));
    def.maxForce = dragAcceleration * dragged->GetMass();
    scree::LinearStiffness(def.stiffness, def.damping, dragHertz, dragDampingRatio, m_dragGround, dragged);
    m_drag = static_cast<scree::MouseJoint*>(m_world->CreateJoint(&def));
    dragged->SetAwake(true);
}

void ScreeRun::DestroyDrag() {
    // Its ground goes with it, so that a saved scene has no body that nobody made.
    m_world->DestroyBody(m_dragGround);
    m_drag = nullptr;
    m_dragGround = nullptr;
}

std::shared_ptr<const RunImage> ScreeRun::Save() const {
    auto image = std::make_shared<Image>();
    image->bytes = scree::SaveWorld(*m_world);
    image->state = KeepState();
    if (m_lists == nullptr) m_lists = std::make_shared<const Lists>(Lists{m_bodies, m_proxies, m_proxyOf, m_joints});
    image->lists = m_lists;
    image->dragGround = m_dragGround;
    image->drag = m_drag;
    return image;
}

void ScreeRun::Restore(const RunImage& kept) {
    const auto& image = static_cast<const Image&>(kept);
    if (const scree::SnapshotError error = scree::RestoreWorld(*m_world, image.bytes);
        error != scree::SnapshotError::ok) {
        throw std::runtime_error(std::string("an image of the run cannot be restored: ") + scree::GetName(error));
    }
    // Objects that are in the image have the handles that they had.
    if (m_lists != image.lists) {
        m_bodies = image.lists->bodies;
        m_proxies = image.lists->proxies;
        m_proxyOf = image.lists->proxyOf;
        m_joints = image.lists->joints;
    }
    m_lists = image.lists;
    m_dragGround = image.dragGround;
    m_drag = image.drag;
    PutState(image.state);
}

void ScreeRun::AddOutlines() {
    for (ScreeProxy& proxy : m_proxies) {
        const scenes::Shape& shape = GetScene().fixtures[static_cast<size_t>(proxy.sceneIndex)].shape;
        if (proxy.outline.empty() && scenes::IsFurtherConvex(shape.type))
            proxy.outline = scenes::SampleOutline(GetScene(), shape, outlineDirections);
    }
}

void ScreeRun::CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) {
    if (parts.fixtures) AddOutlines();  // not when a fixture is made: that is timed, and other engines draw none
    const ScreeListing listing{.scene = &GetScene(),
                               .bodies = m_bodies,
                               .indexOf = BodyIndexOf,
                               .proxies = m_proxies,
                               .proxyOf = m_proxyOf,
                               .joints = m_joints};
    testbed::Capture(*m_world, listing, snapshot, parts);
    snapshot.threads = GetSpec().threads;
}

}  // namespace

FeatureFacts GetFeatureFacts(const EngineRun& run) {
    const auto* own = dynamic_cast<const ScreeRun*>(&run);
    if (own == nullptr) throw std::invalid_argument("features are those of our engine");
    const scree::World& world = own->GetWorld();
    FeatureFacts facts;
    const scree::FeatureUsers users = world.GetFeatureUsers();
    for (size_t i = 0; i < users.size(); ++i) facts.uses.push_back({scree::featureNames[i], users[i]});
    facts.kernels = scree::GetName(scree::inspect::GetKernels(world));
    const scree::inspect::MemoryUse memory = scree::inspect::GetMemoryUse(world);
    facts.bytesPerBody = memory.bytesPerBody;
    facts.bytesPerFixture = memory.bytesPerFixture;
    facts.bytesPerContact = memory.bytesPerContact;
    facts.jointBytes = memory.joints;
    facts.bodies = world.GetBodyCount();
    facts.contacts = world.GetContactCount();
    facts.joints = world.GetJointCount();
    facts.stateHash = scree::inspect::GetStateHash(world);
    return facts;
}

std::unique_ptr<InteractiveRun> MakeScreeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return std::make_unique<ScreeRun>(scene, spec, needs);
}

std::unique_ptr<InteractiveRun> MakeScreeRun(const SavedWorld& world, const RunSpec& spec, const RunNeeds& needs) {
    return std::make_unique<ScreeRun>(world, spec, needs);
}

}  // namespace testbed
