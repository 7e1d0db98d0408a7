// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A user's scene in `tradeoff`. The judge of states is held to closed forms and to the engine's own measurement,
// references to the closed form of a thrown body. Also the time up to which distances have a meaning, and the command
// with files of random scenes and with bad input.

#include "testbed/jobs/tradeoff/scene_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "scenes/build.h"
#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/scree_scene.h"
#include "testbed/engines/scree_step.h"
#include "testbed/engines/state_judge.h"
#include "testbed/input/scene_file.h"
#include "testbed/jobs/tradeoff/report.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using scenes::Vec2;

/// Seeded anew in every run; the seed stands in the output.
std::mt19937& Random() {
    static std::mt19937 random = [] {
        const unsigned seed = std::random_device{}();
        std::printf("seed %u\n", seed);
        return std::mt19937(seed);
    }();
    return random;
}
float Draw(float low, float high) { return std::uniform_real_distribution<float>(low, high)(Random()); }

scenes::Scene MakeEmpty(const std::string& name, int steps) {
    scenes::Scene scene;
    scene.name = name;
    scene.steps = scene.showStep = steps;
    return scene;
}

void AddBody(scenes::Scene& scene, scenes::BodyType type, Vec2 position, const scenes::Shape& shape,
             float restitution = 0.0f) {
    scenes::Body body;
    body.type = type;
    body.position = position;
    body.firstFixture = static_cast<int>(scene.fixtures.size());
    body.fixtureCount = 1;
    scene.bodies.push_back(body);
    scenes::Fixture fixture;
    fixture.shape = shape;
    fixture.density = 1.0f;
    fixture.restitution = restitution;
    if (restitution > 0.0f) fixture.friction = 0.0f;
    scene.fixtures.push_back(fixture);
}

/// A box that is thrown and meets nothing; `spawned`: half a second after the start.
scenes::Scene MakeThrow(bool spawned) {
    scenes::Scene scene = MakeEmpty("throw", 60);
    AddBody(scene, scenes::BodyType::dynamic, {0.0f, 0.0f}, scenes::Box(Draw(0.5f, 2.0f), Draw(0.5f, 2.0f)));
    scene.bodies.back().linearVelocity = {Draw(-3.0f, 3.0f), Draw(0.0f, 3.0f)};
    if (spawned) scene.spawns.push_back({.afterStep = 30, .body = 0});
    return scene;
}

/// Elastic balls in a box.
scenes::Scene MakeGas() {
    scenes::Scene scene = MakeEmpty("gas", 240);
    scene.gravity = {0.0f, 0.0f};
    for (const Vec2 wall : {Vec2{-5.0f, 0.0f}, Vec2{5.0f, 0.0f}}) {
        AddBody(scene, scenes::BodyType::isStatic, wall, scenes::Box(0.5f, 5.0f), 1.0f);
    }
    for (const Vec2 wall : {Vec2{0.0f, -5.0f}, Vec2{0.0f, 5.0f}}) {
        AddBody(scene, scenes::BodyType::isStatic, wall, scenes::Box(5.0f, 0.5f), 1.0f);
    }
    for (int i = 0; i < 25; ++i) {
        AddBody(scene, scenes::BodyType::dynamic, {-3.0f + 1.5f * (i % 5), -3.0f + 1.5f * (i / 5)},
                scenes::Circle(0.4f), 1.0f);
        scene.bodies.back().linearVelocity = {Draw(-8.0f, 8.0f), Draw(-8.0f, 8.0f)};
    }
    return scene;
}

/// Boxes on the ground, one on the other with a small gap.
scenes::Scene MakePile(int boxes) {
    scenes::Scene scene = MakeEmpty("pile", 60);
    AddBody(scene, scenes::BodyType::isStatic, {0.0f, -1.0f}, scenes::Box(20.0f, 1.0f));
    for (int i = 0; i < boxes; ++i) {
        AddBody(scene, scenes::BodyType::dynamic, {0.0f, 0.52f + 1.01f * static_cast<float>(i)},
                scenes::Box(0.5f, 0.5f));
    }
    return scene;
}

