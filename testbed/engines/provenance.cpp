// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of provenance.h, for Linux.

#include "testbed/engines/provenance.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sched.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "testbed/engines/box2d_version.h"
#include "testbed_generated/commit.h"
#ifdef SCREE_HAS_BOX2D3
#include "testbed/engines/box2d3/box2d3_engine.h"
#endif

namespace testbed {

namespace {

std::string FindProcessor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

int CountCores() {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 0;
}

std::string NameCompiler() {
#ifdef __clang__
    return __VERSION__;
#else
    return "GCC " __VERSION__;
#endif
}

}  // namespace

Provenance FindProvenance() {
    Provenance p{.processor = FindProcessor(),
                 .cores = CountCores(),
                 .compiler = NameCompiler(),
                 .flags = SCREE_FLAGS,
                 .commit = SCREE_COMMIT,
                 .date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))),
                 .versions = {{"scree", SCREE_VERSION}, {"box2d", GetBox2dVersion()}}};
    if (double loads[1]; getloadavg(loads, 1) == 1) p.load = loads[0];
#ifdef SCREE_HAS_BOX2D3
    p.versions.emplace_back("box2d3", GetBox2d3Version());
#endif
    return p;
}

nlohmann::ordered_json ToJson(const Provenance& provenance) {
    nlohmann::ordered_json object = {{"processor", provenance.processor},
                                     {"cores", provenance.cores},
                                     {"load", provenance.load},
                                     {"compiler", provenance.compiler},
                                     {"flags", provenance.flags},
                                     {"commit", provenance.commit},
                                     {"date", provenance.date}};
    for (const auto& [engine, version] : provenance.versions) object["versions"][engine] = version;
    return object;
}

}  // namespace testbed
