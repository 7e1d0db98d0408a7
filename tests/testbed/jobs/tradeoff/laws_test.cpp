// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The laws as a table, their measurement in both engines where the outcome is known, tiles, verdicts and JSON lines.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "testbed/base/errors.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/measure.h"
#include "testbed/jobs/tradeoff/report.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

const Law& FindLaw(const std::string& name) {
    for (const Law& law : GetLaws()) {
        if (law.name == name) return law;
    }
    throw std::invalid_argument(name);
}

TEST(Laws, AreComplete) {
    std::set<std::string> names;
    for (const Law& law : GetLaws()) {
        EXPECT_TRUE(names.insert(law.name).second) << law.name;
        EXPECT_FALSE(law.title.empty() || law.exact.empty() || law.errors.empty()) << law.name;
        EXPECT_TRUE(law.measure && law.costScene) << law.name;
        const scenes::SceneCounts one = scenes::Count(law.costScene());
        const scenes::SceneCounts tiled = scenes::Count(MakeCostScene(law, 200));
        EXPECT_EQ(tiled.dynamicBodies % one.dynamicBodies, 0) << law.name;
        EXPECT_GE(tiled.dynamicBodies, 100) << law.name;
        EXPECT_EQ(tiled.joints * one.dynamicBodies, one.joints * tiled.dynamicBodies) << law.name;
    }
    EXPECT_EQ(names.size(), 20u);
}

TEST(Laws, TilesOfAScenePassTheSameTrajectory) {
    const Law& law = FindLaw("pendulum");
    const scenes::Scene one = law.costScene(), four = Tile(one, 4, {8.0, 16.0});
    for (const RunSpec& setting : {GetBaseline(), GetSequential("scree")}) {
        const auto alone = MakeLab(one, setting), together = MakeLab(four, setting);
        for (int i = 0; i < 30; ++i) {
            alone->Step();
            together->Step();
        }
        for (int copy = 0; copy < 4; ++copy) {
            const BodyReading a = alone->Read(1), b = together->Read(1 + 2 * copy);
            // Coordinates of up to 25 m round to 2e-6 m.
            EXPECT_NEAR(b.centre.x - 8.0 * (copy % 2), a.centre.x, 2e-5);
            EXPECT_NEAR(b.centre.y - 16.0 * (copy / 2), a.centre.y, 2e-5);
            EXPECT_NEAR(b.angle, a.angle, 2e-5);
        }
    }
}

TEST(Laws, AProjectileUnderSemiImplicitEulerFallsShortByHalfAStep) {
    // g·h·t/2, to the rounding of 240 additions.
    for (const char* engine : {"scree", "box2d"}) {
        for (const int rate : {30, 60, 240}) {
            const std::vector<double> errors =
                FindLaw("projectile").measure(GetSequential(engine, 8, 3, rate), Effort::quick);
            EXPECT_NEAR(errors[0], 0.5 * gravity * 4.0 / rate, 2e-3) << engine << " " << rate;
        }
    }
}

TEST(Laws, ASpringLosesItsAmplitudeAsImplicitEulerDoes) {
    const double omega = 4.0 * 3.14159265358979, h = 1.0 / 60.0;
    const double left = std::pow(1.0 + omega * h * omega * h, -15.0);
    for (const char* engine : {"scree", "box2d"}) {
        EXPECT_NEAR(FindLaw("spring").measure(GetSequential(engine), Effort::quick)[0], 1.0 - left, 1e-3) << engine;
    }
}

TEST(Laws, AColumnHasItsErrorWhereItIsToldTo) {
    // One sweep a step cannot carry ten boxes in two seconds, eight can: 0.933·N² sweeps gain a decade.
    const Law& law = FindLaw("column-10");
    for (const char* engine : {"scree", "box2d"}) {
        const double coarse = law.measure(GetSequential(engine, 1, 1), Effort::quick)[0];
        const double fine = law.measure(GetSequential(engine, 8, 3), Effort::quick)[0];
        EXPECT_GT(coarse, 10.0 * fine) << engine;
        EXPECT_LT(fine, 0.02) << engine;
    }
}

