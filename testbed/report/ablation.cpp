// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of ablation.h.

#include "testbed/report/ablation.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

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

bool IsUsed(const std::vector<FeatureUse>& uses, const std::string& name) {
    const auto use = std::ranges::find(uses, name, &FeatureUse::name);
    return use != uses.end() && use->users > 0;
}

/// All features but these, with commas.
std::string AllBut(const std::vector<FeatureUse>& uses, const Names& out) {
    Names rest;
    for (const FeatureUse& use : uses) {
        if (std::ranges::find(out, use.name) == out.end()) rest.push_back(use.name);
    }
    return fmt::format("{}", fmt::join(rest, ","));
}

double Percent(const AblationRow& row) { return 100.0 * (row.without.nsPerBodyStep / row.full.nsPerBodyStep - 1.0); }

/// Runs the scene with and without the features and fills in the rows of those that are named in `rows`.
void Ablate(const scenes::Scene& scene, const RequirementPlan& plan, const Names& out, bool hasKernel,
            std::vector<AblationRow>& rows, const std::vector<FeatureUse>& uses,
            const std::function<void()>& onRepeat) {
    const Variant variants[] = {{"full", "full"}, {"without", AllBut(uses, out)}};
    const std::vector<VariantCost> costs = RunVariants(scene, plan, variants, onRepeat);
    for (AblationRow& row : rows) {
        if (std::ranges::find(out, row.feature) == out.end()) continue;
        row.leftOut = fmt::format("{}", fmt::join(out, ", "));
        row.hasKernel = hasKernel;
        row.full = costs[0];
        row.without = costs[1];
    }
}

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
        for (std::size_t at = 0; (at = needs.find(',', at)) != std::string::npos; at += 2) needs.replace(at, 1, ", ");
        table.rows.push_back({r.scene, PageCell::Number(r.size), needs, automatic.kernels,
                              PageCell::Number(full.nsPerBodyStep, 1), change(automatic), change(minimal),
                              PageCell::Number(static_cast<double>(full.bytesPerBody)),
                              PageCell::Number(static_cast<double>(automatic.bytesPerBody)), hash});
    }
    return table;
}

PageTable MakeAblationTable(std::span<const AblationRow> rows) {
    PageTable table{.columns = {{.name = "scene"},
                                {.name = "feature"},
                                {.name = "left out together"},
                                {.name = "users", .numeric = true},
                                {.name = "time", .unit = "%", .numeric = true, .hint = "without it, against full"},
                                {.name = "bytes a body", .numeric = true, .hint = "without it, minus full"},
                                {.name = "same hash"}},
                    .filter = true};
    for (const AblationRow& row : rows) {
        if (row.leftOut.empty()) {
            PageCell needed("needed");
            needed.tone = PageTone::muted;
            table.rows.push_back({row.scene, row.feature, "", PageCell::Number(row.users), {}, {}, needed});
            continue;
        }
        const double percent = Percent(row);
        const PageTone tone = percent <= -2.0 ? PageTone::good : percent > 2.0 ? PageTone::bad : PageTone::plain;
        PageCell hash(row.without.sameHash ? "yes" : "no");
        hash.tone = row.without.sameHash ? PageTone::good : PageTone::bad;
        const double bytes = static_cast<double>(row.without.bytesPerBody) - static_cast<double>(row.full.bytesPerBody);
        table.rows.push_back({row.scene, row.feature, row.hasKernel ? row.leftOut : "all without a kernel of their own",
                              PageCell::Number(0), PageCell::Number(percent, 1, tone), PageCell::Number(bytes), hash});
    }
    return table;
}

}  // namespace

int CountAblationRuns() { return static_cast<int>(KernelGroups().size()) + 1; }

