// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The events of nlohmann's parser become nodes.

#include "testbed/input/json_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"

namespace testbed {

namespace {

/// Deeper than any file that we write; a few times that.
constexpr std::size_t deepest = 64;

/// Takes the events of the parser. A method that returns false ends parsing; `m_error` then says why.
class TreeBuilder {
public:
    explicit TreeBuilder(JsonNode& root) : m_root(&root) {}

    bool null() { return Add({}); }
    bool boolean(bool value) { return AddNumber(JsonNode::Kind::boolean, value ? 1.0 : 0.0, true); }
    bool number_integer(std::int64_t value) {
        return AddNumber(JsonNode::Kind::number, static_cast<double>(value), true);
    }
    bool number_unsigned(std::uint64_t value) {
        return AddNumber(JsonNode::Kind::number, static_cast<double>(value), true);
    }
    bool number_float(double value, const std::string&) { return AddNumber(JsonNode::Kind::number, value, false); }
    bool string(std::string& value) {
        JsonNode node;
        node.kind = JsonNode::Kind::string;
        node.keys.push_back(std::move(value));
        return Add(std::move(node));
    }
    bool binary(std::vector<std::uint8_t>&) { return false; }
    bool start_object(std::size_t) { return Open(JsonNode::Kind::object); }
    bool start_array(std::size_t) { return Open(JsonNode::Kind::array); }
    bool key(std::string& name) {
        m_open.back()->keys.push_back(std::move(name));
        return true;
    }
    bool end_object() {
        // Sorted, since an object of a hostile file may have a million keys.
        std::vector<std::string_view> keys(m_open.back()->keys.begin(), m_open.back()->keys.end());
        std::sort(keys.begin(), keys.end());
        if (const auto twice = std::adjacent_find(keys.begin(), keys.end()); twice != keys.end()) {
            m_error = fmt::format("the key {} stands twice in one object", QuoteJson(*twice));
            return false;
        }
        return Close();
    }
    bool end_array() { return Close(); }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception&) {
        m_position = position;
        return false;
    }

    [[nodiscard]] const std::string& GetError() const { return m_error; }
    /// Of what is no JSON: the number of its first wrong character, from 1; 0 if all was JSON.
    [[nodiscard]] std::size_t GetPosition() const { return m_position; }

private:
    bool AddNumber(JsonNode::Kind kind, double value, bool isWhole) {
        JsonNode node;
        node.kind = kind;
        node.number = value;
        node.isWhole = isWhole;
        return Add(std::move(node));
    }
    bool Add(JsonNode&& node) {
        Place() = std::move(node);
        return true;
    }
    bool Open(JsonNode::Kind kind) {
        if (m_open.size() == deepest) {
            m_error = fmt::format("nested deeper than {} levels", deepest);
            return false;
        }
        // Only the innermost open node grows, so that the addresses of those around it hold.
        JsonNode& node = Place();
        node.kind = kind;
        m_open.push_back(&node);
        return true;
    }
    bool Close() {
        m_open.pop_back();
        return true;
    }
    JsonNode& Place() { return m_open.empty() ? *m_root : m_open.back()->items.emplace_back(); }

    JsonNode* m_root;
    std::vector<JsonNode*> m_open;
    std::string m_error;
    std::size_t m_position = 0;
};

}  // namespace

const JsonNode* JsonNode::Find(std::string_view key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

std::string JsonPlace::Describe() const {
    std::string text = outer != nullptr ? outer->Describe() : "";
    if (index >= 0) return text + fmt::format("[{}]", index);
    if (!text.empty() && !key.empty()) text += '.';
    return text + std::string(key);
}

std::string_view NameOf(JsonNode::Kind kind) {
    switch (kind) {
        case JsonNode::Kind::null:
            return "null";
        case JsonNode::Kind::boolean:
            return "true or false";
        case JsonNode::Kind::number:
            return "a number";
        case JsonNode::Kind::string:
            return "a string";
        case JsonNode::Kind::array:
            return "an array";
        case JsonNode::Kind::object:
            break;
    }
    return "an object";
}

JsonNode ParseJson(std::string_view text, std::string_view source) {
    JsonNode root;
    TreeBuilder builder(root);
    if (nlohmann::json::sax_parse(text, &builder)) return root;
    std::string place, what = builder.GetError();
    if (const std::size_t position = builder.GetPosition(); position > 0) {
        const std::string_view before = text.substr(0, std::min(position - 1, text.size()));
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        const std::size_t lineStart = before.find_last_of('\n') + 1;  // npos + 1 is 0: the first line
        place = fmt::format(":{}:{}", line, before.size() - lineStart + 1);
        what = position > text.size() ? "the text ends too early"
                                      : fmt::format("unexpected {}", QuoteJson(text.substr(position - 1, 1)));
    }
    throw FileError(fmt::format("{}{}: not valid JSON: {}", source, place, what));
}

std::string QuoteJson(std::string_view text) { return PrintJson(nlohmann::json(text)); }

}  // namespace testbed
