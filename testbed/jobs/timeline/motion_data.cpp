// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of motion_data.h.

#include "testbed/jobs/timeline/motion_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace testbed {

namespace {

/// No number of the grid is larger.
constexpr double most = 268'435'456.0;
constexpr unsigned isThere = 1, isAwake = 2, isNoNumber = 4;

unsigned FlagsOf(const BodyState& body) {
    const bool isNumber = std::isfinite(body.position.x) && std::isfinite(body.position.y) &&
                          std::isfinite(body.angle) && std::isfinite(body.linearVelocity.x) &&
                          std::isfinite(body.linearVelocity.y) && std::isfinite(body.angularVelocity);
    return isThere | (body.awake ? isAwake : 0u) | (isNumber ? 0u : isNoNumber);
}

/// The bits of a float as a number that grows with it, so that small changes are small numbers; and back.
std::int32_t FlipNegative(std::int32_t bits) { return bits < 0 ? bits ^ 0x7FFFFFFF : bits; }
std::int32_t ToOrdered(float value) { return FlipNegative(std::bit_cast<std::int32_t>(value)); }
float FromOrdered(std::int32_t ordered) { return std::bit_cast<float>(FlipNegative(ordered)); }

/// Wraps around.
std::int32_t Subtract(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

bool HasNumbers(unsigned flags) { return (flags & isThere) != 0 && (flags & isNoNumber) == 0; }

}  // namespace

Grid::Grid(const Box& view)
    : m_centerX((double{view.lower.x} + view.upper.x) / 2),
      m_centerY((double{view.lower.y} + view.upper.y) / 2),
      m_unit(std::max({double{view.upper.x} - view.lower.x, double{view.upper.y} - view.lower.y, 1e-6}) / 65536.0) {}

std::int32_t Grid::Round(double value) {
    return std::isfinite(value) ? static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most))) : 0;
}

std::int32_t Grid::Angle(float angle) {
    return Round(std::fmod(double{angle} * 65536.0 / (2.0 * std::numbers::pi), most));
}

MotionData::Numbers MotionData::NumbersOf(const BodyState& body) const {
    const Vec2 at = body.position, v = body.linearVelocity;
    Numbers numbers{m_grid.X(at.x),     m_grid.Y(at.y),     Grid::Angle(body.angle),
                    m_grid.Length(v.x), m_grid.Length(v.y), Grid::Spin(body.angularVelocity)};
    if (m_isExact) {
        numbers[0] = ToOrdered(at.x);
        numbers[1] = ToOrdered(at.y);
        numbers[2] = ToOrdered(body.angle);
    }
    return numbers;
}

double MotionData::GetX(int body) const {
    const std::int32_t x = m_last[static_cast<std::size_t>(body)].numbers[0];
    return m_isExact ? double{FromOrdered(x)} : m_grid.ToX(x);
}

double MotionData::GetY(int body) const {
    const std::int32_t y = m_last[static_cast<std::size_t>(body)].numbers[1];
    return m_isExact ? double{FromOrdered(y)} : m_grid.ToY(y);
}

void MotionData::Put(const Numbers& numbers, Known& known) {
    const bool goesOn = known.step == m_step - 1;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::int32_t change = Subtract(numbers[i], known.numbers[i]);
        m_stream.PutSigned(Subtract(change, goesOn ? known.changes[i] : 0));
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
