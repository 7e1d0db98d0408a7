// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The version of the Box2D library that is linked, for reports.

#pragma once

#include <string>

namespace testbed {

/// For example "2.4.1".
[[nodiscard]] std::string GetBox2dVersion();

}  // namespace testbed
