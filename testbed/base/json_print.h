// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// JSON as text, also of names that are no UTF-8, as names of files may be.

#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace testbed {

/// The text of a value; bytes that are no UTF-8 become U+FFFD, so that nothing is thrown. `indent` as dump() takes it:
/// −1 puts all in one line.
template <typename Json>
[[nodiscard]] std::string PrintJson(const Json& value, int indent = -1) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace testbed
