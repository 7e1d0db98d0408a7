// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Camera: what is fitted lies inside the margins and touches them, y turns over, scaling keeps the view, and the
// command line's text is read strictly.

#include "testbed/view/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace testbed {
namespace {

constexpr double pixelTolerance = 1e-6;  // of a pixel: double arithmetic on values of a few thousand

TEST(Camera, FitShowsEveryBoxInsideTheMarginsAndFillsOneAxis) {
    const bool holds = rc::check("fit", [] {
        const auto count = *rc::gen::inRange(1, 20);
        std::vector<Box> boxes;
        for (int i = 0; i < count; ++i) {
            const auto x = static_cast<float>(*rc::gen::inRange(-1000, 1000)) * 0.37f;
            const auto y = static_cast<float>(*rc::gen::inRange(-1000, 1000)) * 0.11f;
            boxes.push_back({{x, y}, {x + static_cast<float>(*rc::gen::inRange(1, 90)), y + 1}});
        }
        const Margins margins{10, 30, 20, 50};
        const Camera camera = FitCamera(boxes, 640, 400, margins);
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (const Box& box : boxes) {
            left = std::min(left, camera.ToPixelX(box.lower.x));
            right = std::max(right, camera.ToPixelX(box.upper.x));
            top = std::min(top, camera.ToPixelY(box.upper.y));
            bottom = std::max(bottom, camera.ToPixelY(box.lower.y));
        }
        RC_ASSERT(left >= 10 - pixelTolerance && right <= 620 + pixelTolerance);
        RC_ASSERT(top >= 30 - pixelTolerance && bottom <= 350 + pixelTolerance);
        const bool fillsWidth = std::abs((right - left) - 610) < pixelTolerance;
        const bool fillsHeight = std::abs((bottom - top) - 320) < pixelTolerance;
        RC_ASSERT(fillsWidth || fillsHeight);
    });
    EXPECT_TRUE(holds);
}

/// A snapshot of boxes with their bodies' types.
Snapshot MakeBoxes(const std::vector<std::pair<Box, scenes::BodyType>>& boxes) {
    Snapshot snapshot;
    for (const auto& [box, type] : boxes) {
        BodyState body{};
        body.type = type;
        FixtureState fixture{};
        fixture.body = static_cast<int>(snapshot.bodies.size());
        fixture.tight = box;
        snapshot.bodies.push_back(body);
        snapshot.fixtures.push_back(fixture);
    }
    return snapshot;
}

std::vector<Box> FitBoxesOf(const Snapshot& snapshot) {
    const Snapshot* const pointer = &snapshot;
    FitArea area;
    AddStep(area, std::span(&pointer, 1));
    return GetFitBoxes(area);
}

TEST(Camera, FitLooksAtWhatMoves) {
    using scenes::BodyType;
    EXPECT_TRUE(rc::check("ground", [] {
        const auto half = static_cast<float>(*rc::gen::inRange(1, 500));
        const auto x = static_cast<float>(*rc::gen::inRange(-100, 100)),
                   y = static_cast<float>(*rc::gen::inRange(0, 3));
        const Box pile{{x, y}, {x + 10, y + 6}};
        const Snapshot snapshot =
            MakeBoxes({{{{-half, -1}, {half, 0}}, BodyType::isStatic}, {pile, BodyType::dynamic}});
        const Camera camera = FitCamera(FitBoxesOf(snapshot), 640, 400, {});
        RC_ASSERT(camera.ToPixelX(pile.lower.x) >= -pixelTolerance &&
                  camera.ToPixelX(pile.upper.x) <= 640 + pixelTolerance);
        RC_ASSERT(camera.ToPixelY(pile.upper.y) >= -pixelTolerance &&
                  camera.ToPixelY(pile.lower.y) <= 400 + pixelTolerance);
        RC_ASSERT(camera.pixelsPerMetre * 10 >= 640 / 1.5 - 1e-3);  // the ground takes a quarter on each side at most
    }));
    // What stands still alone is shown whole.
    const Snapshot still = MakeBoxes({{{{-200, -1}, {200, 0}}, BodyType::isStatic}});
    EXPECT_NEAR(FitCamera(FitBoxesOf(still), 800, 400, {}).pixelsPerMetre, 2, 1e-6);
}

TEST(Camera, NothingToFitIsAViewOfTheOrigin) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const std::vector<Box>& boxes : {std::vector<Box>{}, std::vector<Box>{{{nan, 0}, {1, 1}}}}) {
        const Camera camera = FitCamera(boxes, 200, 100, {});
        EXPECT_EQ(camera.ToPixelX(0), 100);
        EXPECT_EQ(camera.ToPixelY(0), 50);
        EXPECT_EQ(camera.pixelsPerMetre, 20);
    }
    const std::vector<Box> point{{{3, 4}, {3, 4}}};
    EXPECT_TRUE(std::isfinite(FitCamera(point, 200, 100, {}).pixelsPerMetre));
}

TEST(Camera, RequestGivesCentreAndMetresAcross) {
    const Camera camera = MakeCamera({10, 20, 50}, 500, 200);
    EXPECT_EQ(camera.ToPixelX(-15), 0);
    EXPECT_EQ(camera.ToPixelX(35), 500);
    EXPECT_EQ(camera.ToPixelY(20), 100);
    EXPECT_EQ(camera.ToPixelY(21), 90) << "y points up in the world and down in the picture";
}

TEST(Camera, ScalingKeepsTheView) {
    const Camera camera = FitCamera(std::vector<Box>{{{0, 0}, {30, 10}}}, 600, 400, {10, 20, 30, 40});
    const Camera half = ScaleCamera(camera, 300, 200);
    EXPECT_NEAR(half.ToPixelX(7) * 2, camera.ToPixelX(7), pixelTolerance);
    EXPECT_NEAR(half.ToPixelY(7) * 2, camera.ToPixelY(7), pixelTolerance);
}

TEST(Camera, QuerySizeGrowsABoxOnAllSides) {
    const Camera camera = MakeCamera({0, 0, 100}, 1000, 1000);
    const PixelRect rect = ProjectBox({{0, 0}, {4, 2}}, 0.5, camera);
    EXPECT_DOUBLE_EQ(rect.x0, 495);
    EXPECT_DOUBLE_EQ(rect.x1, 545);
    EXPECT_DOUBLE_EQ(rect.y0, 475);
    EXPECT_DOUBLE_EQ(rect.y1, 505);
}

TEST(Camera, TextIsReadStrictly) {
    EXPECT_FALSE(ParseCamera("fit").has_value());
    const std::optional<CameraRequest> request = ParseCamera("-1.5,2,1e2");
    ASSERT_TRUE(request.has_value());
    EXPECT_EQ(request->x, -1.5);
    EXPECT_EQ(request->y, 2);
    EXPECT_EQ(request->across, 100);
    for (const char* bad : {"", "1,2", "1,2,0", "1,2,-3", "1,2,3,4", "a,2,3", "1,2,inf", "nan,0,1", "1, 2,3", "Fit"}) {
        EXPECT_THROW((void)ParseCamera(bad), std::invalid_argument) << bad;
    }
}

}  // namespace
}  // namespace testbed
