// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of a comparison of pictures: results, pictures, sidecars and colour tables as JSON in the page, shown by
// snapshot*.js of this folder.

#include "testbed/jobs/snapshot/page.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "testbed/base/input.h"
#include "testbed/base/json_print.h"
#include "testbed/page/page_markup.h"
#include "testbed/picture/image.h"
#include "testbed/picture/palette.h"
#include "testbed_generated/snapshot_sources.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// The colours of counts 0, 1, 2, … in an overlap picture, six hex digits each: what turns a pixel back into its count.
/// Null when the sidecar does not say how counts were coloured.
Json DescribeCountColors(const Json& sidecar) {
    try {
        if (sidecar.value("kind", "") != "overlap") return nullptr;
        const Style style = ParseStyle(sidecar.value("style", GetStyleName(Style::heat)));
        const Json& scale = sidecar.contains("scale_max") ? sidecar : sidecar.at("overlap");
        const auto scaleMax = scale.at("scale_max").get<uint32_t>();
        // The page needs only as many as a reader can tell apart, and a damaged sidecar may name any number.
        if (scaleMax > 4096) return nullptr;
        std::string digits;
        for (const Color& color : MakePalette(style, sidecar.value("opacity", usualOpacity), scaleMax)) {
            digits += fmt::format("{:02x}{:02x}{:02x}", color.r, color.g, color.b);
        }
        return digits;
    } catch (const std::exception&) {
        return nullptr;
    }
}

/// What a sidecar says in a line each: everything but the lists.
Json DescribeMaker(const Json& sidecar) {
    Json maker = Json::object();
    for (const auto& [key, value] : sidecar.items()) {
        if (value.is_primitive() && key != "schema") maker[key] = value;
    }
    if (sidecar.contains("overlap") && sidecar["overlap"].is_object()) {
        for (const auto& [key, value] : sidecar["overlap"].items()) maker["overlap " + key] = value;
    }
    return maker;
}

Json DescribeSideFiles(const fs::path& folder, const std::optional<SnapshotSide>& side) {
    if (!side) return nullptr;
    Json json = {{"picture", nullptr}, {"maker", nullptr}, {"colors", nullptr}, {"structured", false}};
    if (!side->image.empty()) json["picture"] = MakeDataUri(folder / side->image);
    if (!side->sidecar.empty()) {
        const Json sidecar = ReadJsonObject(folder / side->sidecar);
        json["maker"] = DescribeMaker(sidecar);
        json["colors"] = DescribeCountColors(sidecar);
        json["structured"] = sidecar.contains("structure");
    }
    return json;
}

Json DescribeCase(const fs::path& folder, const SnapshotResult& result) {
    Json json = DescribeResult(result);
    json["embedded"] = {
        {"expected", DescribeSideFiles(folder, result.expected)},
        {"actual", DescribeSideFiles(folder, result.actual)},
        {"difference", result.difference.empty() ? Json(nullptr) : Json(MakeDataUri(folder / result.difference))}};
    return json;
}

std::string MakeDuration(double ms) { return ms < 1000 ? fmt::format("{:.0f}", ms) : fmt::format("{:.1f}", ms / 1000); }

PageTiles MakeTiles(std::span<const SnapshotResult> results) {
    std::map<SnapshotStatus, int> counts;
    double ms = 0;
    for (const SnapshotResult& result : results) {
        ++counts[result.status];
        ms += result.simulateMs + result.renderMs + result.compareMs;
    }
    PageTiles block;
    const int equal = counts[SnapshotStatus::equal], all = static_cast<int>(results.size());
    block.tiles.push_back({.label = "equal",
                           .value = fmt::format("{}", equal),
                           .unit = fmt::format("of {}", all),
                           .tone = equal == all ? PageTone::good : PageTone::plain});
    for (const auto& [status, count] : counts) {
        if (status == SnapshotStatus::equal || count == 0) continue;
        block.tiles.push_back(
            {.label = std::string(GetStatusName(status)), .value = fmt::format("{}", count), .tone = PageTone::bad});
    }
    block.tiles.push_back({.label = "work", .value = MakeDuration(ms), .unit = ms < 1000 ? "ms" : "s"});
    return block;
}

}  // namespace

Page MakeSnapshotPage(const fs::path& folder, const SnapshotOrigin& origin, std::span<const SnapshotResult> results) {
    Json data = {
        {"renderer", {{"backend", origin.backend}, {"gl_renderer", origin.renderer}, {"gl_version", origin.version}}},
        {"cases", Json::array()}};
    for (const SnapshotResult& result : results) data["cases"].push_back(DescribeCase(folder, result));

    Page page{.title = IsClean(results) ? "Pictures: all equal" : "Pictures: differences",
              .intro = fmt::format("`{}`", origin.command)};
    page.style = snapshot_sources::snapshotCss;
    page.script = snapshot_sources::snapshotJs;
    page.sections.push_back({.blocks = {MakeTiles(results)}});
    page.sections.push_back({.blocks = {PageHtml{std::string(snapshot_sources::snapshotHtml) +
                                                 "<script type=\"application/json\" id=\"snapshot-data\">" +
                                                 ProtectJson(PrintJson(data)) + "</script>"}}});
    if (!origin.backend.empty()) {
        page.facts.push_back({"renderer", fmt::format("{}: {} {}", origin.backend, origin.renderer, origin.version)});
    }
    page.facts.push_back({"keys",
                          "↑ ↓ another case · 1 to 5 another view · space pauses blinking · arrow keys on the picture "
                          "move the cursor · / filter"});
    return page;
}

fs::path WriteSnapshotPage(const fs::path& folder, const SnapshotOrigin& origin,
                           std::span<const SnapshotResult> results) {
    fs::path path = folder / "index.html";
    WritePage(path, MakeSnapshotPage(folder, origin, results));
    return path;
}

}  // namespace testbed
