// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the runs of all engines share: loading in the scene's order, counting steps, spawning, memory, and the common
// part of a capture. An engine adds how to make a body and a joint, how to step, and how to describe itself.

#pragma once

#include "testbed/base/stopwatch.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/heap_meter.h"

namespace testbed {

class SceneRun : public InteractiveRun {
public:
    void Step() final;
    [[nodiscard]] int GetStep() const final { return m_step; }
    [[nodiscard]] StepTimes GetTimes() const final { return m_times; }
    [[nodiscard]] double GetCreateMilliseconds() const final { return m_createMilliseconds; }
    [[nodiscard]] int64_t GetPeakBytes() const final { return m_heap.GetPeakBytes(); }
    void Capture(Snapshot& snapshot, const CaptureParts& parts) final;

    [[nodiscard]] const scenes::Scene& GetScene() const final { return m_scene; }
    [[nodiscard]] const RunSpec& GetSpec() const final { return m_spec; }
    void Apply(const RunSpec& spec) final;
    void BeginDrag(int body, Vec2 localPoint) final;
    void MoveDrag(Vec2 target) final;
    void EndDrag() final;
    int ShootBullet(Vec2 position, Vec2 velocity) final;
    void Edit(int body, const BodyEdit& edit) final;
    [[nodiscard]] scenes::Scene MakeScene() const final;
    void Record(const std::string& path, const TrackContents& contents) override;
    void EndRecord() override {}

protected:
    SceneRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs);
    /// Creates what exists before the first step; for the constructor of the engine's class, inside Create.
    void Load();
    /// Instead of Load, where the world is there already.
    void SetLoaded() { m_bodyCount = m_scene.InitialBodyCount(); }
    [[nodiscard]] float GetTimeStep() const { return static_cast<float>(*m_spec.timeStep); }
    /// Whether any surface of the scene moves what touches it.
    [[nodiscard]] bool HasConveyor() const;
    /// Bodies created so far: indices 0 … count − 1.
    [[nodiscard]] int GetBodyCount() const { return m_bodyCount; }
    /// Heap growth inside `call` counts as held by the engine, its time as spent on creation.
    template <typename Call>
    void Create(Call&& call) {
        m_heap.Measure([&] {
            const Stopwatch watch;
            std::forward<Call>(call)();
            m_createMilliseconds += watch.GetMilliseconds();
        });
    }

    virtual void CreateBody(const scenes::Body& body) = 0;
    virtual void CreateJoint(const scenes::Joint& joint) = 0;
    /// One step; `newFixtures` tells that fixtures were created since the last one.
    virtual StepTimes StepEngine(bool newFixtures) = 0;
    /// All that the world itself knows, in the order of the scene.
    virtual void CaptureWorld(Snapshot& snapshot, const CaptureParts& parts) = 0;
    /// The state after a step and its spawns, into the track that Record has begun, if any.
    virtual void RecordStep() {}
    /// Gravity, sleeping, warm starting and continuous collision into the world; steps read the rest.
    virtual void ApplyToWorld(const RunSpec& spec) = 0;
    /// A mouse joint on the body at `localPoint`; none exists. Its strength is that of the dragSpring… below.
    virtual void CreateDrag(int body, Vec2 localPoint) = 0;
    virtual void MoveDragTo(Vec2 target) = 0;
    virtual void DestroyDrag() = 0;

    /// A legal edit of a body that exists.
    virtual void EditBody(int body, const BodyEdit& edit);
    /// The world without what is not made yet.
    [[nodiscard]] virtual scenes::Scene DescribeWorld() const;

    /// What of an image is not the world's: see Save.
    struct State {
        std::shared_ptr<const scenes::Scene> scene;
        RunSpec spec;
        StepTimes times;
        int step = 0, bodyCount = 0;
        std::size_t spawnCount = 0;
        bool newFixtures = false, isDragging = false;
    };
    [[nodiscard]] State KeepState() const;
    void PutState(const State& state);

    static constexpr float dragHertz = 5.0f;         ///< of the spring that pulls a body
    static constexpr float dragDampingRatio = 0.7f;  ///< of the spring
    static constexpr float dragAcceleration = 1000;  ///< largest force over the body's mass, m/s²

private:
    void CreateBodiesUpTo(int count);
    /// Tight boxes are kept before a step, and joined with those after it in the capture.
    void KeepBoxes();
    void AddKeptBoxes(std::vector<FixtureState>& fixtures) const;

    scenes::Scene m_scene;
    HeapMeter m_heap;
    StepTimes m_times;
    double m_createMilliseconds = 0;
    int m_step = 0;
    int m_bodyCount = 0;
    size_t m_spawnCount = 0;
    bool m_newFixtures = false;
    RunSpec m_spec;
    bool m_isDragging = false;
    bool m_keepBoxes;
    mutable std::shared_ptr<const scenes::Scene> m_keptScene;  ///< a copy of m_scene for images; null: it has changed
    std::vector<Box> m_boxesBefore;  ///< by index into Snapshot::fixtures, before the last step
};

}  // namespace testbed
