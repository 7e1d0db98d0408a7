// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Judges a law of mechanics in both engines and keeps the table of what was measured: exact value and measured values →
// expectations, and one printed row. The rule: this library is within a stated tolerance of the exact value. It is
// never more than 5 % further from it than Box2D 2.4.1 in the same run. Its soft step of four sub-steps is within the
// tolerance too, or at least no further from the exact value than sequential impulses.

#pragma once

#include <limits>
#include <string>

namespace scree::test {

/// For laws that 8 velocity and 3 position iterations cannot meet: only Box2D's own error bounds them.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// What is measured and how near it must be.
struct Law {
    std::string name;  ///< with the unit
    double exact = 0.0;
    double tolerance = unbounded;  ///< largest |ours − exact|
    /// Errors up to this are the rounding of floats, different in every order of additions: not compared with Box2D's.
    double rounding = 0.0;
    bool ofSequential = false;  ///< a law of how sequential impulses move bodies: the soft step is not judged
};

/// The same measurement in both engines, in ours by either solver.
template <class T>
struct Both {
    T ours, box2d, soft;
};

/// Adds the row and expects the law.
void Judge(const Law& law, Both<double> measured);

}  // namespace scree::test
