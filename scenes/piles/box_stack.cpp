// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box stack: five columns of n boxes each; in column k every second box stands 0.05 k m beside the others. Size →
// scene.

#include "scenes/build.h"

namespace scenes {

Scene BoxStack(int n) {
    Scene scene;
    Reserve(scene, 1 + 5 * n, 1 + 5 * n);
    AddFlatGround(scene, 14.0);
    for (int column = 0; column < 5; ++column) {
        for (int row = 0; row < n; ++row) {
            AddBody(scene, BodyType::dynamic,
                    Point(-10.0 + 5.0 * column + 0.05 * column * (row % 2 == 0 ? 1 : -1), 0.505 + 1.01 * row));
            AddFixture(scene, Box(0.5, 0.5), 1.0);
        }
    }
    return scene;
}

}  // namespace scenes
