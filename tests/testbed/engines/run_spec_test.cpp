// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of the run spec. What is printed reads back to the same spec and holds nothing that could be left out. Every key
// refuses what is no value of it and changes nothing then. Every setting reaches the engine.

#include "testbed/engines/run_spec.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "scree/broad_phase_kind.h"
#include "scree/features.h"
#include "testbed/base/errors.h"
#include "testbed/engines/engine_list.h"
#include "tests/testbed/engines/run_checks.h"
#include "tests/testbed/engines/scene_builder.h"

namespace testbed {
namespace {

template <typename Number>
Number Between(Number low, Number high) {
    return low + (high - low) * static_cast<Number>(*rc::gen::inRange(0, 1'000'001)) / Number{1'000'000};
}

Solver RandomSolver(Abilities abilities, float lengthScale) {
    const int first = abilities.Has(Ability::sequential) ? 0 : 2;
    const int end = abilities.Has(Ability::dial) ? 5 : abilities.Has(Ability::softSteps) ? 3 : 2;
    switch (*rc::gen::inRange(first, end)) {
        case 0:
            return SequentialImpulses{};
        case 1:
            return SequentialImpulses{Iterations{*rc::gen::inRange(1, 201), *rc::gen::inRange(0, 201)}};
        case 2:
            return SoftStep{*rc::gen::inRange(1, 65)};
        case 3:
            return static_cast<Accuracy>(*rc::gen::inRange(0, 4));
        default:
            break;
    }
    Tolerance tolerance{Between(0.006f, 1.0f) * lengthScale, *rc::gen::element(0.001f, 0.25f)};
    if (*rc::gen::arbitrary<bool>()) {
        tolerance.leastSubsteps = *rc::gen::inRange(1, 65);
        tolerance.mostSubsteps = *rc::gen::inRange(tolerance.leastSubsteps, 65);
    }
    return tolerance;
}

std::string RandomFeatures() {
    std::string names;
    for (const char* name : scree::featureNames) {
        if (*rc::gen::arbitrary<bool>()) names += (names.empty() ? "" : "+") + std::string(name);
    }
    return *rc::gen::element<std::string>("automatic", "full", "none", names.empty() ? "none" : names);
}

/// Any spec that an engine of the list can run.
RunSpec RandomSpec() {
    const EngineInfo& engine = *rc::gen::elementOf(std::vector(GetEngines().begin(), GetEngines().end()));
    RunSpec spec{.engine = std::string(engine.name)};
    if (engine.abilities.Has(Ability::lengthScales)) spec.lengthScale = *rc::gen::element(1.0f, Between(1e-6f, 1e6f));
    spec.solver = RandomSolver(engine.abilities, spec.lengthScale);
    if (*rc::gen::arbitrary<bool>()) {
        spec.timeStep = *rc::gen::arbitrary<bool>() ? 1.0 / *rc::gen::inRange(10, 10001) : Between(1e-4, 0.1);
    }
    if (*rc::gen::arbitrary<bool>()) spec.gravity = scenes::Vec2{Between(-30.0f, 30.0f), Between(-30.0f, 30.0f)};
    spec.continuous = *rc::gen::arbitrary<bool>();
    spec.sleeping = *rc::gen::arbitrary<bool>();
    spec.warmStarting = *rc::gen::arbitrary<bool>();
    if (engine.abilities.Has(Ability::freeSpeed)) spec.caps = *rc::gen::arbitrary<bool>();
    if (engine.abilities.Has(Ability::threads)) spec.threads = *rc::gen::inRange(1, maxThreads + 1);
    if (engine.abilities.Has(Ability::features)) spec.features = RandomFeatures();
    if (engine.abilities.Has(Ability::joints)) spec.directJoints = *rc::gen::arbitrary<bool>();
    if (engine.abilities.Has(Ability::softTuning)) {
        for (auto member : {&RunSpec::contactHertz, &RunSpec::contactDamping, &RunSpec::pushSpeed}) {
            if (*rc::gen::arbitrary<bool>()) spec.*member = Between(0.001f, *rc::gen::element(1.0f, 100.0f, 1e6f));
        }
    }
    if (engine.abilities.Has(Ability::broadPhases)) {
        spec.broadPhase =
            *rc::gen::elementOf(std::vector<std::string>(scree::broadPhaseNames.begin(), scree::broadPhaseNames.end()));
    }
    return spec;
}

std::vector<std::string> Words(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

RunSpec Read(const std::string& engine, const std::vector<std::string>& settings) {
    RunSpec spec = MakeSpec(engine);
    for (const std::string& setting : settings) EXPECT_TRUE(ApplySetting(spec, setting)) << setting;
    return spec;
}

TEST(RunSpec, ReadsBackWhatItPrints) {
    EXPECT_TRUE(rc::check("settings and back", [] {
        const RunSpec spec = RandomSpec();
        RC_ASSERT(FindProblem(spec).empty());
        const std::string text = PrintSettings(spec);
        RC_ASSERT(text.find_first_of(",:\"") == std::string::npos);  // fits into lists, tables and CSV
        RC_ASSERT(Read(spec.engine, Words(text)) == spec);
    }));
}

TEST(RunSpec, PrintsNothingThatCouldBeLeftOut) {
    EXPECT_TRUE(rc::check("shortest", [] {
        const RunSpec spec = RandomSpec();
        const std::vector<std::string> words = Words(PrintSettings(spec));
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::vector<std::string> fewer = words;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
            RC_ASSERT(Read(spec.engine, fewer) != spec);
        }
    }));
}

TEST(RunSpec, TheDefaultsAreTheEnginesOwn) {
    const RunSpec own = MakeSpec("scree");
    EXPECT_EQ(own, RunSpec{});
    EXPECT_EQ(PrintSettings(own), "");
    EXPECT_EQ(PrintSettings(MakeSpec("box2d")), "");
    EXPECT_FALSE(own.caps);
    EXPECT_TRUE(own.continuous && own.sleeping && own.warmStarting);
    const RunSpec alike = MakeSpec("scree", likeBox2dPreset);
    EXPECT_TRUE(alike.caps);
    EXPECT_FALSE(alike.continuous);
    for (const Preset& preset : GetPresets()) {
        for (const EngineInfo& engine : GetEngines()) {
            const RunSpec spec = MakeSpec(engine.name, preset.name);
            EXPECT_EQ(Read(spec.engine, Words(PrintSettings(spec))), spec) << preset.name;
        }
    }
    EXPECT_EQ(PrintSettings(alike), "preset=like-box2d");
    EXPECT_THROW((void)MakeSpec("scree", "like-box3d"), UsageError);
}

TEST(RunSpec, TheLastSettingCountsAndAPresetSetsAll) {
    EXPECT_EQ(Read("scree", {"solver=soft@8", "threads=2", "solver=si"}), Read("scree", {"threads=2"}));
    EXPECT_EQ(Read("scree", {"iterations=16/6"}), Read("scree", {"solver=si@16/6"}));
    EXPECT_EQ(Read("scree", {"substeps=8"}), Read("scree", {"solver=soft@8"}));
    EXPECT_EQ(Read("scree", {"solver=soft"}), Read("scree", {"solver=soft@4"}));
    EXPECT_EQ(Read("scree", {"accuracy=fine", "tolerance=0.02"}), Read("scree", {"tolerance=0.02/0.001/4/32"}));
    EXPECT_EQ(Read("scree", {"threads=4", "caps=on", "preset=own"}), MakeSpec("scree"));
    EXPECT_EQ(Read("scree", {"features=friction+rotation+friction"}).features, "rotation+friction");
    EXPECT_DOUBLE_EQ(*Read("box2d", {"timeStep=1/240"}).timeStep, 1.0 / 240);
}

TEST(RunSpec, ACommaMayStandForASlash) {
    EXPECT_EQ(Read("scree", {"gravity=0,-20"}), Read("scree", {"gravity=0/-20"}));
    EXPECT_FLOAT_EQ(Read("scree", {"gravity=0,-20"}).gravity->y, -20.0f);
    EXPECT_EQ(Read("box2d", {"iterations=4,2"}), Read("box2d", {"solver=si@4/2"}));
    EXPECT_EQ(Read("scree", {"solver=si@4,2"}), Read("scree", {"solver=si@4/2"}));
    EXPECT_EQ(Read("scree", {"tolerance=0.02,0.002,2,16"}), Read("scree", {"tolerance=0.02/0.002/2/16"}));
}

TEST(RunSpec, NamesTheNearestKey) {
    for (const SettingKey& key : GetSettingKeys()) {
        for (std::size_t i = 0; i < key.name.size(); ++i) {
            std::string typed(key.name);
            typed[i] = '#';
            try {
                (void)FindSettingKey(typed);
                FAIL() << typed;
            } catch (const UsageError& error) {
                EXPECT_NE(std::string(error.what()).find("did you mean '" + std::string(key.name) + "'"),
                          std::string::npos)
                    << error.what();
            }
        }
    }
}

TEST(RunSpec, RefusesWhatIsNoValueAndChangesNothing) {
    for (const char* setting : {"solver=soft@0",
                                "solver=soft@65",
                                "solver=soft@",
                                "solver=SI",
                                "solver=si@8",
                                "solver=si@0/3",
                                "iterations=8/3/1",
                                "iterations=201/3",
                                "substeps=1.5",
                                "accuracy=gaem",
                                "tolerance=0",
                                "tolerance=-1",
                                "tolerance=0.01/0.001/4",
                                "tolerance=0.01/0.001/8/4",
                                "tolerance=nan",
                                "timeStep=0",
                                "timeStep=1",
                                "timeStep=1/0",
                                "timeStep=1/",
                                "timeStep=60",
                                "gravity=-10",
                                "gravity=0/inf",
                                "gravity=0/-10/0",
                                "gravity=0,-10,0",
                                "gravity=0,",
                                "gravity=0,/-10",
                                "iterations=4,2/1",
                                "timeStep=1,120",
                                "caps=yes",
                                "continuous=",
                                "sleeping=1",
                                "warmStarting=ON",
                                "lengthScale=0",
                                "lengthScale=nan",
                                "joints=on",
                                "joints=",
                                "contactHertz=0",
                                "contactHertz=nan",
                                "contactDamping=-1",
                                "contactDamping=scene",
                                "pushSpeed=inf",
                                "pushSpeed=1e7",
                                "threads=0",
                                "threads=65",
                                "threads=2x",
                                "features=wings",
                                "features=",
                                "features=friction+",
                                "broadPhase=kees",
                                "preset=box2d",
                                "threads",
                                "=2",
                                "",
                                "timestep=0.01"}) {
        const RunSpec before = Read("scree", {"solver=soft@8", "threads=2"});
        RunSpec spec = before;
        EXPECT_THROW((void)ApplySetting(spec, setting), UsageError) << setting;
        EXPECT_EQ(spec, before) << setting;
        spec = MakeSpec("box2d");
        EXPECT_THROW((void)ApplySetting(spec, setting), UsageError) << setting << " is a value nowhere";
    }
}

TEST(RunSpec, AnEngineLeavesWhatItDoesNotHave) {
    for (const char* setting : {"solver=soft@8", "substeps=4", "accuracy=draft", "tolerance=0.01", "caps=off",
                                "lengthScale=0.1", "threads=2", "features=full", "broadPhase=keys", "contactHertz=60",
                                "contactDamping=5", "pushSpeed=own", "joints=direct"}) {
        RunSpec spec = MakeSpec("box2d");
        EXPECT_FALSE(ApplySetting(spec, setting)) << setting;
        EXPECT_EQ(spec, MakeSpec("box2d")) << setting;
    }
    for (const char* setting : {"solver=si@4/2", "timeStep=1/120", "gravity=0/0", "continuous=off", "sleeping=off",
                                "warmStarting=off", "preset=like-box2d"}) {
        RunSpec spec = MakeSpec("box2d");
        EXPECT_TRUE(ApplySetting(spec, setting)) << setting;
        EXPECT_NE(spec, MakeSpec("box2d")) << setting;
    }
}

/// State after half a second of a pile that lands.
Snapshot RunPile(const std::string& engine, const std::vector<std::string>& settings) {
    const scenes::Scene scene = scenes::Build("pyramid", 6);
    const auto run = MakeRun(scene, Read(engine, settings));
    for (int i = 0; i < 30; ++i) run->Step();
    Snapshot snapshot;
    run->Capture(snapshot);
    return snapshot;
}

TEST(RunSpec, EverySettingReachesTheEngine) {
    const auto hash = [](const std::string& engine, const std::vector<std::string>& settings) {
        return RunPile(engine, settings).stateHash;
    };
    for (const EngineInfo& engine : GetEngines()) {
        const std::string name(engine.name);
        const uint64_t plain = hash(name, {});
        const bool isSequential = engine.abilities.Has(Ability::sequential);
        const char* own = isSequential ? "iterations=8/3" : "substeps=4";
        EXPECT_EQ(hash(name, {own, "timeStep=1/60", "gravity=0/-10"}), plain) << name;
        for (const char* setting :
             {isSequential ? "iterations=2/1" : "substeps=1", "timeStep=1/120", "gravity=0.5/-9", "warmStarting=off"}) {
            EXPECT_NE(hash(name, {setting}), plain) << name << ' ' << setting;
        }
        if (!engine.abilities.Has(Ability::softTuning)) continue;
        const uint64_t soft = hash(name, {"substeps=4"});
        for (const char* tuning : {"contactHertz=10", "contactDamping=2", "pushSpeed=0.01"}) {
            EXPECT_NE(hash(name, {"substeps=4", tuning}), soft) << name << ' ' << tuning;
        }
        const std::string push = name == "scree" ? "pushSpeed=1" : "pushSpeed=3";
        EXPECT_EQ(hash(name, {"substeps=4", "contactHertz=30", "contactDamping=10", push}), soft)
            << name << ": what the table of settings says of the engine's own";
    }
    const uint64_t plain = hash("scree", {});
    EXPECT_EQ(hash("scree", {"accuracy=draft"}), hash("scree", {"iterations=4/2"}));
    EXPECT_EQ(hash("scree", {"accuracy=game"}), hash("scree", {"solver=soft"}));
    EXPECT_EQ(hash("scree", {"accuracy=precise"}), hash("scree", {"substeps=16"}));
    EXPECT_NE(hash("scree", {"solver=soft"}), plain);
    EXPECT_NE(hash("scree", {"tolerance=0.006/0.001/1/64"}), hash("scree", {"tolerance=0.1/0.1/1/1"}));
    EXPECT_NE(hash("scree", {"lengthScale=0.1"}), plain);
    for (const char* same : {"threads=2", "features=full", "broadPhase=unified"}) {
        EXPECT_EQ(hash("scree", {same}), plain) << same;
    }
    EXPECT_EQ(RunPile("scree", {"broadPhase=unified"}).broadPhase, "unified");
    EXPECT_EQ(RunPile("scree", {"threads=2"}).threads, 2);
}

TEST(RunSpec, SleepCapsAndContinuousCollisionAreSwitches) {
    scenes::Scene fast;
    fast.name = "fast";
    fast.gravity = {0, 0};
    fast.fixtures.resize(1);
    fast.fixtures[0].shape.type = scenes::ShapeType::circle;
    fast.fixtures[0].shape.radius = 0.5f;
    fast.fixtures[0].density = 1;
    scenes::Body body;
    body.type = scenes::BodyType::dynamic;
    body.linearVelocity = {300, 0};
    body.firstFixture = 0;
    body.fixtureCount = 1;
    fast.bodies = {body};
    const auto way = [&](const std::vector<std::string>& settings) {
        const auto run = MakeRun(fast, Read("scree", settings));
        run->Step();
        Snapshot snapshot;
        run->Capture(snapshot);
        return snapshot.bodies[0].position.x;
    };
    EXPECT_NEAR(way({"caps=off"}), 5.0f, 1e-5f);
    EXPECT_NEAR(way({"caps=on"}), 2.0f, 1e-5f);
    for (const EngineInfo& engine : GetEngines()) {
        const scenes::Scene box = checks::RestingBox();
        const auto awake = [&](const char* setting) {
            const auto run = MakeRun(box, Read(std::string(engine.name), {setting}));
            int awakeInStep = 0;
            for (int i = 0; i < 120; ++i) {
                run->Step();
                awakeInStep = run->CountStep().awake;
            }
            return awakeInStep;
        };
        EXPECT_EQ(awake("sleeping=on"), 0) << engine.name;
        EXPECT_GT(awake("sleeping=off"), 0) << engine.name;
    }
}

TEST(RunSpec, ATolerancesLeastDependsOnTheLengthScaleInAnyOrder) {
    for (const char* small : {"tolerance=0.0006 lengthScale=0.1", "lengthScale=0.1 tolerance=0.0006"}) {
        EXPECT_EQ(FindProblem(Read("scree", Words(small))), "") << small;
    }
    const RunSpec below = Read("scree", {"tolerance=0.004"});
    EXPECT_NE(FindProblem(below), "");
    EXPECT_THROW((void)MakeRun(scenes::Build("pyramid", 3), below), std::invalid_argument);
}

TEST(RunSpec, OnlyLiveKeysChangeWhileASceneRuns) {
    const scenes::Scene scene = scenes::Build("pyramid", 4);
    for (const auto& [setting, isLive] : {std::pair("solver=soft@8", true),
                                          {"accuracy=fine", true},
                                          {"timeStep=1/120", true},
                                          {"gravity=1/2", true},
                                          {"continuous=off", true},
                                          {"sleeping=off", true},
                                          {"warmStarting=off", true},
                                          {"caps=on", false},
                                          {"joints=iterative", true},
                                          {"contactHertz=60", false},
                                          {"contactDamping=5", false},
                                          {"pushSpeed=2", false},
                                          {"lengthScale=0.5", false},
                                          {"threads=2", false},
                                          {"features=full", false},
                                          {"broadPhase=unified", false}}) {
        const auto run = MakeRun(scene, MakeSpec("scree"));
        const RunSpec before = run->GetSpec();
        RunSpec changed = before;
        ASSERT_TRUE(ApplySetting(changed, setting));
        if (isLive) {
            run->Apply(changed);
            EXPECT_EQ(run->GetSpec(), changed) << setting;
        } else {
            EXPECT_THROW(run->Apply(changed), std::invalid_argument) << setting;
            EXPECT_EQ(run->GetSpec(), before) << setting;
        }
        run->Step();
    }
}

TEST(RunSpec, ThePageHoldsTheTableOfTheKeys) {
    std::ifstream file(SCREE_SOURCE_DIR "/testbed/docs/settings.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(page.find(WriteSettingTable()), std::string::npos) << "it should read\n" << WriteSettingTable();
}

}  // namespace
}  // namespace testbed
