// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Big mobile: a hanging binary tree of 2^(n+1) − 1 bodies on revolute joints, depth first. Size (the depth) → scene.
// Tsamis 2020, §8.1, after the mobile of Box2D's testbed.

#include "scenes/build.h"

namespace scenes {

namespace {

constexpr double a = 0.25;  // half the length of a hanging bar, m

void AddHinge(Scene& scene, int parent, int child, Vec2 parentAnchor) {
    Joint& joint = scene.joints.emplace_back();
    joint.bodyA = parent;
    joint.bodyB = child;
    joint.localAnchorA = parentAnchor;
    joint.localAnchorB = Point(0.0, a);
}

// Adds a node and what hangs below it. Both children exist before their joints, as in the published scene.
int AddNode(Scene& scene, int parent, Vec2 anchor, int levelsBelow, double offset) {
    const Vec2 above = scene.bodies[static_cast<std::size_t>(parent)].position;
    const Vec2 position = Point(static_cast<double>(above.x) + anchor.x, static_cast<double>(above.y) + anchor.y - a);
    AddBody(scene, BodyType::dynamic, position);
    const int self = LastBody(scene);
    AddFixture(scene, Box(0.25 * a, a), 20.0 + 0.02 * position.x);
    if (levelsBelow == 0) return self;

    AddFixture(scene, Box(offset, 0.25 * a, Point(0.0, -a)), 20.0);
    const Vec2 right = Point(offset, -a);
    const Vec2 left = Point(-offset, -a);
    const int rightChild = AddNode(scene, self, right, levelsBelow - 1, offset / 2.0);
    const int leftChild = AddNode(scene, self, left, levelsBelow - 1, offset / 2.0);
    AddHinge(scene, self, rightChild, right);
    AddHinge(scene, self, leftChild, left);
    return self;
}

}  // namespace

Scene BigMobile(int n) {
    Scene scene;
    const int nodes = (2 << n) - 1;
    Reserve(scene, nodes + 1, nodes + nodes / 2);
    scene.joints.reserve(static_cast<std::size_t>(nodes));
    AddBody(scene, BodyType::isStatic, Point(0.0, 20.0));
    const int root = AddNode(scene, 0, {}, n, 200.0);
    AddHinge(scene, 0, root, {});
    return scene;
}

}  // namespace scenes
