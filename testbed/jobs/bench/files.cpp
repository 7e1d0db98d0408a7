// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of files.h.

#include "testbed/jobs/bench/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "testbed/base/output.h"
#include "testbed/jobs/bench/plots.h"
#include "testbed/page/gnuplot.h"

namespace testbed {

namespace fs = std::filesystem;

BenchFiles::BenchFiles(BenchPaths paths) : m_paths(std::move(paths)) {
    if (!m_paths.output.empty()) {
        if (m_paths.csv.empty()) m_paths.csv = (fs::path(m_paths.output) / "bench.csv").string();
        if (m_paths.plots.empty()) m_paths.plots = (fs::path(m_paths.output) / "plots").string();
        const OutputFolder check(m_paths.output);
    }
    if (!m_paths.plots.empty()) {
        CheckGnuplot();
        const OutputFolder check(m_paths.plots);
    }
}

void BenchFiles::Add(const BenchResult& result) {
    m_rows.insert(m_rows.end(), result.rows.begin(), result.rows.end());
    if (m_paths.plots.empty() || result.timing.empty()) return;
    const BenchRow& first = result.rows.front();
    // Sizes come in ascending order: the largest stays.
    std::erase_if(m_timed, [&](const TimedCase& other) {
        return other.rows.front().scene == first.scene && other.rows.front().continuous == first.continuous;
    });
    m_timed.push_back({result.rows, result.timing});
}

std::vector<fs::path> BenchFiles::DrawPlots(const fs::path& folder) const {
    std::vector<fs::path> plots;
    const auto draw = [&](const Plot& plot, const std::string& name) {
        DrawPlotFiles(plot, folder / name);
        plots.push_back(folder / (name + ".svg"));
    };
    std::vector<std::pair<std::string, bool>> drawn;
    for (const BenchRow& row : m_rows) {
        if (std::ranges::find(drawn, std::pair(row.scene, row.continuous)) != drawn.end()) continue;
        drawn.emplace_back(row.scene, row.continuous);
        std::vector<BenchRow> same;
        std::ranges::copy_if(m_rows, std::back_inserter(same), [&](const BenchRow& other) {
            return other.scene == row.scene && other.continuous == row.continuous;
        });
        const bool hasSizes = std::ranges::any_of(same, [&](const BenchRow& other) { return other.size != row.size; });
        if (hasSizes) draw(MakeTotalsPlot(same), row.scene + (row.continuous ? "-continuous-total" : "-total"));
    }
    if (const Plot cost = MakeCostPlot(m_rows); !cost.curves.empty()) draw(cost, "cost-per-body");
    for (const TimedCase& timed : m_timed) {
        const BenchRow& row = timed.rows.front();
        draw(MakeStepsPlot(timed.rows, timed.timing), row.scene + (row.continuous ? "-continuous-steps" : "-steps"));
    }
    return plots;
}

std::string BenchFiles::Write(BenchReport report) const {
    std::vector<std::string> files;
    if (!m_paths.csv.empty()) {
        WriteTextFile(m_paths.csv, WriteBenchCsv(m_rows));
        files.push_back(m_paths.csv);
    }
    if (!m_paths.plots.empty()) report.plots = DrawPlots(m_paths.plots);
    for (const fs::path& plot : report.plots) files.push_back(plot.string());
    if (!m_paths.output.empty()) {
        const fs::path page = fs::path(m_paths.output) / "index.html";
        WritePage(page, MakeBenchPage(report));
        files.push_back(page.string());
    }
    return files.empty() ? std::string() : FormatFiles(files);
}

}  // namespace testbed
