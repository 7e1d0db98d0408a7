// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scene_run.h.

#include "testbed/engines/scene_run.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

namespace testbed {

namespace {

constexpr float bulletDensity = 20.0f;  // kg/m²: heavy among the scenes' bodies, most of which have 1

/// The spec with what the scene decides filled in. Throws std::invalid_argument for what an engine cannot run.
RunSpec CheckedSpec(const RunSpec& spec, const scenes::Scene& scene) {
    RunSpec resolved = Resolve(spec, scene);
    if (const std::string problem = FindProblem(resolved); !problem.empty()) throw std::invalid_argument(problem);
    return resolved;
}

}  // namespace

SceneRun::SceneRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs)
    : m_scene(scene), m_spec(CheckedSpec(spec, scene)), m_keepBoxes(needs.sweptBoxes) {}

void SceneRun::Load() {
    CreateBodiesUpTo(m_scene.InitialBodyCount());
    for (const scenes::Joint& joint : m_scene.joints) CreateJoint(joint);
}

bool SceneRun::HasConveyor() const {
    return std::ranges::any_of(m_scene.fixtures, [](const scenes::Fixture& f) { return f.tangentSpeed != 0.0f; });
}

void SceneRun::CreateBodiesUpTo(int count) {
    for (; m_bodyCount < count; ++m_bodyCount) {
        const scenes::Body& body = m_scene.bodies[static_cast<size_t>(m_bodyCount)];
        m_newFixtures |= body.fixtureCount > 0;
        CreateBody(body);
    }
}

void SceneRun::KeepBoxes() {
    Snapshot before;
    CaptureWorld(before, {.fixtures = true, .contacts = false, .joints = false, .nodes = false});
    m_boxesBefore.clear();
    for (const FixtureState& fixture : before.fixtures) m_boxesBefore.push_back(fixture.tight);
}

void SceneRun::AddKeptBoxes(std::vector<FixtureState>& fixtures) const {
    for (size_t i = 0; i < fixtures.size(); ++i) {
        const Box& after = fixtures[i].tight;
        // What was spawned after the step has no box before it.
        const Box& before = i < m_boxesBefore.size() ? m_boxesBefore[i] : after;
        fixtures[i].swept = {{std::min(before.lower.x, after.lower.x), std::min(before.lower.y, after.lower.y)},
                             {std::max(before.upper.x, after.upper.x), std::max(before.upper.y, after.upper.y)}};
    }
}

void SceneRun::Step() {
    if (m_keepBoxes) KeepBoxes();
    m_heap.Measure([&] {
        const CpuStopwatch watch;
        m_times = StepEngine(m_newFixtures);
        m_times.cpu = watch.GetMilliseconds();
    });
    m_newFixtures = false;
    ++m_step;
    int due = m_bodyCount;
    while (m_spawnCount < m_scene.spawns.size() && m_scene.spawns[m_spawnCount].afterStep <= m_step) {
        due = m_scene.spawns[m_spawnCount++].body + 1;
    }
    if (due > m_bodyCount) Create([&] { CreateBodiesUpTo(due); });
    RecordStep();
}

void SceneRun::Record(const std::string&, const TrackContents&) {
    throw std::invalid_argument(m_spec.engine + " cannot be recorded here: scree and box2d can");
}

void SceneRun::EditBody(int, const BodyEdit&) {
    throw std::invalid_argument(m_spec.engine + " cannot edit bodies here; scree and box2d can");
}

void SceneRun::Edit(int body, const BodyEdit& edit) {
    if (body < 0 || body >= m_bodyCount) throw std::invalid_argument("there is no body " + std::to_string(body));
    if (const std::string problem = FindProblem(edit); !problem.empty()) throw std::invalid_argument(problem);
    EditBody(body, edit);
    if (!edit.type) return;
    m_scene.bodies[static_cast<size_t>(body)].type = *edit.type;
    m_keptScene.reset();
}

SceneRun::State SceneRun::KeepState() const {
    if (m_keptScene == nullptr) m_keptScene = std::make_shared<const scenes::Scene>(m_scene);
    return {m_keptScene, m_spec, m_times, m_step, m_bodyCount, m_spawnCount, m_newFixtures, m_isDragging};
}

void SceneRun::PutState(const State& state) {
    if (m_keptScene != state.scene) m_scene = *state.scene;
    m_keptScene = state.scene;
    m_spec = state.spec;
    m_times = state.times;
    m_step = state.step;
    m_bodyCount = state.bodyCount;
    m_spawnCount = state.spawnCount;
    m_newFixtures = state.newFixtures;
    m_isDragging = state.isDragging;
}

