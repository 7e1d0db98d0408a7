// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A sum together with what rounding took from it (Knuth, "The Art of Computer Programming" 2, 4.2.2).

#pragma once

namespace scree {

struct RoundedSum {
    float sum;   ///< nearest to a + b
    float rest;  ///< a + b − sum, exactly
};

/// For finite numbers whose sum is finite, in any order of sizes.
inline RoundedSum TwoSum(float a, float b) {
    const float sum = a + b;
    const float added = sum - a;
    return {sum, (a - (sum - added)) + (b - added)};
}

}  // namespace scree
