// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the runs of poses.h share. They step the source and tell which bodies are new, which are gone and which moved.
// Their capture is that of the source but for the broad phase; times and memory are those of the broad phase alone.

#pragma once

#include "testbed/engines/engine_run.h"
#include "testbed/engines/heap_meter.h"

namespace testbed {

class FollowingRun : public EngineRun {
public:
    void Step() final;
    [[nodiscard]] int GetStep() const final { return m_source->GetStep(); }
    [[nodiscard]] StepTimes GetTimes() const final { return m_times; }
    [[nodiscard]] int GetContactCount() const final { return m_source->GetContactCount(); }
    [[nodiscard]] StepCounts CountStep() final { return m_source->CountStep(); }
    [[nodiscard]] double GetCreateMilliseconds() const final { return m_source->GetCreateMilliseconds(); }
    [[nodiscard]] int64_t GetPeakBytes() const final { return m_heap.GetPeakBytes(); }
    void Capture(Snapshot& snapshot, const CaptureParts& parts) final;

protected:
    FollowingRun(const scenes::Scene& scene, std::unique_ptr<EngineRun> source)
        : m_scene(scene), m_source(std::move(source)) {}
    /// Creates the bodies of the source's present state; for the constructor of the engine's class.
    void Load();
    [[nodiscard]] const scenes::Scene& GetScene() const { return m_scene; }

    /// A fixture, or an edge of one, has a slot; those of a body follow each other.
    struct Slots {
        size_t begin = 0, end = 0;
    };
    [[nodiscard]] Slots SlotsOf(const BodyState& body) const { return m_slots[static_cast<size_t>(body.index)]; }
    /// Index into Snapshot::fixtures of what a slot holds; −1: its body is gone.
    [[nodiscard]] int FixtureOf(size_t slot) const { return m_fixtureOf[slot]; }

    /// Adds the fixtures of a new body at its pose, in the next free slots.
    virtual void Create(const BodyState& body) = 0;
    /// Removes the fixtures of a body that is gone.
    virtual void Destroy(const BodyState& body) = 0;
    /// Moves the fixtures of the bodies that the step simulated, and finds pairs. `before` and `after` hold the same
    /// bodies. A body that fell asleep in the step counts as standing still at its new pose, as in Box2D.
    virtual void Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) = 0;
    /// Overwrites engine, broadPhase and pairsReported; with `nodes` also nodes, treeHeight and leafSize.
    virtual void CaptureBroadPhase(Snapshot& snapshot, bool nodes) = 0;

private:
    void CreateIn(const BodyState& body);
    void ListFixtures();

    scenes::Scene m_scene;
    std::unique_ptr<EngineRun> m_source;
    std::vector<BodyState> m_bodies;  ///< as of the last step, by growing index
    std::vector<Slots> m_slots;       ///< by index of a body in the scene
    std::vector<int> m_fixtureOf;     ///< by slot
    HeapMeter m_heap;
    StepTimes m_times;
};

/// Whether the step from `before` to `after` simulated the body.
inline bool WasSimulated(const BodyState& before, const BodyState& after) {
    return after.type != scenes::BodyType::isStatic && (before.awake || after.awake);
}

}  // namespace testbed
