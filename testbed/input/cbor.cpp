// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of cbor.h.

#include "testbed/input/cbor.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "testbed/base/errors.h"

namespace testbed {

namespace {

/// As deep as text may be (json_tree.cpp).
constexpr int deepest = 64;

std::string_view NameOf(CborItem::Kind kind) {
    switch (kind) {
        case CborItem::Kind::whole:
            return "a whole number";
        case CborItem::Kind::number:
            return "a number";
        case CborItem::Kind::boolean:
            return "true or false";
        case CborItem::Kind::null:
            return "null";
        case CborItem::Kind::text:
            return "text";
        case CborItem::Kind::bytes:
            return "bytes";
        case CborItem::Kind::array:
            return "an array";
        case CborItem::Kind::map:
            break;
    }
    return "a map";
}

/// RFC 8949, appendix D.
double FromHalf(std::uint64_t half) {
    const int exponent = static_cast<int>(half >> 10 & 0x1F);
    const double mantissa = static_cast<double>(half & 0x3FF);
    double value = exponent == 0    ? std::ldexp(mantissa, -24)
                   : exponent != 31 ? std::ldexp(mantissa + 1024.0, exponent - 25)
                   : mantissa == 0  ? std::numeric_limits<double>::infinity()
                                    : std::numeric_limits<double>::quiet_NaN();
    return (half & 0x8000) != 0 ? -value : value;
}

CborItem Number(double value, std::size_t at) {
    CborItem item;
    item.kind = CborItem::Kind::number;
    item.number = value;
    item.at = at;
    return item;
}

}  // namespace

void CborReader::FailAt(std::size_t position, std::string_view what) const {
    throw FileError(fmt::format("{}, byte {}: {}", m_context, m_offset + position, what));
}

CborItem CborReader::Next() {
    m_last = m_position;
    const std::size_t left = m_bytes.size() - m_position;
    if (left == 0) Fail("ends too early; record it again");
    const std::uint8_t head = m_bytes[m_position];
    const int major = head >> 5, low = head & 31;
    if (low > 27) Fail("a length that comes later, or no CBOR; give items with their length in front");
    const std::size_t size = low < 24 ? 0 : std::size_t{1} << (low - 24);
    if (left < 1 + size) Fail("ends within an item; record it again");
    std::uint64_t value = static_cast<std::uint64_t>(low);
    if (size > 0) value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | m_bytes[m_position + 1 + i];
    m_position += 1 + size;
    const std::size_t rest = m_bytes.size() - m_position;
    CborItem item;
    item.at = m_last;
    switch (major) {
        case 0:
        case 1: {
            constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
            const std::int64_t near = static_cast<std::int64_t>(value > most ? most : value);
            item.kind = CborItem::Kind::whole;
            item.whole = major == 0 ? near : -1 - near;
            item.number = major == 0 ? static_cast<double>(value) : -1.0 - static_cast<double>(value);
            return item;
        }
        case 2:
        case 3:
            if (value > rest) Fail("a string is longer than the file; record it again");
            item.kind = major == 2 ? CborItem::Kind::bytes : CborItem::Kind::text;
            item.bytes = m_bytes.subspan(m_position, static_cast<std::size_t>(value));
            m_position += static_cast<std::size_t>(value);
            return item;
        case 4:
        case 5:
            // Each item takes a byte at least.
            if (value > rest / (major == 4 ? 1 : 2)) Fail("a list is longer than the file; record it again");
            item.kind = major == 4 ? CborItem::Kind::array : CborItem::Kind::map;
            item.count = value;
            return item;
        case 7:
            if (low == 25) return Number(FromHalf(value), m_last);
            if (low == 26) {
                return Number(double{std::bit_cast<float>(static_cast<std::uint32_t>(value))}, m_last);
            }
            if (low == 27) return Number(std::bit_cast<double>(value), m_last);
            if (low == 20 || low == 21) {
                item.kind = CborItem::Kind::boolean;
                item.number = low == 21 ? 1.0 : 0.0;
                return item;
            }
            if (low == 22 || low == 23) return item;
            break;
        default:
            break;
    }
    Fail("a tag or a value that tracks do not have; leave it out");
}

CborItem CborReader::Next(CborItem::Kind kind, std::string_view what) {
    const CborItem item = Next();
    if (item.kind != kind) Fail(fmt::format("{}: give {}, not {}", what, NameOf(kind), NameOf(item.kind)));
    return item;
}

void CborReader::Skip() {
    // Never more than the bytes that are left, since each item takes one at least.
    std::uint64_t pending = 1;
    for (; pending > 0; --pending) {
        const CborItem item = Next();
        const std::uint64_t values = item.kind == CborItem::Kind::map ? 2 * item.count : item.count;
        pending += values;
        if (pending - 1 > m_bytes.size() - m_position) Fail("lists are longer than the file; record it again");
    }
}

std::int64_t CborReader::NextWhole(std::string_view what, std::int64_t least, std::int64_t most) {
    const CborItem item = Next(CborItem::Kind::whole, what);
    if (item.whole < least || item.whole > most) {
        Fail(fmt::format("{}: give a whole number from {} to {}", what, least, most));
    }
    return item.whole;
}

float CborReader::NextFloat(std::string_view what) {
    const CborItem item = Next();
    if (item.kind != CborItem::Kind::number && item.kind != CborItem::Kind::whole) {
        Fail(fmt::format("{}: give a number, not {}", what, NameOf(item.kind)));
    }
    return static_cast<float>(item.number);
}

JsonNode CborReader::NextTree(int depth) {
    const CborItem item = Next();
    JsonNode node;
    node.number = item.number;
    switch (item.kind) {
        case CborItem::Kind::null:
            break;
        case CborItem::Kind::boolean:
            node.kind = JsonNode::Kind::boolean;
            node.isWhole = true;
            break;
        case CborItem::Kind::whole:
        case CborItem::Kind::number:
            node.kind = JsonNode::Kind::number;
            node.isWhole = item.kind == CborItem::Kind::whole;
            break;
        case CborItem::Kind::text:
            node.kind = JsonNode::Kind::string;
            node.keys.emplace_back(item.Text());
            break;
        case CborItem::Kind::bytes:
            Fail("bytes where a scene has none; leave them out");
        case CborItem::Kind::array:
        case CborItem::Kind::map: {
            if (depth == deepest) Fail(fmt::format("nested deeper than {} levels", deepest));
            const bool isMap = item.kind == CborItem::Kind::map;
            node.kind = isMap ? JsonNode::Kind::object : JsonNode::Kind::array;
            for (std::uint64_t i = 0; i < item.count; ++i) {
                if (isMap) node.keys.emplace_back(NextText("a key"));
                node.items.push_back(NextTree(depth + 1));
            }
            // Sorted, since a map of a hostile file may have a million keys.
            std::vector<std::string_view> keys(node.keys.begin(), node.keys.end());
            std::sort(keys.begin(), keys.end());
            if (const auto twice = std::adjacent_find(keys.begin(), keys.end()); twice != keys.end()) {
                FailAt(item.at, fmt::format("the key {} stands twice in one map", QuoteJson(*twice)));
            }
            break;
        }
    }
    return node;
}

}  // namespace testbed
