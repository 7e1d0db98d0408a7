// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// JSON text as a tree that a reader walks: no key twice, no deeper than it has to be, and memory in proportion to the
// text. Parsing is nlohmann's.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace testbed {

struct JsonNode {
    enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    bool isWhole = false;           ///< number: written without fraction and exponent, and within 64 bits
    double number = 0.0;            ///< number; boolean: 0 or 1
    std::vector<std::string> keys;  ///< object: of its items; string: itself, since large files are mostly numbers
    std::vector<JsonNode> items;    ///< array, object

    /// Of a string; nothing of another kind.
    [[nodiscard]] std::string_view Text() const {
        return kind == Kind::string ? std::string_view(keys.front()) : std::string_view();
    }

    /// The item of that key, or nullptr.
    [[nodiscard]] const JsonNode* Find(std::string_view key) const;
};

/// Where in a tree a node stands: "bodies[12].angle". The text is only made for messages.
struct JsonPlace {
    const JsonPlace* outer = nullptr;  ///< has to live as long
    std::string_view key{};            ///< in an object
    int index = -1;                    ///< in an array

    [[nodiscard]] std::string Describe() const;
};

/// What a kind is called in messages: "a number", "an object" …
[[nodiscard]] std::string_view NameOf(JsonNode::Kind kind);

/// The tree of a whole text. Throws FileError with `source`, line and column for text that is no JSON, has a key twice
/// in one object, or nests deeper than 64 levels.
[[nodiscard]] JsonNode ParseJson(std::string_view text, std::string_view source);

/// A string as JSON, quotes included; what is no UTF-8 becomes U+FFFD.
[[nodiscard]] std::string QuoteJson(std::string_view text);

}  // namespace testbed
