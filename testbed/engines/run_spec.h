// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How a scene is run: engine, solver, time step, gravity, threads and what else a program may choose of an engine. The
// table of keys is the one list of it: the command line's --set KEY=VALUE, what stands in sidecars, rows and pages, and
// the table of testbed/docs/settings.md follow it. Values are printed without comma, colon or blank, so that specs
// fit into lists of any kind. Numbers of a value may be typed with a comma between them, too.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "scenes/scene.h"

namespace testbed {

/// What an engine may be able to do beyond sleeping, warm starting and continuous collision.
enum class Ability : unsigned {
    softSteps = 1,     ///< sub-steps with soft contacts
    freeSpeed = 2,     ///< speed without caps
    lengthScales = 4,  ///< tolerances for worlds of another scale
    threads = 8,
    features = 16,     ///< a world that models a part of the engine
    broadPhases = 32,  ///< a choice of algorithms
    sequential = 64,   ///< sequential impulses
    dial = 128,        ///< the accuracy dial and tolerances
    softTuning = 256,  ///< how stiff the contacts of soft steps are
    joints = 512,      ///< a choice of how joints are solved
};

struct Abilities {
    unsigned bits = 0;
    [[nodiscard]] bool Has(Ability ability) const { return (bits & static_cast<unsigned>(ability)) != 0; }
};
inline constexpr int maxThreads = 64;

struct Iterations {
    int velocity = 8;  ///< 1 … 200
    int position = 3;  ///< 0 … 200

    friend bool operator==(const Iterations&, const Iterations&) = default;
};

/// Sequential impulses: Box2D 2.4's solver and ours.
struct SequentialImpulses {
    std::optional<Iterations> iterations{};  ///< none: the scene's

    friend bool operator==(const SequentialImpulses&, const SequentialImpulses&) = default;
};

/// Sub-steps with soft contacts.
struct SoftStep {
    int substeps = 4;  ///< 1 … 64

    friend bool operator==(const SoftStep&, const SoftStep&) = default;
};

/// A mark of the engine's dial, scree::Accuracy.
enum class Accuracy { draft, game, fine, precise };

/// Errors to stay below, scree::Tolerance.
struct Tolerance {
    float overlap = 0.01f;    ///< of two shapes, m
    float jointGap = 0.001f;  ///< m
    int leastSubsteps = 4;    ///< 1 … 64
    int mostSubsteps = 32;    ///< leastSubsteps … 64

    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

using Solver = std::variant<SequentialImpulses, SoftStep, Accuracy, Tolerance>;

/// The defaults are the engine's own: what a program gets that chooses nothing.
struct RunSpec {
    std::string engine = "scree";  ///< a name of engine_list.h
    Solver solver{};
    std::optional<double> timeStep{};       ///< s, 0.0001 … 0.1; none: the scene's
    std::optional<scenes::Vec2> gravity{};  ///< m/s²; none: the scene's
    bool caps = false;                      ///< speed capped at 2 m and π/2 per step; Box2D always does
    bool continuous = true;                 ///< nothing passes through static fixtures between two steps
    bool sleeping = true;                   ///< bodies at rest fall asleep
    bool warmStarting = true;               ///< a step begins with the impulses of the last one
    bool directJoints = true;               ///< soft step: joints are solved directly where they can be, not in turn
    std::optional<float> contactHertz{};    ///< of soft contacts, 1/s; this and the next two none: the engine's own
    std::optional<float> contactDamping{};  ///< of soft contacts: damping ratio
    std::optional<float> pushSpeed{};       ///< at which soft contacts push overlapping bodies apart at most, m/s
    float lengthScale = 1.0f;               ///< of a typical body, m: tolerances are Box2D's times this
    int threads = 1;                        ///< that share a step, 1 … maxThreads
    std::string features = "automatic";     ///< what the world models: automatic, full, none, or names joined by +
    std::string broadPhase = "auto";        ///< a name of scree::broadPhaseNames

    friend bool operator==(const RunSpec&, const RunSpec&) = default;
};

[[nodiscard]] bool IsSequential(const RunSpec& spec);

/// Settings by name: `own` (an engine's defaults) and `like-box2d` (what Box2D 2.4 does, as the published comparison
/// has it: speed caps, no continuous collision).
struct Preset {
    std::string_view name, what;
    std::string_view settings;  ///< what differs from the engine's own, as PrintSettings writes it
};
[[nodiscard]] std::span<const Preset> GetPresets();
inline constexpr std::string_view ownPreset = "own", likeBox2dPreset = "like-box2d";

/// An engine's defaults, or the settings of a preset in it. Throws UsageError with the nearest name for an unknown one.
[[nodiscard]] RunSpec MakeSpec(std::string_view engine, std::string_view preset = ownPreset);

/// One way to say one thing about a run.
struct SettingKey {
    std::string_view name;
    std::string_view values;  ///< what it takes, in words
    std::string_view unit;    ///< empty: none
    std::string_view what;
    std::string_view flag;  ///< the option that commands have for it; empty: none
    unsigned needs;         ///< bits of the abilities without which an engine does not have it
    bool isLive;            ///< may change while a scene runs
    /// Puts a value into the spec; returns what is wrong with it, empty: nothing.
    std::string (*read)(std::string_view value, RunSpec& spec);
    /// The value in canonical form; empty: another key says it.
    std::string (*print)(const RunSpec& spec);
};
/// In the order in which they are printed.
[[nodiscard]] std::span<const SettingKey> GetSettingKeys();

/// The key's row; UsageError beginning with `source` and naming the nearest key for an unknown one.
[[nodiscard]] const SettingKey& FindSettingKey(std::string_view name, std::string_view source = "--set");

/// "KEY=VALUE" into the spec. False: the spec's engine has no such setting or value; nothing is changed then. Throws
/// UsageError beginning with `source` for an unknown key and for what is no value of it.
bool ApplySetting(RunSpec& spec, std::string_view setting, std::string_view source = "--set");
/// Several of them, separated by blanks; what the engine does not have is left out.
void ApplySettings(RunSpec& spec, std::string_view settings);

/// Whether the engine of that name has the setting at all.
[[nodiscard]] bool HasSetting(std::string_view engine, const SettingKey& key);

/// The shortest list of KEY=VALUE with blanks between that makes this spec out of its engine's defaults; empty for
/// these. ApplySettings of it to MakeSpec(spec.engine) gives the spec again.
[[nodiscard]] std::string PrintSettings(const RunSpec& spec);
/// "scree" or "scree:solver=soft@8:threads=2", as --engines takes it.
[[nodiscard]] std::string PrintSpec(const RunSpec& spec);

/// What is wrong with a spec's numbers, or with what its engine is asked for; empty: nothing.
[[nodiscard]] std::string FindProblem(const RunSpec& spec);

/// Iterations, time step and gravity from the scene where the spec leaves them to it.
[[nodiscard]] RunSpec Resolve(const RunSpec& spec, const scenes::Scene& scene);

/// Of a spec that leaves it to the scene: 1/60 s.
[[nodiscard]] double GetTimeStep(const RunSpec& spec);
/// Steps per second, rounded.
[[nodiscard]] int GetRate(const RunSpec& spec);

/// "8/3", "soft 4", "fine", "tolerance 0.01/0.001/4/32"; "si" for the scene's iterations.
[[nodiscard]] std::string NameSolver(const RunSpec& spec);

/// A line per key for --help.
[[nodiscard]] std::string DescribeSettingKeys();
/// The table of testbed/docs/settings.md: Markdown.
[[nodiscard]] std::string WriteSettingTable();

}  // namespace testbed
