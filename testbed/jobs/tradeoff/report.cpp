// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of report.h.

#include "testbed/jobs/tradeoff/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "testbed/base/csv.h"

namespace testbed {

namespace {

struct FamilyLook {
    Family family;
    PlotLook look;
};
constexpr FamilyLook looks[] = {{Family::box2d, boxTwoDLook},
                                {Family::box2d3, ourLooks[3]},
                                {Family::sequential, ourLooks[0]},
                                {Family::soft, ourLooks[1]}};

constexpr Family oursBoth[] = {Family::sequential, Family::soft};
constexpr Family oursSequential[] = {Family::sequential};
constexpr Family oursSoft[] = {Family::soft};

struct Choice {
    std::string_view name;
    std::span<const Family> families;
};
constexpr std::array<Choice, 3> choices{
    {{"any solver", oursBoth}, {"sequential impulses", oursSequential}, {"soft step", oursSoft}}};

bool Has(std::span<const TradeCase> cases, Family family) {
    return std::ranges::any_of(cases, [family](const TradeCase& c) { return FamilyOf(c.setting) == family; });
}
bool HasSoft(std::span<const TradeCase> cases) { return Has(cases, Family::soft); }

/// All settings of a family as points, its front as a line, its defaults as larger points with their names.
void AddCurves(const Law& law, std::span<const TradeCase> cases, const FamilyLook& look, Plot& plot) {
    PlotCurve all{.title = "", .look = look.look, .style = PlotStyle::points, .pointSize = 0.5};
    PlotCurve front{.title = std::string(NameFamily(look.family)), .look = look.look, .style = PlotStyle::lines};
    PlotCurve defaults{.title = "", .look = look.look, .style = PlotStyle::points, .pointSize = 1.6};
    std::vector<TradePoint> points;
    for (const TradeCase& one : cases) {
        if (one.law != law.name || FamilyOf(one.setting) != look.family) continue;
        if (HasFailed(law, one)) continue;
        const TradePoint point{one.GetCost().median, FlooredError(law, one)};
        points.push_back(point);
        all.points.push_back({point.cost, point.error});
        all.names.push_back(
            fmt::format("{} {} at {} Hz", NameFamily(look.family), NameSolver(one.setting), GetRate(one.setting)));
        if (!IsDefault(one.setting)) continue;
        defaults.points.push_back({point.cost, point.error});
        defaults.labels.push_back(NameSolver(one.setting));
    }
    for (const std::size_t i : FindFront(points)) {
        front.points.push_back({points[i].cost, points[i].error});
        front.names.push_back(all.names[i]);
    }
    for (const PlotCurve& curve : {all, front, defaults}) {
        if (!curve.points.empty()) plot.curves.push_back(curve);
    }
}

std::string UnitOf(const LawError& error) { return error.unit.empty() ? "" : " [" + error.unit + "]"; }

PageCell ErrorCell(std::optional<double> value, std::optional<bool> met) {
    if (!value) return {"–"};
    PageCell cell(fmt::format("{:.3g}", *value));
    cell.value = *value;
    if (met) cell.tone = *met ? PageTone::good : PageTone::bad;
    return cell;
}

PageCell BoundCell(double bound) {
    if (bound == noBound) return {"–"};
    PageCell cell(fmt::format("{:.3g}", bound));
    cell.value = bound;
    return cell;
}

PageCell RatioCell(std::optional<double> ratio) {
    if (!ratio) return PageCell("out of reach");
    return PageCell::Number(*ratio, 2);
}

/// With the colour of its verdict, if the law has one.
PageCell VerdictCell(const LawGain& gain, std::optional<double> ratio) {
    PageCell cell = RatioCell(ratio);
    if (gain.standing == Standing::compared) cell.tone = ratio.value_or(0.0) < 1.0 ? PageTone::bad : PageTone::good;
    return cell;
}

std::string_view DescribeStanding(const LawGain& gain) {
    switch (gain.standing) {
        case Standing::cannotTrade:
            return "cannot trade";
        case Standing::baselineFails:
            return "Box2D 8/3 fails";
        case Standing::compared:
            break;
    }
    return gain.IsLost() ? "lost" : "";
}

/// Names of the laws that `is` picks, or "none".
template <typename Is>
std::string ListLaws(std::span<const LawGain> gains, Is is) {
    std::string names;
    for (const LawGain& gain : gains) {
        if (is(gain)) names += (names.empty() ? "" : ", ") + gain.law->name;
    }
    return names.empty() ? "none" : names;
}

std::string NameOrNone(const std::optional<RunSpec>& setting) {
    return setting ? fmt::format("{} at {} Hz", NameSolver(*setting), GetRate(*setting)) : "–";
}

PageTable MakeGainTable(std::span<const LawGain> gains, bool hasBox2d3) {
    constexpr const char *speed = "speed at equal accuracy", *accuracy = "accuracy at equal cost";
    PageTable table{.columns = {{.name = "law"},
                                {.name = "both choose", .unit = "×", .numeric = true, .group = speed},
                                {.name = "ours", .unit = "×", .numeric = true, .group = speed},
                                {.name = "with", .group = speed},
                                {.name = "Box2D", .unit = "×", .numeric = true, .group = speed},
                                {.name = "both choose", .unit = "×", .numeric = true, .group = accuracy},
                                {.name = "ours", .unit = "×", .numeric = true, .group = accuracy},
                                {.name = "with", .group = accuracy},
                                {.name = "Box2D", .unit = "×", .numeric = true, .group = accuracy},
                                {.name = "remark"}}};
    if (hasBox2d3) {
        for (const std::size_t place : {std::size_t{9}, std::size_t{5}}) {
            table.columns.insert(
                table.columns.begin() + static_cast<std::ptrdiff_t>(place),
                {.name = "Box2D 3", .unit = "×", .numeric = true, .group = place == 5 ? speed : accuracy});
        }
    }
    for (const LawGain& g : gains) {
        PageCell name(g.law->name), remark((std::string(DescribeStanding(g))));
        name.link = "#" + g.law->name;
        name.hint = g.law->title;
        if (g.IsLost()) remark.tone = PageTone::bad;
        table.rows.push_back({name, VerdictCell(g, g.GetSpeedUp()), RatioCell(g.ours.speedUp), NameOrNone(g.cheapest),
                              RatioCell(g.box2d.speedUp), VerdictCell(g, g.GetErrorRatio()),
                              RatioCell(g.ours.errorRatio), NameOrNone(g.closest), RatioCell(g.box2d.errorRatio),
                              remark});
        if (!hasBox2d3) continue;
        std::vector<PageCell>& row = table.rows.back();
        row.insert(row.begin() + 9, RatioCell(g.box2d3.errorRatio));
        row.insert(row.begin() + 5, RatioCell(g.box2d3.speedUp));
    }
    return table;
}

PageTable MakeBoundsTable(std::span<const BoundRow> rows) {
    PageTable table{.columns = {{.name = "law"},
                                {.name = "error"},
                                {.name = "unit"},
                                {.name = "bound", .numeric = true, .group = "game (soft 4)"},
                                {.name = "measured", .numeric = true, .group = "game (soft 4)"},
                                {.name = "bound", .numeric = true, .group = "precise (soft 16)"},
                                {.name = "measured", .numeric = true, .group = "precise (soft 16)"},
                                {.name = "Scree", .numeric = true, .group = "8/3"},
                                {.name = "Box2D", .numeric = true, .group = "8/3"}},
                    .filter = true};
    for (const BoundRow& row : rows) {
        table.rows.push_back({row.law->name, row.error->name, row.error->unit, BoundCell(row.error->game),
                              ErrorCell(row.game, row.MeetsGame()), BoundCell(row.error->precise),
                              ErrorCell(row.precise, row.MeetsPrecise()), ErrorCell(row.sequential, std::nullopt),
                              ErrorCell(row.box2d, std::nullopt)});
    }
    return table;
}

PageTable MakeAllTable(std::span<const TradeCase> cases) {
    PageTable table{.columns = {{.name = "law"},
                                {.name = "engine"},
                                {.name = "solver"},
                                {.name = "steps per s", .numeric = true},
                                {.name = "cost", .unit = "ns", .numeric = true},
                                {.name = "quartiles", .unit = "ns"},
                                {.name = "error", .numeric = true}},
                    .filter = true};
    for (const TradeCase& one : cases) {
        const Quartiles cost = one.GetCost();
        table.rows.push_back({one.law, one.setting.engine, NameSolver(one.setting),
                              PageCell::Number(GetRate(one.setting), 0), PageCell::Number(cost.median, 1),
                              fmt::format("{:.1f} … {:.1f}", cost.low, cost.high),
                              ErrorCell(one.errors.front(), std::nullopt)});
    }
    return table;
}

/// What the cases say of scenes, each once.
std::vector<const SceneFacts*> ListScenes(std::span<const TradeCase> cases) {
    std::vector<const SceneFacts*> scenes;
    for (const TradeCase& one : cases) {
        if (one.scene == nullptr) continue;
        const auto isIt = [&](const SceneFacts* other) { return other->scene == one.scene->facts.scene; };
        if (std::ranges::none_of(scenes, isIt)) scenes.push_back(&one.scene->facts);
    }
    return scenes;
}

/// How far distances have a meaning, in a sentence.
std::string DescribeWindow(const SceneFacts& facts) {
    if (facts.window == 0.0) {
        return fmt::format(
            "{}: references and runs half as fine part at once, so distance and energy have no meaning in this scene. "
            "Only overlap{} compared.",
            facts.scene, facts.hasJoints ? " and joint gaps are" : " is");
    }
    if (facts.window >= facts.seconds) {
        return fmt::format("{}: references and runs half as fine agree over all {:.3g} s.", facts.scene, facts.seconds);
    }
    return fmt::format(
        "{}: references and runs half as fine agree for {:.3g} of {:.3g} s. Distance and energy are compared up to "
        "there; later, small causes decide where bodies are.",
        facts.scene, facts.window, facts.seconds);
}

PageSection MakeReferenceSection(std::span<const SceneFacts* const> scenes) {
    PageTable table{.columns = {{.name = "scene"},
                                {.name = "settings of"},
                                {.name = "reference"},
                                {.name = "compared with"},
                                {.name = "part at", .unit = "s", .numeric = true},
                                {.name = "apart", .unit = "mm", .numeric = true},
                                {.name = "from ours", .unit = "mm", .numeric = true}}};
    PageSection section{
        .title = "References",
        .intro = fmt::format(
            "Nobody knows how a scene should move exactly. So the settings of each engine and solver are measured "
            "against one of their own with much finer steps. Distance is the root mean square over bodies of how far "
            "their mass is from where the reference has it, at its largest. Energy is the largest difference from the "
            "reference's, over the mass. Overlap and joint gap are the deepest and widest of a moment, as "
            "`World::MeasureErrors` gives them, averaged over the run.\n\n"
            "How good a reference is tells a second one, half as fine. Where both are apart by {:.0f} % of the size of "
            "a body, they part: from there on no distance has a meaning, and all engines are compared up to the first "
            "parting. Errors below what two references differ by count as that. `from ours` is the way between the "
            "references themselves: engines model contact differently, and no setting changes that.",
            100.0 * partedShare),
        .blocks = {}};
    for (const SceneFacts* facts : scenes) {
        section.blocks.push_back(
            PageNote{DescribeWindow(*facts), facts->window >= facts->seconds ? PageTone::plain : PageTone::warning});
        if (!facts->leftOut.empty()) {
            section.blocks.push_back(
                PageNote{fmt::format("{} is left out: {}", facts->scene, facts->leftOut), PageTone::warning});
        }
        for (const SceneReference& r : facts->references) {
            table.rows.push_back({facts->scene, NameFamily(r.family), r.setting, r.coarser,
                                  r.parted ? PageCell::Number(*r.parted, 2) : PageCell("never"),
                                  PageCell::Number(1e3 * r.apart, 2), PageCell::Number(1e3 * r.fromOurs, 2)});
        }
    }
    section.blocks.push_back(table);
    return section;
}

PageTiles MakeTiles(std::span<const TradeCase> cases) {
    PageTiles tiles;
    for (const Choice& choice : choices) {
        if (!HasSoft(cases) && choice.name != "sequential impulses") continue;
        const Headline headline = Summarise(CompareWithBaseline(cases, choice.families));
        const auto add = [&](std::string_view what, std::optional<double> value, int won) {
            tiles.tiles.push_back({.label = fmt::format("{}, {}", what, choice.name),
                                   .value = value ? fmt::format("{:.2f}", *value) : "–",
                                   .unit = "×",
                                   .note = ListScenes(cases).empty()
                                               ? fmt::format("median of {} laws, not lost in {}", headline.laws, won)
                                               : fmt::format("median of {} scene{}, not lost in {}", headline.laws,
                                                             headline.laws == 1 ? "" : "s", won),
                                   .tone = value.value_or(0.0) < 1.0 ? PageTone::bad : PageTone::good});
        };
        add("speed at equal accuracy", headline.speedUp, headline.fasterIn);
        add("accuracy at equal cost", headline.errorRatio, headline.closerIn);
    }
    return tiles;
}

/// In which laws Box2D 3 beats us.
std::string DescribeBox2d3(std::span<const LawGain> gains) {
    return fmt::format(
        "Box2D 3 is as accurate as Box2D 8/3 for less than ours in: {}. It is closer at the cost of Box2D 8/3 in: {}.",
        ListLaws(gains, [](const LawGain& g) { return g.IsBox2d3Faster(); }),
        ListLaws(gains, [](const LawGain& g) { return g.IsBox2d3Closer(); }));
}

constexpr std::string_view howToRead =
    "Every point is one setting of one engine. Right is slower, up is wrong: a setting is worth using when nothing "
    "lies left of it and below. The line of each engine joins these settings. Named points are defaults. `8/3` is "
    "Box2D's: 8 velocity and 3 position iterations at 60 Hz. `soft 4` and `soft 16` are our dial's `game` and "
    "`precise`. A setting that fails, whose column falls or whose chain tears, has no point.";

constexpr std::string_view howMeasured =
    "Cost is processor time of one thread per moving body and 1/60 s of simulated time, so that settings with other "
    "steps compare. It is the median of repeats taken in turns, on the law's scene copied to about a thousand "
    "bodies.\n\n"
    "Errors are measured once, in double, from the states of the bodies; runs are deterministic. An error below the "
    "rounding of floats counts as that rounding.\n\n"
    "Cost and errors come from two runs. Most laws need few bodies, whose step is too short to be timed alone, and "
    "some errors need runs of their own.";

}  // namespace

std::string MakeTradeCsv(std::span<const TradeCase> cases) {
    CsvTable table{"law",  "engine", "solver",  "rate",       "error_name",
                   "unit", "error",  "cost_ns", "cost_ns_q1", "cost_ns_q3"};
    const auto ns = [](double cost) { return fmt::format("{:.4f}", cost); };
    for (const TradeCase& one : cases) {
        const Law& law = LawOf(one);
        const Quartiles cost = one.GetCost();
        for (std::size_t i = 0; i < one.errors.size(); ++i) {
            table.AddRow(one.law, one.setting.engine, NameSolver(one.setting), GetRate(one.setting), law.errors[i].name,
                         law.errors[i].unit, fmt::format("{:.9g}", one.errors[i]), ns(cost.median), ns(cost.low),
                         ns(cost.high));
        }
    }
    return table.GetText();
}

std::string MakeBoundsCsv(std::span<const TradeCase> cases) {
    const auto number = [](std::optional<double> value) { return value ? fmt::format("{:.9g}", *value) : ""; };
    const auto bound = [](double value) { return value == noBound ? "" : fmt::format("{:g}", value); };
    const auto word = [](std::optional<bool> met) { return !met ? "" : *met ? "met" : "missed"; };
    CsvTable table{"law",     "error",           "unit",      "game_bound", "game", "game_verdict", "precise_bound",
                   "precise", "precise_verdict", "scree_8_3", "box2d_8_3"};
    for (const BoundRow& row : CheckBounds(cases)) {
        table.AddRow(row.law->name, row.error->name, row.error->unit, bound(row.error->game), number(row.game),
                     word(row.MeetsGame()), bound(row.error->precise), number(row.precise), word(row.MeetsPrecise()),
                     number(row.sequential), number(row.box2d));
    }
    return table.GetText();
}

Plot MakeTradePlot(const Law& law, std::span<const TradeCase> cases) {
    Plot plot{.title = law.title,
              .xLabel = "ns per body and 1/60 s",
              .yLabel = law.errors.front().name + UnitOf(law.errors.front())};
    plot.logarithmic = plot.powersOfTen = plot.small = true;
    plot.legend = PlotLegend::below;
    plot.roomAbove = 0.1;
    plot.roomBelow = plot.roomBeside = 0.05;
    for (const FamilyLook& look : looks) AddCurves(law, cases, look, plot);
    return plot;
}

Page MakeTradePage(std::span<const TradeCase> cases, const std::filesystem::path& plots, const std::string& command) {
    const std::vector<const SceneFacts*> scenes = ListScenes(cases);
    Page page{.title = "Speed against accuracy",
              .intro = scenes.empty() ? "Laws of mechanics with a known result. Every engine runs them under many "
                                        "settings: how far off it is, and what that costs."
                                      : "Scenes without a known result. Every engine runs them under many settings: "
                                        "how far it is from much finer runs, and what that costs.",
              .facts = {{"command", command}, {"cases", fmt::format("{}", cases.size())}}};
    PageSection gains{.title = "Against Box2D's default",
                      .intro =
                          "Two questions are asked of each law. How fast is the cheapest setting that is as accurate "
                          "as Box2D 2.4.1 at 8/3 and 60 Hz, in every error of the law? That is speed at equal "
                          "accuracy. How accurate is the most accurate setting that costs no more? That is accuracy "
                          "at equal cost; the error that gains least counts.\n\n"
                          "Each engine chooses among its settings by this rule, Box2D too. `both choose` is our gain "
                          "over Box2D's own, and the numbers on top are its medians. A law is lost if one of its two "
                          "gains is below 1 or out of reach.\n\n"
                          "Two kinds of laws are left out of the medians. In some, no number of Box2D's iterations "
                          "changes the errors (`cannot trade`). In others, Box2D's default fails.",
                      .blocks = {MakeTiles(cases)}};
    const std::vector<LawGain> compared = CompareWithBaseline(cases, oursBoth);
    if (Has(cases, Family::box2d3)) {
        gains.blocks.insert(gains.blocks.begin(), PageNote{DescribeBox2d3(compared), PageTone::warning});
    }
    gains.blocks.push_back(MakeGainTable(compared, Has(cases, Family::box2d3)));
    if (!HasSoft(cases)) {
        gains.blocks.push_back(
            PageNote{"This build has no soft step: only sequential impulses are compared, and the "
                     "dial's marks `game` and `precise` are not measured.",
                     PageTone::warning});
    }
    page.sections.push_back(gains);
    if (!scenes.empty()) page.sections.push_back(MakeReferenceSection(scenes));
    page.sections.push_back({.title = scenes.empty() ? "Bounds of the dial" : "Errors at the marks of the dial",
                             .intro = scenes.empty() ? "What the marks of the dial promise at 60 Hz, and what was "
                                                       "measured. Sequential impulses at 8/3 stand beside them."
                                                     : "What the marks of the dial reach at 60 Hz. Sequential impulses "
                                                       "at 8/3 stand beside them. Scenes have no bounds.",
                             .blocks = {MakeBoundsTable(CheckBounds(cases))}});
    PageSection figures{.title = "Error against cost", .intro = std::string(howToRead), .blocks = {}};
    PageFigures all{.figures = {}, .columns = 2};
    for (const Law* law : LawsOf(cases)) {
        all.figures.push_back({.title = law->name,
                               .caption = fmt::format("{}. Exact: {}.", law->title, law->exact),
                               .file = plots / (law->name + ".svg")});
    }
    figures.blocks.push_back(all);
    page.sections.push_back({.title = "How it is measured", .intro = std::string(howMeasured), .blocks = {}});
    page.sections.push_back(figures);
    page.sections.push_back({.title = "All measurements", .blocks = {MakeAllTable(cases)}, .folded = true});
    return page;
}

std::string FormatTrade(std::span<const TradeCase> cases) {
    std::string text;
    if (Has(cases, Family::box2d3)) text += DescribeBox2d3(CompareWithBaseline(cases, oursBoth)) + "\n";
    const auto show = [](std::optional<double> value) { return value ? fmt::format("{:.2f}x", *value) : "none"; };
    for (const Choice& choice : choices) {
        if (!HasSoft(cases) && choice.name != "sequential impulses") continue;
        const std::vector<LawGain> gains = CompareWithBaseline(cases, choice.families);
        const Headline h = Summarise(gains);
        text += fmt::format(
            "{}: {} as fast at equal accuracy, no slower in {} of {} laws; {} as accurate at equal cost, no worse in "
            "{} "
            "(medians; each engine chooses its settings)\n",
            choice.name, show(h.speedUp), h.fasterIn, h.laws, show(h.errorRatio), h.closerIn);
        text += "  lost to Box2D: " + ListLaws(gains, [](const LawGain& g) { return g.IsLost(); }) + "\n";
    }
    const std::vector<LawGain> all = CompareWithBaseline(cases, oursBoth);
    const auto has = [](Standing standing) {
        return [standing](const LawGain& gain) { return gain.standing == standing; };
    };
    text += "left out, for no iterations change Box2D's errors: " + ListLaws(all, has(Standing::cannotTrade)) + "\n";
    text += "left out, for Box2D 8/3 fails: " + ListLaws(all, has(Standing::baselineFails)) + "\n";
    int met = 0, missed = 0;
    std::string misses;
    const auto judge = [&](const BoundRow& row, std::string_view mark, std::optional<double> value, double bound,
                           std::optional<bool> ok) {
        if (!ok) return;
        (*ok ? met : missed)++;
        if (!*ok) {
            misses += fmt::format("  missed at {}: {}, {}: {:.3g}, bound {:.3g}{}\n", mark, row.law->name,
                                  row.error->name, *value, bound, UnitOf(*row.error));
        }
    };
    for (const SceneFacts* facts : ListScenes(cases)) {
        text += DescribeWindow(*facts) + "\n";
        if (!facts->leftOut.empty()) text += fmt::format("left out of {}: {}\n", facts->scene, facts->leftOut);
    }
    for (const BoundRow& row : CheckBounds(cases)) {
        judge(row, "game", row.game, row.error->game, row.MeetsGame());
        judge(row, "precise", row.precise, row.error->precise, row.MeetsPrecise());
    }
    if (met + missed == 0) return text;
    return text + fmt::format("bounds of the dial: {} met, {} missed\n", met, missed) + misses;
}

}  // namespace testbed
