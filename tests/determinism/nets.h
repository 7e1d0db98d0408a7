// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene of what the catalogue lacks: nets of joints, too much coupled for a direct solve. Each is of one type of
// joint that nets hold, and the last of all.

#pragma once

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace determinism {

inline void TieInNet(scenes::Scene& scene, int a, int b, int kind) {
    const scenes::Vec2 from = scene.bodies[static_cast<size_t>(a)].position;
    const scenes::Vec2 to = scene.bodies[static_cast<size_t>(b)].position;
    const scenes::Vec2 middle{0.5f * (from.x + to.x), 0.5f * (from.y + to.y)};
    const scenes::Vec2 axis{to.x - from.x, to.y - from.y};
    switch (kind) {
        case 0:
            AddJoint(scene, scenes::JointType::revolute, a, b, middle);
            return;
        case 1:
            AddJoint(scene, scenes::JointType::weld, a, b, middle);
            return;
        case 2: {
            scenes::Joint& rod = AddDistance(scene, a, b, from, to);
            rod.minLength = rod.maxLength = rod.length;
            rod.stiffness = rod.damping = 0.0f;
            return;
        }
        case 3: {
            scenes::Joint& slide = AddPrismatic(scene, a, b, middle, axis);
            slide.enableLimit = true;
            slide.lowerTranslation = -0.1f, slide.upperTranslation = 0.1f;
            return;
        }
        default:
            AddWheel(scene, a, b, middle, axis);
    }
}

/// Six nets of 8 × 8 bodies a metre apart, hung by two corners.
inline scenes::Scene BuildNets() {
    constexpr int side = 8, kinds = 5;
    scenes::Scene scene;
    scene.name = "nets";
    scenes::Random random(7);
    for (int net = 0; net <= kinds; ++net) {
        const int first = static_cast<int>(scene.bodies.size());
        for (int i = 0; i < side * side; ++i) {
            const int column = i / side, row = i % side;
            const bool hangs = row == 0 && (column == 0 || column == side - 1);
            AddBody(scene, hangs ? scenes::BodyType::isStatic : scenes::BodyType::dynamic,
                    scenes::Point(column + 12.0 * net, -row));
            AddFixture(scene, scenes::Circle(0.3), random.Uniform(1.0, 20.0));
            if (row > 0) TieInNet(scene, first + i - 1, first + i, net < kinds ? net : i % kinds);
            if (column > 0) TieInNet(scene, first + i - side, first + i, net < kinds ? net : (i + 2) % kinds);
        }
    }
    return scene;
}

}  // namespace determinism
