// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Values of R.U.B.E. files. Numbers may be the bits of a float in hexadecimal, and the zero vector may be the number 0.
// What is missing is zero, false or empty.

#pragma once

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"
#include "testbed/base/errors.h"
#include "testbed/input/json_tree.h"

namespace testbed {

/// Values by key; what is missing has a value too. Throws FileError with the place and the cure.
class RubeValues {
public:
    explicit RubeValues(std::string_view source) : m_source(source) {}

    [[noreturn]] void Fail(const JsonPlace& place, const std::string& what) const {
        const std::string at = place.Describe();
        throw FileError(at.empty() ? fmt::format("{}: {}", m_source, what)
                                   : fmt::format("{}: {}: {}", m_source, at, what));
    }
    void Expect(const JsonNode& node, const JsonPlace& place, JsonNode::Kind kind) const {
        if (node.kind != kind) Fail(place, fmt::format("give {}, not {}", NameOf(kind), NameOf(node.kind)));
    }
    /// A number, or the bits of one as eight hexadecimal digits.
    [[nodiscard]] float ToFloat(const JsonNode& node, const JsonPlace& place) const {
        float value = 0.0f;
        if (node.kind == JsonNode::Kind::string) {
            std::uint32_t bits = 0;
            const char* const end = node.Text().data() + node.Text().size();
            const auto [stop, error] = std::from_chars(node.Text().data(), end, bits, 16);
            if (node.Text().size() != 8 || error != std::errc() || stop != end) {
                Fail(place, "give a number, or the bits of a float as eight hexadecimal digits such as \"3F800000\"");
            }
            value = std::bit_cast<float>(bits);
        } else {
            if (node.kind != JsonNode::Kind::number)
                Fail(place, fmt::format("give a number, not {}", NameOf(node.kind)));
            value = static_cast<float>(node.number);
        }
        if (!std::isfinite(value)) Fail(place, "give a finite number that fits a float (3.4e38)");
        return value;
    }
    [[nodiscard]] float Number(const JsonNode& node, const JsonPlace& place, std::string_view key,
                               float missing = 0.0f) const {
        const JsonNode* value = node.Find(key);
        return value == nullptr ? missing : ToFloat(*value, JsonPlace{&place, key});
    }
    /// {x, y}, or the number 0.
    [[nodiscard]] scenes::Vec2 Vector(const JsonNode& node, const JsonPlace& place, std::string_view key,
                                      scenes::Vec2 missing = {}) const {
        const JsonNode* value = node.Find(key);
        if (value == nullptr) return missing;
        const JsonPlace at{&place, key};
        if (value->kind == JsonNode::Kind::number && value->number == 0.0) return {};
        if (value->kind != JsonNode::Kind::object)
            Fail(at, "give {\"x\": number, \"y\": number}, or 0 for the zero vector");
        return {Number(*value, at, "x"), Number(*value, at, "y")};
    }
    [[nodiscard]] bool Flag(const JsonNode& node, const JsonPlace& place, std::string_view key,
                            bool missing = false) const {
        const JsonNode* value = node.Find(key);
        if (value == nullptr) return missing;
        const bool isBit = value->kind == JsonNode::Kind::number && (value->number == 0.0 || value->number == 1.0);
        if (value->kind != JsonNode::Kind::boolean && !isBit) Fail(JsonPlace{&place, key}, "give true or false");
        return value->number != 0.0;
    }
    [[nodiscard]] int Whole(const JsonNode& node, const JsonPlace& place, std::string_view key, int least, int most,
                            std::optional<int> missing = std::nullopt) const {
        const JsonNode* value = node.Find(key);
        if (value == nullptr && missing) return *missing;
        const bool isWhole = value != nullptr && value->kind == JsonNode::Kind::number && value->number >= least &&
                             value->number <= most && value->number == std::floor(value->number);
        if (!isWhole) Fail(JsonPlace{&place, key}, fmt::format("give a whole number from {} to {}", least, most));
        return static_cast<int>(value->number);
    }
    [[nodiscard]] std::string Text(const JsonNode& node, const JsonPlace& place, std::string_view key) const {
        const JsonNode* value = node.Find(key);
        if (value == nullptr) return {};
        Expect(*value, JsonPlace{&place, key}, JsonNode::Kind::string);
        return std::string(value->Text());
    }
    /// {"x": [...], "y": [...]}.
    [[nodiscard]] std::vector<scenes::Vec2> Points(const JsonNode& node, const JsonPlace& place) const {
        const JsonNode* value = node.Find("vertices");
        const JsonPlace at{&place, "vertices"};
        constexpr const char* cure = "give {\"x\": [numbers], \"y\": [as many]}";
        if (value == nullptr || value->kind != JsonNode::Kind::object) Fail(at, cure);
        const JsonNode *x = value->Find("x"), *y = value->Find("y");
        const bool arePaired = x != nullptr && y != nullptr && x->kind == JsonNode::Kind::array &&
                               y->kind == JsonNode::Kind::array && x->items.size() == y->items.size();
        if (!arePaired) Fail(at, cure);
        std::vector<scenes::Vec2> points;
        const JsonPlace atX{&at, "x"}, atY{&at, "y"};
        for (std::size_t i = 0; i < x->items.size(); ++i) {
            const int index = static_cast<int>(i);
            points.push_back(
                {ToFloat(x->items[i], JsonPlace{&atX, {}, index}), ToFloat(y->items[i], JsonPlace{&atY, {}, index})});
        }
        return points;
    }
    template <typename ReadItem>
    void List(const JsonNode& node, const JsonPlace& place, std::string_view key, ReadItem&& readItem) const {
        const JsonNode* list = node.Find(key);
        if (list == nullptr) return;
        const JsonPlace at{&place, key};
        Expect(*list, at, JsonNode::Kind::array);
        for (std::size_t i = 0; i < list->items.size(); ++i) {
            const JsonPlace here{&at, {}, static_cast<int>(i)};
            Expect(list->items[i], here, JsonNode::Kind::object);
            readItem(list->items[i], here);
        }
    }

private:
    std::string_view m_source;
};

}  // namespace testbed
