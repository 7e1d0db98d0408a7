// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Add pair 400: a fast box shoots into 400 circles at seeded random places. Size (always 400) → scene. Tsamis 2020,
// §3.8 (figures 9 and 10).

#include "scenes/fast/fast_box.h"

namespace scenes {

Scene AddPair400(int n) {
    Scene scene;
    scene.gravity = {};
    Reserve(scene, n + 1, n + 1);
    Random random(400);
    for (int i = 0; i < n; ++i) {
        // Two statements: the order in which arguments are evaluated is not specified.
        const double x = random.Uniform(-6.0, 0.0);
        const double y = random.Uniform(4.0, 6.0);
        AddCloudCircle(scene, Point(x, y));
    }
    AddFastBox(scene);
    return scene;
}

}  // namespace scenes
