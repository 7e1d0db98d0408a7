// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The version of the Box2D library that is linked.

#include "testbed/engines/box2d_version.h"

#include <box2d/b2_common.h>
#include <fmt/format.h>

namespace testbed {

std::string GetBox2dVersion() {
    return fmt::format("{}.{}.{}", b2_version.major, b2_version.minor, b2_version.revision);
}

}  // namespace testbed
