// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The scenes in their panes: mouse and keyboard in, actions on the viewer out; and drawing them with what the pointer
// found. All between Gui::BeginFrame and EndFrame.

#pragma once

#include <span>
#include <vector>

#include "testbed/jobs/window/viewer.h"
#include "testbed/picture/draw_list.h"

namespace testbed {

/// Keys and mouse, as far as no panel takes them.
void HandleInput(Viewer& viewer);

/// The node under the pointer and the trace of the query, on the trees as they are now.
void UpdateFindings(Viewer& viewer);

/// The layers of each pane.
[[nodiscard]] std::vector<DrawList> BuildPaneLists(const Viewer& viewer);
/// The selected nodes of a pane in its pixels, empty when overlap is off.
[[nodiscard]] std::vector<PixelRect> ProjectNodes(const Viewer& viewer, const EnginePane& pane);
/// The colours of counts.
[[nodiscard]] std::vector<Color> MakeLookPalette(const ViewerLook& look);

/// Titles, labels, highlighted nodes and the pulled point, behind the panels.
void DrawOverlay(const Viewer& viewer, std::span<const DrawList> lists);

}  // namespace testbed