TEST(Laws, TheGridHasBothEnginesDefaultsAndNothingTwice) {
    for (const Effort effort : {Effort::quick, Effort::full}) {
        const std::vector<RunSpec> grid = MakeGrid(effort);
        EXPECT_EQ(grid.front(), GetBaseline());
        EXPECT_TRUE(std::ranges::find(grid, GetSequential("scree")) != grid.end());
        std::set<std::string> names;
        int soft = 0, box2d3 = 0;
        for (const RunSpec& setting : grid) {
            box2d3 += setting.engine == "box2d3";
            EXPECT_TRUE(names.insert(PrintSpec(setting)).second) << PrintSpec(setting);
            soft += !IsSequential(setting) && setting.engine == "scree";
        }
        const std::size_t sequential = effort == Effort::quick ? 2 * 3 * 2 : 2 * 7 * 4;
        EXPECT_EQ(grid.size() - static_cast<std::size_t>(soft + box2d3), sequential);
        const int softSettings = effort == Effort::quick ? 6 : 16;
        EXPECT_EQ(soft, softSettings);
        EXPECT_EQ(box2d3, !IsBuilt("box2d3") ? 0 : effort == Effort::quick ? 4 : 20);
    }
}

TEST(Laws, SettingsGoToAllOfTheGridButWhatItIsComparedWith) {
    const std::vector<RunSpec> plain = MakeGrid(Effort::quick);
    EXPECT_EQ(ChooseGrid(Effort::quick, "", {}), plain);
    const TypedSetting sleepy{"sleeping=on", "--set sleeping=on"}, soft{"solver=soft@8", "--set solver=soft@8"};
    const std::vector<RunSpec> sleeping = ChooseGrid(Effort::quick, "", std::span(&sleepy, 1));
    EXPECT_EQ(sleeping.size(), plain.size());
    EXPECT_EQ(sleeping.front(), GetBaseline());
    for (std::size_t i = 1; i < sleeping.size(); ++i) EXPECT_TRUE(sleeping[i].sleeping);
    const std::vector<RunSpec> narrowed = ChooseGrid(Effort::quick, "", std::span(&soft, 1));
    EXPECT_EQ(std::ranges::count_if(narrowed, [](const RunSpec& s) { return s.engine == "scree"; }), 2) << "two rates";
    const std::vector<RunSpec> chosen = ChooseGrid(Effort::full, "scree:accuracy=fine,box2d:iterations=1/1", {});
    ASSERT_EQ(chosen.size(), 3u);
    EXPECT_EQ(chosen[0], GetBaseline());
    EXPECT_EQ(chosen[1].solver, Solver(Accuracy::fine));
    EXPECT_FALSE(chosen[1].sleeping);
    EXPECT_EQ(chosen[2], GetSequential("box2d", 1, 1));
}

TradeCase MakeCase(const std::string& law, const RunSpec& setting, double error, double cost) {
    TradeCase one;
    one.law = law;
    one.setting = setting;
    one.errors.assign(FindLaw(law).errors.size(), error);
    one.milliseconds = {0.9 * cost, cost, 1.1 * cost};
    one.bodyFrames = 1e6;  // so that ms are ns
    return one;
}

constexpr Family ourSequential[] = {Family::sequential};

TEST(Verdict, ComparesWithBox2dsDefaultLawByLaw) {
    const std::vector<TradeCase> cases = {
        MakeCase("spring", GetBaseline(), 0.4, 100.0), MakeCase("spring", GetSequential("scree"), 0.4, 50.0),
        MakeCase("spring", GetSequential("scree", 64), 0.1, 90.0), MakeCase("pyramid", GetBaseline(), 0.01, 100.0),
        MakeCase("pyramid", GetSequential("scree"), 0.02, 80.0)};
    const std::vector<LawGain> gains = CompareWithBaseline(cases, ourSequential);
    ASSERT_EQ(gains.size(), 2u);
    EXPECT_EQ(gains[0].law->name, "spring");
    EXPECT_DOUBLE_EQ(*gains[0].GetSpeedUp(), 2.0);
    EXPECT_EQ(*gains[0].closest, GetSequential("scree", 64));
    EXPECT_DOUBLE_EQ(*gains[0].GetErrorRatio(), 4.0);
    EXPECT_FALSE(gains[0].IsLost());
    EXPECT_TRUE(gains[1].IsLost());
    const Headline headline = Summarise(gains);
    EXPECT_EQ(headline.laws, 2);
    EXPECT_EQ(headline.fasterIn, 1);
    EXPECT_EQ(headline.closerIn, 1);
    EXPECT_FALSE(headline.speedUp) << "the lower one of two is out of reach";
    EXPECT_DOUBLE_EQ(*headline.errorRatio, 0.5);
    const std::string text = FormatTrade(cases);
    EXPECT_NE(text.find("lost to Box2D: pyramid"), std::string::npos) << text;
}

