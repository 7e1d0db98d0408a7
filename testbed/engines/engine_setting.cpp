// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Names of settings and the table of the dial.

#include "testbed/engines/engine_setting.h"

#include <fmt/format.h>

namespace testbed {

EngineSetting GetSequential(const std::string& engine, int velocityIterations, int positionIterations, int rate) {
    EngineSetting setting;
    setting.engine = engine;
    setting.velocityIterations = velocityIterations;
    setting.positionIterations = positionIterations;
    setting.rate = rate;
    return setting;
}

EngineSetting GetSoft(int substeps, int rate) {
    EngineSetting setting;
    setting.solver = SolverKind::soft;
    setting.substeps = substeps;
    setting.rate = rate;
    return setting;
}

EngineSetting GetDial(Dial dial, int rate) {
    switch (dial) {
        case Dial::draft:
            return GetSequential("scree", 4, 2, rate);
        case Dial::game:
            return GetSoft(4, rate);
        case Dial::fine:
            return GetSoft(8, rate);
        case Dial::precise:
            return GetSoft(16, rate);
    }
    return GetSoft(4, rate);
}

bool IsAvailable(const EngineSetting& setting) {
    return setting.engine == "scree" || setting.solver == SolverKind::sequential;
}

std::string NameSolver(const EngineSetting& setting) {
    if (setting.solver == SolverKind::soft) return fmt::format("soft {}", setting.substeps);
    return fmt::format("{}/{}", setting.velocityIterations, setting.positionIterations);
}

std::string NameSetting(const EngineSetting& setting) {
    return fmt::format("{} {} at {} Hz", setting.engine, NameSolver(setting), setting.rate);
}

}  // namespace testbed