std::vector<BodyState> Capture(EngineRun& run) {
    Snapshot snapshot;
    run.Capture(snapshot);
    return snapshot.bodies;
}

TEST(StateJudge, TellsDistancesAndEnergiesOfKnownStates) {
    const scenes::Scene scene = MakeThrow(false);
    StateJudge judge(scene);
    const std::vector<BodyState> start = Capture(*MakeRun(scene, GetBaseline()));
    const auto box = scene.fixtures.front().shape;
    const std::vector<BodyState>& one = start;
    std::vector<BodyState> other = start;
    const float dx = Draw(-2.0f, 2.0f), dy = Draw(-2.0f, 2.0f);
    other[0].position = {other[0].position.x + dx, other[0].position.y + dy};
    EXPECT_NEAR(judge.GetDistance(one, other), std::hypot(double{dx}, double{dy}), 1e-6);
    // A quarter of a turn moves a mass at r by r √2; the mean of r² in a box is (w² + h²)/12.
    other = start;
    other[0].sin = 1.0f;
    other[0].cos = 0.0f;
    const double width = 2.0 * double{box.halfExtents.x}, height = 2.0 * double{box.halfExtents.y};
    const double spread = std::sqrt((width * width + height * height) / 12.0);
    EXPECT_NEAR(judge.GetDistance(one, other), std::sqrt(2.0) * spread, 1e-5);
    // Skins are part of the box around a body.
    EXPECT_NEAR(judge.GetBodySize(), std::max(width, height), 0.03);
    const Vec2 v = scene.bodies[0].linearVelocity;
    const double up = Draw(1.0f, 50.0f), kinetic = 0.5 * (double{v.x} * v.x + double{v.y} * v.y);
    other = start;
    other[0].position.y += static_cast<float>(up);
    EXPECT_NEAR(judge.GetEnergy(start, {0.0f, -10.0f}), kinetic, 1e-5);
    EXPECT_NEAR(judge.GetEnergy(other, {0.0f, -10.0f}), kinetic + 10.0 * up, 1e-3);
    EXPECT_EQ(judge.GetDistance(start, {}), 0.0);
}

TEST(StateJudge, AgreesWithWhatTheEngineSaysOfItself) {
    const scenes::Scene scene = MakePile(std::uniform_int_distribution(2, 6)(Random()));
    for (const RunSpec& spec : {GetSequential("scree"), GetSoft(4), GetSoft(16)}) {
        scree::World world(MakeScreeWorldDef(Resolve(spec, scene)));
        world.SetMeasureErrors(true);
        std::vector<scree::Body*> bodies;
        for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
            bodies.push_back(CreateScreeBody(world, scene, i));
        }
        StateJudge judge(scene);
        for (int step = 1; step <= 120; ++step) {
            const scree::StepReport report = StepScree(world, spec.solver, 1.0f / 60.0f);
            std::vector<BodyState> states;
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                states.push_back(CaptureBody(*bodies[i], static_cast<int>(i)));
            }
            // At rest; in motion the engine has the contacts of before the step.
            if (step < 90) continue;
            ASSERT_GT(report.errors.overlap, 0.0f);
            EXPECT_NEAR(judge.Measure(states, !IsSequential(spec)).overlap, report.errors.overlap, 1e-4)
                << PrintSpec(spec);
        }
    }
    // One box is pushed into another by a known way.
    StateJudge judge(scene);
    std::vector<BodyState> states = Capture(*MakeRun(scene, GetBaseline()));
    const float way = Draw(0.05f, 0.2f);
    states[2].position.y = states[1].position.y + 1.0f - way;
    for (std::size_t i = 3; i < states.size(); ++i) states[i].position.y += 100.0f * static_cast<float>(i);
    EXPECT_NEAR(judge.Measure(states, true).overlap, way, 1e-4);
    EXPECT_NEAR(judge.Measure(states, false).overlap, way + 0.02, 1e-4) << "two skins more";
    // Bodies that are not there take no part.
    EXPECT_EQ(judge.Measure(std::span(states).first(2), true).overlap, 0.0);
    states[1].position.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isinf(judge.Measure(states, true).overlap));
}

