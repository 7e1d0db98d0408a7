// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Motor joints: three boxes start 3 m beside and half a turn off the poses they are driven to. They are held against
// gravity by ample force, by just enough of it, and by too little. A fourth rides on a box that is driven along with
// it.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointMotor(int) {
    Scene scene;
    AddFlatGround(scene, 16.0);
    const auto addBox = [&scene](double x, double y) {
        AddBody(scene, BodyType::dynamic, Point(x, y));
        AddFixture(scene, Box(1.0, 0.5), 2.0);
        return LastBody(scene);
    };
    // Towards an offset in body A and half a turn from its angle.
    const auto drive = [&scene](int bodyA, int bodyB, Vec2 offset, double maxForce) {
        Joint& joint = AddMotor(scene, bodyA, bodyB);
        joint.linearOffset = offset;
        joint.angularOffset = static_cast<float>(pi);
        joint.maxForce = static_cast<float>(maxForce);
        joint.maxTorque = 100.0f;
    };
    // A body without fixtures that marks where to.
    const auto addMark = [&scene](double x, double y) {
        AddBody(scene, BodyType::isStatic, Point(x, y));
        return LastBody(scene);
    };
    constexpr double weight = 2.0 * 2.0 * 10.0;
    const double forces[] = {10.0 * weight, 1.2 * weight, 0.8 * weight};
    for (int i = 0; i < 3; ++i) {
        const double x = -11.0 + 7.0 * i;
        const int mark = addMark(x, 6.0);
        drive(mark, addBox(x - 3.0, 6.0), {}, forces[i]);
    }
    const int mark = addMark(12.0, 5.0);
    const int carrier = addBox(8.0, 5.0);
    drive(mark, carrier, {}, 20.0 * weight);
    drive(carrier, addBox(8.0, 8.0), Point(0.0, -3.0), 5.0 * weight);
    return scene;
}

}  // namespace scenes
