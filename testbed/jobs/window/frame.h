// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One frame of the window: events in, a picture in the renderer out. The same with and without a window.

#pragma once

#include <span>
#include <string>

#include "testbed/gl/window_renderer.h"
#include "testbed/jobs/window/gui.h"
#include "testbed/jobs/window/input_event.h"
#include "testbed/jobs/window/viewer.h"

namespace testbed {

struct FrameInput {
    std::span<const InputEvent> events;
    int width = 1280, height = 800;  ///< of the picture, pixels
    double deltaTime = 1.0 / 60;     ///< since the last frame, s
};

/// Takes the input, makes a step unless paused, and draws.
void DrawFrame(Viewer& viewer, Gui& gui, Items& items, WindowRenderer& renderer, const FrameInput& input);

/// What the window shows, as JSON: scene, step, settings, layers, findings, and the pose of the picked body in each
/// engine.
[[nodiscard]] std::string WriteState(const Viewer& viewer);

}  // namespace testbed
