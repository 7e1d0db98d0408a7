// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs a scene and hands over the snapshots of the steps that were asked for.

#include "testbed/jobs/overlap/show_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/jobs/overlap/tree_quality.h"

namespace testbed {

namespace {

constexpr std::array<std::string_view, 2> worstByNames = {"time", "overlap"};

/// A step that is among the worst so far.
struct Candidate {
    double score;
    std::vector<Snapshot> snapshots;
};

double BroadPhaseTime(const SideBySide& engines) {
    double time = 0;
    for (const TimingSeries& series : engines.GetTiming()) {
        time = std::max(time, series.steps.back().times.broadPhase);
    }
    return time;
}

double SiblingOverlap(std::span<const Snapshot> snapshots) {
    double overlap = 0;
    for (const Snapshot& snapshot : snapshots) {
        overlap = std::max(overlap, MeasureTree(snapshot.nodes, snapshot.fixtures).siblingOverlap);
    }
    return overlap;
}

/// Keeps the step the engines are at if it is among the worst. Of equals the earlier step stays.
void Offer(SideBySide& engines, const StepSelection& selection, std::vector<Candidate>& kept) {
    const bool byTime = selection.worstBy == WorstBy::time;
    const bool full = static_cast<int>(kept.size()) == selection.worst;
    double score = byTime ? BroadPhaseTime(engines) : 0;
    // By time, most steps need no capture at all.
    if (byTime && full && score <= kept.back().score) return;
    std::vector<Snapshot> snapshots = engines.Capture();
    if (!byTime) score = SiblingOverlap(snapshots);
    if (full && score <= kept.back().score) return;
    if (full) kept.pop_back();
    const auto place = std::find_if(kept.begin(), kept.end(), [&](const Candidate& c) { return score > c.score; });
    kept.insert(place, Candidate{score, std::move(snapshots)});
}

}  // namespace

int StepSelection::Count() const { return worst > 0 ? std::min(worst, range.Count()) : range.Count(); }

StepSelection SelectSteps(const StepArguments& arguments, const SceneInput& input) {
    StepSelection selection;
    selection.range = {input.showStep, input.showStep, 1};
    if (arguments.step) {
        if (*arguments.step < 1 || *arguments.step > maxStep) {
            throw UsageError(fmt::format("--step {}: steps are legal from 1 to {}", *arguments.step, maxStep));
        }
        selection.range = {*arguments.step, *arguments.step, 1};
    }
    if (arguments.worst) selection.range = FullRun(input);
    if (!arguments.steps.empty()) selection.range = ParseSteps(arguments.steps, false);
    if (arguments.worst) {
        if (*arguments.worst < 1 || *arguments.worst > maxWorst) {
            throw UsageError(fmt::format("--worst {}: legal from 1 to {}", *arguments.worst, maxWorst));
        }
        if (std::find(worstByNames.begin(), worstByNames.end(), arguments.worstBy) == worstByNames.end()) {
            throw UsageError(DescribeUnknown("measure for --worst-by", arguments.worstBy, worstByNames));
        }
        selection.worst = *arguments.worst;
        selection.worstBy = arguments.worstBy == "time" ? WorstBy::time : WorstBy::overlap;
    }
    CheckSteps(selection.range, input);
    return selection;
}

StepRange FullRun(const SceneInput& input) { return {input.firstStep + 1, input.steps, 1}; }

void CheckSteps(const StepRange& range, const SceneInput& input) {
    if (input.HasStep(range.first) && input.HasStep(range.last)) return;
    throw UsageError(fmt::format("{}: steps {}:{} are not in its motion; give some from {} to {}", input.name,
                                 range.first, range.last, input.firstStep + 1, input.steps));
}

std::vector<SceneJob> MakeJobs(const std::vector<std::string>& names, const SceneArguments& run,
                               const StepArguments& steps) {
    if (names.empty()) throw UsageError("which scene? Give its name or its file; `scree list` shows all names");
    std::vector<SceneJob> jobs;
    for (SceneInput& input : ChooseScenes(names, run.size, run.input)) {
        const StepSelection selection = SelectSteps(steps, input);
        jobs.push_back({std::move(input), selection});
    }
    return jobs;
}

std::filesystem::path StepFolder(const Snapshot& snapshot) {
    return std::filesystem::path(snapshot.scene) / fmt::format("step-{:04}", snapshot.step);
}

void ShowSteps(SideBySide& engines, const StepSelection& selection, int runTo, Progress& progress,
               const std::function<void(std::span<const Snapshot>)>& show,
               const std::function<void(const StepVisits&)>& prepare) {
    std::vector<Candidate> kept;
    const int last = std::max(selection.range.last, runTo);
    while (engines.GetStep() < last) {
        engines.Step();
        progress.Advance(1);
        if (!selection.range.Contains(engines.GetStep())) continue;
        if (selection.worst > 0) {
            Offer(engines, selection, kept);
        } else {
            show(engines.Capture());
            progress.Advance(workPerPicture);
        }
    }
    std::sort(kept.begin(), kept.end(), [](const Candidate& a, const Candidate& b) {
        return a.snapshots.front().step < b.snapshots.front().step;
    });
    if (prepare && kept.size() > 1) {
        prepare([&kept](const auto& visit) {
            for (const Candidate& candidate : kept) visit(candidate.snapshots);
        });
    }
    for (const Candidate& candidate : kept) {
        show(candidate.snapshots);
        progress.Advance(workPerPicture);
    }
}

}  // namespace testbed