TEST(Verdict, BothEnginesChooseByTheSameRule) {
    // Box2D reaches the accuracy of its default at half the cost by itself, so half of our four times is its own.
    const std::vector<TradeCase> cases = {MakeCase("spring", GetBaseline(), 0.4, 100.0),
                                          MakeCase("spring", GetSequential("box2d", 4, 2), 0.3, 50.0),
                                          MakeCase("spring", GetSequential("box2d", 64, 24), 0.1, 900.0),
                                          MakeCase("spring", GetSequential("scree"), 0.2, 25.0)};
    const std::vector<LawGain> gains = CompareWithBaseline(cases, ourSequential);
    EXPECT_DOUBLE_EQ(*gains[0].ours.speedUp, 4.0);
    EXPECT_DOUBLE_EQ(*gains[0].box2d.speedUp, 2.0);
    EXPECT_DOUBLE_EQ(*gains[0].GetSpeedUp(), 2.0);
    EXPECT_DOUBLE_EQ(*gains[0].GetErrorRatio(), 1.5);
    // The control: Box2D in our place gains nothing over itself.
    constexpr Family theirs[] = {Family::box2d};
    const std::vector<LawGain> control = CompareWithBaseline(cases, theirs);
    EXPECT_DOUBLE_EQ(*control[0].GetSpeedUp(), 1.0);
    EXPECT_DOUBLE_EQ(*control[0].GetErrorRatio(), 1.0);
}

TEST(Verdict, LawsThatCannotTradeAndFallenBaselinesAreLeftOut) {
    const std::vector<TradeCase> cases = {
        MakeCase("free-spin", GetBaseline(), 0.1, 100.0),
        MakeCase("free-spin", GetSequential("box2d", 4, 2), 0.1, 90.0),
        MakeCase("free-spin", GetSequential("box2d", 8, 3, 120), 0.05, 200.0),  // another rate is another step
        MakeCase("free-spin", GetSequential("scree"), 0.1, 1.0),
        MakeCase("column-50", GetBaseline(), 44.0, 100.0),
        MakeCase("column-50", GetSequential("scree"), 151.0, 10.0),
        MakeCase("spring", GetBaseline(), 0.4, 100.0),
        MakeCase("spring", GetSequential("box2d", 4, 2), 0.5, 90.0),
        MakeCase("spring", GetSequential("scree"), 0.4, 50.0)};
    const std::vector<LawGain> gains = CompareWithBaseline(cases, ourSequential);
    ASSERT_EQ(gains.size(), 3u);
    for (const LawGain& gain : gains) {
        const Standing expected = gain.law->name == "free-spin"   ? Standing::cannotTrade
                                  : gain.law->name == "column-50" ? Standing::baselineFails
                                                                  : Standing::compared;
        EXPECT_EQ(gain.standing, expected) << gain.law->name;
        EXPECT_FALSE(gain.IsLost()) << gain.law->name;
    }
    EXPECT_EQ(Summarise(gains).laws, 1);
    EXPECT_DOUBLE_EQ(*Summarise(gains).speedUp, 2.0);
    const std::string text = FormatTrade(cases);
    EXPECT_NE(text.find("Box2D's errors: free-spin\n"), std::string::npos) << text;
    EXPECT_NE(text.find("Box2D 8/3 fails: column-50\n"), std::string::npos) << text;
}

TEST(Verdict, SaysWhereBox2d3Wins) {
    std::vector<TradeCase> cases = {MakeCase("spring", GetBaseline(), 0.4, 100.0),
                                    MakeCase("spring", GetSequential("box2d", 4, 2), 0.5, 90.0),
                                    MakeCase("spring", GetSequential("scree"), 0.3, 50.0),
                                    MakeCase("pyramid", GetBaseline(), 0.01, 100.0),
                                    MakeCase("pyramid", GetSequential("box2d", 4, 2), 0.02, 90.0),
                                    MakeCase("pyramid", GetSequential("scree"), 0.002, 40.0)};
    EXPECT_EQ(FormatTrade(cases).find("Box2D 3"), std::string::npos) << "it did not run";
    TradeCase one = MakeCase("spring", GetSoft(4, 60, "box2d3"), 0.2, 40.0);
    cases.push_back(one);
    cases.push_back(MakeCase("pyramid", GetSoft(4, 60, "box2d3"), 0.005, 60.0));
    const std::vector<LawGain> gains = CompareWithBaseline(cases, ourSequential);
    EXPECT_EQ(FamilyOf(one.setting), Family::box2d3);
    EXPECT_TRUE(gains[0].IsBox2d3Faster() && gains[0].IsBox2d3Closer());
    EXPECT_FALSE(gains[1].IsBox2d3Faster() || gains[1].IsBox2d3Closer());
    EXPECT_TRUE(
        FormatTrade(cases).starts_with("Box2D 3 is as accurate as Box2D 8/3 for less than ours in: spring. It "
                                       "is closer at the cost of Box2D 8/3 in: spring.\n"))
        << FormatTrade(cases);
}

