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

/// A share of a span as 0…65534; what is no number lies at its beginning.
std::uint16_t Quantise(float value, float lower, float upper) {
    const double share = (double{value} - lower) / (double{upper} - lower);
    return static_cast<std::uint16_t>(std::lround(65534.0 * (share >= 0.0 ? std::min(share, 1.0) : 0.0)));
}

}  // namespace

void MotionData::Put(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) m_bytes.push_back(static_cast<unsigned char>(value >> (8 * i) & 0xFFu));
}

MotionData::Words MotionData::WordsOf(const BodyState& body) const {
    const double turns = double{body.angle} / (2.0 * std::numbers::pi);
    const double share = std::isfinite(turns) ? turns - std::floor(turns) : 0.0;
    return {static_cast<std::uint16_t>(body.awake ? 0x8000 : 0),
            Quantise(body.position.x, m_view.lower.x, m_view.upper.x),
            Quantise(body.position.y, m_view.lower.y, m_view.upper.y),
            static_cast<std::uint16_t>(std::lround(65536.0 * share) & 0xFFFF)};
}

void MotionData::Add(const Snapshot& snapshot) {
    std::vector<Words> now(m_last.size());
    for (const BodyState& body : snapshot.bodies) now[static_cast<std::size_t>(body.index)] = WordsOf(body);
    const std::size_t countAt = m_bytes.size();
    Put(0, 4);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == m_last[i]) continue;
        Put(static_cast<std::uint32_t>(i) | now[i].awake, 2);
        Put(now[i].x, 2);
        Put(now[i].y, 2);
        Put(now[i].angle, 2);
        ++count;
    }
    for (int i = 0; i < 4; ++i)
        m_bytes[countAt + static_cast<std::size_t>(i)] = static_cast<unsigned char>(count >> (8 * i) & 0xFFu);
    m_changes += count;
    m_last = std::move(now);
}

}  // namespace testbed
