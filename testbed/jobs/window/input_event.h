// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a user does with mouse and keyboard, from a window or from a script: the one form in which input reaches the
// panels and the scene.

#pragma once

namespace testbed {

/// Keys are ASCII for what prints ('A' for the key, whatever its case), and these numbers (GLFW's) for the rest.
namespace key {
inline constexpr int space = 32, escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261;
inline constexpr int right = 262, left = 263, down = 264, up = 265, pageUp = 266, pageDown = 267, home = 268, end = 269;
inline constexpr int f12 = 301, keypadEnter = 335, leftShift = 340, leftControl = 341, leftAlt = 342, leftSuper = 343;
inline constexpr int rightShift = 344, rightControl = 345, rightAlt = 346, rightSuper = 347;
inline constexpr int count = 348;
}  // namespace key

struct InputEvent {
    enum class Kind { move, button, scroll, key, text, leave };
    Kind kind = Kind::move;
    float x = 0, y = 0;   ///< move: pixels of the picture; scroll: steps, up and right positive
    int code = 0;         ///< button: 0 left, 1 right, 2 middle; key: see `key`; text: a Unicode code point
    bool isDown = false;  ///< button, key
};

}  // namespace testbed
