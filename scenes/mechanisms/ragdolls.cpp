// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Ragdolls: n figures of ten limbs on limited revolute joints fall onto a staircase. The limbs of one figure do not
// collide with each other. Size → scene.

#include <cmath>

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

struct Limb {
    double x, y;                   ///< of its centre in the figure, m
    double halfWidth, halfHeight;  ///< m
    int parent;                    ///< limb that it hangs on; −1: none
    double jointX, jointY;         ///< of that joint, m
    double lower, upper;           ///< limits, degrees
};

constexpr Limb limbs[] = {
    {0.0, 1.25, 0.22, 0.35, -1, 0.0, 0.0, 0.0, 0.0},     // torso
    {0.0, 1.80, 0.17, 0.17, 0, 0.0, 1.62, -40.0, 40.0},  // head, a circle
    {-0.32, 1.32, 0.08, 0.22, 0, -0.3, 1.52, -120.0, 40.0},  {0.32, 1.32, 0.08, 0.22, 0, 0.3, 1.52, -40.0, 120.0},
    {-0.32, 0.90, 0.07, 0.22, 2, -0.32, 1.11, -10.0, 100.0}, {0.32, 0.90, 0.07, 0.22, 3, 0.32, 1.11, -100.0, 10.0},
    {-0.13, 0.65, 0.10, 0.26, 0, -0.13, 0.90, -70.0, 30.0},  {0.13, 0.65, 0.10, 0.26, 0, 0.13, 0.90, -30.0, 70.0},
    {-0.13, 0.15, 0.08, 0.26, 6, -0.13, 0.40, -5.0, 90.0},   {0.13, 0.15, 0.08, 0.26, 7, 0.13, 0.40, -90.0, 5.0},
};

/// `x`, `y`: between the feet, m.
void AddFigure(Scene& scene, double x, double y, int group) {
    const int first = LastBody(scene) + 1;
    for (const Limb& limb : limbs) {
        AddBody(scene, BodyType::dynamic, Point(x + limb.x, y + limb.y));
        const bool isHead = limb.halfWidth == limb.halfHeight;
        Fixture& fixture =
            AddFixture(scene, isHead ? Circle(limb.halfWidth) : Box(limb.halfWidth, limb.halfHeight), 1.0);
        fixture.groupIndex = static_cast<std::int16_t>(-group);
        fixture.friction = 0.4f;
        if (limb.parent < 0) continue;
        Joint& joint = AddJoint(scene, JointType::revolute, first + limb.parent, LastBody(scene),
                                Point(x + limb.jointX, y + limb.jointY));
        joint.enableLimit = true;
        joint.lowerAngle = static_cast<float>(limb.lower * pi / 180.0);
        joint.upperAngle = static_cast<float>(limb.upper * pi / 180.0);
    }
}

}  // namespace

Scene Ragdolls(int n) {
    Scene scene;
    constexpr int steps = 10;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(-15.0, 0.0), Point(5.0, 0.0))).friction = 0.6f;
    AddFixture(scene, Edge(Point(-15.0, 0.0), Point(-15.0, 6.0)));
    AddFixture(scene, Edge(Point(5.0, 0.0), Point(5.0, 6.0)));
    for (int i = 0; i < steps; ++i) {
        AddFixture(scene, Box(0.5 * (i + 1), 0.25, Point(-0.5 * (i + 1), 0.25 + 0.5 * (steps - 1 - i)))).friction =
            0.6f;
    }
    for (int i = 0; i < n; ++i) AddFigure(scene, -9.0 + 2.0 * (i % 6) + 0.4 * (i / 6 % 3), 6.5 + 2.5 * (i / 6), i + 1);
    return scene;
}

}  // namespace scenes
