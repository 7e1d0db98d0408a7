// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs, table and page of the second suite. The engines' frames follow each other in turn, so that other work on the
// machine meets all of them; the least median of the rounds stands for a case.

#include "testbed/jobs/bench/games.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "testbed/base/errors.h"
#include "testbed/base/memory.h"
#include "testbed/base/output.h"
#include "testbed/base/statistics.h"
#include "testbed/base/stopwatch.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/provenance.h"
#include "testbed/jobs/bench/game_cases.h"
#include "testbed/page/facts.h"
#include "testbed/page/markdown.h"
#include "testbed/page/page.h"

namespace testbed {
namespace {

/// One column: an engine with a solver.
struct Player {
    std::string name;
    RunSpec spec;
};

std::vector<Player> ListPlayers() {
    std::vector<Player> players;
    const auto add = [&](const char* name, const char* engine, Solver solver) {
        if (!IsBuilt(engine)) return;
        RunSpec spec = MakeSpec(engine);
        spec.solver = solver;
        players.push_back({name, spec});
    };
    add("ours 8/3", "scree", SequentialImpulses{Iterations{8, 3}});
    add("ours soft 4", "scree", SoftStep{4});
    add("Box2D 2.4", "box2d", SequentialImpulses{Iterations{8, 3}});
    add("Box2D 3", "box2d3", SoftStep{4});
    return players;
}

/// One player's worlds of a case in one round.
class Table {
public:
    Table(const GameCase& game, const scenes::Scene& scene, RunSpec spec) : m_game(game) {
        spec.sleeping = game.sleeping;
        if (game.isFresh) ReturnFreedMemory();
        const Stopwatch watch;
        for (int i = 0; i < game.worlds; ++i) m_worlds.push_back(MakeLab(scene, spec));
        m_creationMs = watch.GetMilliseconds();
        for (const auto& world : m_worlds) {
            if (game.listens) world->Listen();
        }
        if (game.timing == GameTiming::creation || game.timing == GameTiming::firstStep) return;
        for (int i = 0; i < game.warmUp; ++i) {
            (void)Advance(i);
            if (game.timing == GameTiming::queries) (void)StepAll();  // a game steps its level before it asks
        }
    }
    /// The time of a frame, or of what else is timed: µs, ms.
    void Time(int frame) {
        if (m_game.timing == GameTiming::creation) return m_times.push_back(m_creationMs);
        const double ms = Advance(m_game.warmUp + frame);
        m_times.push_back(m_game.timing == GameTiming::firstStep ? ms : 1e3 * ms / m_game.worlds);
    }
    [[nodiscard]] double GetMedian() const { return FindQuartiles(m_times).median; }

private:
    /// Plays a frame; returns what that and the engine's step took, ms. What the adapter reads after a step is not in
    /// it.
    double Advance(int frame) {
        const Stopwatch watch;
        for (const auto& world : m_worlds) {
            if (m_game.play) m_game.play(*world, frame);
        }
        const double played = watch.GetMilliseconds();
        return m_game.timing == GameTiming::queries ? played : played + StepAll();
    }
    double StepAll() {
        double ms = 0.0;
        for (const auto& world : m_worlds) ms += world->Step().milliseconds;
        return ms;
    }

