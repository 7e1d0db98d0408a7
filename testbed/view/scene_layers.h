// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A snapshot's bodies, contacts, joints and boxes as a DrawList: which colour and size each has on the picture.

#pragma once

#include <optional>

#include "testbed/engines/snapshot.h"
#include "testbed/picture/draw_list.h"
#include "testbed/picture/theme.h"
#include "testbed/view/camera.h"
#include "testbed/view/layers.h"
#include "testbed/view/nodes.h"

namespace testbed {

/// The largest values of a snapshot, which lines of impulses and arrows of velocities are drawn in proportion to.
struct Peaks {
    double impulse = 0;  ///< N·s
    double speed = 0;    ///< m/s
    double turn = 0;     ///< rad/s
};
[[nodiscard]] Peaks FindPeaks(const Snapshot& snapshot);
/// The larger of each.
[[nodiscard]] Peaks JoinPeaks(const Peaks& a, const Peaks& b);

/// What to draw and in which colours.
struct SceneLook {
    Layers layers = Layers::Bodies();
    NodeSelection nodes;    ///< those that the layer bvh outlines
    int supersampling = 2;  ///< 1, 2 or 4
    Theme theme = Theme::dark;
    bool isOverCounts = false;     ///< bodies half as opaque, so that the counts under them are read
    std::optional<Peaks> peaks{};  ///< none: those of the snapshot
};

[[nodiscard]] DrawList BuildDrawList(const Snapshot& snapshot, const Camera& camera, const SceneLook& look);

}  // namespace testbed
