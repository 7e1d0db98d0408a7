// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of json_lines.h.

#include "testbed/base/json_lines.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "testbed/base/errors.h"
#include "testbed/base/text.h"

namespace testbed {

void ParseJsonLines(const std::string& file, std::string_view text, std::string_view command,
                    const std::function<void(const nlohmann::ordered_json& object)>& read) {
    ForEachLine(text, [&](std::size_t number, std::string_view line) {
        try {
            const auto object = nlohmann::ordered_json::parse(line);
            if (!object.is_object()) throw std::invalid_argument("not a JSON object");
            read(object);
        } catch (const std::exception& error) {  // of the parser, of a missing field, or of a value that is none
            throw FileError(
                fmt::format("{}:{}: not a line of `scree {} --json`: {}", file, number, command, error.what()));
        }
    });
}

}  // namespace testbed