    const GameCase& m_game;
    std::vector<std::unique_ptr<LabWorld>> m_worlds;
    std::vector<double> m_times;
    double m_creationMs = 0.0;
};

/// The times of a case, by player.
std::vector<double> RunCase(const GameCase& game, std::span<const Player> players, const BenchArguments& arguments) {
    const scenes::Scene scene = game.build();
    const int frames = arguments.steps > 0 ? std::min(arguments.steps, game.frames) : game.frames;
    std::vector<double> best(players.size(), std::numeric_limits<double>::infinity());
    const int rounds = arguments.repeats.value_or(3);
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::unique_ptr<Table>> tables;
        for (const Player& player : players) tables.push_back(std::make_unique<Table>(game, scene, player.spec));
        for (int frame = 0; frame < frames; ++frame) {
            for (const auto& table : tables) table->Time(frame);
        }
        for (std::size_t i = 0; i < players.size(); ++i) best[i] = std::min(best[i], tables[i]->GetMedian());
    }
    return best;
}

struct GameRow {
    const GameCase* game;
    std::vector<double> times;  ///< by player
};

/// How many times as fast as a rival we are with the solver that the rival has too: sequential impulses as Box2D 2.4,
/// sub-steps as Box2D 3. 0 without that rival.
double RatioTo(const GameRow& row, std::span<const Player> players, const std::string& rival) {
    const auto theirs = std::ranges::find(players, rival, [](const Player& player) { return player.spec.engine; });
    if (theirs == players.end()) return 0.0;
    const auto isOurs = [&](const Player& player) {
        return player.spec.engine == "scree" && player.spec.solver.index() == theirs->spec.solver.index();
    };
    const auto ours = std::ranges::find_if(players, isOurs);
    const auto timeOf = [&](auto player) { return row.times[static_cast<std::size_t>(player - players.begin())]; };
    return timeOf(theirs) / timeOf(ours);
}

/// The cases in which a rival is faster than we are.
std::string ListLost(std::span<const GameRow> rows, std::span<const Player> players, const std::string& rival) {
    std::string list;
    for (const GameRow& row : rows) {
        const double ratio = RatioTo(row, players, rival);
        if (ratio > 0.0 && ratio < 1.0) list += (list.empty() ? "" : ", ") + row.game->name;
    }
    return list.empty() ? "none" : list;
}

const char* UnitOf(const GameCase& game) {
    return game.timing == GameTiming::creation || game.timing == GameTiming::firstStep ? "ms" : "µs";
}

std::string FormatTime(double time) { return fmt::format("{:.{}f}", time, time < 10.0 ? 2 : time < 1000.0 ? 1 : 0); }

std::string FormatHeader(std::span<const Player> players) {
    std::string line = fmt::format("{:<18}{:>4}", "case", "");
    for (const Player& player : players) line += fmt::format("{:>13}", player.name);
    return line + fmt::format("{:>10}{:>10}\n", "x 2.4", "x 3");
}

std::string FormatRow(const GameRow& row, std::span<const Player> players) {
    std::string line = fmt::format("{:<18}{:>4}", row.game->name, UnitOf(*row.game) == std::string("ms") ? "ms" : "us");
    for (const double time : row.times) line += fmt::format("{:>13}", FormatTime(time));
    for (const char* rival : {"box2d", "box2d3"}) {
        const double ratio = RatioTo(row, players, rival);
        line += ratio > 0.0 ? fmt::format("{:>10.2f}", ratio) : fmt::format("{:>10}", "-");
    }
    return line + "\n";
}

Page MakeGamesPage(std::span<const GameRow> rows, std::span<const Player> players, const std::string& command) {
    Page page{.title = "Games",
              .intro =
                  "What games do, with every engine's default settings: continuous collision on, sleeping on where "
                  "a case does not say awake, one thread. All engines run in one process, their frames in turn."};
    page.intro +=
        fmt::format("\n\nBox2D 3 is faster than our soft step in: {}. Box2D 2.4 is faster than our 8/3 in: {}.",
                    ListLost(rows, players, "box2d3"), ListLost(rows, players, "box2d"));
    AddFacts(page, command, ToJson(FindProvenance()));
    PageTable table{
        .caption =
            "Times are the least median of the rounds. The first ratio is Box2D 2.4's time over ours at 8/3, the "
            "second Box2D 3's over ours with 4 sub-steps: each rival against the solver that it has, too.",
        .columns = {{.name = "case"}, {.name = "what"}, {.name = "unit"}}};
    for (const Player& player : players) table.columns.push_back({.name = player.name, .numeric = true});
    table.columns.push_back({.name = "× Box2D 2.4", .numeric = true});
    table.columns.push_back({.name = "× Box2D 3", .numeric = true});
    for (const GameRow& row : rows) {
        std::vector<PageCell> cells{row.game->name, row.game->what, UnitOf(*row.game)};
        for (const double time : row.times) cells.push_back(PageCell::Number(time, time < 10.0 ? 2 : 1));
        for (const char* rival : {"box2d", "box2d3"}) {
            const double ratio = RatioTo(row, players, rival);
            const PageTone tone = ratio >= 1.0 ? PageTone::good : PageTone::bad;
            cells.push_back(ratio > 0.0 ? PageCell::Number(ratio, 2, tone) : PageCell("–"));
        }
        table.rows.push_back(cells);
    }
    page.sections.push_back({.title = "Times", .blocks = {table}});
    return page;
}

/// Those that were named, or all. Throws UsageError with the nearest name.
std::vector<const GameCase*> ChooseCases(const std::vector<std::string>& names) {
    std::vector<const GameCase*> chosen;
    for (const GameCase& game : GetGameCases()) {
        if (names.empty() || std::ranges::find(names, game.name) != names.end()) chosen.push_back(&game);
    }
    for (const std::string& name : names) {
        if (std::ranges::none_of(chosen, [&](const GameCase* game) { return game->name == name; })) {
            std::string known;
            for (const GameCase& game : GetGameCases()) known += (known.empty() ? "" : ", ") + game.name;
            throw UsageError(fmt::format("--games: there is no case {}; choose from {}", name, known));
        }
    }
    return chosen;
}

}  // namespace

int RunGames(const BenchArguments& arguments, const Request& request) {
    if (arguments.repeats.value_or(3) < 1) {
        throw UsageError(fmt::format("--repeat {}: give at least 1", *arguments.repeats));
    }
    if (arguments.steps < 0) throw UsageError(fmt::format("--steps {}: give at least 1", arguments.steps));
    const std::vector<const GameCase*> games = ChooseCases(arguments.scenes);
    const std::vector<Player> players = ListPlayers();
    fmt::print("{}", FormatHeader(players));
    std::vector<GameRow> rows;
    for (const GameCase* game : games) {
        rows.push_back({game, RunCase(*game, players, arguments)});
        fmt::print("{}", FormatRow(rows.back(), players));
        std::fflush(stdout);
    }
    const Page page = MakeGamesPage(rows, players, DescribeCommand(request.arguments));
    if (!arguments.output.empty()) {
        const std::filesystem::path path = std::filesystem::path(arguments.output) / "index.html";
        WritePage(path, page);
        const std::string files[] = {path.string()};
        fmt::print("{}", FormatFiles(files));
    }
    if (!arguments.markdown.empty()) WriteMarkdown(arguments.markdown, page);
    return exitDone;
}

}  // namespace testbed
