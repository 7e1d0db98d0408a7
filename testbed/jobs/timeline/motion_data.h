// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The motion of a session as the bytes that timeline_data.js decodes: step by step the bodies that changed, each number
// as what it differs by from going on as before. Most bodies cost a few bytes a step before they are deflated.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "testbed/engines/snapshot.h"
#include "testbed/jobs/timeline/byte_stream.h"

namespace testbed {

/// Lengths as whole numbers: of the middle of the view, in units of 2^-16 of its longer side.
class Grid {
public:
    explicit Grid(const Box& view);
    [[nodiscard]] std::int32_t X(float x) const { return Round((double{x} - m_centerX) / m_unit); }
    [[nodiscard]] std::int32_t Y(float y) const { return Round((double{y} - m_centerY) / m_unit); }
    /// A length or a speed.
    [[nodiscard]] std::int32_t Length(double length) const { return Round(length / m_unit); }
    /// Back to m.
    [[nodiscard]] double ToX(std::int32_t x) const { return m_centerX + x * m_unit; }
    [[nodiscard]] double ToY(std::int32_t y) const { return m_centerY + y * m_unit; }
    /// 2^-16 of a turn; it begins anew after 2^12 turns.
    [[nodiscard]] static std::int32_t Angle(float angle);
    /// 2^-12 rad/s.
    [[nodiscard]] static std::int32_t Spin(float spin) { return Round(double{spin} * 4096.0); }
    [[nodiscard]] double GetUnit() const { return m_unit; }

private:
    /// What lies 2^12 views away stays there; no number is 0.
    static std::int32_t Round(double value);
    double m_centerX, m_centerY, m_unit;
};

class MotionData {
public:
    /// `isExact`: positions and angles have all bits of their floats, and not those of the grid.
    MotionData(std::size_t bodies, const Grid& grid, bool isExact) : m_grid(grid), m_isExact(isExact), m_last(bodies) {}

    /// Per step: how many changed, then each of them by growing index. Of each: how many are left out before it, and 1
    /// it is there + 2 awake + 4 its pose or velocity is no number. If it is there and a number, it says how x, y,
    /// angle, both velocities and the spin differ from the last change going on. The last change goes on if the body
    /// was named in the step before. Differences have 32 bits and wrap around.
    void Add(const Snapshot& snapshot);
    [[nodiscard]] const ByteStream& GetStream() const { return m_stream; }
    [[nodiscard]] std::size_t GetChangeCount() const { return m_changes; }
    /// Place of a body in the last step as the page has it, m.
    [[nodiscard]] double GetX(int body) const;
    [[nodiscard]] double GetY(int body) const;

private:
    using Numbers = std::array<std::int32_t, 6>;
    struct Known {
        unsigned flags = 0;
        int step = -2;  ///< in which it was named
        Numbers numbers{}, changes{};
    };
    [[nodiscard]] Numbers NumbersOf(const BodyState& body) const;
    void Put(const Numbers& numbers, Known& known);

    Grid m_grid;
    bool m_isExact;
    std::vector<Known> m_last;
    ByteStream m_stream;
    int m_step = -1;
    std::size_t m_changes = 0;
};

}  // namespace testbed
