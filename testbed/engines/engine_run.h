// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in one engine. run_scree.cpp and run_box2d.cpp implement it; outside of this
// folder only what abuses an engine on purpose includes an engine's header.

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/run_spec.h"
#include "testbed/engines/run_values.h"
#include "testbed/engines/snapshot.h"
#include "testbed/engines/track_contents.h"

namespace testbed {

class LoopMeter;
class TrackFile;
struct SavedWorld;

/// What a capture must contain beyond bodies, counts, times and hash; leaving a part out saves its time.
struct CaptureParts {
    bool fixtures = true;
    bool contacts = true;
    bool joints = true;
    bool nodes = true;
    bool pairs = true;  ///< Box2D's reported pairs, which take a search; 0 without
};

/// What a run must keep for captures beyond its world.
struct RunNeeds {
    bool sweptBoxes = false;  ///< the boxes before each step, for FixtureState::swept; untimed, O(fixtures)
    LoopMeter* loops =
        nullptr;  ///< runs and times the loops of our engine, in a task for each thread; outlives the run
};

/// What one step dealt with; the same words for every engine.
struct StepCounts {
    int awake = 0;     ///< bodies simulated in the step, those that fell asleep in it included
    int touching = 0;  ///< contacts that touch, as its narrow phase found
    int contacts = 0;  ///< kept after it, touching or not
};

class EngineRun {
public:
    virtual ~EngineRun() = default;
    /// One time step of the scene with its iterations, then the scene's spawns due after it.
    virtual void Step() = 0;
    [[nodiscard]] virtual int GetStep() const = 0;
    /// Times of the last step.
    [[nodiscard]] virtual StepTimes GetTimes() const = 0;
    /// Contacts kept now, touching or not (cheap: no capture).
    [[nodiscard]] virtual int GetContactCount() const = 0;
    /// Counts of the last step. Call it after every step or never: a step that was not counted blurs who fell asleep.
    [[nodiscard]] virtual StepCounts CountStep() = 0;
    /// Time spent so far in creating world, bodies, fixtures and joints, spawned ones included, ms.
    [[nodiscard]] virtual double GetCreateMilliseconds() const = 0;
    /// Largest number of heap bytes that the engine held so far.
    [[nodiscard]] virtual int64_t GetPeakBytes() const = 0;
    /// Replaces everything in `snapshot`. Box2D's reported pairs are counted from nodes and fixtures: 0 without them.
    virtual void Capture(Snapshot& snapshot, const CaptureParts& parts = {}) = 0;

    EngineRun() = default;
    EngineRun(const EngineRun&) = delete;
    EngineRun& operator=(const EngineRun&) = delete;
};

/// A run at one moment, to the bit. Only the run that made it reads it.
class RunImage {
public:
    virtual ~RunImage() = default;
    [[nodiscard]] virtual std::size_t GetBytes() const = 0;

    RunImage() = default;
    RunImage(const RunImage&) = delete;
    RunImage& operator=(const RunImage&) = delete;
};

/// A run that takes what a user does with the mouse and the keyboard.
class InteractiveRun : public EngineRun {
public:
    /// What indices of bodies mean: the scene with all that was shot into it.
    [[nodiscard]] virtual const scenes::Scene& GetScene() const = 0;
    /// How it runs, with what the scene decides filled in.
    [[nodiscard]] virtual const RunSpec& GetSpec() const = 0;
    /// From the next step on. Throws std::invalid_argument, and changes nothing then, for a value outside its range and
    /// for another value of a key that cannot change while a scene runs.
    virtual void Apply(const RunSpec& spec) = 0;
    /// Pulls a point of a dynamic body (in its coordinates) by a spring; a drag that was going on ends. Throws
    /// std::invalid_argument for another body. At first the spring pulls to where the point is.
    virtual void BeginDrag(int body, Vec2 localPoint) = 0;
    /// Where to, world, m. Nothing without a drag.
    virtual void MoveDrag(Vec2 target) = 0;
    virtual void EndDrag() = 0;
    /// Adds a small heavy circle that nothing lets through; returns its body index. It takes the index of the scene's
    /// next spawn, and those that are still to come move up.
    virtual int ShootBullet(Vec2 position, Vec2 velocity) = 0;
    /// Changes a body; its mass follows. Throws std::invalid_argument, and changes nothing then, for illegal values and
    /// for an engine that has no edits here.
    virtual void Edit(int body, const BodyEdit& edit) = 0;

