// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree env`: what this machine and this build offer, for bug reports.

#include <fmt/core.h>
#include <zlib.h>

#include <CLI/Version.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/cli/commands.h"
#include "testbed/engines/box2d_version.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/provenance.h"
#include "testbed/page/gnuplot.h"

namespace testbed {

namespace {

void PrintLine(const std::string& name, const std::string& value) { fmt::print("{:<16}{}\n", name, value); }

std::string CpuFeatures() {
    std::string features;
#if defined(__x86_64__)
    const auto add = [&](bool present, const char* name) {
        if (present) features += (features.empty() ? "" : " ") + std::string(name);
    };
    add(__builtin_cpu_supports("sse2"), "sse2");
    add(__builtin_cpu_supports("sse4.2"), "sse4.2");
    add(__builtin_cpu_supports("avx"), "avx");
    add(__builtin_cpu_supports("avx2"), "avx2");
    add(__builtin_cpu_supports("fma"), "fma");
    add(__builtin_cpu_supports("bmi2"), "bmi2");
    add(__builtin_cpu_supports("avx512f"), "avx512f");
#endif
    return features.empty() ? "none of those looked for" : features;
}

std::string BuildKind() {
    std::string kind;
#ifdef NDEBUG
    kind = "without assertions";
#else
    kind = "with assertions";
#endif
#if defined(__SANITIZE_ADDRESS__)
    kind += ", address sanitizer";
#endif
#if defined(__SANITIZE_THREAD__)
    kind += ", thread sanitizer";
#endif
    return kind;
}

std::string Gnuplot() {
    try {
        CheckGnuplot();
        return "found";
    } catch (const ToolError& error) {
        return error.what();
    }
}

/// Where this program lies, and what was installed along with it.
void PrintInstallation() {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    PrintLine("program", error ? std::string("unknown: there is no /proc") : program.string());
    const fs::path prefix = program.parent_path().parent_path();
    const fs::path headers = prefix / SCREE_INCLUDE_FOLDER / "scree_capture.h";
    const bool isInstalled = !error && fs::exists(headers);
    PrintLine("installed", isInstalled ? prefix.string() : "no: run where it was built");
    if (!isInstalled) return;
    PrintLine("capture", headers.string() + ", scree_capture_box2d.h beside it");
    const fs::path manual = prefix / SCREE_MANUAL_FOLDER / "scree.1";
    PrintLine("manual", fs::exists(manual) ? manual.string() : "missing: " + manual.string());
    PrintLine("shaders", "in the program");
}

int RunEnv(const Request& request) {
    PrintInstallation();
    for (const BackendReport& report : ProbeBackends(request.contextOptions)) {
        PrintLine(fmt::format("backend {}", GetBackendName(report.backend)),
                  report.works ? fmt::format("{} {}", report.renderer, report.version)
                               : fmt::format("missing: {}", report.problem));
    }
    for (const EngineInfo& engine : GetEngines()) {
        PrintLine(fmt::format("engine {}", engine.name), DescribeAbilities(engine.abilities));
    }
    const Provenance provenance = FindProvenance();
    const auto box2d3 = std::ranges::find(provenance.versions, "box2d3", &std::pair<std::string, std::string>::first);
    PrintLine("box2d3", box2d3 != provenance.versions.end()
                            ? box2d3->second
                            : "not found when this was built: box2d3_ROOT names where Box2D 3.2 or newer is installed");
    PrintLine("version", fmt::format("{}, commit {}", provenance.versions.front().second, provenance.commit));
    PrintLine("cpu", provenance.processor);
    PrintLine("cpu features", CpuFeatures());
    PrintLine("threads", fmt::format("{}", std::thread::hardware_concurrency()));
    PrintLine("compiler", provenance.compiler + " " + provenance.flags);
    PrintLine("build", BuildKind());
    PrintLine("box2d", GetBox2dVersion() + " (what the library says of itself; Debian's 2.4.1 still says 2.4.0)");
    PrintLine("fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100));
    PrintLine("CLI11", CLI11_VERSION);
    PrintLine("nlohmann json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                           NLOHMANN_JSON_VERSION_PATCH));
    PrintLine("zlib", zlibVersion());
    PrintLine("stb", "headers, no version number");
    PrintLine("gnuplot", Gnuplot());
    return exitDone;
}

}  // namespace

void AddEnvCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("env", "Backends, CPU features, library versions");
    command->callback([&request] { request.action = [&request] { return RunEnv(request); }; });
}

}  // namespace testbed
