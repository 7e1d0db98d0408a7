// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The camera: from metres, y up, to pixels, y down, in double arithmetic (compiled without contraction, so that every
// machine gets the same pixels).

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "testbed/engines/snapshot.h"
#include "testbed/picture/counts.h"

namespace testbed {

/// What the user asked for by `--camera X,Y,M`.
struct CameraRequest {
    double x = 0, y = 0;  ///< centre of the picture, m
    double across = 0;    ///< width of the picture, m, > 0
};

/// "fit" gives nothing; "X,Y,M" a request. Throws std::invalid_argument for anything else, M ≤ 0 or not finite.
[[nodiscard]] std::optional<CameraRequest> ParseCamera(std::string_view text);

struct Camera {
    double x = 0, y = 0;  ///< world point at the picture's centre, m
    double pixelsPerMetre = 1;
    int width = 1, height = 1;        ///< picture, pixels
    double offsetX = 0, offsetY = 0;  ///< where the world point lies from the picture's centre, pixels, y down

    /// Pixel coordinates (continuous: pixel i spans i…i+1) of a world point.
    [[nodiscard]] double ToPixelX(double worldX) const {
        return (worldX - x) * pixelsPerMetre + (width * 0.5 + offsetX);
    }
    [[nodiscard]] double ToPixelY(double worldY) const {
        return (y - worldY) * pixelsPerMetre + (height * 0.5 + offsetY);
    }
};

/// Space kept free at the picture's edges by FitCamera, pixels.
struct Margins {
    int left = 0, top = 0, right = 0, bottom = 0;
};

[[nodiscard]] Camera MakeCamera(const CameraRequest& request, int width, int height);

/// What pictures are fitted to.
struct FitArea {
    std::optional<Box> moving;  ///< around all fixtures whose bodies can move, of all steps that were added
    std::vector<Box> still;     ///< fixtures of static bodies, of the last step
};
/// The snapshots of one step.
void AddStep(FitArea& area, std::span<const Snapshot* const> snapshots);
/// Around what moves, and of what is static the parts near it, so that a long ground does not make all else small. All
/// that is static where nothing can move.
[[nodiscard]] std::vector<Box> GetFitBoxes(const FitArea& area);

/// Shows all boxes, centred between the margins, as large as possible. No or non-finite boxes: 10 m across the origin.
[[nodiscard]] Camera FitCamera(std::span<const Box> boxes, int width, int height, const Margins& margins);

/// The same view in a picture of another size of the same shape.
[[nodiscard]] Camera ScaleCamera(const Camera& camera, int width, int height);

/// The box, grown by `inflate` metres on each side, in continuous pixel coordinates. Not clipped; NaN stays NaN.
[[nodiscard]] PixelRect ProjectBox(const Box& box, double inflate, const Camera& camera);

}  // namespace testbed
