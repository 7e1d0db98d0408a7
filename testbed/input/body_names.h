// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a scene file tells people below "user": what its bodies are called, and what wrote it:
// {"writer": "level editor", "bodies": {"37": {"name": "player"}}}.

#pragma once

#include <string>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// By index of a body; empty for one without a name.
[[nodiscard]] std::vector<std::string> NamesIn(const scenes::Scene& scene);

/// The program that wrote it, or nothing.
[[nodiscard]] std::string WriterOf(const scenes::Scene& scene);
/// The scene for a file of this program, which says so unless the scene names its writer already.
[[nodiscard]] scenes::Scene WithWriter(scenes::Scene scene);

}  // namespace testbed
