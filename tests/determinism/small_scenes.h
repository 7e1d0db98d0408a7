// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every scene of the catalogue at a size that runs in moments.

#pragma once

#include <algorithm>
#include <map>
#include <string_view>

#include "scenes/catalog.h"

namespace determinism {

/// Small enough that all scenes run in seconds.
inline int SmallSize(const scenes::SceneInfo& info) {
    static const std::map<std::string_view, int> sizes = {{"tiles", 15},
                                                          {"falling-squares", 8},
                                                          {"falling-circles", 8},
                                                          {"multi-fixture", 4},
                                                          {"add-pair", 150},
                                                          {"mild-n2", 4},
                                                          {"n2", 25},
                                                          {"mostly-static-single", 8},
                                                          {"diagonal", 3},
                                                          {"mixed", 200},
                                                          {"mostly-static-multi", 8},
                                                          {"slow-explosion", 300},
                                                          {"big-mobile", 5},
                                                          {"pyramid", 8},
                                                          {"tumbler", 50}};
    const auto found = sizes.find(info.name);
    if (!info.hasSize || found == sizes.end())
        return info.hasSize ? std::max(info.minSize, std::min(info.defaultSize, 6)) : 0;
    return found->second;
}

inline scenes::Scene BuildSmall(const scenes::SceneInfo& info) {
    return info.hasSize ? scenes::Build(info.name, SmallSize(info)) : scenes::Build(info.name);
}

}  // namespace determinism
