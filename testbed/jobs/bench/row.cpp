// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of row.h.

#include "testbed/jobs/bench/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

#include "testbed/base/csv.h"
#include "testbed/base/json_lines.h"
#include "testbed/base/statistics.h"
#include "testbed/base/text.h"

namespace testbed {
namespace {

/// Differences beyond which two runs did not do the same work.
constexpr double awakeTolerance = 0.02, touchingTolerance = 0.20;

/// Calls visit(column, value) in the order of the columns; this and the next are the one place that names them.
template <typename Row, typename Visit>
void ForEachCount(Row& row, Visit&& visit) {
    visit("scene", row.scene);
    visit("size", row.size);
    visit("fixtures", row.fixtures);
    visit("joints", row.joints);
    visit("movers", row.movers);
    visit("engine", row.engine);
    visit("solver", row.solver);
    visit("threads", row.threads);
    visit("continuous", row.continuous);
    visit("repeats", row.repeats);
    visit("steps", row.steps);
    visit("complete", row.complete);
    visit("awake_body_steps", row.awakeBodySteps);
    visit("touching_sum", row.touchingSum);
    visit("contact_sum", row.contactSum);
    visit("peak_contacts", row.peakContacts);
    visit("peak_bytes", row.peakBytes);
    visit("state_hash", row.stateHash);
    visit("void", row.voidReason);
}

/// What depends on the clock.
template <typename Row, typename Visit>
void ForEachTime(Row& row, Visit&& visit) {
    visit("create_ms", row.createMs);
    visit("total_ms", row.totalMs);
    visit("total_q1_ms", row.totalLowMs);
    visit("total_q3_ms", row.totalHighMs);
    visit("cpu_ms", row.cpuMs);
    visit("median_ms", row.medianMs);
    visit("p99_ms", row.p99Ms);
    visit("max_ms", row.maxMs);
    visit("max_step", row.maxStep);
    visit("broad_phase_ms", row.stages.broadPhase);
    visit("narrow_phase_ms", row.stages.narrowPhase);
    visit("islands_ms", row.stages.islands);
    visit("solver_ms", row.stages.solver);
    visit("continuous_ms", row.stages.continuous);
    visit("ns_per_body_step", row.nsPerBodyStep);
    visit("ratio", row.ratio);
    visit("cpu_ratio", row.cpuRatio);
}

/// How it was run. Lines that older programs wrote may lack these fields.
template <typename Row, typename Visit>
void ForEachSetting(Row& row, Visit&& visit) {
    visit("pane", row.pane);
    visit("settings", row.settings);
    visit("baseline", row.baseline);
}

template <typename Row, typename Visit>
void ForEachColumn(Row& row, Visit&& visit) {
    ForEachCount(row, visit);
    ForEachTime(row, visit);
    ForEachSetting(row, visit);
}

/// A hash as it is written: JSON numbers cannot hold 64 bits.
template <typename Value>
constexpr bool isHash = std::is_same_v<Value, uint64_t>;

template <typename Value>
void ReadField(const nlohmann::ordered_json& object, const char* name, Value& value) {
    if constexpr (isHash<Value>) {
        const Parsed<uint64_t> hash = ParseHash(object.at(name).get<std::string>());
        if (!hash) throw std::invalid_argument(fmt::format("{}: {}", name, hash.problem));
        value = *hash;
    } else {
        value = object.at(name).get<Value>();
    }
}

BenchRow ReadRow(const nlohmann::ordered_json& object) {
    BenchRow row;
    ForEachCount(row, [&](const char* name, auto& value) { ReadField(object, name, value); });
    ForEachTime(row, [&](const char* name, auto& value) { ReadField(object.at("ms"), name, value); });
    ForEachSetting(row, [&](const char* name, auto& value) {
        if (object.contains(name)) ReadField(object, name, value);
    });
    return row;
}

double Difference(int64_t ours, int64_t theirs) {
    if (ours == theirs) return 0;
    return std::abs(static_cast<double>(ours - theirs)) / static_cast<double>(std::max<int64_t>(1, theirs));
}

std::string DescribeDifference(std::span<const WorkCounts> own, std::span<const WorkCounts> baseline) {
    const std::size_t common = std::min(own.size(), baseline.size());
    if (common == 0) return {};
    const double awake = Difference(own[common - 1].awake, baseline[common - 1].awake);
    const double touching = Difference(own[common - 1].touching, baseline[common - 1].touching);
    std::string reason;
    if (awake > awakeTolerance) reason = fmt::format("awake body-steps differ by {:.1f} %", 100 * awake);
    if (touching > touchingTolerance) {
        reason += fmt::format("{}touching contacts differ by {:.0f} %", reason.empty() ? "" : "; ", 100 * touching);
    }
    if (!reason.empty() && own.size() != baseline.size()) reason += fmt::format(" in the first {} steps", common);
    return reason;
}

}  // namespace

BenchRun MergeRepeats(std::span<const BenchRun> runs) {
    BenchRun merged;
    std::vector<double> creates;
    std::size_t shortest = runs.front().steps.size();
    for (const BenchRun& run : runs) {
        creates.push_back(run.createMs);
        shortest = std::min(shortest, run.steps.size());
        merged.complete = merged.complete && run.complete;
    }
    merged.createMs = NearestRankQuantile(creates, 0.5);
    merged.work = runs.front().work;
    if (merged.work.size() > shortest) merged.work.resize(shortest);
    std::vector<StepRecord> same;
    for (std::size_t i = 0; i < shortest; ++i) {
        same.clear();
        for (const BenchRun& run : runs) same.push_back(run.steps[i]);
        const auto middle = same.begin() + static_cast<std::ptrdiff_t>(NearestRank(same.size(), 0.5));
        std::nth_element(same.begin(), middle, same.end(),
                         [](const StepRecord& a, const StepRecord& b) { return a.times.step < b.times.step; });
        merged.steps.push_back(*middle);
    }
    return merged;
}

void SetTimes(BenchRow& row, const BenchRun& run) {
    std::vector<double> times;
    row.steps = static_cast<int>(run.steps.size());
    row.complete = run.complete;
    row.createMs = run.createMs;
    row.totalMs = row.cpuMs = row.maxMs = 0;
    row.stages = {};
    for (const StepRecord& record : run.steps) {
        const StepTimes& t = record.times;
        times.push_back(t.step);
        row.totalMs += t.step;
        row.cpuMs += t.cpu;
        if (t.step > row.maxMs) {
            row.maxMs = t.step;
            row.maxStep = record.step;
        }
        row.stages.broadPhase += t.broadPhase;
        row.stages.narrowPhase += t.narrowPhase;
        row.stages.islands += t.islands;
        row.stages.solver += t.solver - t.islands;
        row.stages.continuous += t.continuous;
    }
    row.medianMs = NearestRankQuantile(times, 0.5);
    row.p99Ms = NearestRankQuantile(times, 0.99);
    row.nsPerBodyStep = row.awakeBodySteps > 0 ? row.totalMs * 1e6 / static_cast<double>(row.awakeBodySteps) : 0;
}

const BenchRow* FindBaseline(std::span<const BenchRow> rows, const BenchRow& row) {
    const BenchRow* found = nullptr;
    const auto isCloser = [&](const BenchRow& other) {
        const auto key = [&](const BenchRow& one) {
            return std::tuple(one.continuous == row.continuous, one.threads == row.threads, -one.threads);
        };
        return found == nullptr || key(other) > key(*found);
    };
    for (const BenchRow& other : rows) {
        if (other.GetName() != row.baseline || other.scene != row.scene || other.size != row.size) continue;
        // Rows without settings differ from their baseline in the continuous setting alone.
        if (other.continuous != row.continuous && row.settings.empty()) continue;
        if (isCloser(other)) found = &other;
    }
    return found;
}

bool WasBusy(const BenchRow& row) {
    constexpr double most = 1.15;
    return row.threads == 1 && row.cpuMs > 0 && row.totalMs > most * row.cpuMs;
}

void CompareWithBaseline(std::span<BenchRow> rows, std::span<const std::vector<WorkCounts>> work) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        BenchRow& row = rows[i];
        const BenchRow* baseline = FindBaseline(rows, row);
        row.ratio = baseline != nullptr && row.totalMs > 0 ? baseline->totalMs / row.totalMs : 0;
        row.cpuRatio = baseline != nullptr && row.cpuMs > 0 ? baseline->cpuMs / row.cpuMs : 0;
        if (baseline == nullptr) continue;
        row.voidReason = DescribeDifference(work[i], work[static_cast<std::size_t>(baseline - rows.data())]);
    }
}

