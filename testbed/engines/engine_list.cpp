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
     .abilities = Of({Ability::softSteps, Ability::freeSpeed, Ability::lengthScales, Ability::threads,
                      Ability::features, Ability::broadPhases}),
     .makeRun = MakeScreeRun,
     .makeFollower = MakeScreeFollower,
     .makeLab = MakeScreeLab},
    {.name = "box2d",
     .title = "Box2D 2.4.1",
     .abilities = {},
     .makeRun = MakeBox2dRun,
     .makeFollower = MakeBox2dFollower,
     .makeLab = MakeBox2dLab},
};

constexpr std::pair<Ability, std::string_view> abilityNames[] = {
    {Ability::softSteps, "soft steps"},       {Ability::freeSpeed, "speed without caps"},
    {Ability::lengthScales, "length scales"}, {Ability::threads, "threads"},
    {Ability::features, "chosen features"},   {Ability::broadPhases, "choice of broad phases"}};

}  // namespace

std::span<const EngineInfo> GetEngines() { return engines; }

const EngineInfo& FindEngine(std::string_view name) {
    const auto found = std::ranges::find(engines, name, &EngineInfo::name);
    if (found != std::end(engines)) return *found;
    std::vector<std::string_view> names;
    for (const EngineInfo& engine : engines) names.push_back(engine.name);
    throw UsageError(DescribeUnknown("engine", name, names));
}

std::string DescribeAbilities(Abilities abilities) {
    std::string text = "sequential impulses";
    for (const auto& [ability, name] : abilityNames) {
        if (abilities.Has(ability)) text += fmt::format(", {}", name);
    }
    return text;
}

std::unique_ptr<InteractiveRun> MakeRun(const scenes::Scene& scene, const RunSpec& spec, const RunNeeds& needs) {
    return FindEngine(spec.engine).makeRun(scene, spec, needs);
}

std::unique_ptr<EngineRun> MakeFollower(const scenes::Scene& scene, const RunSpec& spec, const RunSpec& source,
                                        const RunNeeds& needs) {
    if (spec == source) return MakeRun(scene, spec, needs);
    return FindEngine(spec.engine).makeFollower(scene, spec, MakeRun(scene, source, needs));
}

std::unique_ptr<LabWorld> MakeLab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs) {
    return FindEngine(spec.engine).makeLab(scene, spec, needs);
}

}  // namespace testbed
