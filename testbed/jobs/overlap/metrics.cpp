// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of metrics.h.

#include "testbed/jobs/overlap/metrics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testbed/base/csv.h"
#include "testbed/base/json_print.h"
#include "testbed/base/output.h"
#include "testbed/base/text.h"
#include "testbed/engines/pair_count.h"
#include "testbed/jobs/overlap/tree_quality.h"
#include "testbed/view/picture.h"

namespace testbed {
namespace {

/// Calls visit(column, value) in the order of the columns: the one place that names them.
template <typename Visit>
void ForEachColumn(const MetricsRow& row, Visit&& visit) {
    visit("engine", row.engine);
    visit("broad_phase", row.broadPhase);
    visit("threads", row.threads);
    visit("step", row.step);
    visit("bodies", row.bodies);
    visit("proxies", row.proxies);
    visit("nodes", row.nodes);
    visit("height", row.height);
    visit("max_balance", row.maxBalance);
    visit("area_ratio", row.areaRatio);
    visit("sah_cost", row.sahCost);
    visit("sibling_overlap", row.siblingOverlap);
    visit("epo", row.epo);
    visit("overlap_max", row.overlapMax);
    visit("overlap_mean", row.overlapMean);
    visit("overlap_p99", row.overlapP99);
    visit("pairs_reported", row.pairsReported);
    visit("pairs_true", row.pairsTrue);
    visit("false_pair_ratio", row.falsePairRatio);
    visit("contacts", row.contacts);
    visit("touching", row.touching);
    visit("broad_phase_ms", row.broadPhaseMs);
    visit("narrow_phase_ms", row.narrowPhaseMs);
    visit("solver_ms", row.solverMs);
    visit("step_ms", row.stepMs);
    visit("memory_bytes", row.memoryBytes);
    visit("state_hash", FormatHash(row.stateHash));
    visit("pane", row.pane);
    visit("settings", row.settings);
}

}  // namespace

MetricsRow MeasureSnapshot(const Snapshot& snapshot, const OverlapStats& overlap) {
    const TreeQuality tree = MeasureTree(snapshot.nodes, snapshot.fixtures);
    MetricsRow row;
    row.engine = snapshot.engine;
    row.broadPhase = snapshot.broadPhase;
    row.threads = snapshot.threads;
    row.step = snapshot.step;
    row.bodies = static_cast<int>(snapshot.bodies.size());
    row.proxies = static_cast<int>(snapshot.fixtures.size());
    row.nodes = tree.nodes;
    row.height = tree.height;
    row.maxBalance = tree.maxBalance;
    row.areaRatio = tree.areaRatio;
    row.sahCost = tree.sahCost;
    row.siblingOverlap = tree.siblingOverlap;
    row.epo = tree.epo;
    row.overlapMax = overlap.max;
    row.overlapMean = overlap.mean;
    row.overlapP99 = overlap.p99;
    row.pairsReported = snapshot.pairsReported;
    row.pairsTrue = CountPairs(TightBoxes(snapshot));
    if (row.pairsReported > 0) {
        const int64_t excess = std::max<int64_t>(0, row.pairsReported - row.pairsTrue);
        row.falsePairRatio = static_cast<double>(excess) / static_cast<double>(row.pairsReported);
    }
    row.contacts = snapshot.contactCount;
    row.touching = snapshot.touchingCount;
    row.broadPhaseMs = snapshot.times.broadPhase;
    row.narrowPhaseMs = snapshot.times.narrowPhase;
    row.solverMs = snapshot.times.solver;
    row.stepMs = snapshot.times.step;
    row.memoryBytes = snapshot.memoryBytes;
    row.stateHash = snapshot.stateHash;
    row.pane = snapshot.GetName();
    row.settings = snapshot.settings;
    return row;
}

std::string WriteMetricsCsv(std::span<const MetricsRow> rows) {
    CsvTable table;
    ForEachColumn(MetricsRow{}, [&](const char* name, const auto&) { table.Add(std::string_view(name)); });
    table.EndRow();
    for (const MetricsRow& row : rows) {
        ForEachColumn(row, [&](const char*, const auto& value) { table.Add(value); });
        table.EndRow();
    }
    return table.GetText();
}

std::string WriteMetricsJson(const MetricsHeader& header, std::span<const MetricsRow> rows) {
    nlohmann::ordered_json document;
    document["schema"] = 1;
    document["scene"] = header.scene;
    document["size"] = header.size;
    document["command"] = header.command;
    document["rows"] = nlohmann::ordered_json::array();
    for (const MetricsRow& row : rows) {
        nlohmann::ordered_json object;
        ForEachColumn(row, [&object](const char* name, const auto& value) { object[name] = value; });
        document["rows"].push_back(std::move(object));
    }
    return PrintJson(document, 2) + "\n";
}

void SaveMetrics(OutputFolder& output, const std::filesystem::path& folder, const MetricsHeader& header,
                 std::span<const MetricsRow> rows) {
    output.WriteText(folder / "metrics.csv", WriteMetricsCsv(rows));
    output.WriteText(folder / "metrics.json", WriteMetricsJson(header, rows));
}

}  // namespace testbed
