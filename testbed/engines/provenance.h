// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where measurements come from: the machine, the build and the day. Results carry it, so that tables of different
// machines and builds can be told apart.

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace testbed {

struct Provenance {
    std::string processor;  ///< its model
    int cores = 0;          ///< that this process may use at once
    double load = 0.0;      ///< of the machine, mean over the last minute: processes that ran or waited
    std::string compiler;   ///< "GCC 12.2.0"
    std::string flags;      ///< of this build
    std::string commit;     ///< of the source; "-dirty" behind one that was changed; "unknown" outside of a repository
    std::string date;       ///< "2026-05-31", UTC
    std::vector<std::pair<std::string, std::string>> versions;  ///< by engine
};
/// Of this process, now.
[[nodiscard]] Provenance FindProvenance();

/// As an object with the members' names.
[[nodiscard]] nlohmann::ordered_json ToJson(const Provenance& provenance);

}  // namespace testbed
