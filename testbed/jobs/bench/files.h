// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Collects what `scree bench` measured, case by case, and writes it at the end: CSV, plots, page.

#pragma once

#include <string>
#include <vector>

#include "testbed/jobs/bench/page.h"
#include "testbed/jobs/bench/run.h"

namespace testbed {

/// Where to write; empty: not wanted. `output` is a folder for all of it: bench.csv, plots/, index.html.
struct BenchPaths {
    std::string csv, plots, output;
};

class BenchFiles {
public:
    /// Throws ToolError without gnuplot where plots are wanted, FileError for a folder that cannot be written.
    explicit BenchFiles(BenchPaths paths);

    void Add(const BenchResult& result);
    [[nodiscard]] const std::vector<BenchRow>& GetRows() const { return m_rows; }

    /// Writes all files that are wanted; returns the lines that name them. `report` needs no plots yet.
    [[nodiscard]] std::string Write(BenchReport report) const;

private:
    /// One case with times of every step.
    struct TimedCase {
        std::vector<BenchRow> rows;
        std::vector<TimingSeries> timing;
    };

    [[nodiscard]] std::vector<std::filesystem::path> DrawPlots(const std::filesystem::path& folder) const;

    BenchPaths m_paths;
    std::vector<BenchRow> m_rows;
    std::vector<TimedCase> m_timed;  ///< of every scene its largest size
};

}  // namespace testbed
