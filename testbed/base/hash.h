// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// FNV-1a (Fowler, Noll, Vo 1991): enough to see that something changed. It is defined over bytes; taking wider words
// whole is quicker and still lets every changed word show.

#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

namespace testbed {

template <std::unsigned_integral Word>
class Fnv1a {
public:
    static_assert(sizeof(Word) == 4 || sizeof(Word) == 8);

    /// A byte, or a word as a whole.
    constexpr void Add(Word part) { m_hash = (m_hash ^ part) * prime; }
    /// The four bytes of a word, the lowest first.
    constexpr void AddBytes(uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) Add(word >> shift & 255u);
    }
    constexpr void Add(std::string_view text) {
        for (const char c : text) Add(Word{static_cast<unsigned char>(c)});
    }
    [[nodiscard]] constexpr Word Get() const { return m_hash; }

private:
    static constexpr Word prime = sizeof(Word) == 8 ? static_cast<Word>(0x100000001b3u) : Word{0x01000193u};
    Word m_hash = sizeof(Word) == 8 ? static_cast<Word>(0xcbf29ce484222325u) : Word{0x811c9dc5u};
};

}  // namespace testbed
