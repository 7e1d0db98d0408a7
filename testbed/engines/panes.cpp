// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Reading of panes.

#include "testbed/engines/panes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_list.h"

namespace testbed {

namespace {

constexpr std::size_t maxPanes = 16;

/// Cuts off and returns what stands before the separator.
std::string_view Take(std::string_view& rest, char separator) {
    const std::string_view part = rest.substr(0, rest.find(separator));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    return part;
}

bool IsNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
}

void CheckName(std::string_view name) {
    // A name becomes that of files.
    if (!name.empty() && name.front() != '.' && std::ranges::all_of(name, IsNameCharacter)) return;
    throw UsageError(
        fmt::format("--engines: the pane name '{}' is not one of letters, digits, and ._- after them", name));
}

/// "solver=soft@8:threads=2" as part of a name: "soft-8-threads-2".
std::string NameOf(std::string_view settings) {
    std::string name;
    while (!settings.empty()) {
        std::string_view setting = Take(settings, ':');
        if (setting.starts_with("solver=")) setting.remove_prefix(std::string_view("solver=").size());
        name += '-';
        for (const char c : setting) name += IsNameCharacter(c) ? c : '-';
    }
    return name;
}

/// The parts between commas that separate panes. A number after a comma belongs to the value before it.
std::vector<std::string_view> SplitPanes(std::string_view text) {
    std::vector<std::string_view> parts;
    for (const std::string_view part : Split(text, ',')) {
        const bool continues = ParseNumber<double>(part.substr(0, part.find(':'))) && !parts.empty() &&
                               parts.back().find(':') != std::string_view::npos;
        if (continues) {
            parts.back() = std::string_view(parts.back().data(), part.data() + part.size());
        } else {
            parts.push_back(part);
        }
    }
    return parts;
}

struct Written {
    std::string_view name, engine, settings;
};

Written ReadPane(std::string_view text) {
    Written pane;
    if (text.ends_with(':'))
        throw UsageError(fmt::format("--engines {}: KEY=VALUE is missing after the last colon", text));
    pane.settings = text;
    pane.engine = Take(pane.settings, ':');
    if (const std::size_t equals = pane.engine.find('='); equals != std::string_view::npos) {
        pane.name = pane.engine.substr(0, equals);
        pane.engine.remove_prefix(equals + 1);
        CheckName(pane.name);
    }
    return pane;
}

/// Sets `isHad` of the settings that the engine has.
RunSpec ApplyCommon(std::string_view engine, std::span<const TypedSetting> common, std::string_view base,
                    std::vector<bool>& isHad) {
    RunSpec spec = MakeSpec(engine);
    ApplySettings(spec, base);
    isHad.resize(common.size(), false);
    for (std::size_t i = 0; i < common.size(); ++i) {
        if (ApplySetting(spec, common[i].setting, common[i].source)) isHad[i] = true;
    }
    return spec;
}

void CheckHad(std::span<const TypedSetting> common, const std::vector<bool>& isHad) {
    for (std::size_t i = 0; i < common.size(); ++i) {
        if (!isHad[i] && !common[i].isOptional)
            throw UsageError(
                fmt::format("{}: none of the engines of this run has this setting; see `scree env` for engines and "
                            "--help for settings",
                            common[i].source));
    }
}

void ApplyOwn(RunSpec& spec, std::string_view settings) {
    while (!settings.empty()) {
        const std::string_view setting = Take(settings, ':');
        const std::string source = fmt::format("--engines {}:{}", spec.engine, setting);
        if (!ApplySetting(spec, setting, source)) {
            throw UsageError(fmt::format("{}: {} does not have it", source, spec.engine));
        }
    }
}

/// For a pane that was given none.
std::string FindName(const Written& pane, std::span<const Written> all, std::span<const Pane> before) {
    const auto count = std::ranges::count_if(
        all, [&](const Written& other) { return other.engine == pane.engine && other.name.empty(); });
    const std::string name = std::string(pane.engine) + (count == 1 ? std::string() : NameOf(pane.settings));
    std::string found = name;
    for (int i = 2; std::ranges::find(before, found, &Pane::name) != before.end(); ++i) {
        found = fmt::format("{}-{}", name, i);
    }
    return found;
}

}  // namespace

std::vector<Pane> ParsePanes(std::string_view text, std::span<const TypedSetting> common, std::string_view base) {
    std::vector<Written> written;
    for (const std::string_view part : SplitPanes(text)) written.push_back(ReadPane(part));
    if (written.size() > maxPanes) throw UsageError(fmt::format("--engines: at most {} panes", maxPanes));
    std::vector<Pane> panes;
    std::vector<bool> isHad(common.size(), false);
    for (const Written& one : written) {
        Pane pane{.name = std::string(one.name), .spec = ApplyCommon(one.engine, common, base, isHad)};
        ApplyOwn(pane.spec, one.settings);
        if (pane.name.empty()) pane.name = FindName(one, written, panes);
        if (std::ranges::find(panes, pane.name, &Pane::name) != panes.end()) {
            throw UsageError(fmt::format("--engines {}: two panes are called '{}'", text, pane.name));
        }
        panes.push_back(std::move(pane));
    }
    CheckHad(common, isHad);
    return panes;
}

RunSpec ParseSpec(std::string_view engine, std::span<const TypedSetting> common, std::string_view base) {
    std::vector<bool> isHad;
    const RunSpec spec = ApplyCommon(engine, common, base, isHad);
    CheckHad(common, isHad);
    return spec;
}

std::size_t FindBaseline(std::span<const Pane> panes, std::string_view name) {
    if (name.empty()) {
        for (const std::string_view rival : {std::string_view("box2d"), std::string_view("box2d3"), recordedEngine}) {
            const auto found = std::ranges::find(panes, rival, [](const Pane& pane) { return pane.spec.engine; });
            if (found != panes.end()) return static_cast<std::size_t>(found - panes.begin());
        }
        return 0;
    }
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        if (panes[i].name == name) return i;
        names.push_back(panes[i].name);
    }
    throw UsageError(fmt::format("--baseline: {}", DescribeUnknown("pane", name, names)));
}

}  // namespace testbed