TEST(Verdict, BoundsAreMetAtTheDialsMarks) {
    const std::vector<TradeCase> cases = {MakeCase("spring", GetBaseline(), 0.6, 1.0),
                                          MakeCase("spring", GetDial(Accuracy::game), 0.4, 1.0),
                                          MakeCase("spring", GetDial(Accuracy::precise), 0.4, 1.0)};
    const std::vector<BoundRow> rows = CheckBounds(cases);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].MeetsGame(), true);      // 0.5
    EXPECT_EQ(rows[0].MeetsPrecise(), false);  // 0.02
    EXPECT_FALSE(rows[0].sequential);
    EXPECT_NE(FormatTrade(cases).find("1 met, 1 missed"), std::string::npos);
    EXPECT_TRUE(HasMiss(rows));
    EXPECT_FALSE(HasMiss(CheckBounds(std::span(cases).first(2))));
}

TEST(Trade, LinesComeBackAsTheyWent) {
    TradeCase one = MakeCase("bridge", GetSoft(8, 120), 0.25, 3.0);
    one.errors[1] = std::numeric_limits<double>::infinity();
    const TradeCase back = TradeCaseFromJson(nlohmann::ordered_json::parse(ToJson(one).dump()));
    EXPECT_EQ(back.law, one.law);
    EXPECT_EQ(back.setting, one.setting);
    EXPECT_EQ(back.errors, one.errors);
    EXPECT_EQ(back.GetCost().median, one.GetCost().median);
    one.setting.solver = Tolerance{0.02f};
    one.setting.warmStarting = false;
    EXPECT_EQ(TradeCaseFromJson(ToJson(one)).setting, one.setting) << "what the columns do not tell";
    nlohmann::ordered_json old = ToJson(MakeCase("bridge", GetSequential("box2d", 16, 6, 30), 0.25, 3.0));
    old.erase("settings");
    EXPECT_EQ(TradeCaseFromJson(old).setting, GetSequential("box2d", 16, 6, 30)) << "a file of before";
    EXPECT_EQ(FlooredError(FindLaw("bridge"), back, 1), std::numeric_limits<double>::infinity());
    EXPECT_EQ(FlooredError(FindLaw("bridge"), MakeCase("bridge", GetSoft(8), 0.0, 1.0)), 1e-6);
}

TEST(Trade, TheCommandMeasuresOneLawAndDrawsIt) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("tradeoff --quick -g '^free-spin$' -o out --json lines.jsonl");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::size_t settings = MakeGrid(Effort::quick).size();
    EXPECT_NE(result.output.find(std::to_string(settings) + " cases: 1 laws"), std::string::npos) << result.output;
    for (const char* file : {"out/index.html", "out/cases.csv", "out/bounds.csv", "out/plots/free-spin.svg"}) {
        EXPECT_TRUE(folder.Has(file)) << file;
    }
    EXPECT_NE(folder.Read("out/index.html").find(R"(<script type="application/json">{"x":"ns per body)"),
              std::string::npos)
        << "figures that tell their points";
    const std::string csv = folder.Read("out/cases.csv");  // of two errors: the angle's, and its share of the turn
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), 1 + 2 * settings);
    // Two shards together hold the lines of the whole, times apart, and the report comes from the joined file.
    for (const char* part : {"1", "2"}) {
        const ProgramResult shard = folder.Run(std::string("tradeoff --quick -g '^free-spin$' -o out --json part") +
                                               part + ".jsonl --shard " + part + "/2");
        ASSERT_EQ(shard.exitCode, 0) << shard.output;
    }
    ASSERT_EQ(folder.Run("merge part1.jsonl part2.jsonl -o joined.jsonl").exitCode, 0);
    EXPECT_EQ(std::ranges::count(folder.Read("joined.jsonl"), '\n'),
              std::ranges::count(folder.Read("lines.jsonl"), '\n'));
    EXPECT_EQ(folder.Run("tradeoff --from joined.jsonl -o joined").exitCode, 0);
    const ProgramResult from = folder.Run("tradeoff --from lines.jsonl -o again");
    EXPECT_EQ(from.exitCode, 0) << from.output;
    EXPECT_EQ(folder.Read("again/cases.csv"), csv);
}

