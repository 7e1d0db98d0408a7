// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of targets and the laws that are judged on it.

#include "testbed/jobs/bench/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/catalog.h"
#include "testbed/base/statistics.h"

namespace testbed {
namespace {

constexpr SpeedTarget speedTargets[] = {
    {"slow-explosion", 5461, 24.1, 24.1, 9.9, 1.5},
    {"big-mobile", 6856, 4.5, 6.4, 26.2, 4.2},
    {"mixed", 7656, 8.3, 11.8, 80.5, 20},
    {"diagonal", 10185, 7.7, 10.7, 40.0, 5.7},
    {"mostly-static-multi", 542, 25.3, 26.1, 26.7, 0.57},
    {"mostly-static-single", 104, 6.1, 6.1, 23.7, 0.57},
    {"multi-fixture", 48647, 75.8, 108.8, 1352, 2.8},
    {"n2", 1783, 12.9, 12.9, 584, 68},
    {"mild-n2", 6834, 12.5, 12.5, 2383, 170},
    {"add-pair", 57106, 255.5, 274.2, 8392, 4.1},
    {"tumbler", 3514, 8.1, 10.0, 7.2, 1.6},
    {"falling-circles", 16004, 16.1, 18.9, 39.1, 2.1},
    {"falling-squares", 13819, 9.3, 14.3, 22.5, 2.8},
    {"tiles", 2099, 12.3, 12.3, 56.5, 3.7},
};
constexpr double meanRatioOne = 16, meanRatioTwo = 18;

/// So many times as fast as the fastest of all rivals that ran beside it, with as many threads at most.
constexpr double rivalRatio = 3;

/// Stability of the step time: p99 and maximum at most this share of Box2D's, in the scenes where it spikes.
constexpr double spikeShare = 0.2;
constexpr std::array<std::string_view, 5> spikyScenes = {"tiles", "add-pair", "n2", "mild-n2", "multi-fixture"};

/// Two threads against one: this much faster where many bodies move, and never slower by more than 3 %.
constexpr double speedUp = 1.5, noSlower = 0.97;
constexpr int manyMovers = 2000;

constexpr double continuousCost = 1.3;
constexpr std::array<std::string_view, 3> continuousScenes = {"mixed", "diagonal", "falling-squares"};

/// Stage gates, ns on the machine of the table. They are scaled by Box2D's total here / there, in the same run.
constexpr double boxUpdateNs = 5, buildAndDetectNs = 25, matchNs = 14;  // per moving box, per box, per kept contact
constexpr double narrowNs = 25;                                         // per persisting contact
constexpr double contactNs = 55, isolatedNs = 15;  // soft step n = 4: per touching contact, per body
constexpr std::array<std::string_view, 3> gateScenes = {"slow-explosion", "falling-squares", "tiles"};

/// Worlds of growing size: time per body and step grows no faster than the logarithm of the bodies.
constexpr std::array<std::string_view, 3> largeScenes = {"slow-explosion", "falling-squares", "tiles"};

/// Rows of one scene at its default size, by role; a run of fewer steps (unless it was stopped) judges nothing.
struct SceneRows {
    std::span<const BenchRow> all;
    std::string_view scene;
    int size = 0;
    int steps = 0;

    [[nodiscard]] bool Has(const BenchRow& row) const {
        return row.scene == scene && row.size == size && (row.steps == steps || !row.complete);
    }

