// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of trade.h.

#include "testbed/jobs/tradeoff/trade.h"
#include "testbed/base/errors.h"
#include "testbed/engines/engine_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

namespace testbed {

namespace {

/// What every setting of the grid begins with.
constexpr std::string_view laboratory = "solver=si@8/3 timeStep=1/60 caps=on sleeping=off";

/// Processor time of this thread, ms: other programs on the machine do not count.
double ReadThreadClock() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// A timed run: a fresh world, two steps to make its contacts, then the steps that count.
double TimeRun(const scenes::Scene& scene, const Law& law, const RunSpec& setting) {
    RunSpec spec = setting;
    spec.caps = spec.caps && law.capped;
    const auto lab = MakeLab(scene, spec, {.restitutionThreshold = 0.0});
    lab->Step();
    lab->Step();
    const int steps = std::max(1, static_cast<int>(std::lround(law.costSeconds * GetRate(setting))));
    const double start = ReadThreadClock();
    for (int i = 0; i < steps; ++i) lab->Step();
    return ReadThreadClock() - start;
}

/// In turns, so that a slow minute of the machine meets all settings alike.
template <typename Time>
void TimeInTurns(std::vector<TradeCase>& cases, int repeats, Time&& time) {
    std::vector<std::vector<double>> times(cases.size());
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (std::size_t i = 0; i < cases.size(); ++i) times[i].push_back(time(cases[i].setting));
    }
    for (std::size_t i = 0; i < cases.size(); ++i) cases[i].milliseconds = FindQuartiles(times[i]);
}

}  // namespace

RunSpec GetSequential(std::string_view engine, int velocityIterations, int positionIterations, int rate) {
    RunSpec spec = MakeSpec(engine);
    ApplySettings(spec, laboratory);
    spec.solver = SequentialImpulses{Iterations{velocityIterations, positionIterations}};
    spec.timeStep = 1.0 / rate;
    return spec;
}

RunSpec GetSoft(int substeps, int rate, std::string_view engine) {
    RunSpec spec = GetSequential(engine, 8, 3, rate);
    spec.solver = SoftStep{substeps};
    return spec;
}

RunSpec GetDial(Accuracy mark, int rate) {
    switch (mark) {
        case Accuracy::draft:
            return GetSequential("scree", 4, 2, rate);
        case Accuracy::game:
            return GetSoft(4, rate);
        case Accuracy::fine:
            return GetSoft(8, rate);
        case Accuracy::precise:
            return GetSoft(16, rate);
    }
    return GetSoft(4, rate);
}

RunSpec GetBaseline() { return GetSequential("box2d"); }

std::vector<RunSpec> MakeGrid(Effort effort) {
    const bool quick = effort == Effort::quick;
    const std::vector<Iterations> iterations =
        quick ? std::vector<Iterations>{{4, 2}, {8, 3}, {32, 12}}
              : std::vector<Iterations>{{1, 1}, {2, 1}, {4, 2}, {8, 3}, {16, 6}, {32, 12}, {64, 24}};
    const std::vector<int> substeps = quick ? std::vector<int>{4, 8, 16} : std::vector<int>{4, 8, 16, 32};
    const std::vector<int> rates = quick ? std::vector<int>{60, 120} : std::vector<int>{30, 60, 120, 240};
    std::vector<RunSpec> grid{GetBaseline()};
    const auto add = [&grid](const RunSpec& setting) {
        if (setting != GetBaseline()) grid.push_back(setting);
    };
    for (const char* engine : {"box2d", "scree"}) {
        for (const int rate : rates) {
            for (const Iterations& i : iterations) add(GetSequential(engine, i.velocity, i.position, rate));
        }
    }
    for (const int rate : rates) {
        for (const int n : substeps) add(GetSoft(n, rate));
    }
    if (!IsBuilt("box2d3")) return grid;
    for (const int rate : rates) {
        for (const int n : quick ? std::vector<int>{4, 8} : std::vector<int>{1, 2, 4, 8, 16}) {
            add(GetSoft(n, rate, "box2d3"));
        }
    }
    return grid;
}

std::vector<RunSpec> ChooseGrid(Effort effort, std::string_view engines, std::span<const TypedSetting> common) {
    std::vector<RunSpec> chosen{GetBaseline()};
    const auto add = [&chosen](const RunSpec& spec) {
        if (std::ranges::find(chosen, spec) == chosen.end()) chosen.push_back(spec);
    };
    if (!engines.empty()) {
        for (const Pane& pane : ParsePanes(engines, common, laboratory)) add(pane.spec);
        return chosen;
    }
    for (RunSpec& spec : MakeGrid(effort)) {
        if (spec == GetBaseline()) continue;
        for (const TypedSetting& one : common) (void)ApplySetting(spec, one.setting, one.source);
        add(spec);
    }
    return chosen;
}

