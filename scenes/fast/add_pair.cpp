// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Add pair: a fast box shoots through n resting circles, so that a step adds and removes many pairs. Size → scene.
// Tsamis 2020, §8.1, after Box2D's testbed.

#include "scenes/fast/fast_box.h"

namespace scenes {

Scene AddPair(int n) {
    Scene scene;
    scene.gravity = {};
    Reserve(scene, n + 1, n + 1);
    for (int i = 0; i < n; ++i) AddCloudCircle(scene, Point(-9.0 + 18.0 * i / n, 4.0 + 2.0 * (i % 32) / 32.0));
    AddFastBox(scene);
    return scene;
}

}  // namespace scenes
