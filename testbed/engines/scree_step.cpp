// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scree_step.h.

#include "testbed/engines/scree_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "scree/inspect.h"
#include "testbed/engines/scree_shape.h"

namespace testbed {

namespace {

struct Stepper {
    scree::World& world;
    float timeStep;

    scree::StepReport operator()(const SequentialImpulses& si) const {
        return world.Step(timeStep, si.iterations->velocity, si.iterations->position);
    }
    scree::StepReport operator()(const SoftStep& soft) const { return world.Step(timeStep, soft.substeps); }
    scree::StepReport operator()(Accuracy mark) const {
        return world.Step(timeStep, static_cast<scree::Accuracy>(mark));
    }
    scree::StepReport operator()(const Tolerance& t) const {
        return world.Step(timeStep, scree::Tolerance{t.overlap, t.jointGap, t.leastSubsteps, t.mostSubsteps});
    }
};

static_assert(static_cast<int>(Accuracy::precise) == static_cast<int>(scree::Accuracy::precise));
static_assert(maxThreads == scree::maxWorkers);

/// Names joined by +, which FindProblem has checked.
scree::Features ParseFeatures(std::string_view names) {
    scree::Features features;
    if (names == "none") return features;
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find('+'));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
        features.Add(*scree::FeatureFromName(name));
    }
    return features;
}

std::string PrintFeatures(scree::Features features) {
    std::string names;
    for (std::size_t i = 0; i < scree::featureNames.size(); ++i) {
        if (!features.Has(static_cast<scree::Feature>(i))) continue;
        names += fmt::format("{}{}", names.empty() ? "" : "+", scree::featureNames[i]);
    }
    return names.empty() ? "none" : names;
}

}  // namespace

scree::WorldDef MakeScreeWorldDef(const RunSpec& spec) {
    scree::WorldDef def;
    def.gravity = ToScree(*spec.gravity);
    def.allowSleep = spec.sleeping;
    def.warmStarting = spec.warmStarting;
    def.continuousPhysics = spec.continuous;
    def.softStep.contactHertz = spec.contactHertz.value_or(def.softStep.contactHertz);
    def.softStep.contactDampingRatio = spec.contactDamping.value_or(def.softStep.contactDampingRatio);
    def.softStep.contactPushSpeed = spec.pushSpeed.value_or(def.softStep.contactPushSpeed);
    def.lengthScale = spec.lengthScale;
    def.workerCount = spec.threads;
    def.broadPhase = *scree::BroadPhaseFromName(spec.broadPhase);
    if (spec.features == "full") {
        def.featureMode = scree::FeatureMode::full;
    } else if (spec.features != "automatic") {
        def.featureMode = scree::FeatureMode::fixed;
        def.features = ParseFeatures(spec.features);
    }
    if (spec.caps) {
        def.maxTranslation = scree::maxTranslation;
        def.maxRotation = scree::maxRotation;
    }
    return def;
}

RunSpec DescribeScreeWorld(const scree::World& world) {
    const scree::WorldDef& def = scree::inspect::GetDefinition(world);
    RunSpec spec = MakeSpec("scree");
    spec.directJoints = scree::inspect::GetDirectJoints(world);
    spec.sleeping = def.allowSleep;
    spec.warmStarting = def.warmStarting;
    spec.continuous = def.continuousPhysics;
    spec.caps = std::isfinite(def.maxTranslation);
    const auto unlessOwn = [](float value, float own) { return value == own ? std::nullopt : std::optional(value); };
    constexpr scree::SoftStepDef own;
    spec.contactHertz = unlessOwn(def.softStep.contactHertz, own.contactHertz);
    spec.contactDamping = unlessOwn(def.softStep.contactDampingRatio, own.contactDampingRatio);
    spec.pushSpeed = unlessOwn(def.softStep.contactPushSpeed, own.contactPushSpeed);
    spec.lengthScale = def.lengthScale;
    spec.broadPhase = scree::GetName(def.broadPhase);
    if (def.featureMode == scree::FeatureMode::full) spec.features = "full";
    if (def.featureMode == scree::FeatureMode::fixed) spec.features = PrintFeatures(def.features);
    return spec;
}

scree::StepReport StepScree(scree::World& world, const Solver& solver, float timeStep) {
    return std::visit(Stepper{world, timeStep}, solver);
}

}  // namespace testbed
