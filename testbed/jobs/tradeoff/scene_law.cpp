// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scene_law.h.

#include "testbed/jobs/tradeoff/scene_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/engines/engine_run.h"

namespace testbed {

namespace {

constexpr double lost = std::numeric_limits<double>::infinity();
constexpr Family families[] = {Family::box2d, Family::box2d3, Family::sequential, Family::soft};

std::string_view WordOf(Family family) {
    constexpr std::string_view words[] = {"box2d", "box2d3", "sequential", "soft"};
    return words[static_cast<std::size_t>(family)];
}

/// Shapes may overlap by the slop and joints be open by a millimetre by design: less counts as none.
constexpr double overlapRounding = 0.005, jointRounding = 0.001;
constexpr double leastDistanceFloor = 1e-5, leastEnergyFloor = 1e-4;

/// Scenes with more than this are cut, s.
double LongestOf(Effort effort) { return effort == Effort::quick ? 2.0 : 4.0; }

int CountSamples(double seconds) { return static_cast<int>(std::floor(seconds / sampleInterval + 1e-9)); }

/// The scene for another time step: what appears after a step appears at the same time.
scenes::Scene Retimed(scenes::Scene scene, double timeStep) {
    for (scenes::Spawn& spawn : scene.spawns) {
        const double steps = spawn.afterStep * double{scene.timeStep} / timeStep;
        spawn.afterStep = std::max(1, static_cast<int>(std::lround(steps)));
    }
    return scene;
}

/// What a family's settings are measured against: `finer` divides the steps. A soft step's sub-steps refine what is
/// solved and its steps where shapes meet, so both are refined; sequential impulses only have steps.
RunSpec MakeReference(const RunSpec& setting, Effort effort, bool coarser) {
    RunSpec reference = setting;
    const bool isSequential = IsSequential(setting);
    const bool quick = effort == Effort::quick;
    const int most = isSequential ? (quick ? 16 : 32) : (quick ? 2 : 4);
    const int finer = coarser ? most / 2 : most;
    if (isSequential) {
        reference.solver = SequentialImpulses{quick ? Iterations{32, 12} : Iterations{64, 24}};
    } else {
        reference.solver = SoftStep{64};
    }
    reference.timeStep = 1.0 / (60.0 * finer);
    return reference;
}

/// One setting of each family among them, the first one.
std::vector<RunSpec> FirstOfFamilies(std::span<const RunSpec> settings) {
    std::vector<RunSpec> first;
    for (const Family family : families) {
        const auto found = std::ranges::find_if(settings, [family](const RunSpec& s) { return FamilyOf(s) == family; });
        if (found != settings.end()) first.push_back(*found);
    }
    return first;
}

/// A state between two, `share` of the way from the first to the second.
BodyState Between(const BodyState& a, const BodyState& b, float share) {
    const auto mix = [share](float from, float to) { return from + share * (to - from); };
    BodyState state = b;
    state.position = {mix(a.position.x, b.position.x), mix(a.position.y, b.position.y)};
    state.angle = mix(a.angle, b.angle);
    state.sin = std::sin(state.angle);
    state.cos = std::cos(state.angle);
    state.linearVelocity = {mix(a.linearVelocity.x, b.linearVelocity.x), mix(a.linearVelocity.y, b.linearVelocity.y)};
    state.angularVelocity = mix(a.angularVelocity, b.angularVelocity);
    return state;
}

using States = std::vector<BodyState>;

/// Both list bodies by growing index; of a body that is only in `b`, its state there.
States Between(const States& a, const States& b, double share) {
    States states;
    auto before = a.begin();
    for (const BodyState& after : b) {
        while (before != a.end() && before->index < after.index) ++before;
        const bool isThere = before != a.end() && before->index == after.index;
        states.push_back(isThere ? Between(*before, after, static_cast<float>(share)) : after);
    }
    return states;
}

States CaptureStates(EngineRun& run) {
    Snapshot snapshot;
    run.Capture(snapshot, {.fixtures = false, .contacts = false, .joints = false, .nodes = false, .pairs = false});
    return std::move(snapshot.bodies);
}

bool IsFinite(const BodyState& b) {
    return std::isfinite(b.position.x + b.position.y + b.sin + b.cos) &&
           std::isfinite(b.linearVelocity.x + b.linearVelocity.y + b.angularVelocity);
}

double Checked(const nlohmann::ordered_json& fields, const char* name, double least) {
    const double value = fields.at(name).get<double>();
    if (!(value >= least)) throw FileError(fmt::format("\"{}\" of a scene is at least {}, not {}", name, least, value));
    return value;
}

Family FamilyFromWord(const std::string& word) {
    for (const Family family : families) {
        if (WordOf(family) == word) return family;
    }
    throw FileError(fmt::format("no family of settings is called '{}'", word));
}

}  // namespace

std::string NameSceneLaw(const std::string& scene) { return std::string(scenePrefix) + scene; }

std::shared_ptr<const SceneLaw> MakeSceneLaw(const SceneFacts& facts) {
    Law law;
    law.name = NameSceneLaw(facts.scene);
    law.title = fmt::format("Scene {}, {} bodies that move, {:.3g} s", facts.scene, facts.dynamicBodies, facts.seconds);
    if (facts.window > 0.0) {
        law.exact = fmt::format("unknown; measured against finer runs, which agree for {:.3g} s", facts.window);
        law.errors.push_back({.name = "distance", .unit = "m", .rounding = facts.distanceFloor});
        law.errors.push_back({.name = "energy", .unit = "J/kg", .rounding = facts.energyFloor});
    } else {
        law.exact = "unknown; finer runs part at once, so only overlap and gaps are measured";
    }
    law.errors.push_back({.name = "overlap", .unit = "m", .rounding = overlapRounding});
    if (facts.hasJoints) law.errors.push_back({.name = "joint gap", .unit = "m", .rounding = jointRounding});
    return std::make_shared<const SceneLaw>(SceneLaw{facts, std::move(law)});
}

nlohmann::ordered_json ToJson(const SceneFacts& facts) {
    nlohmann::ordered_json references = nlohmann::ordered_json::array();
    for (const SceneReference& r : facts.references) {
        nlohmann::ordered_json one;
        one["family"] = WordOf(r.family);
        one["setting"] = r.setting;
        one["coarser"] = r.coarser;
        one["parted"] = r.parted ? nlohmann::ordered_json(*r.parted) : nlohmann::ordered_json();
        one["apart"] = r.apart;
        one["fromOurs"] = r.fromOurs;
        references.push_back(one);
    }
    nlohmann::ordered_json fields;
    fields["name"] = facts.scene;
    fields["dynamicBodies"] = facts.dynamicBodies;
    fields["seconds"] = facts.seconds;
    fields["window"] = facts.window;
    fields["bodySize"] = facts.bodySize;
    fields["distanceFloor"] = facts.distanceFloor;
    fields["energyFloor"] = facts.energyFloor;
    fields["joints"] = facts.hasJoints;
    fields["references"] = references;
    fields["leftOut"] = facts.leftOut;
    return fields;
}

SceneFacts SceneFactsFromJson(const nlohmann::ordered_json& fields) {
    SceneFacts facts;
    facts.scene = fields.at("name").get<std::string>();
    facts.dynamicBodies = fields.at("dynamicBodies").get<int>();
    facts.seconds = Checked(fields, "seconds", sampleInterval);
    facts.window = Checked(fields, "window", 0.0);
    facts.bodySize = Checked(fields, "bodySize", 0.0);
    facts.distanceFloor = Checked(fields, "distanceFloor", leastDistanceFloor);
    facts.energyFloor = Checked(fields, "energyFloor", leastEnergyFloor);
    facts.hasJoints = fields.at("joints").get<bool>();
    for (const auto& one : fields.at("references")) {
        SceneReference r{.family = FamilyFromWord(one.at("family").get<std::string>()),
                         .setting = one.at("setting").get<std::string>(),
                         .coarser = one.at("coarser").get<std::string>(),
                         .apart = Checked(one, "apart", 0.0),
                         .fromOurs = Checked(one, "fromOurs", 0.0)};
        if (!one.at("parted").is_null()) r.parted = Checked(one, "parted", 0.0);
        facts.references.push_back(std::move(r));
    }
    facts.leftOut = fields.at("leftOut").get<std::string>();
    return facts;
}

double GetSceneSeconds(const scenes::Scene& scene, Effort effort) {
    const double whole = scene.steps * double{scene.timeStep};
    return std::max(sampleInterval, std::min(whole, LongestOf(effort)));
}

std::vector<RunSpec> ChooseForScene(const scenes::Scene& scene, std::span<const RunSpec> settings,
                                    std::string& leftOut) {
    if (scenes::Count(scene).dynamicBodies == 0) {
        throw UsageError(
            fmt::format("scene '{}': nothing moves in it, so there is nothing to measure; "
                        "give a body \"type\": \"dynamic\"",
                        scene.name));
    }
    leftOut.clear();
    std::vector<std::string> refusing;
    for (const RunSpec& first : FirstOfFamilies(settings)) {
        try {
            (void)MakeRun(scene, first);
        } catch (const std::invalid_argument& error) {
            if (first.engine == "box2d" || first.engine == "scree") {
                throw UsageError(fmt::format("scene '{}': {}", scene.name, error.what()));
            }
            refusing.push_back(first.engine);
            leftOut += fmt::format("{}{}: {}", leftOut.empty() ? "" : "; ", NameFamily(FamilyOf(first)), error.what());
        }
    }
    std::vector<RunSpec> chosen;
    for (const RunSpec& setting : settings) {
        if (std::ranges::find(refusing, setting.engine) == refusing.end()) chosen.push_back(setting);
    }
    return chosen;
}

/// States of the dynamic bodies every sampleInterval, and what was measured on the way.
struct SceneMeter::Trajectory {
    std::vector<States> samples;
    std::vector<double> energies;
    double overlap = 0.0, jointGap = 0.0;  ///< means over the samples, of the deepest and the widest
    bool isLost = false;                   ///< a state was not finite; samples end there
};

SceneMeter::~SceneMeter() = default;

double SceneMeter::CountWork(const RunSpec& setting, double seconds) {
    const auto* soft = std::get_if<SoftStep>(&setting.solver);
    const auto* sequential = std::get_if<SequentialImpulses>(&setting.solver);
    double weight = 1.0;
    if (soft != nullptr) weight = std::max(1.0, soft->substeps / 4.0);
    if (sequential != nullptr) weight = 0.5 + sequential->iterations.value_or(Iterations{}).velocity / 16.0;
    return seconds * GetRate(setting) * weight;
}

double SceneMeter::CountReferenceWork(std::span<const RunSpec> settings, Effort effort, double seconds) {
    double work = 0.0;
    for (const RunSpec& first : FirstOfFamilies(settings)) {
        for (const bool coarser : {false, true}) work += CountWork(MakeReference(first, effort, coarser), seconds);
    }
    return work;
}

SceneMeter::Trajectory SceneMeter::Follow(const RunSpec& setting, bool isJudged, const Advance& advance) {
    const double dt = GetTimeStep(setting), rounding = 1e-6 * sampleInterval;
    const auto run = MakeRun(Retimed(m_scene, dt), setting);
    const Vec2 gravity = *Resolve(setting, m_scene).gravity;
    const int samples = CountSamples(m_seconds);
    const double work = CountWork(setting, m_seconds) / samples;
    Trajectory trajectory;
    States before, after;
    StateErrors errors;
    int steps = 0;
    for (int sample = 1; sample <= samples; ++sample) {
        const double time = sample * sampleInterval;
        while (steps * dt < time - rounding) {
            const bool isLast = (steps + 1) * dt >= time - rounding;
            if (isLast && (steps + 1) * dt > time + rounding) before = CaptureStates(*run);
            run->Step();
            ++steps;
            if (!isLast) continue;
            after = CaptureStates(*run);
            trajectory.isLost = !std::ranges::all_of(after, IsFinite);
            if (trajectory.isLost) break;
            if (isJudged) errors = m_judge.Measure(after, !IsSequential(setting));
        }
        if (trajectory.isLost) break;
        const double share = (time - (steps - 1) * dt) / dt;
        States states = share < 1.0 - 1e-6 && !before.empty() ? Between(before, after, share) : after;
        trajectory.energies.push_back(m_judge.GetEnergy(states, gravity));
        std::erase_if(states, [](const BodyState& b) { return b.type != scenes::BodyType::dynamic; });
        trajectory.samples.push_back(std::move(states));
        trajectory.overlap += errors.overlap / samples;
        trajectory.jointGap += errors.jointGap / samples;
        if (advance) advance(work);
    }
    if (trajectory.isLost) trajectory.overlap = trajectory.jointGap = lost;
    return trajectory;
}

double SceneMeter::FindDistance(const Trajectory& one, const Trajectory& other, double until) const {
    const auto samples = static_cast<std::size_t>(CountSamples(until));
    if (one.samples.size() < samples || other.samples.size() < samples) return lost;
    double distance = 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
        distance = std::max(distance, m_judge.GetDistance(one.samples[i], other.samples[i]));
    }
    return distance;
}

