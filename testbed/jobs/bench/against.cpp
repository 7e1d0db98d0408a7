// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of against.h. Rows are read by the names that every version has written, so that older builds serve
// too.

#include "testbed/jobs/bench/against.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"
#include "testbed/base/process.h"
#include "testbed/base/progress.h"
#include "testbed/base/statistics.h"
#include "testbed/page/facts.h"

namespace testbed {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr double sureShare = 0.95;

/// A file for rows that goes with the object.
class RowFile {
public:
    RowFile() : m_path(fs::temp_directory_path() / fmt::format("scree-against-{}.json", getpid())) {}
    RowFile(const RowFile&) = delete;
    RowFile& operator=(const RowFile&) = delete;
    ~RowFile() {
        std::error_code ignored;
        fs::remove(m_path, ignored);
    }
    [[nodiscard]] const fs::path& GetPath() const { return m_path; }

private:
    fs::path m_path;
};

/// Scene, size, pane, solver, threads, continuous: what a row is of.
using RowKey = std::tuple<std::string, int, std::string, std::string, int, bool>;

/// What one build measured of a case, round by round.
struct Timings {
    std::vector<double> ms;
    int steps = 0;
    std::string hash;
};

struct BothTimings {
    std::array<Timings, 2> builds;  ///< this one, the other
};

RowKey FindKey(const ordered_json& row) {
    const std::string pane = row.value("pane", std::string());
    return {row.at("scene").get<std::string>(),
            row.at("size").get<int>(),
            pane.empty() ? row.at("engine").get<std::string>() : pane,
            row.at("solver").get<std::string>(),
            row.at("threads").get<int>(),
            row.at("continuous").get<bool>()};
}

std::string LastLine(const std::string& text) {
    const auto end = text.find_last_not_of('\n');
    if (end == std::string::npos) return "it said nothing";
    const auto begin = text.find_last_of('\n', end);
    return text.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin == std::string::npos ? -1 : begin));
}

/// One round of a scene in one build: its rows.
std::vector<ordered_json> RunBuild(const fs::path& program, const std::string& scene, const AgainstPlan& plan) {
    const RowFile file;
    std::vector<std::string> words{program.string(), "bench", scene};
    words.insert(words.end(), plan.options.begin(), plan.options.end());
    for (const char* word : {"--repeat", "1", "--json"}) words.emplace_back(word);
    words.push_back(file.GetPath().string());
    const MemoryFile said;
    Process process;
    if (const std::error_code error = process.Start(words, {.output = said.Get(), .errors = said.Get()})) {
        throw FileError(fmt::format("{}: {}", program.string(), error.message()));
    }
    const ProcessEnd end = process.Wait();
    if (!end.IsGood()) {
        throw FileError(
            fmt::format("{} bench {}: exit code {}: {}; both builds get the same words, so give only options "
                        "that both have",
                        program.string(), scene, end.GetExitCode(), LastLine(said.Read())));
    }
    std::vector<ordered_json> rows;
    std::ifstream lines(file.GetPath());
    for (std::string line; std::getline(lines, line);) {
        try {
            rows.push_back(ordered_json::parse(line));
            (void)FindKey(rows.back());
            (void)rows.back().at("ms").at("cpu_ms").get<double>();
            (void)rows.back().at("ms").at("total_ms").get<double>();
            (void)rows.back().at("state_hash");
            (void)rows.back().at("steps").get<int>();
        } catch (const ordered_json::exception& error) {
            throw FileError(
                fmt::format("{} bench {}: a row cannot be read: {}", program.string(), scene, error.what()));
        }
    }
    if (rows.empty())
        throw FileError(
            fmt::format("{} bench {}: it wrote no measurements; run it to see why", program.string(), scene));
    return rows;
}

AgainstRow Judge(const RowKey& key, const BothTimings& both) {
    AgainstRow row;
    std::tie(row.scene, row.size, row.pane, row.solver, row.threads, row.continuous) = key;
    const Timings &here = both.builds[0], &there = both.builds[1];
    row.hereMs = Quantile(here.ms, 0.5);
    row.thereMs = Quantile(there.ms, 0.5);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < here.ms.size(); ++i) ratios.push_back(there.ms[i] / std::max(here.ms[i], 1e-9));
    row.ratio = FindMedianInterval(ratios);
    row.sameSteps = here.steps == there.steps;
    row.sameState = row.sameSteps && here.hash == there.hash;
    return row;
}

std::string Describe(const AgainstRow& row) {
    if (!row.ratio.isSure) return "too few rounds";
    if (row.ratio.low > 1.0) return "faster";
    if (row.ratio.high < 1.0) return "slower";
    return "no difference seen";
}

std::string DescribeState(const AgainstRow& row) {
    return row.sameState ? "same" : row.sameSteps ? "differs" : "other steps";
}

}  // namespace

fs::path FindBuiltProgram(const fs::path& given) {
    for (const fs::path& path :
         {given, given / "testbed/scree", given / "build/release/testbed/scree", given / "bin/scree"}) {
        if (fs::is_regular_file(path) && access(path.c_str(), X_OK) == 0) return fs::absolute(path);
    }
    throw UsageError(
        fmt::format("--against {}: there is no program `scree`; give a build folder (with testbed/scree), a checkout "
                    "that was built, or the file",
                    given.string()));
}

MedianInterval FindMedianInterval(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const std::size_t n = sorted.size();
    // The chance that at most k of n values lie on one side of the true median, for k = 0, 1, …: binomial tails.
    std::size_t cut = 0;
    double point = 1.0;
    for (std::size_t i = 0; i < n; ++i) point *= 0.5;
    bool isSure = false;
    for (double tail = point; 1.0 - 2.0 * tail >= sureShare && 2 * cut + 1 < n;) {
        isSure = true;
        ++cut;
        point *= static_cast<double>(n - cut + 1) / static_cast<double>(cut);
        tail += point;
    }
    const std::size_t first = isSure ? cut - 1 : 0;
    return {sorted[first], Quantile(sorted, 0.5), sorted[n - 1 - first], isSure};
}