std::vector<AblationRow> MeasureAblation(const scenes::Scene& scene, const RequirementPlan& plan,
                                         const std::function<void()>& onRepeat) {
    const std::vector<FeatureUse> uses = FindUses(scene, plan);
    std::vector<AblationRow> rows;
    Names withoutKernel;
    for (const FeatureUse& use : uses) {
        rows.push_back({scene.name, scene.size, use.name, "", false, use.users, {}, {}});
        const auto has = [&](const Names& group) { return std::ranges::find(group, use.name) != group.end(); };
        if (use.users == 0 && std::ranges::none_of(KernelGroups(), has)) withoutKernel.push_back(use.name);
    }
    for (const Names& group : KernelGroups()) {
        const bool needed = std::ranges::any_of(group, [&](const std::string& name) { return IsUsed(uses, name); });
        if (!needed) Ablate(scene, plan, group, true, rows, uses, onRepeat);
    }
    if (!withoutKernel.empty()) Ablate(scene, plan, withoutKernel, false, rows, uses, onRepeat);
    return rows;
}

std::string MakeAblationCsv(std::span<const AblationRow> rows) {
    std::string text =
        "scene,size,feature,users,left_out,kernel,ns_full,ns_without,time_percent,bytes_per_body_full,"
        "bytes_per_body_without,same_hash\n";
    for (const AblationRow& row : rows) {
        auto out = std::back_inserter(text);
        fmt::format_to(out, "{},{},{},{},\"{}\",{},", row.scene, row.size, row.feature, row.users, row.leftOut,
                       row.hasKernel ? "yes" : "no");
        if (row.leftOut.empty()) {
            fmt::format_to(out, ",,,,,\n");
            continue;
        }
        fmt::format_to(out, "{:.3f},{:.3f},{:.2f},{},{},{}\n", row.full.nsPerBodyStep, row.without.nsPerBodyStep,
                       Percent(row), row.full.bytesPerBody, row.without.bytesPerBody,
                       row.without.sameHash ? "yes" : "no");
    }
    return text;
}

std::string MakeAblationJson(std::span<const AblationRow> rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const AblationRow& row : rows) {
        nlohmann::ordered_json entry = {
            {"scene", row.scene}, {"size", row.size}, {"feature", row.feature}, {"users", row.users}};
        if (!row.leftOut.empty()) {
            entry["left_out"] = row.leftOut;
            entry["kernel"] = row.hasKernel;
            entry["ns_full"] = row.full.nsPerBodyStep;
            entry["ns_without"] = row.without.nsPerBodyStep;
            entry["time_percent"] = Percent(row);
            entry["bytes_per_body_full"] = row.full.bytesPerBody;
            entry["bytes_per_body_without"] = row.without.bytesPerBody;
            entry["same_hash"] = row.without.sameHash;
        }
        list.push_back(std::move(entry));
    }
    return nlohmann::ordered_json{{"schema", 1}, {"rows", list}}.dump(2) + "\n";
}

Page MakeAblationPage(std::span<const Requirement> requirements, std::span<const AblationRow> rows,
                      const std::string& command) {
    Page page{.title = "What a scene requires",
              .intro =
                  "Every feature of the engine has a neutral value at which leaving it out changes no bit. A world "
                  "leaves out what nobody in it uses; here is what that saves.",
              .facts = {{"command", command}}};
    page.sections.push_back(
        {.title = "Scenes",
         .intro = "Full: everything on, used or not. Automatic: what the world uses at the moment (the default). "
                  "Minimal: a fixed set of what the scene uses at any time. Times of the latter two against full.",
         .blocks = {MakeRequirementTable(requirements)}});
    if (!rows.empty()) {
        page.sections.push_back(
            {.title = "Ablation",
             .intro = "A row per feature: the scene with everything but it, against full. Below 0 the scene is faster "
                      "without. Features that share a kernel are left out together; of the others nothing is "
                      "compiled twice, so that their row shows the noise of the measurement. Steps of the variants "
                      "alternate, and of each step the fastest of all repeats counts.",
             .blocks = {MakeAblationTable(rows)}});
    }
    return page;
}

}  // namespace testbed
