// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// results.json.

#include "testbed/jobs/snapshot/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/json_print.h"

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

std::string ReadTextOrNull(const Json& json) { return json.is_null() ? std::string() : json.get<std::string>(); }

PixelArea ReadArea(const Json& json) {
    return json.is_null() ? PixelArea{} : PixelArea{json.at(0), json.at(1), json.at(2), json.at(3)};
}

/// The name of a file that a report keeps of a case; another name could lead out of the report.
std::string ReadFileName(const Json& json, const std::string& expected) {
    const std::string name = ReadTextOrNull(json);
    if (!name.empty() && name != expected) throw std::invalid_argument(fmt::format("'{}' is not {}", name, expected));
    return name;
}

std::optional<SnapshotSide> ReadSide(const Json& json, const std::string& stem) {
    if (json.is_null()) return std::nullopt;
    return SnapshotSide{ReadFileName(json.at("image"), stem + ".png"), ReadFileName(json.at("sidecar"), stem + ".json"),
                        json.at("width"), json.at("height")};
}

SnapshotStatus ReadStatus(const std::string& name) {
    const auto place = std::ranges::find(snapshotStatusNames, name);
    if (place == snapshotStatusNames.end()) throw std::invalid_argument(fmt::format("unknown status '{}'", name));
    return static_cast<SnapshotStatus>(place - snapshotStatusNames.begin());
}

void ReadRule(const Json& json, SnapshotResult& result) {
    CompareRule& rule = result.rule;
    rule.tolerance = json.at("tolerance");
    for (const Json& area : json.at("mask")) rule.mask.push_back(ReadArea(area));
    rule.source = json.at("source");
    rule.reason = json.at("reason");
    result.pixels.masked = json.at("masked_pixels");
    result.pixels.tolerated = json.at("tolerated_pixels");
}

/// What DescribeResult wrote. Throws std::invalid_argument and Json::exception.
SnapshotResult ReadResult(const Json& json) {
    SnapshotResult result;
    result.number = json.at("case");
    result.id = json.at("id");
    const std::filesystem::path path(result.id);
    if (result.id.empty() || path.is_absolute() || path.lexically_normal() != path || *path.begin() == "..") {
        throw std::invalid_argument(fmt::format("'{}' cannot be the name of a case", result.id));
    }
    if (json.contains("scene")) {
        result.scene = json["scene"];
        result.name = json.at("name");
        result.size = json.at("size");
        result.step = json.at("step");
        result.kind = json.at("kind");
        result.layers = json.at("layers");
    }
    result.status = ReadStatus(json.at("status"));
    result.message = json.at("message");
    result.isStateChanged = json.at("state_changed");
    ReadRule(json.at("rule"), result);
    result.expected = ReadSide(json.at("expected"), "expected/" + result.id);
    result.actual = ReadSide(json.at("actual"), "actual/" + result.id);
    result.difference = ReadFileName(json.at("difference"), "diff/" + result.id + ".png");
    result.pixels.changed = json.at("changed_pixels");
    result.pixels.maxDifference = json.at("max_difference");
    result.pixels.box = ReadArea(json.at("box"));
    result.structure = json.at("structure").is_null() ? std::string() : PrintJson(json["structure"]);
    result.update = ReadTextOrNull(json.at("update"));
    const Json& times = json.at("ms");
    result.simulateMs = times.at("simulate");
    result.renderMs = times.at("render");
    result.compareMs = times.at("compare");
    return result;
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
    entry["state_changed"] = result.isStateChanged;
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
        Json entry = {{"case", result.number}};
        entry.update(DescribeResult(result));
        list.push_back(std::move(entry));
    }
    const Json document = {
        {"schema", 1},
        {"command", origin.command},
        {"clean", IsClean(results)},
        {"renderer", {{"backend", origin.backend}, {"gl_renderer", origin.renderer}, {"gl_version", origin.version}}},
        {"cases", origin.caseCount},
        {"counts", std::move(counts)},
        {"results", std::move(list)}};
    return PrintJson(document, 1) + "\n";
}

WrittenResults ReadResults(const std::filesystem::path& file) {
    const Json json = ReadJsonObject(file);
    WrittenResults written;
    try {
        if (json.at("schema") != 1) throw std::invalid_argument("it is of another schema than 1");
        const Json& renderer = json.at("renderer");
        written.origin = {json.at("command"), renderer.at("backend"), renderer.at("gl_renderer"),
                          renderer.at("gl_version"), json.at("cases")};
        for (const Json& entry : json.at("results")) {
            written.results.push_back(ReadResult(entry));
            if (written.results.back().number >= written.origin.caseCount) {
                throw std::invalid_argument(fmt::format("it has {} cases and a case {}", written.origin.caseCount,
                                                        written.results.back().number));
            }
        }
    } catch (const std::exception& error) {
        throw FileError(fmt::format("{}: not the results of a comparison of pictures by this version: {}",
                                    file.string(), error.what()));
    }
    return written;
}

}  // namespace testbed