bool IsDefault(const RunSpec& setting) {
    return setting == GetBaseline() || setting == GetSoft(4, 60, "box2d3") || setting == GetSequential("scree") ||
           setting == GetDial(Accuracy::draft) || setting == GetDial(Accuracy::game) ||
           setting == GetDial(Accuracy::fine) || setting == GetDial(Accuracy::precise);
}

Quartiles TradeCase::GetCost() const {
    const double scale = 1e6 / bodyFrames;
    return {milliseconds.low * scale, milliseconds.median * scale, milliseconds.high * scale};
}

std::vector<TradeCase> MeasureTrade(const Law& law, std::span<const RunSpec> settings, const TradePlan& plan,
                                    const std::function<void()>& advance) {
    const scenes::Scene scene = MakeCostScene(law, plan.bodies);
    const int bodies = scenes::Count(scene).dynamicBodies;
    std::vector<TradeCase> cases;
    for (const RunSpec& setting : settings) {
        TradeCase one;
        one.law = law.name;
        one.setting = setting;
        one.errors = law.measure(setting, plan.effort);
        for (double& error : one.errors) {
            if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
        }
        const int steps = std::max(1, static_cast<int>(std::lround(law.costSeconds * GetRate(setting))));
        one.bodyFrames = bodies * 60.0 * steps * GetTimeStep(setting);
        cases.push_back(one);
        advance();
    }
    TimeInTurns(cases, plan.repeats, [&](const RunSpec& setting) {
        advance();
        return TimeRun(scene, law, setting);
    });
    return cases;
}

std::vector<const Law*> LawsOf(std::span<const TradeCase> cases) {
    std::vector<const Law*> laws;
    for (const Law& law : GetLaws()) {
        if (std::ranges::find(cases, law.name, &TradeCase::law) != cases.end()) laws.push_back(&law);
    }
    for (const TradeCase& one : cases) {
        if (one.scene == nullptr) continue;
        const auto isIt = [&](const Law* law) { return law->name == one.law; };
        if (std::ranges::none_of(laws, isIt)) laws.push_back(&one.scene->law);
    }
    return laws;
}

const Law& LawOf(const TradeCase& one) {
    return one.scene != nullptr ? one.scene->law : *std::ranges::find(GetLaws(), one.law, &Law::name);
}

std::vector<TradeCase> MeasureScene(const scenes::Scene& scene, std::span<const RunSpec> settings,
                                    const std::vector<bool>& isWanted, const TradePlan& plan, double seconds,
                                    const std::string& leftOut, const std::function<void(double)>& advance) {
    SceneMeter meter(scene, settings, plan.effort, seconds, leftOut, advance);
    const int bodies = scenes::Count(scene).dynamicBodies;
    std::vector<TradeCase> cases;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (!isWanted[i]) continue;
        cases.push_back({.law = meter.GetLaw()->law.name,
                         .setting = settings[i],
                         .errors = meter.MeasureErrors(settings[i], advance),
                         .milliseconds = {},
                         .bodyFrames = bodies * 60.0 * seconds,
                         .scene = meter.GetLaw()});
    }
    TimeInTurns(cases, plan.repeats, [&](const RunSpec& setting) { return meter.TimeRun(setting, advance); });
    return cases;
}

double CountSceneWork(std::span<const RunSpec> settings, const std::vector<bool>& isWanted, const TradePlan& plan,
                      double seconds) {
    double work = SceneMeter::CountReferenceWork(settings, plan.effort, seconds);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (isWanted[i]) work += SceneMeter::CountWork(settings[i], seconds) * (1 + plan.repeats);
    }
    return work;
}

double FlooredError(const Law& law, const TradeCase& one, std::size_t index) {
    const double error = one.errors.at(index);
    return std::isfinite(error) ? std::max(error, law.errors.at(index).rounding)
                                : std::numeric_limits<double>::infinity();
}

bool HasFailed(const Law& law, const TradeCase& one) {
    for (std::size_t i = 0; i < law.errors.size(); ++i) {
        const double error = one.errors.at(i);
        if (!std::isfinite(error) || error >= law.errors[i].failed) return true;
    }
    return false;
}

