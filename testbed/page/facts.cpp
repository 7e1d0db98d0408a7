// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT

#include "testbed/page/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testbed/base/json_print.h"

namespace testbed {

namespace {

/// A text, a number, or a list of versions.
std::string Describe(const nlohmann::ordered_json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_object()) return PrintJson(value);
    std::string list;
    for (const auto& [engine, version] : value.items()) {
        list += fmt::format("{}{} {}", list.empty() ? "" : ", ", engine, version.get<std::string>());
    }
    return list;
}

}  // namespace

void AddFacts(Page& page, std::span<const nlohmann::ordered_json> provenances) {
    for (const nlohmann::ordered_json& one : provenances) {
        for (const auto& [name, value] : one.items()) {
            const std::string text = Describe(value);
            const auto found = std::ranges::find(page.facts, name, &PageFact::name);
            if (found == page.facts.end()) {
                page.facts.push_back({name, text});
            } else if (found->value.find(text) == std::string::npos) {
                found->value += "; " + text;
            }
        }
    }
}

void AddFacts(Page& page, const std::string& command, const nlohmann::ordered_json& provenance) {
    page.facts.push_back({"command", command});
    AddFacts(page, {&provenance, 1});
}

}  // namespace testbed
