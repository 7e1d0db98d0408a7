// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Web: n rings of twelve small balls, held by springs along and across, hang in a frame and catch three heavier balls.
// Size → scene.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

constexpr int spokes = 12;
constexpr double nodeRadius = 0.1, nodeDensity = 4.0;

void Stretch(Scene& scene, int bodyA, int bodyB, Vec2 anchorB) {
    constexpr double mass = nodeDensity * pi * nodeRadius * nodeRadius;
    Joint& joint = AddSpring(scene, bodyA, bodyB, scene.bodies[static_cast<std::size_t>(bodyA)].position, anchorB);
    const Spring spring = MakeSpring(mass, 6.0, 0.3);
    joint.stiffness = spring.stiffness;
    joint.damping = spring.damping;
    joint.length *= 0.9f;  // under tension from the start
}

}  // namespace

Scene Web(int n) {
    Scene scene;
    const double frame = n + 1.0;
    AddBody(scene, BodyType::isStatic, {});
    for (int k = 0; k < spokes; ++k) {
        const auto a = SinCos(2.0 * pi * k / spokes), b = SinCos(2.0 * pi * (k + 1) / spokes);
        AddFixture(scene, Edge(Point(frame * a.cos, frame * a.sin), Point(frame * b.cos, frame * b.sin)));
    }
    AddBody(scene, BodyType::dynamic, {});
    AddFixture(scene, Circle(nodeRadius), nodeDensity);
    for (int ring = 1; ring <= n; ++ring) {
        for (int k = 0; k < spokes; ++k) {
            const auto [sin, cos] = SinCos(2.0 * pi * k / spokes);
            AddBody(scene, BodyType::dynamic, Point(ring * cos, ring * sin));
            AddFixture(scene, Circle(nodeRadius), nodeDensity);
        }
    }
    const auto node = [n](int ring, int k) { return ring == 0 ? 1 : 2 + (ring - 1) * spokes + k % spokes; };
    const auto at = [&scene](int body) { return scene.bodies[static_cast<std::size_t>(body)].position; };
    for (int k = 0; k < spokes; ++k) {
        const auto [sin, cos] = SinCos(2.0 * pi * k / spokes);
        for (int ring = 0; ring < n; ++ring) Stretch(scene, node(ring, k), node(ring + 1, k), at(node(ring + 1, k)));
        for (int ring = 1; ring <= n; ++ring) Stretch(scene, node(ring, k), node(ring, k + 1), at(node(ring, k + 1)));
        Stretch(scene, node(n, k), 0, Point(frame * cos, frame * sin));
    }
    for (int i = 0; i < 3; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.6 * n * (i - 1), 0.35 * n + 1.0 + 0.6 * (i % 2)));
        AddFixture(scene, Circle(0.45), 1.0);
    }
    return scene;
}

}  // namespace scenes
