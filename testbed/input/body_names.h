// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What people call the bodies of a scene: below "user" of its file, {"bodies": {"37": {"name": "player"}}}.

#pragma once

#include <string>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// By index of a body; empty for one without a name.
[[nodiscard]] std::vector<std::string> NamesIn(const scenes::Scene& scene);

}  // namespace testbed
