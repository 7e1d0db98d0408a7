// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Draw lists. All corners stay inside the picture whatever the camera, and every backend draws them alike. Bodies that
// differ in kind differ in colour, and islands are what contacts and joints connect.

#include "testbed/view/scene_layers.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <tuple>

#include "scenes/outline.h"
#include "testbed/gl/renderer.h"
#include "testbed/view/canvas.h"
#include "testbed/view/islands.h"
#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

constexpr const char* allLayers =
    "bodies,partitions,bvh,aabbs-fattened,aabbs-swept,aabbs,joints,velocities,impulses,normals,contacts,labels";
constexpr Color transparent{0, 0, 0, 0};

std::vector<Camera> MakeCameras() {
    return {MakeCamera({7, 3, 20}, 320, 200),      // everything in view
            MakeCamera({7, 3, 3}, 320, 200),       // bodies cut by all edges
            MakeCamera({7, 3, 0.01}, 320, 200),    // inside one body
            MakeCamera({7, 3, 4000}, 320, 200),    // bodies smaller than a pixel
            MakeCamera({9000, 0, 20}, 320, 200)};  // nothing in view
}

TEST(SceneLayers, CornersStayInsideThePicture) {
    Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    snapshot.bodies[3].position.x = std::numeric_limits<float>::quiet_NaN();
    snapshot.bodies[5].position.y = std::numeric_limits<float>::infinity();
    snapshot.bodies[9].position.x = 1e30f;
    for (const Camera& camera : MakeCameras()) {
        for (const int supersampling : {1, 2, 4}) {
            const DrawList list =
                BuildDrawList(snapshot, camera,
                              {ParseLayers(allLayers), ParseNodeSelection("all"), supersampling, Theme::dark, false});
            const int32_t right = list.width * supersampling * fixedPointOne;
            const int32_t bottom = list.height * supersampling * fixedPointOne;
            for (const Triangle& triangle : list.triangles) {
                for (const FixedPoint& corner : {triangle.a, triangle.b, triangle.c}) {
                    ASSERT_TRUE(corner.x >= 0 && corner.x <= right && corner.y >= 0 && corner.y <= bottom);
                }
            }
        }
    }
}

class SceneLayersOnGl : public testing::TestWithParam<Backend> {};

