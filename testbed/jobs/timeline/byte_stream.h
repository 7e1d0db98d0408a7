// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The numbers of a page, step by step, as timeline_data.js reads them: each step begins with its length in bytes.

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace testbed {

class ByteStream {
public:
    /// What is put from here on belongs to a new step.
    void BeginStep() {
        m_stepAt = m_bytes.size();
        m_bytes.resize(m_stepAt + 4);
    }
    void EndStep() {
        const auto size = static_cast<std::uint32_t>(m_bytes.size() - m_stepAt - 4);
        for (std::size_t i = 0; i < 4; ++i) m_bytes[m_stepAt + i] = static_cast<unsigned char>(size >> (8 * i));
    }

    void PutByte(unsigned value) { m_bytes.push_back(static_cast<unsigned char>(value)); }
    /// 16 bits, the lower byte first.
    void PutWord(unsigned value) {
        PutByte(value & 0xFF);
        PutByte(value >> 8 & 0xFF);
    }
    /// Seven bits a byte, the lowest first; the highest bit: more follow.
    void PutNumber(std::uint32_t value) {
        for (; value >= 0x80; value >>= 7) PutByte((value & 0x7F) | 0x80);
        PutByte(value);
    }
    /// A number whose lowest bit is the sign.
    void PutSigned(std::int32_t value) {
        PutNumber((static_cast<std::uint32_t>(value) << 1) ^ static_cast<std::uint32_t>(value >> 31));
    }
    /// The upper half of a float: eight bits of precision.
    void PutReal(float value) { PutWord(std::bit_cast<std::uint32_t>(value) >> 16); }
    /// All bits of a float, the lowest first.
    void PutFloat(float value) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        PutWord(bits & 0xFFFF);
        PutWord(bits >> 16);
    }
    void Append(const ByteStream& other) { m_bytes.insert(m_bytes.end(), other.m_bytes.begin(), other.m_bytes.end()); }

    [[nodiscard]] std::size_t GetSize() const { return m_bytes.size(); }
    /// A zlib stream of it in base64. Throws FileError when memory runs out.
    [[nodiscard]] std::string Pack() const;

private:
    std::vector<unsigned char> m_bytes;
    std::size_t m_stepAt = 0;
};

}  // namespace testbed
