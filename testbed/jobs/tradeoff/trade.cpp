// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of trade.h.

#include "testbed/jobs/tradeoff/trade.h"
#include "testbed/base/errors.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

namespace testbed {

namespace {

struct Iterations {
    int velocity, position;
};

/// Processor time of this thread, ms: other programs on the machine do not count.
double ReadThreadClock() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// A timed run: a fresh world, two steps to make its contacts, then the steps that count.
double TimeRun(const scenes::Scene& scene, const Law& law, const EngineSetting& setting) {
    const auto lab = MakeLab(scene, setting, {.capped = law.capped, .restitutionThreshold = 0.0});
    lab->Step();
    lab->Step();
    const int steps = std::max(1, static_cast<int>(std::lround(law.costSeconds * setting.rate)));
    const double start = ReadThreadClock();
    for (int i = 0; i < steps; ++i) lab->Step();
    return ReadThreadClock() - start;
}

}  // namespace

EngineSetting GetBaseline() { return GetSequential("box2d"); }

std::vector<EngineSetting> MakeGrid(Effort effort) {
    const bool quick = effort == Effort::quick;
    const std::vector<Iterations> iterations =
        quick ? std::vector<Iterations>{{4, 2}, {8, 3}, {32, 12}}
              : std::vector<Iterations>{{1, 1}, {2, 1}, {4, 2}, {8, 3}, {16, 6}, {32, 12}, {64, 24}};
    const std::vector<int> substeps = quick ? std::vector<int>{4, 8, 16} : std::vector<int>{4, 8, 16, 32};
    const std::vector<int> rates = quick ? std::vector<int>{60, 120} : std::vector<int>{30, 60, 120, 240};
    std::vector<EngineSetting> grid{GetBaseline()};
    const auto add = [&grid](const EngineSetting& setting) {
        if (IsAvailable(setting) && setting != GetBaseline()) grid.push_back(setting);
    };
    for (const char* engine : {"box2d", "scree"}) {
        for (const int rate : rates) {
            for (const Iterations& i : iterations) add(GetSequential(engine, i.velocity, i.position, rate));
        }
    }
    for (const int rate : rates) {
        for (const int n : substeps) add(GetSoft(n, rate));
    }
    return grid;
}

bool IsDefault(const EngineSetting& setting) {
    return setting == GetBaseline() || setting == GetSequential("scree") || setting == GetDial(Dial::draft) ||
           setting == GetDial(Dial::game) || setting == GetDial(Dial::fine) || setting == GetDial(Dial::precise);
}

Quartiles TradeCase::GetCost() const {
    const double scale = 1e6 / bodyFrames;
    return {milliseconds.low * scale, milliseconds.median * scale, milliseconds.high * scale};
}

std::vector<TradeCase> MeasureTrade(const Law& law, std::span<const EngineSetting> settings, const TradePlan& plan,
                                    const std::function<void()>& advance) {
    const scenes::Scene scene = MakeCostScene(law, plan.bodies);
    const int bodies = scenes::Count(scene).dynamicBodies;
    std::vector<TradeCase> cases;
    for (const EngineSetting& setting : settings) {
        TradeCase one;
        one.law = law.name;
        one.setting = setting;
        one.errors = law.measure(setting, plan.effort);
        for (double& error : one.errors) {
            if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
        }
        const int steps = std::max(1, static_cast<int>(std::lround(law.costSeconds * setting.rate)));
        one.bodyFrames = bodies * 60.0 * steps * setting.GetTimeStep();
        cases.push_back(one);
        advance();
    }
    // In turns, so that a slow minute of the machine meets all settings alike.
    std::vector<std::vector<double>> times(settings.size());
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
        for (std::size_t i = 0; i < settings.size(); ++i) {
            times[i].push_back(TimeRun(scene, law, settings[i]));
            advance();
        }
    }
    for (std::size_t i = 0; i < settings.size(); ++i) cases[i].milliseconds = FindQuartiles(times[i]);
    return cases;
}

double FlooredError(const Law& law, const TradeCase& one, std::size_t index) {
    const double error = one.errors.at(index);
    return std::isfinite(error) ? std::max(error, law.errors.at(index).rounding)
                                : std::numeric_limits<double>::infinity();
}

nlohmann::ordered_json ToJson(const TradeCase& one) {
    nlohmann::ordered_json errors = nlohmann::ordered_json::array();
    for (const double error : one.errors) {
        if (std::isfinite(error))
            errors.push_back(error);
        else
            errors.push_back(nullptr);  // JSON has no infinity
    }
    const EngineSetting& s = one.setting;
    nlohmann::ordered_json fields;
    fields["law"] = one.law;
    fields["engine"] = s.engine;
    fields["solver"] = s.solver == SolverKind::soft ? "soft" : "sequential";
    fields["velocityIterations"] = s.velocityIterations;
    fields["positionIterations"] = s.positionIterations;
    fields["substeps"] = s.substeps;
    fields["rate"] = s.rate;
    fields["errors"] = errors;
    fields["bodyFrames"] = one.bodyFrames;
    fields["ms"] = {one.milliseconds.low, one.milliseconds.median, one.milliseconds.high};
    return fields;
}

TradeCase TradeCaseFromJson(const nlohmann::ordered_json& fields) {
    try {
        TradeCase one;
        one.law = fields.at("law").get<std::string>();
        one.setting.engine = fields.at("engine").get<std::string>();
        one.setting.solver = fields.at("solver") == "soft" ? SolverKind::soft : SolverKind::sequential;
        one.setting.velocityIterations = fields.at("velocityIterations").get<int>();
        one.setting.positionIterations = fields.at("positionIterations").get<int>();
        one.setting.substeps = fields.at("substeps").get<int>();
        one.setting.rate = fields.at("rate").get<int>();
        for (const auto& error : fields.at("errors")) {
            one.errors.push_back(error.is_null() ? std::numeric_limits<double>::infinity() : error.get<double>());
        }
        one.bodyFrames = fields.at("bodyFrames").get<double>();
        const auto& ms = fields.at("ms");
        one.milliseconds = {ms.at(0).get<double>(), ms.at(1).get<double>(), ms.at(2).get<double>()};
        return one;
    } catch (const nlohmann::json::exception& error) {
        throw FileError(std::string("a field is missing or of another kind: ") + error.what());
    }
}

}  // namespace testbed