AgainstResult RunAgainst(const AgainstPlan& plan) {
    const std::array<fs::path, 2> programs{"/proc/self/exe", plan.program};
    AgainstResult result;
    for (const std::string& scene : plan.scenes) {
        Progress progress(scene, 2.0 * plan.rounds);
        std::map<RowKey, BothTimings> timings;
        std::vector<RowKey> order;
        for (int round = 0; round < plan.rounds; ++round) {
            for (int turn = 0; turn < 2; ++turn) {
                const std::size_t build = static_cast<std::size_t>((round + turn) % 2);  // who begins alternates
                for (const ordered_json& row : RunBuild(programs[build], scene, plan)) {
                    const RowKey key = FindKey(row);
                    if (!timings.contains(key)) order.push_back(key);
                    Timings& timing = timings[key].builds[build];
                    timing.ms.push_back(row["ms"][row["threads"] == 1 ? "cpu_ms" : "total_ms"].get<double>());
                    timing.steps = row["steps"].get<int>();
                    timing.hash = PrintJson(row["state_hash"]);
                    const ordered_json made = row.value("made", ordered_json());
                    if (!made.is_null() && std::ranges::find(result.made, made) == result.made.end()) {
                        result.made.push_back(made);
                    }
                }
                progress.Advance(1.0);
            }
        }
        for (const RowKey& key : order) {
            const auto rounds = static_cast<std::size_t>(plan.rounds);
            const BothTimings& both = timings.at(key);
            if (both.builds[0].ms.size() != rounds || both.builds[1].ms.size() != rounds) {
                throw FileError(fmt::format("{}: {} has no row in one of the builds; choose what both have",
                                            plan.program.string(), scene));
            }
            result.rows.push_back(Judge(key, both));
        }
        progress.Finish(fmt::format("{} rounds", plan.rounds));
    }
    return result;
}

bool IsSlower(const AgainstRow& row, double least) { return row.ratio.high < least; }

std::string FormatAgainst(const AgainstResult& result) {
    std::string text = fmt::format("{:<28} {:>7} {:<8} {:>3} {:>10} {:>10} {:>7} {:>15}  {:<18} {}\n", "scene", "size",
                                   "solver", "thr", "here ms", "there ms", "ratio", "95 %", "", "state");
    std::vector<double> ratios;
    for (const AgainstRow& row : result.rows) {
        const std::string name = row.pane == "scree" ? row.scene : row.scene + " " + row.pane;
        text +=
            fmt::format("{:<28} {:>7} {:<8} {:>3} {:>10.2f} {:>10.2f} {:>7.3f} {:>15}  {:<18} {}\n",
                        name + (row.continuous ? " (continuous)" : ""), row.size, row.solver, row.threads, row.hereMs,
                        row.thereMs, row.ratio.median, fmt::format("{:.3f} – {:.3f}", row.ratio.low, row.ratio.high),
                        Describe(row), DescribeState(row));
        ratios.push_back(row.ratio.median);
    }
    text += fmt::format(
        "ratio: the other build's time over this one's, median of the rounds; above 1 this one is faster. All cases: "
        "median {:.3f}, least {:.3f}\n",
        Quantile(ratios, 0.5), ratios.empty() ? 0.0 : *std::ranges::min_element(ratios));
    return text;
}

Page MakeAgainstPage(const AgainstResult& result, const std::string& command) {
    Page page{.title = "Two builds side by side",
              .intro =
                  "Each case runs in both builds in turn, each time in a process of its own. A ratio is the other "
                  "build's time over this one's: above 1 this build is faster. The interval holds the true median "
                  "with a probability of 95 %, judged from the order of the rounds alone."};
    page.facts.push_back({"command", command});
    AddFacts(page, result.made);
    PageTable table{.columns = {{.name = "scene"},
                                {.name = "size", .numeric = true},
                                {.name = "pane"},
                                {.name = "solver"},
                                {.name = "threads", .numeric = true},
                                {.name = "here", .unit = "ms", .numeric = true},
                                {.name = "there", .unit = "ms", .numeric = true},
                                {.name = "ratio", .unit = "×", .numeric = true},
                                {.name = "from", .unit = "×", .numeric = true},
                                {.name = "to", .unit = "×", .numeric = true},
                                {.name = "this build is"},
                                {.name = "state after the last step"}},
                    .filter = true};
    for (const AgainstRow& row : result.rows) {
        const PageTone tone = !row.ratio.isSure      ? PageTone::muted
                              : row.ratio.low > 1.0  ? PageTone::good
                              : row.ratio.high < 1.0 ? PageTone::bad
                                                     : PageTone::plain;
        PageCell verdict(Describe(row)), state(DescribeState(row));
        verdict.tone = tone;
        state.tone = row.sameState ? PageTone::plain : PageTone::warning;
        table.rows.push_back({row.scene + (row.continuous ? " (continuous)" : ""), PageCell::Number(row.size), row.pane,
                              row.solver, PageCell::Number(row.threads), PageCell::Number(row.hereMs, 2),
                              PageCell::Number(row.thereMs, 2), PageCell::Number(row.ratio.median, 3, tone),
                              PageCell::Number(row.ratio.low, 3), PageCell::Number(row.ratio.high, 3), verdict, state});
    }
    page.sections.push_back({.title = "Cases", .blocks = {table}});
    return page;
}

}  // namespace testbed