TEST(StateJudge, SeesTheGapOfAJoint) {
    scenes::Scene scene = scenes::Build("bridge", 10);
    StateJudge judge(scene);
    std::vector<BodyState> states = Capture(*MakeRun(scene, GetBaseline()));
    const double start = judge.Measure(states, true).jointGap;
    EXPECT_LT(start, 1e-3);
    const float way = Draw(0.1f, 0.4f);
    const auto plank = std::ranges::find(states, scenes::BodyType::dynamic, &BodyState::type);
    plank->position.y += way;
    EXPECT_NEAR(judge.Measure(states, true).jointGap, way, 1e-3);
}

std::vector<RunSpec> FewSettings() {
    return {GetBaseline(), GetSequential("box2d", 8, 3, 120), GetSequential("scree"), GetSoft(4), GetSoft(8, 120)};
}

TEST(SceneMeter, MeasuresAThrowAsItsClosedFormHasIt) {
    for (const bool spawned : {false, true}) {
        const scenes::Scene scene = MakeThrow(spawned);
        const double seconds = 1.0, flight = spawned ? 0.5 : 1.0;
        SceneMeter meter(scene, FewSettings(), Effort::quick, seconds, "", nullptr);
        const SceneFacts& facts = meter.GetLaw()->facts;
        ASSERT_EQ(facts.references.size(), 3u);
        // Semi-implicit Euler falls g t (t + dt)/2: longer steps fall further. The reference has 1/960 s.
        const auto error = [&](double dt) { return 5.0 * flight * (dt - 1.0 / 960.0); };
        EXPECT_EQ(facts.window, seconds);
        EXPECT_NEAR(facts.references[0].apart, 5.0 * flight / 960.0, 2e-4);
        EXPECT_NEAR(meter.MeasureErrors(GetBaseline(), nullptr).at(0), error(1.0 / 60.0), 2e-3);
        EXPECT_NEAR(meter.MeasureErrors(GetSequential("box2d", 8, 3, 120), nullptr).at(0), error(1.0 / 120.0), 2e-3);
        // A rate whose steps are not those of the samples: states between steps.
        EXPECT_NEAR(meter.MeasureErrors(GetSequential("scree", 8, 3, 50), nullptr).at(0), error(1.0 / 50.0), 4e-3);
        EXPECT_EQ(meter.MeasureErrors(GetBaseline(), nullptr).at(2), 0.0) << "nothing touches";
        EXPECT_GT(meter.TimeRun(GetBaseline(), nullptr), 0.0);
    }
}

TEST(SceneMeter, SaysWhereDistancesLoseTheirMeaning) {
    const scenes::Scene gas = MakeGas();
    const SceneMeter meter(gas, FewSettings(), Effort::quick, 4.0, "", nullptr);
    const SceneFacts& facts = meter.GetLaw()->facts;
    EXPECT_LT(facts.window, 3.0) << "elastic balls part";
    double first = 4.0;
    for (const SceneReference& r : facts.references) {
        ASSERT_TRUE(r.parted) << r.setting;
        first = std::min(first, *r.parted);
    }
    if (facts.window > 0.0) {
        EXPECT_NEAR(facts.window, first - sampleInterval, 1e-9);
        EXPECT_LE(facts.distanceFloor, partedShare * facts.bodySize);
        EXPECT_EQ(meter.GetLaw()->law.errors.size(), 3u);
    } else {
        EXPECT_EQ(meter.GetLaw()->law.errors.size(), 1u) << "overlap alone";
    }
}

