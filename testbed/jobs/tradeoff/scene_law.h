// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A user's scene as a law. Nobody knows its exact motion, so each family of settings has a reference: itself with much
// finer steps. The distance to it is the error, up to the time at which a reference and one half as fine part. From
// there on small causes decide, and a distance means nothing. Overlap and joint gaps are measured over the whole run,
// by StateJudge, alike for all engines.

#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbed/engines/state_judge.h"
#include "testbed/jobs/tradeoff/law.h"

namespace testbed {

/// What a family is measured against.
struct SceneReference {
    Family family = Family::box2d;
    std::string setting{};           ///< as PrintSpec writes it
    std::string coarser{};           ///< the one half as fine
    std::optional<double> parted{};  ///< s after the start: from here on both are too far apart; none: never
    double apart = 0.0;              ///< of both, at most, within the window, m
    double fromOurs = 0.0;           ///< of this one and ours, at most, within the window, m
};

/// What was found of a scene before its settings were measured.
struct SceneFacts {
    std::string scene{};
    int dynamicBodies = 0;
    double seconds = 0.0;      ///< simulated
    double window = 0.0;       ///< up to here distance and energy have a meaning, s; 0: nowhere
    double bodySize = 1.0;     ///< StateJudge::GetBodySize
    double distanceFloor = 0;  ///< of distances, m: what references and coarser ones are apart
    double energyFloor = 0;    ///< the same of energies, J/kg
    bool hasJoints = false;
    std::vector<SceneReference> references{};
    std::string leftOut{};  ///< engines that refuse the scene, and why; empty: none
};

/// A case's law where it is no law of mechanics.
struct SceneLaw {
    SceneFacts facts;
    Law law;  ///< without `measure` and `costScene`
};

/// What names of such laws begin with: files, columns and lines.
inline constexpr std::string_view scenePrefix = "scene-";
[[nodiscard]] std::string NameSceneLaw(const std::string& scene);

/// From when on references count as parted: this share of the size of bodies.
inline constexpr double partedShare = 0.01;
/// A window shorter than this is none, s.
inline constexpr double leastWindow = 0.1;
/// Simulated time that may be asked for, s.
inline constexpr double leastSceneSeconds = 0.1, mostSceneSeconds = 3600.0;
/// Simulated time between two measurements, s: all steps of the grid fit into it.
inline constexpr double sampleInterval = 1.0 / 30.0;

[[nodiscard]] std::shared_ptr<const SceneLaw> MakeSceneLaw(const SceneFacts& facts);
[[nodiscard]] nlohmann::ordered_json ToJson(const SceneFacts& facts);
/// Throws FileError, or what the JSON library throws for a field that is not there.
[[nodiscard]] SceneFacts SceneFactsFromJson(const nlohmann::ordered_json& fields);

/// The settings with which this scene can be run: all of an engine that refuses it are taken out, with its words in
/// `leftOut`. Throws UsageError where nothing moves in the scene, or where the baseline or ours refuses it.
[[nodiscard]] std::vector<RunSpec> ChooseForScene(const scenes::Scene& scene, std::span<const RunSpec> settings,
                                                  std::string& leftOut);

/// Measures settings on one scene. Deterministic, but for times.
class SceneMeter {
public:
    using Advance = std::function<void(double work)>;  ///< work: as CountWork counts it

    /// Runs the references of all families among `settings`, which ChooseForScene chose.
    SceneMeter(const scenes::Scene& scene, std::span<const RunSpec> settings, Effort effort, double seconds,
               const std::string& leftOut, const Advance& advance);
    ~SceneMeter();

    [[nodiscard]] const std::shared_ptr<const SceneLaw>& GetLaw() const { return m_law; }
    /// One value per error of the law.
    [[nodiscard]] std::vector<double> MeasureErrors(const RunSpec& setting, const Advance& advance);
    /// Processor time of all steps of a run, ms.
    [[nodiscard]] double TimeRun(const RunSpec& setting, const Advance& advance) const;

    /// Work of the references.
    [[nodiscard]] static double CountReferenceWork(std::span<const RunSpec> settings, Effort effort, double seconds);
    /// Work of one run of a setting: its steps, weighted with their sub-steps or iterations.
    [[nodiscard]] static double CountWork(const RunSpec& setting, double seconds);

private:
    struct Trajectory;
    [[nodiscard]] Trajectory Follow(const RunSpec& setting, bool isJudged, const Advance& advance);
    [[nodiscard]] double FindDistance(const Trajectory& one, const Trajectory& other, double until) const;

    scenes::Scene m_scene;
    double m_seconds;
    StateJudge m_judge;
    std::vector<std::pair<Family, std::unique_ptr<Trajectory>>> m_references;
    std::shared_ptr<const SceneLaw> m_law;
};

/// Simulated time of a scene if none was asked for, s.
[[nodiscard]] double GetSceneSeconds(const scenes::Scene& scene, Effort effort);

}  // namespace testbed