TEST(Trade, TheCommandRefusesWhatItCannotMean) {
    const ScratchFolder folder;
    const ProgramResult none = folder.Run("tradeoff -g nonesuch");
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.output.find("finds no law; there are: projectile"), std::string::npos) << none.output;
    EXPECT_EQ(folder.Run("tradeoff -g '('").exitCode, 2);
    EXPECT_EQ(folder.Run("tradeoff --from missing.jsonl").exitCode, 4);
    const ProgramResult count = folder.Run("tradeoff --count");
    EXPECT_EQ(count.exitCode, 0);
    const std::size_t cases = GetLaws().size() * MakeGrid(Effort::full).size();
    EXPECT_EQ(count.output.rfind(std::to_string(cases) + " cases", 0), 0u) << count.output;
}

/// The lines of a run of two laws at three settings, written here; `change` may spoil a line.
std::string MakeLines(const std::function<void(nlohmann::ordered_json& line, int number)>& change) {
    const std::vector<TradeCase> cases = {
        MakeCase("spring", GetBaseline(), 0.6, 10.0), MakeCase("spring", GetDial(Accuracy::game), 0.4, 10.0),
        MakeCase("spring", GetDial(Accuracy::precise), 0.01, 10.0), MakeCase("tipping", GetBaseline(), 0.01, 10.0)};
    std::string text;
    int number = 0;
    for (const TradeCase& one : cases) {
        nlohmann::ordered_json line = {{"command", "tradeoff"}, {"case", number}, {"cases", cases.size()}};
        const nlohmann::ordered_json fields = ToJson(one);
        for (const auto& [key, value] : fields.items()) line[key] = value;
        change(line, number++);
        if (!line.is_null()) text += line.dump() + "\n";
    }
    return text;
}

TEST(Trade, FromExitsWithOneWhereABoundIsMissed) {
    const ScratchFolder folder;
    std::ofstream(folder.GetPath() / "good.jsonl") << MakeLines([](auto&, int) {});
    std::ofstream(folder.GetPath() / "bad.jsonl") << MakeLines([](auto& line, int number) {
        if (number == 1) line["errors"][0] = 0.51;  // the bound is 0.5
    });
    std::ofstream(folder.GetPath() / "failed.jsonl") << MakeLines([](auto& line, int number) {
        if (number == 2) line["errors"][0] = nullptr;
    });
    EXPECT_EQ(folder.Run("tradeoff --from good.jsonl").exitCode, exitDone);
    EXPECT_EQ(folder.Run("tradeoff --from bad.jsonl").exitCode, exitDiffers);
    EXPECT_EQ(folder.Run("tradeoff --from failed.jsonl").exitCode, exitDiffers);
}

TEST(Trade, FromRefusesFilesThatAreNoWholeRun) {
    const ScratchFolder folder;
    const auto refuse = [&](const std::string& text, const std::string& words) {
        std::ofstream(folder.GetPath() / "f.jsonl") << text;
        const ProgramResult result = folder.Run("tradeoff --from f.jsonl");
        EXPECT_EQ(result.exitCode, exitIo) << words << "\n" << result.output;
        EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
    };
    const std::string whole = MakeLines([](auto&, int) {});
    refuse("", "f.jsonl: there is no line in it");
    refuse(whole + whole, "case 0 is in this file twice");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 2) line = nullptr;
           }),
           "1 of 4 cases are missing, the first is case 2");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 1) line["law"] = "nosuch";
           }),
           "f.jsonl:2");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 1) line["law"] = "nosuch";
           }),
           "no law is called 'nosuch'");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 0) line["errors"].push_back(0.1);
           }),
           "2 errors; law 'spring' has 1");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 0) line["errors"] = nlohmann::json::array();
           }),
           "0 errors; law");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 3) line["bodyFrames"] = 0;
           }),
           "a cost is above 0");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 1) line["settings"] = MakeCase("spring", GetBaseline(), 1, 1).setting.engine;
           }),
           "f.jsonl:2");
    refuse(MakeLines([](auto& line, int) { line["command"] = "bench"; }), "of `scree bench`, not of `scree tradeoff`");
    refuse(MakeLines([](auto& line, int n) {
               if (n == 1) {
                   const int own = line["case"];
                   line = nlohmann::ordered_json::parse(
                       MakeLines([](auto&, int) {}).substr(0, MakeLines([](auto&, int) {}).find('\n')));
                   line["case"] = own;
               }
           }),
           "is there twice");
}

}  // namespace
}  // namespace testbed
