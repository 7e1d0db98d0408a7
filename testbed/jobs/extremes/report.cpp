// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of report.h.

#include "testbed/jobs/extremes/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "testbed/base/csv.h"
#include "testbed/base/errors.h"

namespace testbed {

namespace {

const ExtremeCase* FindCase(const std::string& name) {
    const auto found = std::ranges::find(GetExtremeCases(), name, &ExtremeCase::name);
    return found == GetExtremeCases().end() ? nullptr : &*found;
}

std::vector<std::string> SettingsOf(std::span<const ExtremeResult> results) {
    std::vector<std::string> settings;
    for (const ExtremeResult& result : results) {
        if (std::ranges::find(settings, result.setting) == settings.end()) settings.push_back(result.setting);
    }
    return settings;
}

bool IsOurs(const std::string& setting) { return setting.starts_with("scree"); }

PageCell GradeCell(const ExtremeResult& result) {
    const int grade = static_cast<int>(result.verdict.grade);
    PageCell cell(grade < 0 ? "–" : PrintGrade(result.verdict.grade));
    cell.value = grade;
    cell.tone = grade == 4 ? PageTone::good : grade == 3 || grade < 0 ? PageTone::warning : PageTone::bad;
    cell.hint = fmt::format("{}{}{}", NameGrade(result.verdict.grade), result.verdict.reasons.empty() ? "" : ": ",
                            fmt::join(result.verdict.reasons, "; "));
    return cell;
}

const ExtremeResult* Find(std::span<const ExtremeResult> results, const std::string& name, const std::string& setting) {
    for (const ExtremeResult& result : results) {
        if (result.name == name && result.setting == setting) return &result;
    }
    return nullptr;
}

PageTable MakeMatrix(std::span<const ExtremeResult> results) {
    PageTable table{.columns = {{.name = "case"}, {.name = "group"}, {.name = "what"}}, .filter = true};
    const std::vector<std::string> settings = SettingsOf(results);
    for (const std::string& setting : settings) table.columns.push_back({.name = setting, .numeric = true});
    for (const ExtremeCase& one : GetExtremeCases()) {
        std::vector<PageCell> row{one.name, one.group, one.what};
        bool any = false;
        for (const std::string& setting : settings) {
            const ExtremeResult* result = Find(results, one.name, setting);
            row.push_back(result ? GradeCell(*result) : PageCell("–"));
            any = any || result != nullptr;
        }
        if (any) table.rows.push_back(row);
    }
    return table;
}

PageTable MakeReasons(std::span<const ExtremeResult> results) {
    PageTable table{
        .columns = {{.name = "case"}, {.name = "setting"}, {.name = "grade", .numeric = true}, {.name = "reasons"}},
        .filter = true};
    for (const ExtremeResult& result : results) {
        if (result.verdict.grade == Grade::accurate) continue;
        table.rows.push_back({result.name, result.setting, GradeCell(result),
                              fmt::format("{}", fmt::join(result.verdict.reasons, "; "))});
    }
    return table;
}

/// From the best grade down, then what is no grade.
constexpr std::array gradesInOrder{Grade::accurate,  Grade::survives, Grade::explodes,
                                   Grade::nonFinite, Grade::abort,    Grade::notFinished};

std::ptrdiff_t CountGrade(std::span<const ExtremeResult> results, const std::string& setting, Grade grade) {
    return std::ranges::count_if(results, [&](const ExtremeResult& result) {
        return result.setting == setting && result.verdict.grade == grade;
    });
}

/// How many runs that could have been repeated were not, for lack of time.
std::ptrdiff_t CountUnrepeated(std::span<const ExtremeResult> results, const std::string& setting) {
    return std::ranges::count_if(results, [&](const ExtremeResult& result) {
        const ExtremeCase* one = FindCase(result.name);
        return result.setting == setting && one != nullptr && !one->abuse && result.verdict.grade >= Grade::survives &&
               result.outcome.repeated < 0;
    });
}

PageTable MakeCounts(std::span<const ExtremeResult> results) {
    PageTable table{.columns = {{.name = "setting"}}};
    for (const Grade grade : gradesInOrder) {
        const std::string number = PrintGrade(grade);
        table.columns.push_back({.name = (number.empty() ? "" : number + ": ") + NameGrade(grade), .numeric = true});
    }
    table.columns.push_back({.name = "no second run", .numeric = true});
    for (const std::string& setting : SettingsOf(results)) {
        std::vector<PageCell> row{setting};
        for (const Grade grade : gradesInOrder) {
            row.push_back(PageCell::Number(static_cast<double>(CountGrade(results, setting, grade))));
        }
        row.push_back(PageCell::Number(static_cast<double>(CountUnrepeated(results, setting))));
        table.rows.push_back(row);
    }
    return table;
}

/// How many runs of a group have which grade: "58 · 43 · 12 · 1 · 10", then those that were not finished.
std::string CountGroup(std::span<const ExtremeResult> results, const std::string& group, const std::string& setting) {
    std::string text;
    std::ptrdiff_t unfinished = 0;
    for (const Grade grade : gradesInOrder) {
        const std::ptrdiff_t count = std::ranges::count_if(results, [&](const ExtremeResult& result) {
            const ExtremeCase* one = FindCase(result.name);
            const bool isOfGroup = one != nullptr && (group.empty() || one->group == group);
            return isOfGroup && result.setting == setting && result.verdict.grade == grade;
        });
        if (grade == Grade::notFinished) {
            unfinished = count;
        } else {
            text += fmt::format("{}{}", text.empty() ? "" : " · ", count);
        }
    }
    return unfinished > 0 ? fmt::format("{} ({} not finished)", text, unfinished) : text;
}

PageTable MakeGroups(std::span<const ExtremeResult> results) {
    PageTable table{.title = "By group",
                    .caption = "Runs with grade 4 · 3 · 2 · 1 · 0.",
                    .columns = {{.name = "group"}, {.name = "cases", .numeric = true}}};
    const std::vector<std::string> settings = SettingsOf(results);
    for (const std::string& setting : settings) table.columns.push_back({.name = setting});
    std::vector<std::pair<std::string, int>> groups;
    int all = 0;
    for (const ExtremeCase& one : GetExtremeCases()) {
        if (std::ranges::find(results, one.name, &ExtremeResult::name) == results.end()) continue;
        const auto found = std::ranges::find(groups, one.group, &std::pair<std::string, int>::first);
        ++all;
        if (found == groups.end()) {
            groups.emplace_back(one.group, 1);
        } else {
            ++found->second;
        }
    }
    groups.emplace_back("", all);
    for (const auto& [group, cases] : groups) {
        std::vector<PageCell> row{group.empty() ? "all" : group, PageCell::Number(cases)};
        for (const std::string& setting : settings) row.emplace_back(CountGroup(results, group, setting));
        table.rows.push_back(row);
    }
    return table;
}

/// A number that a case is asked for, and how a report names it.
struct Question {
    const char* name;
    double Demands::*asked;
    double Outcome::*found;
};
constexpr Question questions[] = {{"error", &Demands::accuracy, &Outcome::accuracy},
                                  {"joint gap, m", &Demands::jointGap, &Outcome::jointGap},
                                  {"overlap, m", &Demands::overlap, &Outcome::overlap},
                                  {"speed at rest, m/s", &Demands::restSpeed, &Outcome::restSpeed}};

/// Of every case with such questions the answers of all settings, in the order of the questions.
PageTable MakeAnswers(std::span<const ExtremeResult> results) {
    PageTable table{.columns = {{.name = "case"}, {.name = "what"}, {.name = "asked, at most"}}, .filter = true};
    const std::vector<std::string> settings = SettingsOf(results);
    for (const std::string& setting : settings) table.columns.push_back({.name = setting});
    for (const ExtremeCase& one : GetExtremeCases()) {
        std::vector<std::string> asked;
        for (const Question& question : questions) {
            const double most = one.demands.*question.asked;
            if (most > 0.0) asked.push_back(fmt::format("{} {:.2g}", question.name, most));
        }
        if (asked.empty() || std::ranges::find(results, one.name, &ExtremeResult::name) == results.end()) continue;
        std::vector<PageCell> row{one.name, one.what, fmt::format("{}", fmt::join(asked, ", "))};
        for (const std::string& setting : settings) {
            const ExtremeResult* result = Find(results, one.name, setting);
            std::string answers = result == nullptr ? "–" : "";
            for (const Question& question : questions) {
                if (result == nullptr || !(one.demands.*question.asked > 0.0)) continue;
                const double found = result->outcome.*question.found;
                answers += answers.empty() ? "" : ", ";
                answers += found < 0.0 ? "–" : fmt::format("{:.2g}", found);
            }
            if (result != nullptr && result->outcome.escapes > 0) answers += ", escapes";
            row.emplace_back(answers);
        }
        table.rows.push_back(row);
    }
    return table;
}

PageTable MakeMeasurements(std::span<const ExtremeResult> results) {
    PageTable table{.columns = {{.name = "case"},
                                {.name = "setting"},
                                {.name = "simulated", .unit = "s", .numeric = true},
                                {.name = "cut short"},
                                {.name = "gain", .unit = "%", .numeric = true},
                                {.name = "overlap", .unit = "mm", .numeric = true},
                                {.name = "joint gap", .unit = "mm", .numeric = true},
                                {.name = "contacts", .numeric = true},
                                {.name = "slowest step", .unit = "ms", .numeric = true}},
                    .filter = true};
    for (const ExtremeResult& r : results) {
        const Outcome& o = r.outcome;
        table.rows.push_back({r.name, r.setting, PageCell::Number(o.seconds, 2), o.shortened ? "yes" : "",
                              PageCell::Number(100.0 * o.gain, 3), PageCell::Number(1e3 * o.overlap, 3),
                              PageCell::Number(1e3 * o.jointGap, 3), PageCell::Number(o.contacts),
                              PageCell::Number(o.milliseconds, 2)});
    }
    return table;
}

/// In which cases each rival has a better grade than each setting of ours.
std::string DescribeBetterRivals(std::span<const ExtremeResult> results) {
    constexpr std::size_t mostNames = 8;
    const std::vector<std::string> settings = SettingsOf(results);
    std::vector<std::string> sentences;
    for (const std::string& rival : settings) {
        for (const std::string& ours : settings) {
            if (IsOurs(rival) || !IsOurs(ours)) continue;
            std::vector<std::string> better;
            for (const ExtremeResult& result : results) {
                const ExtremeResult* own = Find(results, result.name, ours);
                if (result.setting != rival || own == nullptr || own->verdict.grade == Grade::notFinished) continue;
                if (result.verdict.grade > own->verdict.grade) better.push_back(result.name);
            }
            if (better.empty()) continue;
            const std::string names =
                better.size() <= mostNames ? fmt::format(": {}", fmt::join(better, ", ")) : std::string();
            sentences.push_back(fmt::format("{} has a better grade than {} in {} case{}{}.", rival, ours, better.size(),
                                            better.size() == 1 ? "" : "s", names));
        }
    }
    return fmt::format("{}", fmt::join(sentences, " "));
}

constexpr std::string_view meaning =
    "Every case runs in a process of its own, with a limit of processor time, and gets a grade. 4: everything as "
    "asked. 3: all survives, but one of the questions is answered badly. 2: energy more than doubles, a body passes a "
    "wall or leaves its place, or the scene is refused. 1: a state is no longer finite. 0: the engine aborts or "
    "hangs.\n\n"
    "A run whose time was over before its end, with nothing broken until then, is `not finished` and has no grade. "
    "Where our engine is told a length scale, its line says so. Box2D has its scale compiled in.\n\n"
    "These are the questions. Are all states finite? Does energy rise by no more than 1 %? Does nobody escape? Two "
    "seconds after a load came, does nobody overlap by more than a tenth of its size? Does no step do more than 50 "
    "times the usual work? Does what should come to rest do so within five seconds? Does a second run end in the same "
    "states? Does bad input get an error that names the field, and change nothing? Grade 4 also asks for small "
    "overlaps (2 cm for bodies of 1 m) and small joint gaps (1 cm).";

}  // namespace

nlohmann::ordered_json ToJson(const ExtremeResult& result) {
    nlohmann::ordered_json fields;
    fields["name"] = result.name;
    fields["setting"] = result.setting;
    if (result.verdict.grade == Grade::notFinished) {
        fields["grade"] = nullptr;
    } else {
        fields["grade"] = static_cast<int>(result.verdict.grade);
    }
    fields["reasons"] = result.verdict.reasons;
    fields["timedOut"] = result.ending.timedOut;
    fields["signal"] = result.ending.signal;
    fields["exitCode"] = result.ending.exitCode;
    fields["told"] = result.ending.output;
    fields["outcome"] = ToJson(result.outcome);
    return fields;
}

ExtremeResult ExtremeResultFromJson(const nlohmann::ordered_json& fields) {
    ExtremeResult result;
    try {
        result.name = fields.at("name").get<std::string>();
        result.setting = fields.at("setting").get<std::string>();
        result.ending = {fields.at("timedOut").get<bool>(), fields.at("signal").get<int>(),
                         fields.at("exitCode").get<int>(), fields.at("told").get<bool>()};
        result.outcome = OutcomeFromJson(fields.at("outcome"));
    } catch (const nlohmann::json::exception& error) {
        throw FileError(std::string("a field is missing or of another kind: ") + error.what());
    }
    const ExtremeCase* one = FindCase(result.name);
    if (!one) throw FileError("no such case: " + result.name);
    result.verdict = GradeCase(*one, result.ending, result.outcome);
    return result;
}

std::string MakeExtremesCsv(std::span<const ExtremeResult> results) {
    CsvTable table{"case",       "group",    "setting",  "grade",          "reasons",   "signal",        "seconds",
                   "cut_short",  "gain",     "escapes",  "max_speed",      "overlap_m", "overlap_share", "joint_gap_m",
                   "rest_speed", "accuracy", "contacts", "work_ratio",     "capped",    "stopped",       "repeated",
                   "bad_calls",  "refused",  "named",    "slowest_step_ms"};
    const auto six = [](double value) { return fmt::format("{:.6g}", value); };
    const auto four = [](double value) { return fmt::format("{:.4g}", value); };
    for (const ExtremeResult& r : results) {
        const Outcome& o = r.outcome;
        const ExtremeCase* one = FindCase(r.name);
        table.AddCells(r.name, one ? one->group : "", r.setting, PrintGrade(r.verdict.grade),
                       fmt::format("{}", fmt::join(r.verdict.reasons, "; ")), r.ending.signal);
        table.AddCells(four(o.seconds), o.shortened ? 1 : 0, six(o.gain), o.escapes, six(o.maxSpeed), six(o.overlap),
                       six(o.overlapShare), six(o.jointGap), six(o.restSpeed), six(o.accuracy));
        table.AddRow(o.contacts, four(o.workRatio), o.capped, o.stopped, o.repeated, o.badCalls, o.refused, o.named,
                     fmt::format("{:.4f}", o.milliseconds));
    }
    return table.GetText();
}

Page MakeExtremesPage(std::span<const ExtremeResult> results, const std::map<std::string, std::string>& pictures,
                      const std::string& command) {
    Page page{.title = "Stability at the extremes",
              .intro =
                  "What each engine does with masses, sizes, speeds, places, loads and input that no engine is made "
                  "for.",
              .facts = {{"command", command}, {"runs", fmt::format("{}", results.size())}}};
    PageSection grades{.title = "Grades",
                       .intro = std::string(meaning),
                       .blocks = {MakeCounts(results), MakeGroups(results), MakeMatrix(results)}};
    if (const std::string better = DescribeBetterRivals(results); !better.empty()) {
        grades.blocks.insert(grades.blocks.begin(), PageNote{better, PageTone::warning});
    }
    page.sections.push_back(grades);
    page.sections.push_back({.title = "What was asked, and the answers", .blocks = {MakeAnswers(results)}});
    page.sections.push_back({.title = "Why not the full grade", .blocks = {MakeReasons(results)}});
    PageSection figures{.title = "Worst moments",
                        .intro =
                            "The moment of the worst fault of every run below the full grade. Outlines only; grey "
                            "is static."};
    PageFigures all{.figures = {}, .columns = 4};
    for (const ExtremeResult& r : results) {
        const auto picture = pictures.find(r.name + "/" + r.setting);
        if (r.verdict.grade == Grade::accurate || picture == pictures.end()) continue;
        all.figures.push_back(
            {.title = r.name + ", " + r.setting,
             .caption = fmt::format("step {}: {}", r.outcome.worstStep, fmt::join(r.verdict.reasons, "; ")),
             .svg = picture->second});
    }
    if (!all.figures.empty()) {
        figures.blocks.push_back(all);
        page.sections.push_back(figures);
    }
    page.sections.push_back({.title = "Measurements", .blocks = {MakeMeasurements(results)}, .folded = true});
    return page;
}

std::string FormatExtremes(std::span<const ExtremeResult> results) {
    std::string text = "runs by grade                4     3     2     1     0  not finished  no second run\n";
    for (const std::string& setting : SettingsOf(results)) {
        text += fmt::format("{:24}", setting);
        for (const Grade grade : gradesInOrder) {
            text += fmt::format(" {:{}}", CountGrade(results, setting, grade), grade == Grade::notFinished ? 13 : 5);
        }
        text += fmt::format(" {:14}\n", CountUnrepeated(results, setting));
    }
    for (const ExtremeResult& r : results) {
        if (r.verdict.grade == Grade::notFinished && IsOurs(r.setting)) {
            text += fmt::format("not finished: {}, {}: {:.3g} s\n", r.name, r.setting, r.outcome.seconds);
        }
        if (r.verdict.grade >= Grade::survives || r.verdict.grade == Grade::notFinished || !IsOurs(r.setting)) continue;
        text += fmt::format("below 3: {}, {}: {} ({})\n", r.name, r.setting, static_cast<int>(r.verdict.grade),
                            fmt::join(r.verdict.reasons, "; "));
    }
    return text;
}

}  // namespace testbed
