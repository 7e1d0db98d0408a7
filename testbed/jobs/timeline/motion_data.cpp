// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of motion_data.h.

#include "testbed/jobs/timeline/motion_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace testbed {

namespace {

constexpr unsigned isThere = 1, isAwake = 2, isNoNumber = 4;

unsigned FlagsOf(const BodyState& body) {
    const bool isNumber = std::isfinite(body.position.x) && std::isfinite(body.position.y) &&
                          std::isfinite(body.angle) && std::isfinite(body.linearVelocity.x) &&
                          std::isfinite(body.linearVelocity.y) && std::isfinite(body.angularVelocity);
    return isThere | (body.awake ? isAwake : 0u) | (isNumber ? 0u : isNoNumber);
}

bool HasNumbers(unsigned flags) { return (flags & isThere) != 0 && (flags & isNoNumber) == 0; }

}  // namespace

Grid::Grid(const Box& view)
    : m_centerX((double{view.lower.x} + view.upper.x) / 2),
      m_centerY((double{view.lower.y} + view.upper.y) / 2),
      m_unit(std::max({double{view.upper.x} - view.lower.x, double{view.upper.y} - view.lower.y, 1e-6}) / 65536.0) {}

std::int32_t Grid::Round(double value) {
    constexpr double most = 536'870'912.0;
    return std::isfinite(value) ? static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most))) : 0;
}

std::int32_t Grid::Angle(float angle) { return Round(double{angle} * 65536.0 / (2.0 * std::numbers::pi)); }

MotionData::Numbers MotionData::NumbersOf(const BodyState& body) const {
    return {m_grid.X(body.position.x),           m_grid.Y(body.position.y),           Grid::Angle(body.angle),
            m_grid.Speed(body.linearVelocity.x), m_grid.Speed(body.linearVelocity.y), Grid::Spin(body.angularVelocity)};
}

void MotionData::Put(const Numbers& numbers, Known& known) {
    const bool goesOn = known.step == m_step - 1;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::int32_t change = numbers[i] - known.numbers[i];
        m_stream.PutSigned(change - (goesOn ? known.changes[i] : 0));
        known.changes[i] = change;
    }
    known.numbers = numbers;
    known.step = m_step;
}

void MotionData::Add(const Snapshot& snapshot) {
    ++m_step;
    std::vector<const BodyState*> now(m_last.size(), nullptr);
    for (const BodyState& body : snapshot.bodies) now[static_cast<std::size_t>(body.index)] = &body;
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Known& known = m_last[i];
        const unsigned flags = now[i] != nullptr ? FlagsOf(*now[i]) : 0;
        const bool isSame = flags == known.flags && (!HasNumbers(flags) || known.numbers == NumbersOf(*now[i]));
        if (!isSame) changed.push_back(i);
    }
    m_stream.BeginStep();
    m_stream.PutNumber(static_cast<std::uint32_t>(changed.size()));
    std::size_t next = 0;
    for (const std::size_t i : changed) {
        m_stream.PutNumber(static_cast<std::uint32_t>(i - next));
        next = i + 1;
        Known& known = m_last[i];
        known.flags = now[i] != nullptr ? FlagsOf(*now[i]) : 0;
        m_stream.PutByte(known.flags);
        if (HasNumbers(known.flags)) Put(NumbersOf(*now[i]), known);
    }
    m_stream.EndStep();
    m_changes += changed.size();
}

}  // namespace testbed
