// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What stands beside (JSON) and inside (PNG text entries) every picture: scene, step, engine, how it was drawn and what
// it counts. So a picture explains itself, and two pictures can be compared by their data.

#pragma once

#include <string>
#include <vector>

#include "testbed/jobs/overlap/metrics.h"
#include "testbed/picture/png.h"
#include "testbed/view/picture.h"

namespace testbed {

/// Everything that the pictures of one run share.
struct PictureOrigin {
    std::string command;  ///< the command line, without the output folder
    std::string poses;    ///< own, track or an engine's name
    std::string backend;
    std::string renderer;  ///< GL_RENDERER
    std::string version;   ///< GL_VERSION
};

/// One finished picture of one pane, or of both (compare, difference).
struct PictureRecord {
    std::string kind;                        ///< overlap, compare, difference or render
    std::vector<const Snapshot*> snapshots;  ///< one, or both panes' in order
    std::vector<MetricsRow> rows;            ///< of the snapshots; empty for `render`
    std::vector<OverlapStats> stats;         ///< of the snapshots; empty for `render`
    Camera camera;
    uint32_t scaleMax = 0;                        ///< 0: no colour scale
    const DifferenceStats* difference = nullptr;  ///< of a difference picture
};

[[nodiscard]] std::string WriteSidecar(const PictureOrigin& origin, const PictureOptions& options,
                                       const PictureRecord& record);

[[nodiscard]] std::vector<PngText> MakePngText(const PictureOrigin& origin, const PictureRecord& record);

}  // namespace testbed
