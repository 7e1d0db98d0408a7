// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The numbers of one pane at one step, as a row: Snapshot (with all parts) and overlap counts in, metrics.csv and
// metrics.json out. Both files hold the same columns in the same order.

#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "testbed/engines/snapshot.h"

namespace testbed {

class OutputFolder;
struct OverlapStats;

/// A row; the fields are the columns, in order. Formulas of the tree's figures: tree_quality.h.
struct MetricsRow {
    std::string engine;
    std::string broadPhase;
    int threads = 1;
    int step = 0;
    int bodies = 0;
    int proxies = 0;  ///< fixtures in the broad phase
    int nodes = 0;    ///< internal nodes and leaves; this and the next six are 0 without a tree
    int height = 0;
    int maxBalance = 0;
    double areaRatio = 0;
    double sahCost = 0;
    double siblingOverlap = 0;
    double epo = 0;
    uint32_t overlapMax = 0;  ///< nodes covering one pixel
    double overlapMean = 0;
    uint32_t overlapP99 = 0;
    int64_t pairsReported = 0;  ///< by the broad phase, before any tight test
    int64_t pairsTrue = 0;      ///< of tight AABBs
    double falsePairRatio = 0;  ///< share of the reported pairs that are not true; 0 when none was reported
    int contacts = 0;
    int touching = 0;
    double broadPhaseMs = 0;
    double narrowPhaseMs = 0;
    double solverMs = 0;
    double stepMs = 0;
    int64_t memoryBytes = 0;
    uint64_t stateHash = 0;  ///< written as 16 hexadecimal digits
    std::string pane;        ///< its name; the engine's where that runs once
    std::string settings;    ///< how it was run, as PrintSettings writes it
};

/// What stands above the rows in metrics.json.
struct MetricsHeader {
    std::string scene;
    int size = 0;
    std::string command;
};

/// Computes a row. The snapshot needs bodies, fixtures and nodes.
[[nodiscard]] MetricsRow MeasureSnapshot(const Snapshot& snapshot, const OverlapStats& overlap);

/// A line of column names, then a line per row; numbers read back to the same values.
[[nodiscard]] std::string WriteMetricsCsv(std::span<const MetricsRow> rows);

/// {"schema": 1, "scene", "size", "command", "rows": [{column: value}]}.
[[nodiscard]] std::string WriteMetricsJson(const MetricsHeader& header, std::span<const MetricsRow> rows);

/// Writes metrics.csv and metrics.json into a folder below `output`, each whole or not at all. Throws FileError.
void SaveMetrics(OutputFolder& output, const std::filesystem::path& folder, const MetricsHeader& header,
                 std::span<const MetricsRow> rows);

}  // namespace testbed
