// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints of scenes. Both frames see one point at the anchors, and rest lengths are the present ones. Springs have the
// frequency they were asked for, and every classic's joints connect what they say.

#include "scenes/build_joints.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <cmath>

#include "scenes/build.h"
#include "scenes/catalog.h"

namespace {

using scenes::Body;
using scenes::Joint;
using scenes::JointType;
using scenes::Scene;
using scenes::Vec2;

// Coordinates are below 100 m in the classics, where a float's spacing is 8e-6 m; a frame change rounds three times.
constexpr double rounding = 3e-5;

double Distance(Vec2 a, Vec2 b) { return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y); }

Scene TwoTurnedBodies() {
    Scene scene;
    scenes::AddBody(scene, scenes::BodyType::dynamic, {1.0f, 2.0f}).angle = 0.5f;
    scenes::AddBody(scene, scenes::BodyType::dynamic, {-3.0f, 4.0f}).angle = -1.25f;
    return scene;
}

TEST(BuildJoints, FramesAreInverse) {
    EXPECT_TRUE(rc::check("to local and back", [] {
        const auto number = [] { return static_cast<float>(*rc::gen::inRange(-50000, 50001)) * 1e-3f; };
        Body body;
        body.position = {number(), number()};
        body.angle = number();
        const Vec2 world{number(), number()};
        RC_ASSERT(Distance(scenes::ToWorld(body, scenes::ToLocal(body, world)), world) < rounding);
        // A turn keeps lengths.
        RC_ASSERT(std::abs(Distance(scenes::ToLocal(body, world), {}) - Distance(world, body.position)) < rounding);
    }));
}

TEST(BuildJoints, AnchorsMeetInTurnedBodies) {
    Scene scene = TwoTurnedBodies();
    const Joint& joint = scenes::AddJoint(scene, JointType::weld, 0, 1, {0.5f, -1.0f});
    EXPECT_LT(Distance(scenes::ToWorld(scene.bodies[0], joint.localAnchorA), {0.5f, -1.0f}), rounding);
    EXPECT_LT(Distance(scenes::ToWorld(scene.bodies[1], joint.localAnchorB), {0.5f, -1.0f}), rounding);
    EXPECT_EQ(joint.referenceAngle, -1.75f);
}

TEST(BuildJoints, AxesAreOfLengthOneInBodyA) {
    Scene scene = TwoTurnedBodies();
    const Joint& joint = scenes::AddPrismatic(scene, 0, 1, {}, {0.0f, 5.0f});
    EXPECT_NEAR(joint.localAxisA.x, std::sin(0.5), 1e-6);
    EXPECT_NEAR(joint.localAxisA.y, std::cos(0.5), 1e-6);
}

TEST(BuildJoints, RodsAreFixedAndSpringsAreFree) {
    Scene scene = TwoTurnedBodies();
    const Joint rod = scenes::AddDistance(scene, 0, 1, {0.0f, 0.0f}, {3.0f, 4.0f});
    EXPECT_FLOAT_EQ(rod.length, 5.0f);
    EXPECT_EQ(rod.minLength, rod.length);
    EXPECT_EQ(rod.maxLength, rod.length);
    const Joint spring = scenes::AddSpring(scene, 0, 1, {0.0f, 0.0f}, {3.0f, 4.0f});
    EXPECT_FLOAT_EQ(spring.length, 5.0f);
    EXPECT_EQ(spring.minLength, 0.0f);
    EXPECT_GT(spring.maxLength, 1e30f);
}

TEST(BuildJoints, SpringsHaveTheirFrequency) {
    // ω = √(k / m) and ζ = d / (2 √(k m)).
    const scenes::Spring spring = scenes::MakeSpring(3.0, 2.5, 0.4);
    EXPECT_NEAR(std::sqrt(spring.stiffness / 3.0) / (2.0 * scenes::pi), 2.5, 1e-6);
    EXPECT_NEAR(spring.damping / (2.0 * std::sqrt(3.0 * spring.stiffness)), 0.4, 1e-6);
    EXPECT_DOUBLE_EQ(scenes::Reduced(2.0, 2.0), 1.0);
}

TEST(BuildJoints, OtherTypesTakeThePresentPose) {
    Scene scene = TwoTurnedBodies();
    const Joint motor = scenes::AddMotor(scene, 0, 1);
    EXPECT_LT(Distance(scenes::ToWorld(scene.bodies[0], motor.linearOffset), scene.bodies[1].position), rounding);
    EXPECT_EQ(motor.angularOffset, -1.75f);
    const Joint mouse = scenes::AddMouse(scene, 0, 1, {2.0f, 2.0f}, {9.0f, 9.0f});
    EXPECT_LT(Distance(scenes::ToWorld(scene.bodies[1], mouse.localAnchorB), {2.0f, 2.0f}), rounding);
    EXPECT_EQ(mouse.target, (Vec2{9.0f, 9.0f}));
    const Joint pulley = scenes::AddPulley(
        scene, 0, 1,
        {.groundA = {0.0f, 9.0f}, .groundB = {5.0f, 9.0f}, .anchorA = {0.0f, 2.0f}, .anchorB = {5.0f, 4.0f}});
    EXPECT_FLOAT_EQ(pulley.lengthA, 7.0f);
    EXPECT_FLOAT_EQ(pulley.lengthB, 5.0f);
    EXPECT_TRUE(pulley.collideConnected);
}

// "" or what is wrong with the joint in the initial poses.
std::string Misfit(const Scene& scene, const Joint& joint) {
    const Body& a = scene.bodies[static_cast<std::size_t>(joint.bodyA)];
    const Body& b = scene.bodies[static_cast<std::size_t>(joint.bodyB)];
    const Vec2 anchorA = scenes::ToWorld(a, joint.localAnchorA), anchorB = scenes::ToWorld(b, joint.localAnchorB);
    switch (joint.type) {
        case JointType::revolute:
        case JointType::friction:
        case JointType::prismatic:
        case JointType::weld:
        case JointType::wheel:
            return Distance(anchorA, anchorB) < rounding ? "" : "anchors apart";
        case JointType::distance: {
            const double length = Distance(anchorA, anchorB);
            return length > joint.minLength - rounding && length < joint.maxLength + rounding ? ""
                                                                                              : "outside its range";
        }
        case JointType::pulley:
            return std::abs(Distance(anchorA, joint.groundAnchorA) - joint.lengthA) < rounding &&
                           std::abs(Distance(anchorB, joint.groundAnchorB) - joint.lengthB) < rounding
                       ? ""
                       : "rope of another length";
        case JointType::mouse:
            return a.type == scenes::BodyType::isStatic ? "" : "a mouse joint hangs in the world";
        case JointType::gear:
        case JointType::motor:
            return "";  // no anchors of their own
    }
    return "type";
}

TEST(Classics, JointsFitTheInitialPoses) {
    int joints = 0;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        if (!info.isClassic) continue;
        const Scene scene = scenes::Build(info.name);
        for (const Joint& joint : scene.joints) {
            const std::string misfit = Misfit(scene, joint);
            // The seesaw of the car starts turned to its limit; a hinge at its own origin does not mind.
            EXPECT_EQ(misfit, "") << info.name << ", joint " << &joint - scene.joints.data();
            ++joints;
        }
    }
    EXPECT_GT(joints, 300);
}

TEST(Classics, AMovedBodyIsAMisfit) {
    Scene scene = scenes::Build("bridge");
    scene.bodies[3].position.x += 0.001f;
    EXPECT_NE(Misfit(scene, scene.joints[2]), "");
}

}  // namespace
