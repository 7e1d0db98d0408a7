// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The motion of a session as the bytes that timeline.js decodes: step by step the bodies that changed, 8 bytes each.
// Positions are quantised to 1/65534 of the view, angles to 1/65536 of a turn.

#pragma once

#include <cstdint>
#include <vector>

#include "testbed/engines/snapshot.h"

namespace testbed {

/// Bodies that a page can tell apart.
inline constexpr std::size_t mostTimelineBodies = 0x8000;

class MotionData {
public:
    /// Positions outside of the view are shown at its edge.
    MotionData(std::size_t bodies, const Box& view) : m_view(view), m_last(bodies) {}

    /// Per step: a count, 32 bits, and for each body that changed: index with the awake bit above it, x, y, angle, 16
    /// bits each, little-endian; all ones in the last three: it is gone.
    void Add(const Snapshot& snapshot);
    [[nodiscard]] const std::vector<unsigned char>& GetBytes() const { return m_bytes; }
    [[nodiscard]] std::size_t GetChangeCount() const { return m_changes; }

private:
    struct Words {
        std::uint16_t awake = 0, x = 0xFFFF, y = 0xFFFF, angle = 0xFFFF;
        friend bool operator==(const Words&, const Words&) = default;
    };
    [[nodiscard]] Words WordsOf(const BodyState& body) const;
    void Put(std::uint32_t value, int bytes);

    Box m_view;
    std::vector<Words> m_last;
    std::vector<unsigned char> m_bytes;
    std::size_t m_changes = 0;
};

}  // namespace testbed
