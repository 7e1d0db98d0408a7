// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Doubles → pairs of floats.

#include "scree/far_position.h"

#include "base/compiler.h"

namespace scree {

namespace {

struct Split {
    float nearest, rest;
};

/// One number, and not in line: side by side g++ 12 makes vectors of two, of which it drops the way to float and back.
SCREE_NOINLINE Split SplitDouble(double x) {
    const auto nearest = static_cast<float>(x);
    return {nearest, static_cast<float>(x - static_cast<double>(nearest))};
}

}  // namespace

FarPosition ToFarPosition(double x, double y) {
    const Split sx = SplitDouble(x), sy = SplitDouble(y);
    return {{sx.nearest, sy.nearest}, {sx.rest, sy.rest}};
}

}  // namespace scree
