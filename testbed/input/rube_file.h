// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Worlds that the Box2D editor R.U.B.E. exported as JSON, read as scenes. The format is described at
// www.iforce2d.net/rube/json-structure. It is that of Box2D 2.3: springs are given by frequency and damping ratio, and
// chains collide on both sides.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// What a file gives as a scene.
struct RubeWorld {
    /// Names of bodies, fixtures and joints stand in `user`, by index.
    scenes::Scene scene;
    /// What no scene can say and was left out or put otherwise, one line a kind, with the first place where it is.
    std::vector<std::string> notices;
};

/// Reads a text; `source` names it in messages, and the scene by its file name. Missing values are zero, false or
/// empty, as the format has it. Throws FileError with place (`body[12].fixture[0].circle.radius`) and cure.
[[nodiscard]] RubeWorld ReadRube(std::string_view text, std::string_view source);

}  // namespace testbed