nlohmann::ordered_json ToJson(const TradeCase& one) {
    nlohmann::ordered_json errors = nlohmann::ordered_json::array();
    for (const double error : one.errors) {
        if (std::isfinite(error))
            errors.push_back(error);
        else
            errors.push_back(nullptr);  // JSON has no infinity
    }
    const RunSpec& s = one.setting;
    const auto* si = std::get_if<SequentialImpulses>(&s.solver);
    const auto* soft = std::get_if<SoftStep>(&s.solver);
    const Iterations iterations = si != nullptr ? si->iterations.value_or(Iterations{}) : Iterations{};
    nlohmann::ordered_json fields;
    fields["law"] = one.law;
    fields["engine"] = s.engine;
    fields["solver"] = IsSequential(s) ? "sequential" : "soft";
    fields["velocityIterations"] = iterations.velocity;
    fields["positionIterations"] = iterations.position;
    fields["substeps"] = soft != nullptr ? soft->substeps : SoftStep{}.substeps;
    fields["rate"] = GetRate(s);
    fields["settings"] = PrintSettings(s);
    fields["errors"] = errors;
    fields["bodyFrames"] = one.bodyFrames;
    fields["ms"] = {one.milliseconds.low, one.milliseconds.median, one.milliseconds.high};
    if (one.scene != nullptr) fields["scene"] = ToJson(one.scene->facts);
    return fields;
}

TradeCase TradeCaseFromJson(const nlohmann::ordered_json& fields) {
    try {
        TradeCase one;
        one.law = fields.at("law").get<std::string>();
        const auto engine = fields.at("engine").get<std::string>();
        const int rate = fields.at("rate").get<int>();
        one.setting = fields.at("solver") == "soft" ? GetSoft(fields.at("substeps").get<int>(), rate, engine)
                                                    : GetSequential(engine, fields.at("velocityIterations").get<int>(),
                                                                    fields.at("positionIterations").get<int>(), rate);
        // Lines without settings have those of the grid.
        if (fields.contains("settings")) {
            one.setting = MakeSpec(engine);
            ApplySettings(one.setting, fields.at("settings").get<std::string>());
        }
        for (const auto& error : fields.at("errors")) {
            one.errors.push_back(error.is_null() ? std::numeric_limits<double>::infinity() : error.get<double>());
        }
        if (fields.contains("scene")) {
            one.scene = MakeSceneLaw(SceneFactsFromJson(fields.at("scene")));
            if (one.scene->law.name != one.law) {
                throw FileError(fmt::format("law '{}' is not that of scene '{}'", one.law, one.scene->facts.scene));
            }
        } else if (std::ranges::find(GetLaws(), one.law, &Law::name) == GetLaws().end()) {
            throw FileError(fmt::format("no law is called '{}'", one.law));
        }
        const Law& law = LawOf(one);
        if (one.errors.size() != law.errors.size()) {
            throw FileError(fmt::format("{} errors; law '{}' has {}", one.errors.size(), one.law, law.errors.size()));
        }
        one.bodyFrames = fields.at("bodyFrames").get<double>();
        const auto& ms = fields.at("ms");
        one.milliseconds = {ms.at(0).get<double>(), ms.at(1).get<double>(), ms.at(2).get<double>()};
        if (!(one.bodyFrames > 0.0 && one.milliseconds.median > 0.0)) {
            throw FileError("a cost is above 0: \"bodyFrames\" and the middle one of \"ms\"");
        }
        return one;
    } catch (const UsageError& error) {  // an engine or setting that is none
        throw FileError(std::string("not a line of `scree tradeoff --json`: ") + error.what());
    } catch (const nlohmann::json::exception& error) {
        throw FileError(std::string("a field is missing or of another kind: ") + error.what());
    }
}

void AddCase(std::vector<TradeCase>& cases, TradeCase one) {
    for (const TradeCase& other : cases) {
        if (other.law != one.law) continue;
        if (other.setting == one.setting) {
            throw FileError(fmt::format("law '{}' with this setting is there twice", one.law));
        }
        if (one.scene == nullptr || other.scene == one.scene) continue;
        if (other.scene == nullptr || ToJson(other.scene->facts) != ToJson(one.scene->facts)) {
            throw FileError(
                fmt::format("\"scene\" says other things than an earlier line about '{}': they are of two "
                            "different scenes or runs",
                            one.scene->facts.scene));
        }
        one.scene = other.scene;
    }
    cases.push_back(std::move(one));
}

}  // namespace testbed