    /// The fastest of our rows with that many threads; rows that are not void come first. Null: none.
    [[nodiscard]] const BenchRow* Ours(int threads, bool continuous = false) const {
        const BenchRow* best = nullptr;
        const auto key = [](const BenchRow& row) {
            const bool hasTime = row.threads == 1 && row.cpuMs > 0;
            return std::pair(!row.voidReason.empty(), hasTime ? row.cpuMs : row.totalMs);
        };
        for (const BenchRow& row : all) {
            if (!Has(row) || row.engine != "scree" || row.threads != threads || row.continuous != continuous) continue;
            if (best == nullptr || key(row) < key(*best)) best = &row;
        }
        return best;
    }
    /// The fastest row of another engine with at most that many threads, whatever work it did.
    [[nodiscard]] const BenchRow* Rival(int threads) const {
        const BenchRow* best = nullptr;
        for (const BenchRow& row : all) {
            if (!Has(row) || row.engine == "scree" || row.threads > threads || row.continuous) continue;
            if (best == nullptr || row.totalMs < best->totalMs) best = &row;
        }
        return best;
    }
    [[nodiscard]] const BenchRow* Box2d() const {
        for (const BenchRow& row : all) {
            if (Has(row) && row.engine == "box2d" && !row.continuous) return &row;
        }
        return nullptr;
    }
};

/// Of processor times, which other programs do not lengthen; of wall times where ours has several threads.
double Ratio(const BenchRow& one, const BenchRow& ours) {
    const bool hasTimes = one.cpuMs > 0 && ours.cpuMs > 0 && ours.threads == 1;
    return hasTimes ? one.cpuMs / ours.cpuMs : one.totalMs / ours.totalMs;
}

SceneRows RowsOf(std::span<const BenchRow> rows, std::string_view scene) {
    const scenes::SceneInfo& info = *scenes::Find(scene);  // the table names scenes of the catalogue
    return {rows, scene, info.defaultSize, info.steps};
}

/// Judges a number that is known only as a bound when a run was stopped: what the bound cannot decide is not measured.
struct Judge {
    std::vector<TargetResult>& results;

