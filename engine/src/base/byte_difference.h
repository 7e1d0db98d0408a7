// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What differs between two states of an array, word by word: 64 bytes at a time a mask of the words that changed, then
// these words. A mask of 0 stands in front of the number of blocks in a row that are equal. A base that is shorter
// counts as if zeros followed.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "base/leave_raw.h"

namespace scree {

namespace difference {

constexpr size_t wordsPerBlock = 16, bytesPerBlock = wordsPerBlock * sizeof(uint32_t);
constexpr size_t mostEqualBlocks = UINT16_MAX;
/// Bytes behind the last array, since four words are read and written at once.
constexpr size_t padding = 4 * sizeof(uint32_t);
using Block = std::array<uint32_t, wordsPerBlock>;

/// The block from this byte on; zeros behind the end.
inline Block BlockAt(std::span<const std::byte> bytes, size_t begin) {
    Block block{};
    if (begin >= bytes.size()) return block;
    std::memcpy(block.data(), bytes.data() + begin, std::min(bytesPerBlock, bytes.size() - begin));
    return block;
}

}  // namespace difference

class DifferenceWriter {
public:
    using Bytes = std::vector<std::byte, LeaveRaw<std::byte>>;

    /// Starts anew in this buffer.
    explicit DifferenceWriter(Bytes& out) : m_out(out) { m_out.clear(); }
    /// Adds the difference that makes `now` of `base`.
    void Add(std::span<const std::byte> base, std::span<const std::byte> now) {
        using namespace difference;
        const size_t blocks = (now.size() + bytesPerBlock - 1) / bytesPerBlock;
        m_out.resize(m_size + sizeof(uint64_t) + blocks * (sizeof(uint16_t) + bytesPerBlock) + difference::padding);
        m_end = m_out.data() + m_size;
        Put(static_cast<uint64_t>(now.size()));
        size_t equal = 0;
        for (size_t at = 0; at < now.size(); at += bytesPerBlock) {
            const bool areWhole = at + bytesPerBlock <= std::min(base.size(), now.size());
            if (areWhole && std::memcmp(base.data() + at, now.data() + at, bytesPerBlock) == 0) {
                ++equal;
                continue;
            }
            PutEqual(equal);
            equal = 0;
            if (areWhole) {
                PutBlock(base.data() + at, now.data() + at);
            } else {
                PutBlock(BlockAt(base, at).data(), BlockAt(now, at).data());
            }
        }
        PutEqual(equal);
        m_size = static_cast<size_t>(m_end - m_out.data());
        m_out.resize(m_size + difference::padding);
    }

private:
    template <typename T>
    void Put(T number) {
        std::memcpy(m_end, &number, sizeof number);
        m_end += sizeof number;
    }
    void PutEqual(size_t blocks) {
        while (blocks > 0) {
            const size_t now = std::min(blocks, difference::mostEqualBlocks);
            Put(uint16_t{0});
            Put(static_cast<uint16_t>(now));
            blocks -= now;
        }
    }
    /// Without a branch, since which words differ has no pattern, and four words at a time: where they go is one sum.
    /// Words that do not differ are written too; the next one is written over them.
    void PutBlock(const void* base, const void* now) {
        std::byte* end = m_end + sizeof(uint16_t);
        uint32_t mask = 0;
        for (uint32_t i = 0; i < difference::wordsPerBlock; i += 4) {
            uint32_t before[4], words[4];
            std::memcpy(before, static_cast<const uint32_t*>(base) + i, sizeof before);
            std::memcpy(words, static_cast<const uint32_t*>(now) + i, sizeof words);
            const uint32_t d0 = words[0] != before[0], d1 = words[1] != before[1], d2 = words[2] != before[2],
                           d3 = words[3] != before[3];
            const uint32_t n2 = d0 + d1, n3 = n2 + d2;
            std::memcpy(end, &words[0], sizeof(uint32_t));
            std::memcpy(end + sizeof(uint32_t) * d0, &words[1], sizeof(uint32_t));
            std::memcpy(end + sizeof(uint32_t) * n2, &words[2], sizeof(uint32_t));
            std::memcpy(end + sizeof(uint32_t) * n3, &words[3], sizeof(uint32_t));
            end += sizeof(uint32_t) * (n3 + d3);
            mask |= (d0 | d1 << 1 | d2 << 2 | d3 << 3) << i;
        }
        Put(static_cast<uint16_t>(mask));
        if (mask == 0) {
            Put(uint16_t{1});
        } else {
            m_end = end;
        }
    }