    /// What the engine itself says of an object, by its index in a capture; empty: it does not tell.
    [[nodiscard]] virtual RunValues ValuesOfBody(int) const { return {}; }
    [[nodiscard]] virtual RunValues ValuesOfFixture(int) const { return {}; }
    [[nodiscard]] virtual RunValues ValuesOfJoint(int) const { return {}; }

    /// Everything as it is now; null: the engine has no images.
    [[nodiscard]] virtual std::shared_ptr<const RunImage> Save() const { return nullptr; }
    /// Back to an image of this run. What follows is what followed then, if the same is done.
    virtual void Restore(const RunImage&) {}
    /// The world as it is now, with the spawns that are still to come. Throws std::invalid_argument for an engine that
    /// no capture header records.
    [[nodiscard]] virtual scenes::Scene MakeScene() const = 0;

    /// Writes all steps from now on as a track, with contacts, in place of one that was written before. Throws
    /// std::invalid_argument for an engine that no capture header records.
    virtual void Record(const std::string& path, const TrackContents& contents) = 0;
    /// The track is whole afterwards. Throws std::runtime_error if it could not be written.
    virtual void EndRecord() = 0;
};

/// Radius of a bullet, m.
inline constexpr float bulletRadius = 0.25f;

/// What runs start from: a scene, and where there is more of it, the exact world of our engine or a recorded motion.
struct RunStart {
    RunStart(scenes::Scene start) : scene(std::move(start)) {}  // NOLINT: a scene is a start

    scenes::Scene scene;                        ///< beside a motion: all bodies that ever were (TrackFile::GetParts)
    std::shared_ptr<const SavedWorld> world{};  ///< our engine goes on with it bit for bit; null: it makes the scene
    std::shared_ptr<TrackFile> motion{};        ///< broad phases follow it; null: engines simulate
    int step = 0;                               ///< of the motion, from which it is followed
};

/// Loads a copy of a scene. Throws std::invalid_argument for a spec that the engine cannot run, or a scene that it
/// refuses.
std::unique_ptr<InteractiveRun> MakeScreeRun(const scenes::Scene& scene, const RunSpec& spec,
                                             const RunNeeds& needs = {});
std::unique_ptr<InteractiveRun> MakeBox2dRun(const scenes::Scene& scene, const RunSpec& spec,
                                             const RunNeeds& needs = {});

/// Goes on with a saved world of our engine. Throws std::invalid_argument also for a setting that is another one in the
/// world and cannot change there.
std::unique_ptr<InteractiveRun> MakeScreeRun(const SavedWorld& world, const RunSpec& spec, const RunNeeds& needs = {});

/// By the spec's engine; UsageError for one that is not in engine_list.h.
std::unique_ptr<InteractiveRun> MakeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs = {});

/// The same from a start without a motion.
std::unique_ptr<InteractiveRun> MakeRun(const RunStart& start, const RunSpec& spec, const RunNeeds& needs = {});

/// The engine's broad phase alone, following the motion of `source`, which it simulates besides: bodies, contacts and
/// hash are the source's; nodes, times, pairs and memory its own. The run itself where both are the same.
std::unique_ptr<EngineRun> MakeFollower(const RunStart& start, const RunSpec& spec, const RunSpec& source,
                                        const RunNeeds& needs = {});
/// The same following a recorded motion.
std::unique_ptr<EngineRun> MakeFollower(const RunStart& start, const RunSpec& spec);

}  // namespace testbed
