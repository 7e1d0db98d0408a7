// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Car: two wheels on sprung wheel joints, the rear one driven, on a chain with bumps and a hill. Then come a seesaw, a
// bridge of planks and a stack of boxes. After Box2D's testbed.

#include <vector>

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

constexpr double terrainBegin = -5.0, bridgeBegin = 47.0, bridgePlanks = 12, terrainEnd = 74.0;
constexpr double seesaw = 40.0;

// Height of the ground, m: flat, bumps 0.3 m high every 4 m, a hill of 3 m, flat.
double HeightAt(double x) {
    if (x > 4.0 && x < 16.0) return 0.15 * (1.0 - SinCos((x - 4.0) * pi / 2.0).cos);
    if (x > 16.0 && x < 34.0) return 1.5 * (1.0 - SinCos((x - 16.0) * pi / 9.0).cos);
    return 0.0;
}

// A chain collides on its right, so the surface runs from the far end to the near one. Two vertices make the gap.
void AddTerrain(Scene& scene) {
    const auto addPiece = [&scene](double begin, double end) {
        std::vector<Vec2> surface;
        for (int i = 0; end - 0.5 * i >= begin; ++i) surface.push_back(Point(end - 0.5 * i, HeightAt(end - 0.5 * i)));
        AddFixture(scene, Chain(scene, surface)).friction = 0.8f;
    };
    AddBody(scene, BodyType::isStatic, {});
    addPiece(terrainBegin, bridgeBegin);
    addPiece(bridgeBegin + bridgePlanks, terrainEnd);
    AddFixture(scene, Edge(Point(terrainBegin, 0.0), Point(terrainBegin, 6.0)));
    AddFixture(scene, Edge(Point(terrainEnd, 0.0), Point(terrainEnd, 6.0)));
}

void AddSeesaw(Scene& scene) {
    AddBody(scene, BodyType::dynamic, Point(seesaw, 0.6));
    AddFixture(scene, Box(4.0, 0.15), 1.0).friction = 0.8f;
    Joint& hinge = AddJoint(scene, JointType::revolute, 0, LastBody(scene), Point(seesaw, 0.6));
    hinge.enableLimit = true;
    hinge.lowerAngle = static_cast<float>(-8.0 * pi / 180.0);
    hinge.upperAngle = static_cast<float>(8.0 * pi / 180.0);
    scene.bodies.back().angle = hinge.upperAngle;
}

void AddPlanks(Scene& scene) {
    int before = 0;
    for (int i = 0; i < bridgePlanks; ++i) {
        AddBody(scene, BodyType::dynamic, Point(bridgeBegin + 0.5 + i, -0.125));
        AddFixture(scene, Box(0.5, 0.125), 1.0).friction = 0.8f;
        AddJoint(scene, JointType::revolute, before, LastBody(scene), Point(bridgeBegin + i, -0.125));
        before = LastBody(scene);
    }
    AddJoint(scene, JointType::revolute, 0, before, Point(bridgeBegin + bridgePlanks, -0.125));
}

void AddWheelOfCar(Scene& scene, int chassis, Vec2 position, bool isDriven) {
    AddBody(scene, BodyType::dynamic, position);
    AddFixture(scene, Circle(0.4), 1.0).friction = 0.9f;
    Joint& joint = AddWheel(scene, chassis, LastBody(scene), position, Point(0.0, 1.0));
    const double mass = pi * 0.4 * 0.4;
    const Spring spring = MakeSpring(mass, 4.0, 0.7);
    joint.stiffness = 4.0f * spring.stiffness;  // the chassis rests on it too
    joint.damping = 4.0f * spring.damping;
    joint.enableLimit = true;
    joint.lowerTranslation = -0.25f;
    joint.upperTranslation = 0.25f;
    joint.enableMotor = isDriven;
    joint.motorSpeed = -20.0f;
    joint.maxMotorTorque = 20.0f;
}

}  // namespace

Scene Car(int) {
    Scene scene;
    AddTerrain(scene);
    AddSeesaw(scene);
    AddPlanks(scene);
    for (int i = 0; i < 5; ++i) {
        AddBody(scene, BodyType::dynamic, Point(66.0, 0.5 + i));
        AddFixture(scene, Box(0.5, 0.5), 0.5);
    }
    AddBody(scene, BodyType::dynamic, Point(0.0, 1.0));
    AddFixture(scene,
               Polygon({Point(-1.5, -0.5), Point(1.5, -0.5), Point(1.5, 0.0), Point(0.0, 0.9), Point(-1.15, 0.9),
                        Point(-1.5, 0.2)}),
               1.0);
    const int chassis = LastBody(scene);
    AddWheelOfCar(scene, chassis, Point(-1.0, 0.42), true);
    AddWheelOfCar(scene, chassis, Point(1.0, 0.42), false);
    return scene;
}

}  // namespace scenes