std::string WriteBenchCsv(std::span<const BenchRow> rows) {
    CsvTable table;
    const BenchRow none;
    ForEachColumn(none, [&](const char* name, const auto&) { table.Add(std::string_view(name)); });
    table.EndRow();
    for (const BenchRow& row : rows) {
        ForEachColumn(row, [&](const char*, const auto& value) {
            if constexpr (isHash<std::remove_cvref_t<decltype(value)>>) {
                table.Add(FormatHash(value));
            } else {
                table.Add(value);
            }
        });
        table.EndRow();
    }
    return table.GetText();
}

nlohmann::ordered_json MakeBenchJson(const BenchRow& row) {
    nlohmann::ordered_json object, times;
    ForEachCount(row, [&object](const char* name, const auto& value) {
        if constexpr (isHash<std::remove_cvref_t<decltype(value)>>) {
            object[name] = FormatHash(value);
        } else {
            object[name] = value;
        }
    });
    ForEachTime(row, [&times](const char* name, const auto& value) { times[name] = value; });
    ForEachSetting(row, [&object](const char* name, const auto& value) { object[name] = value; });
    object["ms"] = std::move(times);
    return object;
}

std::vector<BenchRow> ReadBenchRows(const std::string& file, const std::string& text) {
    std::vector<BenchRow> rows;
    ParseJsonLines(file, text, "bench", [&](const nlohmann::ordered_json& object) { rows.push_back(ReadRow(object)); });
    return rows;
}

}  // namespace testbed
