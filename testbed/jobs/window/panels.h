// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The window's panels: what the viewer holds in, what the user changed in it out. Their places follow from the
// picture's size alone, so that nothing overlaps.

#pragma once

#include "testbed/jobs/window/gui.h"
#include "testbed/jobs/window/viewer.h"

namespace testbed {

/// What the panels leave to the scenes.
[[nodiscard]] PixelBox GetSceneArea(const Viewer& viewer, int width, int height);

/// All panels, between Gui::BeginFrame and EndFrame. Errors of what the user chose become the viewer's message.
void DrawPanels(Viewer& viewer, Items& items, int width, int height);

/// The scenes by theme with a search over their names, and the size; for DrawPanels.
void DrawScenesPanel(Viewer& viewer, Items& items);
/// Steps on and back, the memory for it, break conditions and what is saved; for DrawPanels.
void DrawTimeBar(Viewer& viewer, Items& items);
/// All that is known of the picked body, with fields for what can be changed; for DrawPanels.
void DrawInspector(Viewer& viewer, Items& items);
/// Times of the last steps by stage, all engines in each plot; for DrawPanels.
void DrawTimesPanel(const Viewer& viewer);
/// What the pointer found: body, node, query; for DrawPanels.
void DrawFindings(const Viewer& viewer);

}  // namespace testbed
