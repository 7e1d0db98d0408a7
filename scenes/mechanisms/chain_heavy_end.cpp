// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chain with a heavy end: n links of 5 kg on revolute joints, held level, and a block of 180 kg at the end. It swings
// down; how far the joints open shows how well a solver carries a large mass ratio. Size → scene.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene ChainHeavyEnd(int n) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, Point(0.0, n + 6.0));
    AddFixture(scene, Box(1.0, 0.25, Point(0.0, 0.25)));
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.5 + i, n + 6.0));
        AddFixture(scene, Box(0.6, 0.125), 5.0 / 0.3);
        AddJoint(scene, JointType::revolute, i, i + 1, Point(i, n + 6.0));
    }
    AddBody(scene, BodyType::dynamic, Point(n + 1.5, n + 6.0));
    AddFixture(scene, Box(1.5, 1.5), 20.0);
    AddJoint(scene, JointType::revolute, n, n + 1, Point(n, n + 6.0));
    return scene;
}

}  // namespace scenes
