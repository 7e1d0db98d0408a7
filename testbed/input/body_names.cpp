// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of body_names.h.

#include "testbed/input/body_names.h"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

#include "testbed/base/json_print.h"
#include "testbed/base/text.h"

namespace testbed {

std::vector<std::string> NamesIn(const scenes::Scene& scene) {
    std::vector<std::string> names(scene.bodies.size());
    const nlohmann::json user = nlohmann::json::parse(scene.user, nullptr, false);
    if (!user.is_object() || !user.contains("bodies") || !user["bodies"].is_object()) return names;
    for (const auto& [key, told] : user["bodies"].items()) {
        const Parsed<int> index = ParseNumber<int>(key);
        if (!index || *index < 0 || *index >= std::ssize(names) || !told.is_object()) continue;
        if (told.contains("name") && told["name"].is_string()) names[static_cast<std::size_t>(*index)] = told["name"];
    }
    return names;
}

std::string WriterOf(const scenes::Scene& scene) {
    const nlohmann::json user = nlohmann::json::parse(scene.user, nullptr, false);
    const bool isTold = user.is_object() && user.contains("writer") && user["writer"].is_string();
    return isTold ? user["writer"].get<std::string>() : std::string();
}

scenes::Scene WithWriter(scenes::Scene scene) {
    nlohmann::ordered_json user = nlohmann::ordered_json::parse(scene.user, nullptr, false);
    if (!user.is_object()) user = nlohmann::ordered_json::object();
    if (user.emplace("writer", "scree " SCREE_VERSION).second) scene.user = PrintJson(user);
    return scene;
}

}  // namespace testbed
