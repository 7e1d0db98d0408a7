// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of the engines, and what is made by it.

#include "testbed/engines/engine_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/engines/poses.h"
#include "testbed/engines/track_run.h"
#ifdef SCREE_HAS_BOX2D3
#include "testbed/engines/box2d3/box2d3_engine.h"
#endif

namespace testbed {

namespace {

constexpr Abilities Of(std::initializer_list<Ability> abilities) {
    Abilities all;
    for (const Ability ability : abilities) all.bits |= static_cast<unsigned>(ability);
    return all;
}

constexpr EngineInfo engines[] = {
    {.name = "scree",
     .title = "Scree",
     .abilities =
         Of({Ability::sequential, Ability::softSteps, Ability::softTuning, Ability::joints, Ability::dial,
             Ability::freeSpeed, Ability::lengthScales, Ability::threads, Ability::features, Ability::broadPhases}),
     .makeRun = MakeScreeRun,
     .makeFollower = MakeScreeFollower,
     .makeLab = MakeScreeLab},
    {.name = "box2d",
     .title = "Box2D 2.4.1",
     .abilities = Of({Ability::sequential}),
     .makeRun = MakeBox2dRun,
     .makeFollower = MakeBox2dFollower,
     .makeLab = MakeBox2dLab},
    {.name = "box2d3",
     .title = "Box2D 3",
     .abilities = Of({Ability::softSteps, Ability::softTuning, Ability::threads}),
#ifdef SCREE_HAS_BOX2D3
     .makeRun = MakeBox2d3Run,
     .makeFollower = MakeBox2d3Follower,
     .makeLab = MakeBox2d3Lab},
#else
     .makeRun = nullptr,
     .makeFollower = nullptr,
     .makeLab = nullptr},
#endif
};

/// It has no settings (HasSetting); the ability is what makes the solver of a spec that nobody reads a legal one.
constexpr EngineInfo recorded = {.name = recordedEngine,
                                 .title = "the recorded engine",
                                 .abilities = Of({Ability::sequential}),
                                 .makeRun = nullptr,
                                 .makeFollower = nullptr,
                                 .makeLab = nullptr};

constexpr std::pair<Ability, std::string_view> abilityNames[] = {{Ability::sequential, "sequential impulses"},
                                                                 {Ability::softSteps, "soft steps"},
                                                                 {Ability::dial, "an accuracy dial"},
                                                                 {Ability::freeSpeed, "speed without caps"},
                                                                 {Ability::softTuning, "tuning of soft contacts"},
                                                                 {Ability::joints, "ways to solve joints"},
                                                                 {Ability::lengthScales, "length scales"},
                                                                 {Ability::threads, "threads"},
                                                                 {Ability::features, "chosen features"},
                                                                 {Ability::broadPhases, "choice of broad phases"}};

}  // namespace

std::span<const EngineInfo> GetKnownEngines() { return engines; }

std::span<const EngineInfo> GetEngines() {
    // Those that may be missing come last.
    const auto missing =
        std::ranges::find_if(engines, [](const EngineInfo& engine) { return engine.makeRun == nullptr; });
    return {std::begin(engines), missing};
}

bool IsBuilt(std::string_view name) {
    return std::ranges::find(GetEngines(), name, &EngineInfo::name) != GetEngines().end();
}

const EngineInfo& FindEngine(std::string_view name) {
    if (name == recordedEngine) return recorded;
    const auto found = std::ranges::find(engines, name, &EngineInfo::name);
    if (found != std::end(engines)) return *found;
    std::vector<std::string_view> names;
    for (const EngineInfo& engine : engines) names.push_back(engine.name);
    throw UsageError(DescribeUnknown("engine", name, names));
}

namespace {

const EngineInfo& FindBuilt(std::string_view name) {
    const EngineInfo& engine = FindEngine(name);
    if (engine.makeRun != nullptr) return engine;
    if (name == recordedEngine) {
        throw UsageError(
            "recorded: it is the tree of a motion as it was recorded; give a *.track with nodes "
            "(scree_capture::Options::tree, or `scree convert --tree`), without --from");
    }
    throw UsageError(fmt::format("{} is not in this build: {}_ROOT names where {} is installed when it is configured",
                                 engine.name, engine.name, engine.title));
}

}  // namespace

std::string DescribeAbilities(Abilities abilities) {
    std::string text;
    for (const auto& [ability, name] : abilityNames) {
        if (abilities.Has(ability)) text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
    }
    return text;
}

std::unique_ptr<InteractiveRun> MakeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return FindBuilt(spec.engine).makeRun(scene, spec, needs);
}

std::unique_ptr<InteractiveRun> MakeRun(const RunStart& start, const RunSpec& spec, const RunNeeds& needs) {
    if (start.world != nullptr && spec.engine == "scree") return MakeScreeRun(*start.world, spec, needs);
    return MakeRun(start.scene, spec, needs);
}

std::unique_ptr<EngineRun> MakeFollower(const RunStart& start, const RunSpec& spec, const RunSpec& source,
                                        const RunNeeds& needs) {
    if (spec == source) return MakeRun(start, spec, needs);
    return FindBuilt(spec.engine).makeFollower(start.scene, spec, MakeRun(start, source, needs));
}

std::unique_ptr<EngineRun> MakeFollower(const RunStart& start, const RunSpec& spec) {
    if (spec.engine == recordedEngine && start.motion->GetInfo().hasNodes) {
        return MakeTrackRun(start.motion, start.step);
    }
    return FindBuilt(spec.engine).makeFollower(start.scene, spec, MakeTrackRun(start.motion, start.step));
}

std::unique_ptr<LabWorld> MakeLab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs) {
    return FindBuilt(spec.engine).makeLab(scene, spec, needs);
}

}  // namespace testbed
