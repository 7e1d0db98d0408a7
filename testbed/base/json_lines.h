// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Files of JSON lines, one object a line, as a command's `--json` writes them (base/case_lines.h).

#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace testbed {

/// Calls `read` with the object of every line of a text that `scree COMMAND --json` or `scree merge` wrote; what `read`
/// throws says what its fields lack. Throws FileError that names `file`, line, command and fault.
void ParseJsonLines(const std::string& file, std::string_view text, std::string_view command,
                    const std::function<void(const nlohmann::ordered_json& object)>& read);

}  // namespace testbed
