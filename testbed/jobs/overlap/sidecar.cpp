// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What stands beside and inside every picture.

#include "testbed/jobs/overlap/sidecar.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>

#include "testbed/base/json_print.h"
#include "testbed/base/text.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

Json DescribeCamera(const Camera& camera, bool fit) {
    return {{"fit", fit},
            {"x", camera.x},
            {"y", camera.y},
            {"pixels_per_metre", camera.pixelsPerMetre},
            {"offset_x", camera.offsetX},
            {"offset_y", camera.offsetY},
            {"width", camera.width},
            {"height", camera.height}};
}

/// The row with the names of metrics.json, which metrics.cpp alone knows.
Json DescribeRow(const MetricsRow& row) { return Json::parse(WriteMetricsJson({}, std::span(&row, 1)))["rows"][0]; }

Json DescribeEngine(const PictureRecord& record, std::size_t index) {
    const Snapshot& snapshot = *record.snapshots[index];
    Json engine = {{"engine", snapshot.engine},
                   {"pane", snapshot.GetName()},
                   {"settings", snapshot.settings},
                   {"broad_phase", snapshot.broadPhase},
                   {"leaf_size", snapshot.leafSize},
                   {"bodies", snapshot.bodies.size()},
                   {"fixtures", snapshot.fixtures.size()},
                   {"contacts", snapshot.contactCount},
                   {"touching", snapshot.touchingCount},
                   {"joints", snapshot.joints.size()},
                   {"state_hash", FormatHash(snapshot.stateHash)}};
    if (index < record.stats.size()) {
        const OverlapStats& stats = record.stats[index];
        engine["overlap"] = {
            {"max", stats.max}, {"mean", stats.mean}, {"p99", stats.p99}, {"nodes_drawn", stats.nodesDrawn}};
    }
    if (index < record.rows.size()) engine["metrics"] = DescribeRow(record.rows[index]);
    return engine;
}

std::string JoinEngines(const PictureRecord& record) {
    std::string text;
    for (const Snapshot* snapshot : record.snapshots) text += (text.empty() ? "" : ", ") + snapshot->GetName();
    return text;
}

}  // namespace

std::string WriteSidecar(const PictureOrigin& origin, const PictureOptions& options, const PictureRecord& record) {
    const Snapshot& first = *record.snapshots.front();
    Json document = {{"schema", 1},
                     {"kind", record.kind},
                     {"scene", first.scene},
                     {"size", first.size},
                     {"step", first.step},
                     {"command", origin.command},
                     {"poses", origin.poses},
                     {"backend", origin.backend},
                     {"gl_renderer", origin.renderer},
                     {"gl_version", origin.version},
                     {"camera", DescribeCamera(record.camera, !options.camera.has_value())}};
    document["theme"] = GetThemeName(options.theme);
    document["layers"] = GetLayerNames(options.layers);
    if (record.kind != "render") {
        document["nodes"] = GetNodeSelectionName(options.nodes);
        document["query_size"] = options.querySize;
        document["style"] = GetStyleName(options.style);
        document["opacity"] = GetOpacity(options, record.scaleMax);
        document["scale_max"] = record.scaleMax;
    }
    if (record.difference != nullptr) {
        document["difference"] = {
            {"min", record.difference->min}, {"max", record.difference->max}, {"mean", record.difference->mean}};
    }
    document["engines"] = Json::array();
    for (std::size_t i = 0; i < record.snapshots.size(); ++i) document["engines"].push_back(DescribeEngine(record, i));
    return PrintJson(document, 2) + "\n";
}

std::vector<PngText> MakePngText(const PictureOrigin& origin, const PictureRecord& record) {
    const Snapshot& first = *record.snapshots.front();
    return {{"Software", "scree"},
            {"Scene", fmt::format("{} {}", first.scene, first.size)},
            {"Step", fmt::format("{}", first.step)},
            {"Engine", JoinEngines(record)},
            {"Command", origin.command}};
}

}  // namespace testbed
