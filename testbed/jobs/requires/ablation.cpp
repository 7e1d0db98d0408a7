// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of ablation.h.

#include "testbed/jobs/requires/ablation.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testbed/base/csv.h"
#include "testbed/base/json_print.h"
#include "testbed/base/statistics.h"

namespace testbed {
namespace {

using Names = std::vector<std::string>;

/// Features of one kernel.
const std::vector<Names>& KernelGroups() {
    static const std::vector<Names> groups = {{"damping", "gravityScale", "forces"},
                                              {"speedLimit"},
                                              {"friction"},
                                              {"restitution"},
                                              {"continuousStatic", "continuousBullet", "kinematicBodies"}};
    return groups;
}

FeatureKernel KernelOf(const std::string& feature) {
    for (const Names& group : KernelGroups()) {
        if (std::ranges::find(group, feature) == group.end()) continue;
        return group.size() == 1 ? FeatureKernel::own : FeatureKernel::shared;
    }
    return FeatureKernel::none;
}

std::string_view NameOf(FeatureKernel kernel) {
    constexpr std::string_view names[] = {"none", "shared", "own"};
    return names[static_cast<int>(kernel)];
}

std::string JoinNames(const Names& names, std::string_view separator = ", ") {
    return fmt::format("{}", fmt::join(names, separator));
}

int UsersOf(const std::vector<FeatureUse>& uses, const Names& names) {
    int users = 0;
    for (const FeatureUse& use : uses) {
        if (std::ranges::find(names, use.name) != names.end()) users += use.users;
    }
    return users;
}

/// All features but these, as RunSpec::features takes them.
std::string AllBut(const std::vector<FeatureUse>& uses, const Names& out) {
    Names rest;
    for (const FeatureUse& use : uses) {
        if (std::ranges::find(out, use.name) == out.end()) rest.push_back(use.name);
    }
    return rest.empty() ? "none" : JoinNames(rest, "+");
}

/// What is left out for each row.
std::vector<Names> ListLeftOut(const std::vector<FeatureUse>& uses) {
    std::vector<Names> all;
    for (const FeatureUse& use : uses) all.push_back({use.name});
    for (const Names& group : KernelGroups()) {
        if (group.size() > 1) all.push_back(group);
    }
    return all;
}

/// So many runs beside a full one at a time: more of them would drive each other out of the caches.
constexpr std::size_t runsAtOnce = 4;

PageTable MakeRequirementTable(std::span<const Requirement> requirements) {
    PageTable table{.columns = {{.name = "scene"},
                                {.name = "size", .numeric = true},
                                {.name = "requires"},
                                {.name = "kernels"},
                                {.name = "full", .unit = "ns", .numeric = true, .group = "one body and step"},
                                {.name = "automatic", .unit = "%", .numeric = true, .group = "one body and step"},
                                {.name = "minimal", .unit = "%", .numeric = true, .group = "one body and step"},
                                {.name = "full", .unit = "B", .numeric = true, .group = "one body"},
                                {.name = "automatic", .unit = "B", .numeric = true, .group = "one body"},
                                {.name = "same hash"}},
                    .filter = true};
    for (const Requirement& r : requirements) {
        const VariantCost &full = r.variants[0], &automatic = r.variants[1], &minimal = r.variants[2];
        const auto change = [&](const VariantCost& v) {
            return PageCell::Number(100.0 * (v.nsPerBodyStep / full.nsPerBodyStep - 1.0), 1);
        };
        const bool same = std::ranges::all_of(r.variants, &VariantCost::sameHash);
        PageCell hash(same ? "yes" : "no");
        hash.tone = same ? PageTone::good : PageTone::bad;
        std::string needs = r.GetMinimalSet();
        for (std::size_t at = 0; (at = needs.find('+', at)) != std::string::npos; at += 2) needs.replace(at, 1, ", ");
        table.rows.push_back({r.scene, PageCell::Number(r.size), needs, automatic.kernels,
                              PageCell::Number(full.nsPerBodyStep, 1), change(automatic), change(minimal),
                              PageCell::Number(static_cast<double>(full.bytesPerBody)),
                              PageCell::Number(static_cast<double>(automatic.bytesPerBody)), hash});
    }
    return table;
}

PageCell HashCell(bool same, std::string text) {
    PageCell cell(std::move(text));
    cell.tone = same ? PageTone::good : PageTone::bad;
    return cell;
}

/// Below 0 a scene is faster without; within 2 % it is as fast.
PageTone ToneOf(double percent) {
    return percent <= -2.0 ? PageTone::good : percent > 2.0 ? PageTone::bad : PageTone::plain;
}

PageTable MakeSceneTable(std::span<const AblationRow> rows) {
    PageTable table{.columns = {{.name = "scene"},
                                {.name = "feature"},
                                {.name = "kernel"},
                                {.name = "users", .numeric = true},
                                {.name = "Δ time", .unit = "ns", .numeric = true, .hint = "one body and step"},
                                {.name = "Δ time", .unit = "%", .numeric = true, .hint = "without it, against full"},
                                {.name = "Δ size", .unit = "B", .numeric = true, .hint = "records, without minus full"},
                                {.name = "same hash"}},
                    .filter = true};
    for (const AblationRow& row : rows) {
        const std::string kernel(NameOf(row.kernel));
        if (row.users > 0) {
            PageCell needed("needed");
            needed.tone = PageTone::muted;
            table.rows.push_back({row.scene, row.feature, kernel, PageCell::Number(row.users), {}, {}, {}, needed});
            continue;
        }
        table.rows.push_back({row.scene, row.feature, kernel, PageCell::Number(0),
                              PageCell::Number(row.GetNsChange(), 2),
                              PageCell::Number(row.GetPercent(), 1, ToneOf(row.GetPercent())),
                              PageCell::Number(static_cast<double>(row.GetBytesChange())),
                              HashCell(row.without.sameHash, row.without.sameHash ? "yes" : "no")});
    }
    return table;
}

/// The change, and on hover the scene.
PageCell ExtremeCell(const AblationRow& row) {
    PageCell cell = PageCell::Number(row.GetPercent(), 1, ToneOf(row.GetPercent()));
    cell.hint = row.scene;
    return cell;
}

std::vector<PageCell> MakeFeatureRow(const std::string& feature, std::span<const AblationRow> rows) {
    std::vector<AblationRow> measured;
    int scenes = 0;
    for (const AblationRow& row : rows) {
        if (row.feature != feature) continue;
        ++scenes;
        if (row.users == 0) measured.push_back(row);
    }
    const std::string kernel(NameOf(feature.find(',') == std::string::npos ? KernelOf(feature) : FeatureKernel::own));
    const std::string without = fmt::format("{} of {}", measured.size(), scenes);
    if (measured.empty()) return {feature, kernel, without, {}, {}, {}, {}, {}, {}};
    std::ranges::sort(measured, {}, &AblationRow::GetPercent);
    const AblationRow& middle = measured[NearestRank(measured.size(), 0.5)];
    const auto [least, most] = std::ranges::minmax(measured, {}, &AblationRow::GetBytesChange);
    const auto same = std::ranges::count_if(measured, [](const AblationRow& row) { return row.without.sameHash; });
    const bool allSame = static_cast<std::size_t>(same) == measured.size();
    return {feature,
            kernel,
            without,
            PageCell::Number(static_cast<double>(least.GetBytesChange())),
            PageCell::Number(middle.GetNsChange(), 2),
            PageCell::Number(middle.GetPercent(), 1, ToneOf(middle.GetPercent())),
            ExtremeCell(measured.front()),
            ExtremeCell(measured.back()),
            HashCell(allSame, fmt::format("{} of {}", same, measured.size()))};
}

PageTable MakeFeatureTable(std::span<const AblationRow> rows) {
    PageTable table{
        .columns = {
            {.name = "without"},
            {.name = "kernel"},
            {.name = "scenes without users"},
            {.name = "Δ size", .unit = "B", .numeric = true, .hint = "of one body, contact and joint; the most"},
            {.name = "median", .unit = "ns", .numeric = true, .group = "Δ time of one body and step"},
            {.name = "median", .unit = "%", .numeric = true, .group = "Δ time of one body and step"},
            {.name = "best", .unit = "%", .numeric = true, .group = "Δ time of one body and step"},
            {.name = "worst", .unit = "%", .numeric = true, .group = "Δ time of one body and step"},
            {.name = "same hash"}}};
    Names seen;
    for (const AblationRow& row : rows) {
        if (std::ranges::find(seen, row.feature) != seen.end()) continue;
        seen.push_back(row.feature);
        table.rows.push_back(MakeFeatureRow(row.feature, rows));
    }
    return table;
}

}  // namespace

long AblationRow::GetBytesChange() const {
    const auto sum = [](const VariantCost& v) {
        return static_cast<long>(v.bytesPerBody + v.bytesPerFixture + v.bytesPerContact + v.bytesPerJoint);
    };
    return sum(without) - sum(full);
}

int CountAblationRuns() {
    // One run for each of the 22 features and the two shared kernels, at most.
    constexpr std::size_t most = 24;
    return static_cast<int>((most + runsAtOnce - 1) / runsAtOnce);
}

std::vector<AblationRow> MeasureAblation(const scenes::Scene& scene, const RequirementTask& task,
                                         const std::function<void()>& onRepeat) {
    const std::vector<FeatureUse> uses = FindUses(scene, task);
    std::vector<AblationRow> rows;
    std::vector<Variant> variants;
    std::vector<std::size_t> rowOf;  // per variant
    for (const Names& out : ListLeftOut(uses)) {
        const FeatureKernel kernel = out.size() > 1 ? FeatureKernel::own : KernelOf(out.front());
        rows.push_back({scene.name, scene.size, JoinNames(out), kernel, UsersOf(uses, out), {}, {}});
        if (rows.back().users > 0) continue;
        rowOf.push_back(rows.size() - 1);
        variants.push_back({"without " + rows.back().feature, AllBut(uses, out)});
    }
    for (std::size_t begin = 0; begin < variants.size(); begin += runsAtOnce) {
        const std::size_t end = std::min(begin + runsAtOnce, variants.size());
        std::vector<Variant> lockstep = {{"full", "full"}};
        for (std::size_t i = begin; i < end; ++i) lockstep.push_back(variants[i]);
        const std::vector<VariantCost> costs = RunVariants(scene, task, lockstep, onRepeat);
        for (std::size_t i = begin; i < end; ++i) {
            rows[rowOf[i]].full = costs[0];
            rows[rowOf[i]].without = costs[1 + i - begin];
        }
    }
    return rows;
}

std::string MakeAblationCsv(std::span<const AblationRow> rows) {
    CsvTable table{"scene",   "size",       "feature",      "kernel",       "users",
                   "ns_full", "ns_without", "time_percent", "bytes_change", "same_hash"};
    for (const AblationRow& row : rows) {
        table.AddCells(row.scene, row.size, row.feature, NameOf(row.kernel), row.users);
        if (row.users > 0) {
            table.AddEmpty(5);
        } else {
            table.AddCells(fmt::format("{:.3f}", row.full.nsPerBodyStep),
                           fmt::format("{:.3f}", row.without.nsPerBodyStep), fmt::format("{:.2f}", row.GetPercent()),
                           row.GetBytesChange(), row.without.sameHash ? "yes" : "no");
        }
        table.EndRow();
    }
    return table.GetText();
}

std::string MakeAblationJson(std::span<const AblationRow> rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const AblationRow& row : rows) {
        nlohmann::ordered_json entry = {{"scene", row.scene},
                                        {"size", row.size},
                                        {"feature", row.feature},
                                        {"kernel", NameOf(row.kernel)},
                                        {"users", row.users}};
        if (row.users == 0) {
            entry["ns_full"] = row.full.nsPerBodyStep;
            entry["ns_without"] = row.without.nsPerBodyStep;
            entry["time_percent"] = row.GetPercent();
            entry["bytes_change"] = row.GetBytesChange();
            entry["same_hash"] = row.without.sameHash;
        }
        list.push_back(std::move(entry));
    }
    return PrintJson(nlohmann::ordered_json{{"schema", 2}, {"rows", list}}, 2) + "\n";
}

PageSection MakeRequirementSection(std::span<const Requirement> requirements) {
    return {.title = "Scenes",
            .intro =
                "Full: everything on, used or not. Automatic: what the world uses at the moment (the default). "
                "Minimal: a fixed set of what the scene uses at any time. Times of the latter two against full.",
            .blocks = {MakeRequirementTable(requirements)}};
}

PageSection MakeAblationSection(std::span<const AblationRow> rows) {
    return {.title = "Ablation",
            .intro =
                "A row per feature left out: scenes with everything but it, against full. Below 0 they are "
                "faster without. A kernel that is shared goes only with the last of its features, so these also "
                "have a row together; features without a kernel have nothing that could go, and their rows show "
                "the noise of the measurement. Steps of the variants alternate, and of each step the fastest of "
                "all repeats counts.",
            .blocks = {MakeFeatureTable(rows)}};
}

PageSection MakeAblationDetails(std::span<const AblationRow> rows) {
    return {.title = "Ablation by scene", .blocks = {MakeSceneTable(rows)}, .folded = true};
}

}  // namespace testbed
