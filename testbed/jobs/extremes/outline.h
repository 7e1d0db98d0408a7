// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A picture of a moment: the outlines of the bodies as SVG. It needs no OpenGL, so that any process can draw it.

#pragma once

#include <span>
#include <string>

#include "testbed/engines/lab.h"

namespace testbed {

/// Fitted to most of the moving bodies (the outermost twentieth may lie outside); of many, every second, third …
/// Bodies that are not finite are left out.
[[nodiscard]] std::string DrawOutline(const scenes::Scene& scene, std::span<const BodyReading> bodies);

}  // namespace testbed
