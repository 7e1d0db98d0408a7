// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Prismatic joints: a block slides down an inclined axis to its limit, and another goes up by a motor. A third is
// driven from side to side of its range, and a fourth hangs from the third.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointPrismatic(int) {
    Scene scene;
    AddFlatGround(scene, 14.0);
    const auto addBlock = [&scene](double x, double y, double angle) {
        AddBody(scene, BodyType::dynamic, Point(x, y)).angle = static_cast<float>(angle);
        AddFixture(scene, Box(1.0, 0.5), 5.0);
        return LastBody(scene);
    };
    const auto limit = [](Joint& joint, double lower, double upper) {
        joint.enableLimit = true;
        joint.lowerTranslation = static_cast<float>(lower);
        joint.upperTranslation = static_cast<float>(upper);
    };
    const auto drive = [](Joint& joint, double speed, double maxForce) {
        joint.enableMotor = true;
        joint.motorSpeed = static_cast<float>(speed);
        joint.maxMotorForce = static_cast<float>(maxForce);
    };
    const double incline = pi / 6.0;
    const auto [sin, cos] = SinCos(incline);
    limit(AddPrismatic(scene, 0, addBlock(-10.0, 6.0, incline), Point(-10.0, 6.0), Point(cos, sin)), -5.0, 3.0);

    Joint& lift = AddPrismatic(scene, 0, addBlock(-3.0, 2.0, 0.0), Point(-3.0, 2.0), Point(0.0, 1.0));
    limit(lift, 0.0, 6.0);
    drive(lift, 2.0, 500.0);

    const int trolley = addBlock(3.0, 9.0, 0.0);
    Joint& rail = AddPrismatic(scene, 0, trolley, Point(3.0, 9.0), Point(1.0, 0.0));
    limit(rail, 0.0, 7.0);
    drive(rail, 2.0, 300.0);

    // Below the trolley, on an axis that is fixed in the trolley.
    limit(AddPrismatic(scene, trolley, addBlock(3.0, 7.5, 0.0), Point(3.0, 7.5), Point(0.0, 1.0)), -3.0, 0.0);
    return scene;
}

}  // namespace scenes