    void NotMeasured(std::string law, std::string_view scene) {
        results.push_back({.law = std::move(law), .scene = std::string(scene)});
    }
    void Add(TargetResult result, const BenchRow& row, const BenchRow* other) {
        const bool good = result.atLeast ? result.measured >= result.needed : result.measured <= result.needed;
        result.verdict = good ? Verdict::met : Verdict::missed;
        result.note = row.solver;
        if (!row.complete) {
            result.verdict = Verdict::missed;
            result.note += ", stopped at the time limit";
        } else if (!row.voidReason.empty()) {
            result.verdict = Verdict::isVoid;
            result.note += ": " + row.voidReason;
        } else if (other != nullptr && !other->complete) {
            // The other took longer than measured: what is met stays met.
            if (!good) result.verdict = Verdict::notMeasured;
            result.note += ", the other stopped at the time limit";
        }
        results.push_back(std::move(result));
    }
};

void JudgeTotals(const SpeedTarget& target, const SceneRows& rows, Judge& judge) {
    const BenchRow* box2d = rows.Box2d();
    for (const int threads : {1, 2}) {
        const std::string law = fmt::format("total, {} thread{}", threads, threads == 1 ? "" : "s");
        const BenchRow* ours = rows.Ours(threads);
        if (ours == nullptr || box2d == nullptr) {
            judge.NotMeasured(law, target.scene);
            continue;
        }
        judge.Add({.law = law,
                   .scene = std::string(target.scene),
                   .measured = Ratio(*box2d, *ours),
                   .needed = threads == 1 ? target.ratioOne : target.ratioTwo},
                  *ours, box2d);
    }
}

/// What must not be above a share of Box2D's.
/// Box2D alone is no judge: `total` has its own ratio for it.
void JudgeRivals(const SceneRows& rows, Judge& judge) {
    const auto isOther = [&](const BenchRow& row) {
        return rows.Has(row) && row.engine != "scree" && row.engine != "box2d" && !row.continuous;
    };
    for (const int threads : {1, 2}) {
        const std::string law = fmt::format("best rival, {} thread{}", threads, threads == 1 ? "" : "s");
        const BenchRow* ours = rows.Ours(threads);
        const BenchRow* rival = rows.Rival(threads);
        if (ours == nullptr || rival == nullptr || std::ranges::none_of(rows.all, isOther)) {
            judge.NotMeasured(law, rows.scene);
            continue;
        }
        judge.Add(
            {.law = law, .scene = std::string(rows.scene), .measured = Ratio(*rival, *ours), .needed = rivalRatio},
            *ours, rival);
        judge.results.back().note += fmt::format(", against {}", rival->engine);
    }
}

void JudgeShare(const std::string& law, double share, double BenchRow::*field, const SceneRows& rows, Judge& judge) {
    const BenchRow* box2d = rows.Box2d();
    const BenchRow* ours = rows.Ours(1);
    if (ours == nullptr || box2d == nullptr) {
        judge.NotMeasured(law, rows.scene);
        return;
    }
    judge.Add({.law = law,
               .scene = std::string(rows.scene),
               .measured = ours->*field,
               .needed = share * box2d->*field,
               .atLeast = false},
              *ours, box2d);
}

void JudgeMemory(const SceneRows& rows, Judge& judge) {
    const BenchRow* box2d = rows.Box2d();
    const BenchRow* ours = rows.Ours(1);
    if (ours == nullptr || box2d == nullptr || ours->steps != box2d->steps) {
        judge.NotMeasured("peak memory, MB", rows.scene);
        return;
    }
    judge.Add({.law = "peak memory, MB",
               .scene = std::string(rows.scene),
               .measured = static_cast<double>(ours->peakBytes) / 1e6,
               .needed = static_cast<double>(box2d->peakBytes) / 1e6,
               .atLeast = false},
              *ours, box2d);
}

void JudgeThreads(const SceneRows& rows, Judge& judge) {
    const BenchRow* one = rows.Ours(1);
    const BenchRow* two = rows.Ours(2);
    if (one == nullptr || two == nullptr) {
        judge.NotMeasured("2 threads against 1", rows.scene);
        return;
    }
    judge.Add({.law = "2 threads against 1",
               .scene = std::string(rows.scene),
               .measured = one->totalMs / two->totalMs,
               .needed = one->movers > manyMovers ? speedUp : noSlower},
              *two, nullptr);
}

void JudgeContinuous(const SceneRows& rows, Judge& judge) {
    const BenchRow* off = rows.Ours(1);
    const BenchRow* on = rows.Ours(1, true);
    if (off == nullptr || on == nullptr) {
        judge.NotMeasured("continuous on against off", rows.scene);
        return;
    }
    judge.Add({.law = "continuous on against off",
               .scene = std::string(rows.scene),
               .measured = Ratio(*on, *off),
               .needed = continuousCost,
               .atLeast = false},
              *on, nullptr);
}

/// Our stage times against the sum of the gates for what the run dealt with.
void JudgeGates(const SpeedTarget& target, const SceneRows& rows, Judge& judge) {
    const BenchRow* box2d = rows.Box2d();
    const BenchRow* ours = rows.Ours(1);
    if (ours == nullptr || box2d == nullptr || !box2d->complete) {
        judge.NotMeasured("stage gates", target.scene);
        return;
    }
    const double scale = box2d->totalMs / target.boxTwoDMs * 1e-6;  // ns there → ms here
    const auto bodies = static_cast<double>(ours->awakeBodySteps), touching = static_cast<double>(ours->touchingSum);
    const auto contacts = static_cast<double>(ours->contactSum);
    const StageTotals& s = ours->stages;
    const auto add = [&](const char* law, double measured, double needed) {
        judge.Add({.law = law,
                   .scene = std::string(target.scene),
                   .measured = measured,
                   .needed = needed * scale,
                   .atLeast = false},
                  *ours, box2d);
    };
    add("gate: broad phase, ms", s.broadPhase, (boxUpdateNs + buildAndDetectNs) * bodies + matchNs * contacts);
    add("gate: narrow phase, ms", s.narrowPhase, narrowNs * contacts);
    add("gate: islands and solver, ms", s.islands + s.solver, contactNs * touching + isolatedNs * bodies);
}

void JudgeMean(std::span<const BenchRow> rows, int threads, double needed, Judge& judge) {
    TargetResult result{.law = fmt::format("geometric mean, {} thread{}", threads, threads == 1 ? "" : "s")};
    std::vector<double> ratios;
    for (const SpeedTarget& target : SpeedTargets()) {
        const SceneRows of = RowsOf(rows, target.scene);
        const BenchRow* ours = of.Ours(threads);
        const BenchRow* box2d = of.Box2d();
        if (ours == nullptr || box2d == nullptr || !ours->complete) {
            judge.results.push_back(result);
            return;
        }
        ratios.push_back(Ratio(*box2d, *ours));
        if (!ours->voidReason.empty())
            result.note += fmt::format("{}{}", result.note.empty() ? "void: " : ", ", of.scene);
    }
    result.measured = GeometricMean(ratios).value_or(0.0);
    result.needed = needed;
    result.verdict = !result.note.empty()        ? Verdict::isVoid
                     : result.measured >= needed ? Verdict::met
                                                 : Verdict::missed;
    judge.results.push_back(result);
}

/// The smallest against every larger size of a scene's rows.
void JudgeLargeWorlds(std::span<const BenchRow> rows, std::string_view scene, Judge& judge) {
    std::vector<const BenchRow*> ours;
    for (const BenchRow& row : rows) {
        if (row.scene == scene && row.engine == "scree" && row.threads == 1 && !row.continuous && row.movers >= 1000) {
            ours.push_back(&row);
        }
    }
    std::ranges::stable_sort(ours, {}, [](const BenchRow* row) { return row->movers; });
    for (const BenchRow* large : ours) {
        const BenchRow* small = ours.front();
        if (large->movers < 2 * small->movers || large->solver != small->solver) continue;
        judge.Add(
            {.law = fmt::format("ns per body, {} bodies against {}", large->movers, small->movers),
             .scene = std::string(scene),
             .measured = large->nsPerBodyStep / small->nsPerBodyStep,
             .needed = std::log(static_cast<double>(large->movers)) / std::log(static_cast<double>(small->movers)),
             .atLeast = false},
            *large, nullptr);
    }
}

bool Holds(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::span<const SpeedTarget> SpeedTargets() { return speedTargets; }

bool IsContinuousTarget(std::string_view scene) { return Holds(continuousScenes, scene); }

std::vector<TargetResult> JudgeTargets(std::span<const BenchRow> rows) {
    std::vector<TargetResult> results;
    Judge judge{results};
    for (const SpeedTarget& target : speedTargets) {
        const SceneRows of = RowsOf(rows, target.scene);
        JudgeTotals(target, of, judge);
        JudgeRivals(of, judge);
        JudgeShare("worst step, ms", target.worstMs / target.boxTwoDWorstMs, &BenchRow::maxMs, of, judge);
        if (Holds(spikyScenes, target.scene)) {
            JudgeShare("p99 of a step, ms", spikeShare, &BenchRow::p99Ms, of, judge);
            JudgeShare("maximum of a step, ms", spikeShare, &BenchRow::maxMs, of, judge);
        }
        JudgeShare("creation, ms", 1, &BenchRow::createMs, of, judge);
        JudgeMemory(of, judge);
        JudgeThreads(of, judge);
        if (IsContinuousTarget(target.scene)) JudgeContinuous(of, judge);
        if (Holds(gateScenes, target.scene)) JudgeGates(target, of, judge);
    }
    JudgeMean(rows, 1, meanRatioOne, judge);
    JudgeMean(rows, 2, meanRatioTwo, judge);
    for (const std::string_view scene : largeScenes) JudgeLargeWorlds(rows, scene, judge);
    return results;
}

std::string FormatTargets(std::span<const TargetResult> results) {
    std::string text =
        fmt::format("{:<13} {:<33} {:<21} {:>10}    {:>10}\n", "", "target", "scene", "measured", "needed");
    int counts[4] = {};
    for (const TargetResult& result : results) {
        constexpr std::string_view names[] = {"met", "MISSED", "void", "not measured"};
        const auto verdict = static_cast<std::size_t>(result.verdict);
        ++counts[verdict];
        if (result.verdict == Verdict::notMeasured && result.note.empty()) continue;
        text += fmt::format("{:<13} {:<33} {:<21} {:>10.3f} {:>2} {:>10.3f}  {}\n", names[verdict], result.law,
                            result.scene, result.measured, result.atLeast ? "≥" : "≤", result.needed, result.note);
    }
    return text +
           fmt::format("{} met, {} missed, {} void, {} not measured\n", counts[0], counts[1], counts[2], counts[3]);
}

bool HasMiss(std::span<const TargetResult> results) {
    return std::ranges::any_of(results, [](const TargetResult& result) {
        return result.verdict == Verdict::missed || result.verdict == Verdict::isVoid;
    });
}

}  // namespace testbed
