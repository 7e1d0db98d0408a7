// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Files that people name.

#include "testbed/base/input.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"

namespace testbed {

std::string ReadText(const std::filesystem::path& file, std::string_view cure) {
    if (std::filesystem::is_directory(file)) throw FileError(fmt::format("{}: a folder; {}", file.string(), cure));
    std::ifstream stream(file, std::ios::binary);
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::is_regular_file(file) ? std::filesystem::file_size(file, failure) : 0;
    constexpr std::size_t more = 1 << 16;  // of a pipe, or of a file that grows
    std::string text;
    std::size_t count = 0;
    for (std::size_t room = (failure ? 0 : size) + more; stream; room = more + text.size()) {
        text.resize(count + room);
        stream.read(text.data() + count, static_cast<std::streamsize>(room));
        count += static_cast<std::size_t>(stream.gcount());
    }
    text.resize(count);
    if (!stream.is_open() || stream.bad()) throw FileError(fmt::format("{}: cannot be read; {}", file.string(), cure));
    return text;
}

nlohmann::ordered_json ReadJsonObject(const std::filesystem::path& file) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(ReadText(file, "check its path"), nullptr, false);
    if (!json.is_object()) throw FileError(fmt::format("{}: not a JSON object", file.string()));
    return json;
}

}  // namespace testbed
