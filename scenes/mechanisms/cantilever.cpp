// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Cantilever: three beams of n segments each welded to a wall: slim and elastic, slim and rigid, thick and rigid. Each
// carries a block, welded to its tip. Size → scene. After Box2D's testbed.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

struct Beam {
    double y, halfHeight;
    double hertz;  ///< of two neighbouring segments; 0: rigid
};

void AddBeam(Scene& scene, int n, const Beam& beam) {
    constexpr double halfLength = 0.5, density = 20.0;
    const double mass = 4.0 * halfLength * beam.halfHeight * density;
    const double inertia = mass * (halfLength * halfLength + beam.halfHeight * beam.halfHeight) / 3.0;
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.5 + i, beam.y));
        AddFixture(scene, Box(halfLength, beam.halfHeight), density);
        const int self = LastBody(scene);
        Joint& weld = AddJoint(scene, JointType::weld, i == 0 ? 0 : self - 1, self, Point(i, beam.y));
        if (beam.hertz == 0.0) continue;
        const Spring spring = MakeSpring(i == 0 ? inertia : Reduced(inertia, inertia), beam.hertz, 0.7);
        weld.stiffness = spring.stiffness;
        weld.damping = spring.damping;
    }
    const double loadY = beam.y + beam.halfHeight + 0.4;
    AddBody(scene, BodyType::dynamic, Point(n - 0.5, loadY));
    AddFixture(scene, Box(0.4, 0.4), 10.0);
    AddJoint(scene, JointType::weld, LastBody(scene) - 1, LastBody(scene), Point(n - 0.5, loadY - 0.4));
}

}  // namespace

Scene Cantilever(int n) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Box(0.5, 10.0, Point(-0.5, 10.0)));
    AddFixture(scene, Edge(Point(-1.0, 0.0), Point(n + 4.0, 0.0)));
    AddBeam(scene, n, {.y = 4.0, .halfHeight = 0.125, .hertz = 30.0});
    AddBeam(scene, n, {.y = 10.0, .halfHeight = 0.125, .hertz = 0.0});
    AddBeam(scene, n, {.y = 16.0, .halfHeight = 0.35, .hertz = 0.0});
    return scene;
}

}  // namespace scenes