TEST(SceneMeter, AWorldThatCannotMoveIsRefused) {
    scenes::Scene scene = MakeEmpty("still", 60);
    AddBody(scene, scenes::BodyType::isStatic, {0.0f, 0.0f}, scenes::Box(1.0f, 1.0f));
    std::string leftOut;
    EXPECT_THROW((void)ChooseForScene(scene, FewSettings(), leftOut), UsageError);
    EXPECT_EQ(ChooseForScene(MakePile(2), FewSettings(), leftOut).size(), FewSettings().size());
    EXPECT_TRUE(leftOut.empty());
}

TEST(SceneLaw, FactsComeBackAsTheyWent) {
    const SceneMeter meter(MakePile(3), FewSettings(), Effort::quick, 0.2, "Box2D 3: \"no\" gears", nullptr);
    const SceneFacts& facts = meter.GetLaw()->facts;
    const auto json = nlohmann::ordered_json::parse(ToJson(facts).dump());
    EXPECT_EQ(ToJson(SceneFactsFromJson(json)), json);
    for (const char* name : {"seconds", "window", "distanceFloor", "energyFloor"}) {
        auto bad = json;
        bad[name] = -1.0;
        EXPECT_THROW((void)SceneFactsFromJson(bad), FileError) << name;
        bad.erase(name);
        EXPECT_ANY_THROW((void)SceneFactsFromJson(bad)) << name;
    }
}

/// Cases of one scene, equal for equal numbers.
TradeCase MakeSceneCase(const std::shared_ptr<const SceneLaw>& law, const RunSpec& setting, double error, double cost) {
    TradeCase one;
    one.law = law->law.name;
    one.scene = law;
    one.setting = setting;
    one.errors.assign(law->law.errors.size(), error);
    one.milliseconds = {cost, cost, cost};
    one.bodyFrames = 1e6;
    return one;
}

TEST(SceneLaw, BothSidesChooseByTheSameRule) {
    SceneFacts facts{.scene = "mine", .dynamicBodies = 1, .seconds = 1.0, .window = 1.0};
    facts.distanceFloor = facts.energyFloor = 1e-4;
    const auto law = MakeSceneLaw(facts);
    const double better = Draw(0.1f, 0.9f);
    // Ours has the same two points as Box2D: front against front is 1 whatever Box2D's own gain is.
    std::vector<TradeCase> cases;
    for (const char* engine : {"box2d", "scree"}) {
        cases.push_back(MakeSceneCase(law, GetSequential(engine), 0.5, 10.0));
        cases.push_back(MakeSceneCase(law, GetSequential(engine, 16, 6, 30), 0.4, 10.0 * better));
    }
    constexpr Family ours[] = {Family::sequential, Family::soft};
    const std::vector<LawGain> gains = CompareWithBaseline(cases, ours);
    ASSERT_EQ(gains.size(), 1u);
    EXPECT_EQ(gains[0].law->name, "scene-mine");
    EXPECT_NEAR(*gains[0].box2d.speedUp, 1.0 / better, 1e-9);
    EXPECT_NEAR(*gains[0].GetSpeedUp(), 1.0, 1e-9);
    EXPECT_NEAR(*gains[0].GetErrorRatio(), 1.0, 1e-9);
    EXPECT_FALSE(HasMiss(CheckBounds(cases))) << "scenes have no bounds";
}