    Bytes& m_out;
    size_t m_size = 0;  ///< without padding
    std::byte* m_end = nullptr;
};

/// Reads what a DifferenceWriter has written, in the same order, with the same bases.
class DifferenceReader {
public:
    explicit DifferenceReader(std::span<const std::byte> in) : m_in(in.data()) {}
    /// Bytes of the next array.
    [[nodiscard]] size_t NextSize() const {
        uint64_t size = 0;
        std::memcpy(&size, m_in, sizeof size);
        return static_cast<size_t>(size);
    }
    /// Makes the next array of `base`; `out` has its size.
    void Read(std::span<const std::byte> base, std::span<std::byte> out) {
        using namespace difference;
        Take<uint64_t>();
        for (size_t at = 0; at < out.size();) {
            const uint32_t mask = Take<uint16_t>();
            size_t blocks = mask == 0 ? Take<uint16_t>() : 1;
            const size_t end = std::min(out.size(), at + blocks * bytesPerBlock);
            if (mask == 0 && end <= base.size()) {
                std::memcpy(out.data() + at, base.data() + at, end - at);
                at = end;
                continue;
            }
            for (; at < end; at += bytesPerBlock) {
                if (at + bytesPerBlock <= std::min(base.size(), out.size())) {
                    ChangeBlock(base.data() + at, out.data() + at, mask);
                    continue;
                }
                Block block = BlockAt(base, at);
                ChangeBlock(block.data(), block.data(), mask);
                std::memcpy(out.data() + at, block.data(), std::min(bytesPerBlock, out.size() - at));
            }
        }
    }

private:
    template <typename T>
    T Take() {
        T number;
        std::memcpy(&number, m_in, sizeof number);
        m_in += sizeof number;
        return number;
    }
    /// The way back of PutBlock.
    void ChangeBlock(const void* base, void* out, uint32_t mask) {
        for (uint32_t i = 0; i < difference::wordsPerBlock; i += 4, mask >>= 4) {
            const uint32_t d0 = mask & 1, d1 = mask >> 1 & 1, d2 = mask >> 2 & 1, d3 = mask >> 3 & 1;
            const uint32_t n2 = d0 + d1, n3 = n2 + d2;
            uint32_t words[4], changed[4];
            std::memcpy(words, static_cast<const uint32_t*>(base) + i, sizeof words);
            std::memcpy(&changed[0], m_in, sizeof(uint32_t));
            std::memcpy(&changed[1], m_in + sizeof(uint32_t) * d0, sizeof(uint32_t));
            std::memcpy(&changed[2], m_in + sizeof(uint32_t) * n2, sizeof(uint32_t));
            std::memcpy(&changed[3], m_in + sizeof(uint32_t) * n3, sizeof(uint32_t));
            m_in += sizeof(uint32_t) * (n3 + d3);
            words[0] ^= (words[0] ^ changed[0]) & (0 - d0);
            words[1] ^= (words[1] ^ changed[1]) & (0 - d1);
            words[2] ^= (words[2] ^ changed[2]) & (0 - d2);
            words[3] ^= (words[3] ^ changed[3]) & (0 - d3);
            std::memcpy(static_cast<uint32_t*>(out) + i, words, sizeof words);
        }
    }

    const std::byte* m_in;
};

}  // namespace scree
