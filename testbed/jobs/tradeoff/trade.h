// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Measuring the trade between speed and accuracy: every law under every setting of all engines. Errors are measured
// once, since runs are deterministic; the cost several times, in turns with the other settings.

#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/base/statistics.h"
#include "testbed/engines/panes.h"
#include "testbed/jobs/tradeoff/law.h"
#include "testbed/jobs/tradeoff/pareto.h"
#include "testbed/jobs/tradeoff/scene_law.h"

namespace testbed {

// The settings of the grid, in a laboratory: nothing falls asleep, and our engine keeps Box2D's caps of speed.
[[nodiscard]] RunSpec GetSequential(std::string_view engine, int velocityIterations = 8, int positionIterations = 3,
                                    int rate = 60);
[[nodiscard]] RunSpec GetSoft(int substeps, int rate = 60, std::string_view engine = "scree");
/// What a mark of our accuracy dial stands for.
[[nodiscard]] RunSpec GetDial(Accuracy mark, int rate = 60);

/// All settings to try, Box2D's default first. Sequential impulses of Box2D and ours come with several iterations and
/// time steps. The soft steps of ours and, where it is built in, of Box2D 3 come with several sub-steps and time steps.
[[nodiscard]] std::vector<RunSpec> MakeGrid(Effort effort);
/// The grid with `common` applied to all settings but Box2D's default, which everything is compared with. Settings that
/// become the same count once. If `engines` is given, as ParsePanes takes it, its settings stand in place of the
/// grid's. Throws UsageError.
[[nodiscard]] std::vector<RunSpec> ChooseGrid(Effort effort, std::string_view engines,
                                              std::span<const TypedSetting> common);

/// What everything is compared with: Box2D 2.4.1 with 8 velocity and 3 position iterations at 60 Hz.
[[nodiscard]] RunSpec GetBaseline();

/// Box2D's default, our own 8/3 and the marks of our dial at 60 Hz: marked in plots.
[[nodiscard]] bool IsDefault(const RunSpec& setting);

/// One law under one setting.
struct TradeCase {
    std::string law;
    RunSpec setting;
    std::vector<double> errors;               ///< as Law::errors; infinity: the run failed
    Quartiles milliseconds;                   ///< processor time of the timed steps
    double bodyFrames = 0.0;                  ///< moving bodies × simulated time in 1/60 s
    std::shared_ptr<const SceneLaw> scene{};  ///< whose law it is; null: one of GetLaws

    /// ns per body and 1/60 s of simulated time.
    [[nodiscard]] Quartiles GetCost() const;
};

/// The laws of these cases: of mechanics in the order of GetLaws, then scenes as they come. Scenes live as long as the
/// cases.
[[nodiscard]] std::vector<const Law*> LawsOf(std::span<const TradeCase> cases);
/// The law of one of them.
[[nodiscard]] const Law& LawOf(const TradeCase& one);

struct TradePlan {
    Effort effort = Effort::full;
    int repeats = 9;
    int bodies = 1024;  ///< of a timed scene, about
};

/// The law under the given settings. `advance` is called after each measured setting and each timed run.
[[nodiscard]] std::vector<TradeCase> MeasureTrade(const Law& law, std::span<const RunSpec> settings,
                                                  const TradePlan& plan, const std::function<void()>& advance);

/// A user's scene for `seconds`, under settings that ChooseForScene chose. `advance` is called with the work done, of
/// CountSceneWork in all. All of `settings` decide about the references; those that `isWanted` are measured.
[[nodiscard]] std::vector<TradeCase> MeasureScene(const scenes::Scene& scene, std::span<const RunSpec> settings,
                                                  const std::vector<bool>& isWanted, const TradePlan& plan,
                                                  double seconds, const std::string& leftOut,
                                                  const std::function<void(double work)>& advance);
[[nodiscard]] double CountSceneWork(std::span<const RunSpec> settings, const std::vector<bool>& isWanted,
                                    const TradePlan& plan, double seconds);

/// Error of quantity `index`, floored at its rounding; what is not finite is infinity.
[[nodiscard]] double FlooredError(const Law& law, const TradeCase& one, std::size_t index = 0);

/// Whether nothing of the scenario was left to measure: an error is not finite, or as large as a failure is.
[[nodiscard]] bool HasFailed(const Law& law, const TradeCase& one);

/// A case as the fields of a JSON line and back. Throws FileError for fields that are not there, for an unknown
/// law and for another number of errors than its own. Cases of one scene share what was found of it: AddCase.
[[nodiscard]] nlohmann::ordered_json ToJson(const TradeCase& one);
[[nodiscard]] TradeCase TradeCaseFromJson(const nlohmann::ordered_json& fields);
/// Puts a case to the others. Throws FileError for a scene of which the others say something else, and for a setting
/// that is there.
void AddCase(std::vector<TradeCase>& cases, TradeCase one);

}  // namespace testbed
