// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A set of small numbers that is walked in order: a bit a number, and a bit for every 64 of these. So a walk costs what
// is in the set and hardly what could be. Insert and Erase are O(1).

#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/bytes.h"

namespace scree {

/// Numbers are ints, or indices of one kind.
template <typename I = int>
class IndexSet {
public:
    [[nodiscard]] bool Has(I index) const {
        const size_t word = WordOf(index);
        return word < m_words.size() && (m_words[word] >> BitOf(index) & 1u) != 0;
    }
    [[nodiscard]] int Count() const { return m_count; }
    [[nodiscard]] bool IsEmpty() const { return m_count == 0; }

    /// Room for the numbers below `count`: Insert of one of them cannot fail.
    void Reserve(size_t count) {
        if (count > 64 * m_words.size()) Grow(count);
    }
    /// True if it was not in the set.
    bool Insert(I index) {
        Reserve(ToSize(index) + 1);
        uint64_t& word = m_words[WordOf(index)];
        const uint64_t bit = uint64_t{1} << BitOf(index);
        if ((word & bit) != 0) return false;
        word |= bit;
        m_summary[WordOf(index) / 64] |= uint64_t{1} << (WordOf(index) % 64);
        ++m_count;
        return true;
    }
    /// True if it was in the set.
    bool Erase(I index) {
        if (!Has(index)) return false;
        uint64_t& word = m_words[WordOf(index)];
        word &= ~(uint64_t{1} << BitOf(index));
        if (word == 0) m_summary[WordOf(index) / 64] &= ~(uint64_t{1} << (WordOf(index) % 64));
        --m_count;
        return true;
    }
    void Clear() {
        ForEachWord([this](size_t word) { m_words[word] = 0; });
        m_summary.assign(m_summary.size(), 0);
        m_count = 0;
    }

    /// The largest number below `end`, −1 if there is none.
    [[nodiscard]] I Before(I end) const {
        const I last{ToInt(end) - 1};
        if (ToInt(last) < 0 || m_words.empty()) return I{-1};
        size_t word = WordOf(last);
        uint64_t bits = 0;
        if (word < m_words.size()) {
            bits = m_words[word] & UpTo(BitOf(last));
        } else {
            word = m_words.size();
        }
        while (bits == 0) {
            if (word == 0) return I{-1};
            // The next word below that has bits, by the summary.
            size_t block = (word - 1) / 64;
            uint64_t words = m_summary[block] & UpTo((word - 1) % 64);
            while (words == 0) {
                if (block == 0) return I{-1};
                words = m_summary[--block];
            }
            word = 64 * block + static_cast<size_t>(63 - std::countl_zero(words));
            bits = m_words[word];
        }
        return I{static_cast<int>(64 * word) + 63 - std::countl_zero(bits)};
    }

    /// Calls visit(number) in ascending order. What it inserts or erases may be missed or visited.
    template <typename Visit>
    void ForEach(Visit&& visit) const {
        ForEachWord([&](size_t word) {
            for (uint64_t bits = m_words[word]; bits != 0; bits &= bits - 1) {
                visit(I{static_cast<int>(64 * word) + std::countr_zero(bits)});
            }
        });
    }
    /// The same for those in [begin, end). O(end − begin), so it is for parts of a set that is not sparse.
    template <typename Visit>
    void ForEachBetween(I begin, I end, Visit&& visit) const {
        const size_t last = std::min(WordOf(end), m_words.size());
        const auto visitAll = [&](size_t word, uint64_t bits) {
            for (; bits != 0; bits &= bits - 1) visit(I{static_cast<int>(64 * word) + std::countr_zero(bits)});
        };
        const uint64_t below = (uint64_t{1} << BitOf(end)) - 1;
        uint64_t mask = ~((uint64_t{1} << BitOf(begin)) - 1);
        for (size_t word = WordOf(begin); word < last; ++word, mask = ~uint64_t{0})
            visitAll(word, m_words[word] & mask);
        if (WordOf(end) >= m_words.size()) return;
        visitAll(WordOf(end), m_words[WordOf(end)] & below & (WordOf(begin) == WordOf(end) ? mask : ~uint64_t{0}));
    }
    /// Calls visit(64 · k) for each run of 64 numbers from there on that has some of the set.
    template <typename Visit>
    void ForEachRun(Visit&& visit) const {
        ForEachWord([&](size_t word) { visit(64 * word); });
    }

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_words, m_summary); }

private:
    static size_t WordOf(I index) { return ToSize(index) / 64; }
    static unsigned BitOf(I index) { return static_cast<unsigned>(ToInt(index)) % 64; }
    /// The bits 0 … bit.
    static uint64_t UpTo(size_t bit) { return ~uint64_t{0} >> (63 - bit); }

    void Grow(size_t count) {
        const size_t words = std::bit_ceil((count + 63) / 64);
        m_summary.resize((words + 63) / 64, 0);
        m_words.resize(words, 0);
    }

    template <typename Visit>
    void ForEachWord(Visit&& visit) const {
        for (size_t block = 0; block < m_summary.size(); ++block) {
            for (uint64_t words = m_summary[block]; words != 0; words &= words - 1) {
                visit(64 * block + static_cast<size_t>(std::countr_zero(words)));
            }
        }
    }

    std::vector<uint64_t> m_words;
    std::vector<uint64_t> m_summary;  ///< bit w: word w is not 0
    int m_count = 0;
};

}  // namespace scree