TEST(Trade, TheCommandMeasuresASceneOfTheUsers) {
    const ScratchFolder folder;
    scenes::Scene mine = MakePile(std::uniform_int_distribution(1, 8)(Random()));
    mine.name = "mine";
    std::ofstream(folder.GetPath() / "mine.scene.json") << WriteScene(mine);
    const std::string common =
        "--quick --seconds 0.4 --engines scree:solver=soft@4,scree:solver=soft@16,box2d:solver=si@16/6 -o out ";
    const ProgramResult result = folder.Run("tradeoff mine.scene.json --json lines.jsonl --markdown out.md " + common);
    ASSERT_EQ(result.exitCode, exitDone) << result.output;
    EXPECT_NE(result.output.find("4 cases: 1 scene, 4 settings"), std::string::npos) << result.output;
    for (const char* file : {"out/index.html", "out/cases.csv", "out/plots/scene-mine.svg", "out.md"}) {
        EXPECT_TRUE(folder.Has(file)) << file;
    }
    EXPECT_NE(folder.Read("out.md").find("## References"), std::string::npos);
    const std::string csv = folder.Read("out/cases.csv");
    for (const char* part : {"1", "2"}) {
        const ProgramResult shard =
            folder.Run("tradeoff mine.scene.json " + common + "--json part" + part + ".jsonl --shard " + part + "/2");
        ASSERT_EQ(shard.exitCode, exitDone) << shard.output;
    }
    ASSERT_EQ(folder.Run("merge part1.jsonl part2.jsonl -o joined.jsonl").exitCode, exitDone);
    const ProgramResult joined = folder.Run("tradeoff --from joined.jsonl -o joined");
    EXPECT_EQ(joined.exitCode, exitDone) << joined.output;
    ASSERT_EQ(folder.Run("tradeoff --from lines.jsonl -o again").exitCode, exitDone);
    EXPECT_EQ(folder.Read("again/cases.csv"), csv);
    // A line of another scene of the same name.
    std::string lines = folder.Read("lines.jsonl");
    const std::string field = "\"dynamicBodies\":";
    const std::size_t place = lines.rfind(field);
    ASSERT_NE(place, std::string::npos);
    lines.insert(place + field.size(), "1");
    std::ofstream(folder.GetPath() / "mixed.jsonl") << lines;
    const ProgramResult mixed = folder.Run("tradeoff --from mixed.jsonl");
    EXPECT_EQ(mixed.exitCode, exitIo) << mixed.output;
    EXPECT_NE(mixed.output.find("two different scenes or runs"), std::string::npos) << mixed.output;
}

TEST(Trade, TheCommandRefusesScenesThatItCannotMeasure) {
    const ScratchFolder folder;
    scenes::Scene still = MakeEmpty("still", 60);
    AddBody(still, scenes::BodyType::isStatic, {0.0f, 0.0f}, scenes::Box(1.0f, 1.0f));
    std::ofstream(folder.GetPath() / "still.scene.json") << WriteScene(still);
    std::ofstream(folder.GetPath() / "bad.scene.json") << "{\"scree\": 1, \"bodies\": [";
    const auto refuse = [&](const std::string& arguments, int exitCode, const std::string& words) {
        const ProgramResult result = folder.Run("tradeoff " + arguments);
        EXPECT_EQ(result.exitCode, exitCode) << arguments << "\n" << result.output;
        EXPECT_NE(result.output.find(words), std::string::npos) << arguments << "\n" << result.output;
        EXPECT_FALSE(folder.Has("out")) << arguments;
    };
    refuse("still.scene.json", exitUsage, "nothing moves in it");
    refuse("bad.scene.json", exitIo, "bad.scene.json");
    refuse("none.scene.json", exitIo, "none.scene.json: there is no such file");
    refuse("pyramit", exitUsage, "did you mean 'pyramid'");
    refuse("pyramid -g column", exitUsage, "-g chooses laws");
    refuse("pyramid --from x.jsonl", exitUsage, "--from measures nothing");
    refuse("pyramid --seconds 0", exitUsage, "--seconds 0: from 0.1 to 3600");
    refuse("pyramid --seconds nan", exitUsage, "--seconds");
    refuse("pyramid --size 100000", exitUsage, "--size 100000");
    refuse("--seconds 1 --quick", exitUsage, "give a SCENE");
    refuse("--size 3 --quick", exitUsage, "--size");
}

}  // namespace
}  // namespace testbed
