// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of requirement.h.

#include "testbed/jobs/requires/requirement.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

#include "testbed/base/stopwatch.h"

namespace testbed {
namespace {

std::unique_ptr<InteractiveRun> Start(const scenes::Scene& scene, const RequirementTask& task,
                                      const std::string& features) {
    RunSpec spec = task.spec;
    spec.features = features;
    return MakeScreeRun(scene, spec);
}

/// One variant over all repeats.
struct Track {
    std::vector<double> best;           ///< ms, by step
    std::vector<std::uint64_t> hashes;  ///< by step, of the first repeat
    double bodySteps = 0;
};

void Describe(const FeatureFacts& facts, VariantCost& cost) {
    cost.kernels = facts.kernels;
    cost.bytesPerBody = facts.bytesPerBody;
    cost.bytesPerFixture = facts.bytesPerFixture;
    cost.bytesPerContact = facts.bytesPerContact;
    cost.bytesPerJoint = facts.joints > 0 ? facts.jointBytes / static_cast<std::size_t>(facts.joints) : 0;
}

/// One repeat; the first one also reads hashes, untimed.
void RunOnce(const scenes::Scene& scene, const RequirementTask& task, std::span<const Variant> variants, bool isFirst,
             std::span<Track> tracks, std::span<VariantCost> costs) {
    std::vector<std::unique_ptr<InteractiveRun>> runs;
    for (const Variant& variant : variants) runs.push_back(Start(scene, task, variant.features));
    const std::size_t count = runs.size();
    for (int step = 0; step < task.steps; ++step) {
        const auto at = static_cast<std::size_t>(step);
        for (std::size_t turn = 0; turn < count; ++turn) {
            const std::size_t i = (turn + at) % count;  // nobody is always the first
            runs[i]->Step();
            tracks[i].best[at] = std::min(tracks[i].best[at], runs[i]->GetTimes().step);
        }
        if (!isFirst) continue;
        for (std::size_t i = 0; i < count; ++i) {
            const FeatureFacts facts = GetFeatureFacts(*runs[i]);
            tracks[i].hashes.push_back(facts.stateHash);
            tracks[i].bodySteps += facts.bodies;
            if (step + 1 == task.steps) Describe(facts, costs[i]);
        }
    }
}

std::string Join(std::span<const std::string> words, std::string_view separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

std::vector<std::string> NamesOf(const std::vector<FeatureUse>& uses, bool used) {
    std::vector<std::string> names;
    for (const FeatureUse& use : uses) {
        if ((use.users > 0) == used) names.push_back(use.name);
    }
    return names;
}

}  // namespace

std::string Requirement::GetMinimalSet() const {
    const std::vector<std::string> names = NamesOf(uses, true);
    return names.empty() ? "none" : Join(names, "+");
}

std::vector<FeatureUse> FindUses(const scenes::Scene& scene, const RequirementTask& task) {
    const auto run = Start(scene, task, "automatic");
    std::vector<FeatureUse> most = GetFeatureFacts(*run).uses;
    for (int step = 0; step < task.steps; ++step) {
        run->Step();
        const FeatureFacts now = GetFeatureFacts(*run);
        for (std::size_t i = 0; i < most.size(); ++i) most[i].users = std::max(most[i].users, now.uses[i].users);
    }
    return most;
}

std::vector<VariantCost> RunVariants(const scenes::Scene& scene, const RequirementTask& task,
                                     std::span<const Variant> variants, const std::function<void()>& onRepeat) {
    std::vector<Track> tracks(variants.size());
    for (Track& track : tracks) {
        track.best.assign(static_cast<std::size_t>(task.steps), std::numeric_limits<double>::infinity());
    }
    std::vector<VariantCost> costs(variants.size());
    for (int repeat = 0; repeat < task.repeats; ++repeat) {
        RunOnce(scene, task, variants, repeat == 0, tracks, costs);
        if (onRepeat) onRepeat();
    }
    for (std::size_t i = 0; i < variants.size(); ++i) {
        costs[i].name = variants[i].name;
        const double milliseconds = std::accumulate(tracks[i].best.begin(), tracks[i].best.end(), 0.0);
        costs[i].nsPerBodyStep = milliseconds * 1e6 / std::max(tracks[i].bodySteps, 1.0);
        const auto difference = std::ranges::mismatch(tracks[0].hashes, tracks[i].hashes);
        costs[i].sameHash = difference.in1 == tracks[0].hashes.end();
        if (!costs[i].sameHash) costs[i].firstDifference = static_cast<int>(difference.in1 - tracks[0].hashes.begin());
    }
    return costs;
}

Requirement MeasureRequirement(const scenes::Scene& scene, const RequirementTask& task,
                               const std::function<void()>& onRepeat) {
    Requirement requirement{scene.name, scene.size, task.steps, FindUses(scene, task), {}};
    const Variant variants[] = {{"full", "full"}, {"automatic", "automatic"}, {"minimal", requirement.GetMinimalSet()}};
    requirement.variants = RunVariants(scene, task, variants, onRepeat);
    return requirement;
}

std::string FormatChange(const Requirement& r) {
    const auto change = [&](std::size_t i) {
        return 100.0 * (r.variants[i].nsPerBodyStep / r.variants.front().nsPerBodyStep - 1.0);
    };
    return fmt::format("automatic {:+.1f} %, minimal {:+.1f} % against full", change(1), change(2));
}

std::string FormatRequirement(const Requirement& r) {
    std::string text = fmt::format("{} {}, {} steps\nrequires:\n", r.scene, r.size, r.steps);
    for (const FeatureUse& use : r.uses) {
        if (use.users > 0) text += fmt::format("  {:<18}{:>9} users\n", use.name, use.users);
    }
    text += fmt::format("does without: {}\n\n", Join(NamesOf(r.uses, false), ", "));
    text += fmt::format("{:<12}{:>10}{:>9}{:>8}{:>11}{:>9}  {:<10}{}\n", "variant", "ns/body", "vs full", "B/body",
                        "B/contact", "B/joint", "same hash", "kernels");
    for (const VariantCost& v : r.variants) {
        const double ratio = v.nsPerBodyStep / r.variants.front().nsPerBodyStep;
        text += fmt::format("{:<12}{:>10.2f}{:>+8.1f}%{:>8}{:>11}{:>9}  {:<10}{}\n", v.name, v.nsPerBodyStep,
                            100.0 * (ratio - 1.0), v.bytesPerBody, v.bytesPerContact, v.bytesPerJoint,
                            v.sameHash ? "yes" : fmt::format("step {}", v.firstDifference + 1), v.kernels);
    }
    return text;
}

std::string MakeFeatureHeader(const Requirement& r, std::string_view command) {
    std::string name = r.scene;
    std::ranges::replace(name, '-', '_');
    std::vector<std::string> members;
    for (const std::string& feature : NamesOf(r.uses, true)) members.push_back("scree::Feature::" + feature);
    return fmt::format(
        "// What the scene {0} {1} requires, found in {2} steps by: {3}\n"
        "// With scree::FixedWorld<{4}_features> a call that would use anything else does not compile, or gives\n"
        "// ErrorCode::missingFeature where a value asks for it. A library with nothing else in it:\n"
        "//   cmake -DSCREE_FEATURES=\"{5}\"\n\n"
        "#pragma once\n\n"
        "#include <scree/features.h>\n\n"
        "inline constexpr scree::Features {4}_features{{{6}}};\n",
        r.scene, r.size, r.steps, command, name, Join(NamesOf(r.uses, true), ";"), Join(members, ", "));
}

}  // namespace testbed
