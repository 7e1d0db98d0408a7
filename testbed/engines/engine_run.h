// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene running in one engine. run_scree.cpp and run_box2d.cpp implement it; outside of this
// folder only what abuses an engine on purpose includes an engine's header.

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/snapshot.h"

namespace testbed {

/// What a capture must contain beyond bodies, counts, times and hash; leaving a part out saves its time.
struct CaptureParts {
    bool fixtures = true;
    bool contacts = true;
    bool joints = true;
    bool nodes = true;
    bool pairs = true;  ///< Box2D's reported pairs, which take a search; 0 without
};

inline constexpr int maxThreads = 64;

/// How a scene is to be run.
struct RunOptions {
    std::string broadPhase = "auto";  ///< ours only; a name of scree::broadPhaseNames
    int threads = 1;                  ///< ours, up to maxThreads
    int substeps = 0;                 ///< ours: of the soft step; 0: sequential impulses with the scene's iterations
    bool continuous = false;
    bool boxTwoDCaps = true;  ///< ours: cap speed at 2 m and π/2 per step as Box2D does
    bool sweptBoxes = false;  ///< keep the boxes before each step, for FixtureState::swept; untimed, O(fixtures)
    /// Ours, what the world models: "automatic", "full", or a fixed set as names with commas ("" is the empty set).
    std::string features = "automatic";
    /// Whose motion the broad phase sees: "own", or the engine ("scree", "box2d") whose run it follows. A following run
    /// simulates nothing itself: bodies, contacts and hash are its source's; nodes, times, pairs and memory its own.
    std::string poses = "own";
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

/// What may change while a scene runs. Changes take effect in the next step.
struct SolverSettings {
    float timeStep = 1.0f / 60.0f;  ///< s, 0.0001 … 0.1
    int velocityIterations = 8;     ///< 1 … 200
    int positionIterations = 3;     ///< 0 … 200
    int substeps = 0;               ///< ours: of the soft step, 0 … 64; 0: sequential impulses with the iterations
    Vec2 gravity{0.0f, -10.0f};     ///< m/s²
    bool sleeping = true;
    bool warmStarting = true;
    bool continuous = false;

    friend bool operator==(const SolverSettings&, const SolverSettings&) = default;
};

/// A run that takes what a user does with the mouse and the keyboard.
class InteractiveRun : public EngineRun {
public:
    [[nodiscard]] virtual SolverSettings GetSettings() const = 0;
    /// Throws std::invalid_argument for a value outside its range, and changes nothing then.
    virtual void Apply(const SolverSettings& settings) = 0;
    /// Pulls a point of a dynamic body (in its coordinates) by a spring; a drag that was going on ends. Throws
    /// std::invalid_argument for another body. At first the spring pulls to where the point is.
    virtual void BeginDrag(int body, Vec2 localPoint) = 0;
    /// Where to, world, m. Nothing without a drag.
    virtual void MoveDrag(Vec2 target) = 0;
    virtual void EndDrag() = 0;
    /// Adds a small heavy circle that nothing lets through; returns its body index. It takes the index of the scene's
    /// next spawn, and those that are still to come move up.
    virtual int ShootBullet(Vec2 position, Vec2 velocity) = 0;
};

/// Radius of a bullet, m.
inline constexpr float bulletRadius = 0.25f;

/// Loads a copy of a scene. Throws std::invalid_argument for an unknown broad phase, an option that the engine does not
/// have, or a scene that it refuses.
std::unique_ptr<InteractiveRun> MakeScreeRun(const scenes::Scene& scene, const RunOptions& options);
std::unique_ptr<InteractiveRun> MakeBox2dRun(const scenes::Scene& scene, const RunOptions& options);

/// By name, "scree" or "box2d", following RunOptions::poses. Throws std::invalid_argument for another name.
std::unique_ptr<EngineRun> MakeRun(std::string_view engine, const scenes::Scene& scene, const RunOptions& options);

/// The same for a run with a motion of its own; RunOptions::poses is not read.
std::unique_ptr<InteractiveRun> MakeInteractiveRun(std::string_view engine, const scenes::Scene& scene,
                                                   const RunOptions& options);

}  // namespace testbed
