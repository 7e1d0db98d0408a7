// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Camera arithmetic.

#include "testbed/view/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "testbed/base/text.h"

namespace testbed {

namespace {

constexpr double emptyAcross = 10.0;   // m shown when there is nothing to fit
constexpr float surroundings = 0.25f;  // shown of what is static on each side, of the larger side of what moves

bool IsFinite(const Box& box) {
    return std::isfinite(box.lower.x) && std::isfinite(box.lower.y) && std::isfinite(box.upper.x) &&
           std::isfinite(box.upper.y);
}

/// What two boxes share; none where they do not touch.
std::optional<Box> Intersect(const Box& a, const Box& b) {
    const Box common{{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y)},
                     {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y)}};
    if (common.lower.x > common.upper.x || common.lower.y > common.upper.y) return std::nullopt;
    return common;
}

}  // namespace

std::optional<CameraRequest> ParseCamera(std::string_view text) {
    if (text == "fit") return std::nullopt;
    std::vector<double> numbers;
    std::string problem;
    for (const std::string_view part : Split(text, ',')) {
        const Parsed<double> number = ParseNumber<double>(part);
        if (problem.empty()) problem = number.problem;
        numbers.push_back(*number);
    }
    if (!problem.empty() || numbers.size() != 3 || numbers[2] <= 0) {
        throw std::invalid_argument("bad camera '" + std::string(text) + "': " + BeforeCure(problem) +
                                    "use fit, or X,Y,M: the centre and the metres across, for example 0,50,120");
    }
    return CameraRequest{numbers[0], numbers[1], numbers[2]};
}

Camera MakeCamera(const CameraRequest& request, int width, int height) {
    return {request.x, request.y, width / request.across, width, height, 0, 0};
}

void AddStep(FitArea& area, std::span<const Snapshot* const> snapshots) {
    area.still.clear();
    for (const Snapshot* snapshot : snapshots) {
        for (const FixtureState& fixture : snapshot->fixtures) {
            if (!IsFinite(fixture.tight)) continue;
            if (snapshot->bodies[static_cast<size_t>(fixture.body)].type == scenes::BodyType::isStatic) {
                area.still.push_back(fixture.tight);
            } else {
                area.moving = area.moving ? Join(*area.moving, fixture.tight) : fixture.tight;
            }
        }
    }
}

std::vector<Box> GetFitBoxes(const FitArea& area) {
    if (!area.moving) return area.still;
    Box around = *area.moving;
    const float margin = surroundings * std::max(around.upper.x - around.lower.x, around.upper.y - around.lower.y);
    around.lower = {around.lower.x - margin, around.lower.y - margin};
    around.upper = {around.upper.x + margin, around.upper.y + margin};
    std::vector<Box> boxes{*area.moving};
    for (const Box& box : area.still) {
        if (const std::optional<Box> common = Intersect(box, around)) boxes.push_back(*common);
    }
    return boxes;
}

Camera FitCamera(std::span<const Box> boxes, int width, int height, const Margins& margins) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double lowerX = infinity, lowerY = infinity, upperX = -infinity, upperY = -infinity;
    for (const Box& box : boxes) {
        if (!IsFinite(box)) continue;
        lowerX = std::min(lowerX, static_cast<double>(box.lower.x));
        lowerY = std::min(lowerY, static_cast<double>(box.lower.y));
        upperX = std::max(upperX, static_cast<double>(box.upper.x));
        upperY = std::max(upperY, static_cast<double>(box.upper.y));
    }
    const double innerWidth = std::max(1, width - margins.left - margins.right);
    const double innerHeight = std::max(1, height - margins.top - margins.bottom);
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.offsetX = (margins.left - margins.right) * 0.5;
    camera.offsetY = (margins.top - margins.bottom) * 0.5;
    if (!(lowerX <= upperX)) {
        camera.pixelsPerMetre = innerWidth / emptyAcross;
        return camera;
    }
    camera.x = (lowerX + upperX) * 0.5;
    camera.y = (lowerY + upperY) * 0.5;
    // A point, or a line, has no size along an axis; the other axis then decides, or a default for both.
    const double scaleX = upperX > lowerX ? innerWidth / (upperX - lowerX) : infinity;
    const double scaleY = upperY > lowerY ? innerHeight / (upperY - lowerY) : infinity;
    const double scale = std::min(scaleX, scaleY);
    camera.pixelsPerMetre = std::isfinite(scale) ? scale : innerWidth / emptyAcross;
    return camera;
}

Camera ScaleCamera(const Camera& camera, int width, int height) {
    const double scale = static_cast<double>(width) / camera.width;
    return {camera.x,
            camera.y,
            camera.pixelsPerMetre * scale,
            width,
            height,
            camera.offsetX * scale,
            camera.offsetY * scale};
}

PixelRect ProjectBox(const Box& box, double inflate, const Camera& camera) {
    return {camera.ToPixelX(box.lower.x - inflate), camera.ToPixelY(box.upper.y + inflate),
            camera.ToPixelX(box.upper.x + inflate), camera.ToPixelY(box.lower.y - inflate)};
}

}  // namespace testbed
