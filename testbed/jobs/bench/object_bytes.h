// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What one body, fixture, contact and joint costs in memory. Two worlds differ in one kind of object: the second has
// twice as many. The cost is the difference of the heaps over the difference of the counts. It is the mean over several
// counts, since arrays grow by a factor: at some counts they have no room to spare, at others much.

#pragma once

#include <string>
#include <string_view>

namespace testbed {

/// Heap bytes per object. Those of a contact include the arrays of the solver that grow with it.
struct ObjectBytes {
    double body = 0;
    double fixture = 0;  ///< a box with its place in the broad phase
    double contact = 0;  ///< of two touching circles
    double joint = 0;    ///< revolute
};

/// Measures them. The heap of the process must not be used by another thread meanwhile.
[[nodiscard]] ObjectBytes MeasureObjectBytes(std::string_view engine);

/// One line.
[[nodiscard]] std::string FormatObjectBytes(std::string_view engine, const ObjectBytes& bytes);

}  // namespace testbed
