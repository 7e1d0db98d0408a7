// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Files that people name: read whole, or refused with what is wrong.

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace testbed {

/// The bytes of a file. Throws FileError if it cannot be read; `cure` says what to give instead.
[[nodiscard]] std::string ReadText(const std::filesystem::path& file, std::string_view cure);
/// The object in a JSON file. Throws FileError if it cannot be read or holds something else.
[[nodiscard]] nlohmann::ordered_json ReadJsonObject(const std::filesystem::path& file);

}  // namespace testbed