namespace {

double FindEnergyError(std::span<const double> one, std::span<const double> other, double until) {
    const auto samples = static_cast<std::size_t>(CountSamples(until));
    if (one.size() < samples || other.size() < samples) return lost;
    double error = 0.0;
    for (std::size_t i = 0; i < samples; ++i) error = std::max(error, std::abs(one[i] - other[i]));
    return error;
}

}  // namespace

SceneMeter::SceneMeter(const scenes::Scene& scene, std::span<const RunSpec> settings, Effort effort, double seconds,
                       const std::string& leftOut, const Advance& advance)
    : m_scene(scene), m_seconds(seconds), m_judge(scene) {
    SceneFacts facts{.scene = scene.name,
                     .dynamicBodies = scenes::Count(scene).dynamicBodies,
                     .seconds = seconds,
                     .window = seconds,
                     .bodySize = m_judge.GetBodySize(),
                     .distanceFloor = leastDistanceFloor,
                     .energyFloor = leastEnergyFloor,
                     .hasJoints = m_judge.HasJoints(),
                     .leftOut = leftOut};
    std::vector<Trajectory> coarse;
    for (const RunSpec& first : FirstOfFamilies(settings)) {
        const RunSpec fine = MakeReference(first, effort, false), half = MakeReference(first, effort, true);
        SceneReference reference{.family = FamilyOf(first), .setting = PrintSpec(fine), .coarser = PrintSpec(half)};
        m_references.emplace_back(reference.family, std::make_unique<Trajectory>(Follow(fine, false, advance)));
        coarse.push_back(Follow(half, false, advance));
        const Trajectory& a = *m_references.back().second;
        const Trajectory& b = coarse.back();
        for (int sample = 1; sample <= CountSamples(seconds) && !reference.parted; ++sample) {
            const auto i = static_cast<std::size_t>(sample - 1);
            const bool isThere = i < a.samples.size() && i < b.samples.size();
            if (isThere && m_judge.GetDistance(a.samples[i], b.samples[i]) <= partedShare * facts.bodySize) continue;
            reference.parted = sample * sampleInterval;
            facts.window = std::min(facts.window, (sample - 1) * sampleInterval);
        }
        facts.references.push_back(std::move(reference));
    }
    if (facts.window < leastWindow) facts.window = 0.0;
    const bool hasOurs = m_references.back().first == Family::sequential || m_references.back().first == Family::soft;
    for (std::size_t i = 0; i < m_references.size(); ++i) {
        const Trajectory& fine = *m_references[i].second;
        SceneReference& reference = facts.references[i];
        reference.apart = FindDistance(fine, coarse[i], facts.window);
        if (hasOurs) reference.fromOurs = FindDistance(fine, *m_references.back().second, facts.window);
        facts.distanceFloor = std::max(facts.distanceFloor, reference.apart);
        facts.energyFloor =
            std::max(facts.energyFloor, FindEnergyError(fine.energies, coarse[i].energies, facts.window));
    }
    m_law = MakeSceneLaw(facts);
}