scenes::Scene SceneRun::DescribeWorld() const {
    throw std::invalid_argument(m_spec.engine + " cannot be saved as a scene here: scree and box2d can");
}

scenes::Scene SceneRun::MakeScene() const {
    scenes::Scene made = DescribeWorld();
    made.name = m_scene.name;
    made.size = m_scene.size;
    made.steps = std::max(1, m_scene.steps - m_step);
    made.showStep = made.steps;
    made.gravity = *m_spec.gravity;
    made.timeStep = GetTimeStep();
    made.user = m_scene.user;
    if (const auto* si = std::get_if<SequentialImpulses>(&m_spec.solver); si != nullptr && si->iterations) {
        made.velocityIterations = si->iterations->velocity;
        made.positionIterations = si->iterations->position;
    }
    for (size_t i = m_spawnCount; i < m_scene.spawns.size(); ++i) {
        const scenes::Spawn& spawn = m_scene.spawns[i];
        scenes::Body body = m_scene.bodies[static_cast<size_t>(spawn.body)];
        const std::span<const scenes::Fixture> fixtures = m_scene.FixturesOf(spawn.body);
        body.firstFixture = static_cast<int>(made.fixtures.size());
        for (scenes::Fixture fixture : fixtures) {
            const std::span<const Vec2> chain = m_scene.ChainVerticesOf(fixture.shape);
            fixture.shape.firstChainVertex = static_cast<int>(made.chainVertices.size());
            made.chainVertices.insert(made.chainVertices.end(), chain.begin(), chain.end());
            made.fixtures.push_back(fixture);
        }
        made.spawns.push_back({std::max(1, spawn.afterStep - m_step), static_cast<int>(made.bodies.size())});
        made.bodies.push_back(body);
    }
    return made;
}

void SceneRun::Apply(const RunSpec& spec) {
    RunSpec resolved = CheckedSpec(spec, m_scene);
    for (const SettingKey& key : GetSettingKeys()) {
        if (key.isLive || key.print(resolved) == key.print(m_spec)) continue;
        throw std::invalid_argument(std::string(key.name) + " cannot change while a scene runs");
    }
    m_spec = std::move(resolved);
    ApplyToWorld(m_spec);
}

void SceneRun::BeginDrag(int body, Vec2 localPoint) {
    if (body < 0 || body >= m_bodyCount ||
        m_scene.bodies[static_cast<size_t>(body)].type != scenes::BodyType::dynamic) {
        throw std::invalid_argument("body " + std::to_string(body) + " cannot be dragged: it is not a dynamic body");
    }
    EndDrag();
    CreateDrag(body, localPoint);
    m_isDragging = true;
}

void SceneRun::MoveDrag(Vec2 target) {
    if (m_isDragging) MoveDragTo(target);
}

void SceneRun::EndDrag() {
    if (m_isDragging) DestroyDrag();
    m_isDragging = false;
}

int SceneRun::ShootBullet(Vec2 position, Vec2 velocity) {
    m_keptScene.reset();
    scenes::Fixture fixture;
    fixture.shape.type = scenes::ShapeType::circle;
    fixture.shape.radius = bulletRadius;
    fixture.density = bulletDensity;
    scenes::Body body;
    body.type = scenes::BodyType::dynamic;
    body.bullet = true;
    body.position = position;
    body.linearVelocity = velocity;
    body.firstFixture = static_cast<int>(m_scene.fixtures.size());
    body.fixtureCount = 1;
    m_scene.fixtures.push_back(fixture);
    m_scene.bodies.insert(m_scene.bodies.begin() + m_bodyCount, body);
    for (size_t i = m_spawnCount; i < m_scene.spawns.size(); ++i) ++m_scene.spawns[i].body;
    Create([&] { CreateBodiesUpTo(m_bodyCount + 1); });
    return m_bodyCount - 1;
}

void SceneRun::Capture(Snapshot& snapshot, const CaptureParts& parts) {
    snapshot.scene = m_scene.name;
    snapshot.size = m_scene.size;
    snapshot.step = m_step;
    snapshot.times = m_times;
    snapshot.memoryBytes = m_heap.GetBytes();
    CaptureWorld(snapshot, parts);
    AddKeptBoxes(snapshot.fixtures);
}

}  // namespace testbed