TEST_P(SceneLayersOnGl, EqualTheCpu) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    const auto gl = MakeRenderer(GetParam());
    const auto cpu = MakeRenderer(Backend::cpu);
    for (const Camera& camera : MakeCameras()) {
        for (const int supersampling : {1, 2, 4}) {
            const DrawList list =
                BuildDrawList(snapshot, camera,
                              {ParseLayers(allLayers), ParseNodeSelection("all"), supersampling, Theme::dark, false});
            Image expected(list.width * supersampling, list.height * supersampling, transparent);
            Image actual = expected;
            cpu->Draw(list.triangles, expected);
            gl->Draw(list.triangles, actual);
            EXPECT_TRUE(expected.pixels == actual.pixels);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, SceneLayersOnGl, testing::Values(Backend::osmesa, Backend::egl),
                         [](const auto& tested) { return std::string(GetBackendName(tested.param)); });

TEST(SceneLayers, KindsOfBodiesDifferInColour) {
    using scenes::BodyType;
    scenes::Shape box;
    box.type = scenes::ShapeType::box;
    box.halfExtents = {1, 1};
    std::set<std::tuple<int, int, int, int>> colors;
    for (int kind = 0; kind < 6; ++kind) {
        Snapshot snapshot;
        AddBody(snapshot, kind == 0 ? BodyType::isStatic : (kind == 1 ? BodyType::kinematic : BodyType::dynamic),
                {0, 0}, box);
        snapshot.bodies[0].awake = kind != 3;
        snapshot.bodies[0].bullet = kind == 4;
        snapshot.fixtures[0].sensor = kind == 5;
        const DrawList list =
            BuildDrawList(snapshot, MakeCamera({0, 0, 4}, 64, 64), {Layers::Bodies(), {}, 1, Theme::dark, false});
        const Color& fill = list.triangles.back().color;
        colors.insert({fill.r, fill.g, fill.b, fill.a});
    }
    EXPECT_EQ(colors.size(), 6u);
}

TEST(SceneLayers, SmallBodiesAreStillSeen) {
    scenes::Shape circle;
    circle.radius = 0.01f;
    Snapshot snapshot;
    AddBody(snapshot, scenes::BodyType::dynamic, {0, 0}, circle);
    const DrawList list =
        BuildDrawList(snapshot, MakeCamera({0, 0, 1000}, 64, 64), {Layers::Bodies(), {}, 1, Theme::dark, false});
    Image image(64, 64, transparent);
    MakeRenderer(Backend::cpu)->Draw(list.triangles, image);
    EXPECT_NE(image.At(32, 32).a, 0);
}

TEST(SceneLayers, ADiskCoversItsArea) {
    DrawList list;
    list.width = list.height = 400;
    Canvas(list).DrawDisk({200, 200}, 150, {9, 9, 9, 255});
    Image image(400, 400, transparent);
    MakeRenderer(Backend::cpu)->Draw(list.triangles, image);
    int covered = 0;
    for (const Color& color : image.pixels) covered += color.a == 255 ? 1 : 0;
    const double area = 0.5 * 64 * 150 * 150 * 0.0980171403;  // of the regular 64-gon: n/2 · r² · sin(2π/64)
    EXPECT_NEAR(covered, area, 0.5 * 64 * 2) << "an edge may gain or lose about a pixel";
}

TEST(SceneLayers, BordersLieInsideAndLeaveTheFill) {
    DrawList list;
    list.width = list.height = 20;
    const std::vector<Point> clockwise{{4, 4}, {16, 4}, {16, 16}, {4, 16}};
    const std::vector<Point> counterClockwise{{4, 4}, {4, 16}, {16, 16}, {16, 4}};
    for (const std::vector<Point>& square : {clockwise, counterClockwise}) {
        list.triangles.clear();
        Canvas(list).DrawConvex(square, {1, 1, 1, 255}, {2, 2, 2, 255}, 2);
        Image image(20, 20, transparent);
        MakeRenderer(Backend::cpu)->Draw(list.triangles, image);
        EXPECT_EQ(image.At(3, 10).a, 0);
        EXPECT_EQ(image.At(4, 10).r, 2);
        EXPECT_EQ(image.At(5, 10).r, 2);
        EXPECT_EQ(image.At(6, 10).r, 1);
        EXPECT_EQ(image.At(13, 13).r, 1);
        EXPECT_EQ(image.At(14, 13).r, 2);
    }
    list.triangles.clear();
    Canvas(list).DrawConvex(clockwise, {1, 1, 1, 255}, {2, 2, 2, 255}, 7);
    for (const Triangle& triangle : list.triangles) EXPECT_EQ(triangle.color.r, 2) << "too thin for a fill";
}

/// The layer of joints alone, one pixel a centimetre, the origin in the middle.
Image DrawJointsAlone(const Snapshot& snapshot) {
    const DrawList list = BuildDrawList(snapshot, MakeCamera({0, 0, 8}, 800, 600),
                                        {ParseLayers("joints"), ParseNodeSelection("all"), 1, Theme::dark, false});
    Image image(list.width, list.height, transparent);
    MakeRenderer(Backend::cpu)->Draw(list.triangles, image);
    return image;
}

/// Whether something is drawn within two pixels of a world point.
bool IsDrawn(const Image& image, double x, double y) {
    const int column = static_cast<int>(400 + 100 * x), row = static_cast<int>(300 - 100 * y);
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            if (!(image.At(column + dx, row + dy) == transparent)) return true;
        }
    }
    return false;
}

/// Two bodies at (−2, −1) and (2, −1), and a joint of the type between them.
Snapshot MakeJoined(scenes::JointType type) {
    Snapshot snapshot;
    scenes::Shape circle;
    circle.radius = 0.5f;
    for (const float x : {-2.0f, 2.0f}) AddBody(snapshot, scenes::BodyType::dynamic, {x, -1}, circle);
    JointState joint{0, 1, {-2, -0.5f}, {2, -0.5f}, type, {-1, 2}, {1, 2}};
    snapshot.joints.push_back(joint);
    return snapshot;
}

