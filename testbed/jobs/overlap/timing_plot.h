// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Broad-phase time by step as a picture in the layout of the dissertation's figures 8 and 10 (Tsamis 2020,
// section 3.8): steps on x, ms on y, legend top right.

#pragma once

#include <span>
#include <string>

#include "testbed/engines/timing.h"
#include "testbed/page/plot.h"

namespace testbed {

[[nodiscard]] Plot MakeTimingPlot(std::span<const TimingSeries> series, const std::string& title);

}  // namespace testbed
