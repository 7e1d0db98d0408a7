// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of table.h.

#include "testbed/jobs/bench/table.h"

#include <fmt/format.h>

#include "testbed/base/text.h"

namespace testbed {
namespace {

constexpr double megabyte = 1e6;

/// "×3.1", "≥×3.1" when the baseline was stopped, "≤×3.1" when only this run was, "void" in front when the work
/// differs.
std::string FormatRatio(const BenchRow& row, const BenchRow* baseline) {
    if (row.IsBaseline() || baseline == nullptr || row.ratio == 0) return "";
    if (!row.complete && !baseline->complete) return "?";
    const char* bound = !baseline->complete ? "≥" : !row.complete ? "≤" : "";
    return fmt::format("{}×{:.{}f}{}", bound, row.ratio, row.ratio < 100 ? 2 : 0,
                       row.voidReason.empty() ? "" : " void");
}

std::string FormatCpuRatio(const BenchRow& row) {
    if (row.IsBaseline() || row.cpuRatio == 0) return "";
    return fmt::format("×{:.{}f}", row.cpuRatio, row.cpuRatio < 100 ? 2 : 0);
}

std::string FormatSetting(const BenchRow& row) {
    return fmt::format("{} {}{}", row.solver, row.threads, row.continuous ? " ccd" : "");
}

}  // namespace

std::string FormatBenchHeader() {
    return fmt::format(
        "{:<21} {:>7} {:<6} {:<10} {:>9} {:>11} {:>15} {:>12} {:>10} {:>9} {:>9} {:>9} {:>9} | {:>9} {:>9} {:>8} {:>9} "
        "{:>9} | {:>7} {:>8} {:>8} {}\n",
        "scene", "size", "engine", "solver thr", "create", "total ms", "quartiles", "ratio", "cpu ms", "ratio",
        "median", "p99", "max", "broad", "narrow", "islands", "solver", "contin.", "ns/body", "contacts", "MB",
        "state hash");
}

std::string FormatBenchRows(std::span<const BenchRow> rows) {
    std::string text, voids;
    for (const BenchRow& row : rows) {
        const BenchRow* baseline = FindBaseline(rows, row);
        const StageTotals& s = row.stages;
        text += fmt::format(
            "{:<21} {:>7} {:<6} {:<10} {:>9.1f} {:>11} {:>15} {:>12} {:>10.1f} {:>9} {:>9.3f} {:>9.3f} {:>9.3f} | "
            "{:>9.1f} "
            "{:>9.1f} {:>8.1f} "
            "{:>9.1f} {:>9.1f} | {:>7.0f} {:>8} {:>8.2f} {}\n",
            row.scene, row.size, row.GetName(), FormatSetting(row), row.createMs,
            fmt::format("{}{:.1f}", row.complete ? "" : "≥", row.totalMs),
            fmt::format("{:.1f}-{:.1f}", row.totalLowMs, row.totalHighMs), FormatRatio(row, baseline), row.cpuMs,
            FormatCpuRatio(row), row.medianMs, row.p99Ms, row.maxMs, s.broadPhase, s.narrowPhase, s.islands, s.solver,
            s.continuous, row.nsPerBodyStep, row.peakContacts, static_cast<double>(row.peakBytes) / megabyte,
            FormatHash(row.stateHash));
        if (!row.complete) voids += fmt::format("  stopped at the time limit after {} steps\n", row.steps);
        if (WasBusy(row)) {
            voids +=
                fmt::format("  busy machine ({} {}): {:.2f} times the processor's time; trust the ratio of cpu ms\n",
                            row.GetName(), FormatSetting(row), row.totalMs / row.cpuMs);
        }
        if (!row.voidReason.empty()) voids += fmt::format("  void ({}): {}\n", FormatSetting(row), row.voidReason);
    }
    return text + voids;
}

std::string FormatBenchNotes() {
    return "Times are in ms. `create` builds the world; the total adds up the stages of all steps. Median, p99 and "
           "max\n"
           "are of single steps, quartiles of the repeats' totals.\n\n"
           "A ratio is the baseline's total over the row's. It is that of the baseline with as many threads, or with "
           "one\n"
           "if it has no such row. One ratio is by wall time. The other is by processor time of all threads, which\n"
           "other programs do not lengthen.\n\n"
           "Box2D's solver includes finding islands. Its broad phase includes the pair search after new fixtures, but\n"
           "not the retest in Collide. Debian's libbox2d has its asserts compiled in.\n\n"
           "A row is void if the engines did unlike work in the steps that both took: awake body-steps differ by over\n"
           "2 %, or touching contacts by over 20 %.\n\n"
           "Settings are preset=like-box2d (Box2D's caps of speed, no continuous collision), unless --set says "
           "otherwise.\n\n";
}

}  // namespace testbed