TEST(SceneLayers, APulleyIsARopeOverItsTwoGroundAnchors) {
    const Image image = DrawJointsAlone(MakeJoined(scenes::JointType::pulley));
    EXPECT_TRUE(IsDrawn(image, -1.5, 0.75)) << "from the left body up";
    EXPECT_TRUE(IsDrawn(image, 0, 2)) << "across";
    EXPECT_TRUE(IsDrawn(image, 1.5, 0.75)) << "down to the right body";
    EXPECT_TRUE(IsDrawn(image, -2, -0.75)) << "arm of the left body";
    EXPECT_FALSE(IsDrawn(image, 0, -0.5)) << "no line between the bodies";
}

TEST(SceneLayers, AGearHasArmsAndNoLineBetweenItsBodies) {
    const Image gear = DrawJointsAlone(MakeJoined(scenes::JointType::gear));
    EXPECT_TRUE(IsDrawn(gear, -2, -0.75));
    EXPECT_TRUE(IsDrawn(gear, 2, -0.75));
    EXPECT_TRUE(IsDrawn(gear, -2, -0.5));
    EXPECT_FALSE(IsDrawn(gear, 0, -0.5));
    EXPECT_FALSE(IsDrawn(gear, 0, 2));
    EXPECT_TRUE(IsDrawn(DrawJointsAlone(MakeJoined(scenes::JointType::distance)), 0, -0.5)) << "others have one";
}

TEST(SceneLayers, AFurtherConvexShapeIsDrawnByItsOutline) {
    Snapshot snapshot;
    scenes::Shape ellipse = {.type = scenes::ShapeType::ellipse, .halfExtents = {2, 1}};
    AddBody(snapshot, scenes::BodyType::dynamic, {0, 0}, ellipse);
    snapshot.bodies[0].sin = 0;
    snapshot.bodies[0].cos = 1;
    snapshot.fixtures[0].outline = scenes::SampleOutline({}, ellipse, 96);
    const DrawList list = BuildDrawList(snapshot, MakeCamera({0, 0, 8}, 800, 600),
                                        {ParseLayers("bodies"), ParseNodeSelection("all"), 1, Theme::dark, false});
    Image image(list.width, list.height, transparent);
    MakeRenderer(Backend::cpu)->Draw(list.triangles, image);
    int covered = 0;
    for (const Color& color : image.pixels) covered += color == transparent ? 0 : 1;
    // π·a·b at 10⁴ pixels a square metre; 96 chords lose 0.07 %, borders are as wide as a pixel.
    EXPECT_NEAR(covered, 2 * 3.14159 * 1e4, 0.004 * 2 * 3.14159 * 1e4);
}

TEST(SceneLayers, IslandsAreConnectedByTouchingContactsAndJointsOfDynamicBodies) {
    using scenes::BodyType;
    Snapshot snapshot;
    const scenes::Shape circle;
    for (int i = 0; i < 7; ++i) AddBody(snapshot, i == 0 ? BodyType::isStatic : BodyType::dynamic, {0, 0}, circle);
    for (FixtureState& fixture : snapshot.fixtures) fixture.sensor = fixture.body == 6;
    const auto addContact = [&snapshot](int a, int b, bool touching) {
        snapshot.contacts.push_back({a, b, touching, 0, {}, {}, {}, {}, {}});
    };
    addContact(2, 1, true);
    addContact(1, 0, true);  // the ground joins nothing
    addContact(3, 0, true);
    addContact(3, 4, false);  // boxes overlap, shapes do not
    addContact(5, 6, true);   // a sensor
    snapshot.joints.push_back({4, 2, {}, {}});
    EXPECT_EQ(FindIslands(snapshot), (std::vector<int>{-1, 1, 1, 3, 1, 5, 6}));
}

TEST(SceneLayers, LabelsCarryBodyIndices) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    const DrawList list = BuildDrawList(snapshot, MakeCameras()[0], {ParseLayers("labels"), {}, 1, Theme::dark, false});
    ASSERT_EQ(list.texts.size(), 32u);
    EXPECT_EQ(list.texts[17].text, "17");
    EXPECT_TRUE(
        BuildDrawList(snapshot, MakeCameras()[4], {ParseLayers("labels"), {}, 1, Theme::dark, false}).texts.empty());
}

}  // namespace
}  // namespace testbed
