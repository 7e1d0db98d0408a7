// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// CBOR (RFC 8949) read item by item, without copies: of items with their length in front, which is what tracks are made
// of. A reader's memory never depends on what a length claims, only on the bytes that are there.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "testbed/input/json_tree.h"

namespace testbed {

using ByteSpan = std::span<const std::uint8_t>;

/// What an item is; the values of an array or a map follow as items of their own.
struct CborItem {
    enum class Kind : std::uint8_t { whole, number, boolean, null, text, bytes, array, map };

    Kind kind = Kind::null;
    std::int64_t whole = 0;   ///< whole; beyond 63 bits: the nearest
    double number = 0.0;      ///< whole, number; boolean: 0 or 1
    std::uint64_t count = 0;  ///< array: items; map: pairs
    ByteSpan bytes;           ///< text, bytes
    std::size_t at = 0;       ///< where it begins, from the first byte of the reader's span

    [[nodiscard]] std::string_view Text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// Goes through items. Everything wrong throws FileError: `context`, the place in the file and the cure.
class CborReader {
public:
    /// `context` names file and record, and `offset` is the byte of the file (or of a block that was inflated) at which
    /// the bytes begin.
    CborReader(ByteSpan bytes, std::string_view context, std::size_t offset)
        : m_bytes(bytes), m_context(context), m_offset(offset) {}

    [[nodiscard]] CborItem Next();
    /// Passes over one item with all that it holds.
    void Skip();
    [[nodiscard]] bool IsAtEnd() const { return m_position == m_bytes.size(); }
    [[nodiscard]] std::size_t GetPosition() const { return m_position; }
    void SetPosition(std::size_t position) { m_position = position; }

    // Items of a kind; anything else is an error that names `what`.
    std::uint64_t NextMap(std::string_view what) { return Next(CborItem::Kind::map, what).count; }
    std::uint64_t NextArray(std::string_view what) { return Next(CborItem::Kind::array, what).count; }
    std::string_view NextText(std::string_view what) { return Next(CborItem::Kind::text, what).Text(); }
    ByteSpan NextBytes(std::string_view what) { return Next(CborItem::Kind::bytes, what).bytes; }
    bool NextFlag(std::string_view what) { return Next(CborItem::Kind::boolean, what).number != 0.0; }
    std::int64_t NextWhole(std::string_view what, std::int64_t least, std::int64_t most);
    float NextFloat(std::string_view what);
    /// The next item and all that it holds as a tree; no deeper than what scenes need.
    [[nodiscard]] JsonNode NextTree() { return NextTree(0); }

    /// Throws for something wrong with what was read last.
    [[noreturn]] void Fail(std::string_view what) const { FailAt(m_last, what); }

private:
    CborItem Next(CborItem::Kind kind, std::string_view what);
    JsonNode NextTree(int depth);
    [[noreturn]] void FailAt(std::size_t position, std::string_view what) const;

    ByteSpan m_bytes;
    std::string m_context;
    std::size_t m_offset;
    std::size_t m_position = 0, m_last = 0;
};

}  // namespace testbed
