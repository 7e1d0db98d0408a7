// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pulley joints: equal boxes at ratio 1 and boxes of 2 : 1 at ratio 2 stay in balance, unequal boxes at ratio 1 do not.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointPulley(int) {
    Scene scene;
    AddFlatGround(scene, 18.0);
    const auto addPair = [&scene](double x, double ratio, double densityA, double densityB) {
        for (const double side : {-2.0, 2.0}) {
            AddBody(scene, BodyType::dynamic, Point(x + side, 5.0));
            AddFixture(scene, Box(0.75, 0.75), side < 0.0 ? densityA : densityB);
        }
        AddPulley(scene, LastBody(scene) - 1, LastBody(scene),
                  {.groundA = Point(x - 2.0, 12.0),
                   .groundB = Point(x + 2.0, 12.0),
                   .anchorA = Point(x - 2.0, 5.75),
                   .anchorB = Point(x + 2.0, 5.75)})
            .ratio = static_cast<float>(ratio);
    };
    addPair(-11.0, 1.0, 4.0, 4.0);
    addPair(0.0, 2.0, 4.0, 8.0);
    addPair(11.0, 1.0, 4.0, 5.0);
    return scene;
}

}  // namespace scenes
