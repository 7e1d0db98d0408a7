// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Values → bytes and bytes → values. Both ends walk over the same lists of fields (base/field_list.h), so that what
// one writes the other reads. Numbers are stored as the machine has them; the reader checks every length before it
// believes it and stays at its first failure.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "base/index.h"

namespace scree {

template <typename T>
inline constexpr bool isNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class ImageWriter {
public:
    template <typename... T>
    void operator()(const T&... values) {
        (Write(values), ...);
    }
    template <typename Table, typename... Columns>
    void Rows(const Table&, const Columns&... columns) {
        (Write(columns), ...);
    }
    template <typename... T>
    void Stored(const T&... values) {
        (Write(values), ...);
    }
    template <typename... T>
    void Hashed(const T&...) {}
    template <typename... T>
    void LeftOut(const T&...) {}
    void Append(std::span<const std::byte> bytes) { m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end()); }
    [[nodiscard]] std::vector<std::byte>& Bytes() { return m_bytes; }

private:
    template <typename T>
    void Write(const T& value) {
        if constexpr (isNumber<T>) {
            T known = value;
            if constexpr (std::is_floating_point_v<T>) {
                if (std::isnan(value)) known = T(0);  // what a step takes an impulse for that is none
            }
            const auto* bytes = reinterpret_cast<const std::byte*>(&known);
            m_bytes.insert(m_bytes.end(), bytes, bytes + sizeof(T));
        } else if constexpr (std::is_array_v<T>) {
            for (const auto& element : value) Write(element);
        } else {
            Fields(value, *this);
        }
    }
    template <AnyColumn T>
    void Write(const T& values) {
        Write(static_cast<uint32_t>(values.size()));
        for (const auto& value : values) Write(value);
    }

    std::vector<std::byte> m_bytes;
};

class ImageReader {
public:
    explicit ImageReader(std::span<const std::byte> bytes) : m_bytes(bytes) {}

    template <typename... T>
    void operator()(T&... values) {
        (Read(values), ...);
    }
    template <typename Table, typename... Columns>
    void Rows(const Table&, Columns&... columns) {
        (Read(columns), ...);
    }
    template <typename... T>
    void Stored(T&... values) {
        (Read(values), ...);
    }
    template <typename... T>
    void Hashed(const T&...) {}
    template <typename... T>
    void LeftOut(const T&...) {}
    /// The next bytes as they are; empty and failed if there are fewer.
    std::span<const std::byte> Take(size_t count) {
        if (count > m_bytes.size()) Fail();
        if (m_failed) return {};
        const std::span<const std::byte> taken = m_bytes.first(count);
        m_bytes = m_bytes.subspan(count);
        return taken;
    }

    void Fail() { m_failed = true; }
    [[nodiscard]] bool Failed() const { return m_failed; }
    [[nodiscard]] bool AtEnd() const { return m_bytes.empty(); }

private:
    template <typename T>
    void Read(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            uint8_t byte = 0;
            Read(byte);
            if (byte > 1) Fail();
            value = byte == 1;
        } else if constexpr (isNumber<T>) {
            const std::span<const std::byte> bytes = Take(sizeof(T));
            if (Failed()) return;
            std::memcpy(&value, bytes.data(), sizeof(T));
            if constexpr (std::is_floating_point_v<T>) {
                if (std::isnan(value)) Fail();  // no state of a world is; comparisons could not order it
            }
        } else if constexpr (std::is_array_v<T>) {
            for (auto& element : value) Read(element);
        } else {
            Fields(value, *this);
        }
    }
    template <AnyColumn T>
    void Read(T& values) {
        uint32_t count = 0;
        Read(count);
        if (count > m_bytes.size()) Fail();  // every element has at least one byte
        if (Failed()) return;
        values.resize(count);
        for (auto& value : values) Read(value);
    }

    std::span<const std::byte> m_bytes;
    bool m_failed = false;
};

/// FNV-1a, 64 bits (Fowler, Noll, Vo 1991): a change of one byte always shows.
inline uint64_t ChecksumOf(std::span<const std::byte> bytes) {
    uint64_t sum = 0xcbf29ce484222325ull;
    for (const std::byte byte : bytes) sum = (sum ^ static_cast<uint64_t>(byte)) * 0x100000001b3ull;
    return sum;
}

}  // namespace scree
