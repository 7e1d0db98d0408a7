// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// results.json.

#include "testbed/jobs/snapshot/result.h"
#include "testbed/base/json_print.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

Json TextOrNull(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json DescribeArea(const PixelArea& area) { return Json::array({area.x0, area.y0, area.x1, area.y1}); }

Json DescribeRule(const SnapshotResult& result) {
    Json mask = Json::array();
    for (const PixelArea& area : result.rule.mask) mask.push_back(DescribeArea(area));
    return {{"tolerance", result.rule.tolerance},    {"mask", std::move(mask)},
            {"source", result.rule.source},          {"reason", result.rule.reason},
            {"masked_pixels", result.pixels.masked}, {"tolerated_pixels", result.pixels.tolerated}};
}

Json DescribeSide(const std::optional<SnapshotSide>& side) {
    if (!side) return nullptr;
    return {{"image", TextOrNull(side->image)},
            {"sidecar", TextOrNull(side->sidecar)},
            {"width", side->width},
            {"height", side->height}};
}

}  // namespace

Json DescribeResult(const SnapshotResult& result) {
    Json entry = {{"id", result.id}};
    if (!result.scene.empty()) {
        entry["scene"] = result.scene;
        entry["name"] = result.name;
        entry["size"] = result.size;
        entry["step"] = result.step;
        entry["kind"] = result.kind;
        entry["layers"] = result.layers;
    }
    entry["status"] = GetStatusName(result.status);
    entry["message"] = result.message;
    entry["rule"] = DescribeRule(result);
    entry["expected"] = DescribeSide(result.expected);
    entry["actual"] = DescribeSide(result.actual);
    entry["difference"] = TextOrNull(result.difference);
    entry["changed_pixels"] = result.pixels.changed;
    entry["max_difference"] = result.pixels.maxDifference;
    entry["box"] = result.pixels.changed > 0 ? DescribeArea(result.pixels.box) : Json(nullptr);
    entry["structure"] = result.structure.empty() ? Json(nullptr) : Json::parse(result.structure);
    entry["update"] = TextOrNull(result.update);
    entry["ms"] = {{"simulate", result.simulateMs}, {"render", result.renderMs}, {"compare", result.compareMs}};
    return entry;
}

bool IsClean(std::span<const SnapshotResult> results) {
    return std::ranges::all_of(results, [](const auto& result) { return result.status == SnapshotStatus::equal; });
}

std::string WriteResults(const SnapshotOrigin& origin, std::span<const SnapshotResult> results) {
    Json counts = Json::object();
    for (const std::string_view name : snapshotStatusNames) counts[std::string(name)] = 0;
    Json list = Json::array();
    for (const SnapshotResult& result : results) {
        Json& count = counts[std::string(GetStatusName(result.status))];
        count = count.get<int>() + 1;
        list.push_back(DescribeResult(result));
    }
    const Json document = {
        {"schema", 1},
        {"command", origin.command},
        {"clean", IsClean(results)},
        {"renderer", {{"backend", origin.backend}, {"gl_renderer", origin.renderer}, {"gl_version", origin.version}}},
        {"counts", std::move(counts)},
        {"results", std::move(list)}};
    return PrintJson(document, 1) + "\n";
}

}  // namespace testbed