std::vector<double> SceneMeter::MeasureErrors(const RunSpec& setting, const Advance& advance) {
    const Trajectory one = Follow(setting, true, advance);
    const double window = m_law->facts.window;
    std::vector<double> errors;
    if (window > 0.0) {
        const auto reference =
            std::ranges::find(m_references, FamilyOf(setting), [](const auto& r) { return r.first; });
        errors.push_back(FindDistance(one, *reference->second, window));
        errors.push_back(FindEnergyError(one.energies, reference->second->energies, window));
    }
    errors.push_back(one.overlap);
    if (m_judge.HasJoints()) errors.push_back(one.jointGap);
    // What was lost after the window is lost all the same.
    if (one.isLost) std::ranges::fill(errors, lost);
    return errors;
}

double SceneMeter::TimeRun(const RunSpec& setting, const Advance& advance) const {
    const auto run = MakeRun(Retimed(m_scene, GetTimeStep(setting)), setting);
    const int steps = std::max(1, static_cast<int>(std::lround(m_seconds / GetTimeStep(setting))));
    const double work = CountWork(setting, m_seconds) / steps;
    double milliseconds = 0.0;
    for (int i = 0; i < steps; ++i) {
        run->Step();
        milliseconds += run->GetTimes().cpu;
        if (advance) advance(work);
    }
    return milliseconds;
}

}  // namespace testbed
