// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of moment.h.

#include "testbed/moments/moment.h"

#include <algorithm>
#include <utility>

namespace testbed {

Watch::Watch(const scenes::Scene& scene, Conditions conditions, double time)
    : m_scene(scene), m_conditions(std::move(conditions)), m_time(time) {}

void Watch::Show(Snapshot&& now, double timeStep) {
    std::swap(m_before, m_now);
    std::swap(m_placeBefore, m_placeNow);
    m_now = std::move(now);
    m_placeNow.assign(m_scene.bodies.size(), -1);
    for (std::size_t i = 0; i < m_now.bodies.size(); ++i) {
        const auto index = static_cast<std::size_t>(m_now.bodies[i].index);
        if (index < m_placeNow.size()) m_placeNow[index] = static_cast<int>(i);
    }
    if (m_hasBefore) m_time += timeStep;
    const Frame frame{.now = m_now,
                      .before = m_hasBefore ? &m_before : nullptr,
                      .time = m_time,
                      .timeStep = timeStep,
                      .placeNow = m_placeNow,
                      .placeBefore = m_placeBefore,
                      .scene = m_scene};
    for (const auto& condition : m_conditions) condition->Look(frame, m_found);
    m_hasBefore = true;
}

std::vector<Moment> Watch::TakeNew() {
    std::vector<Moment> begun(m_found.begin() + static_cast<std::ptrdiff_t>(m_toldCount), m_found.end());
    m_toldCount = m_found.size();
    for (const auto& condition : m_conditions) condition->AddOngoing(begun);
    std::erase_if(begun, [&](const Moment& one) {
        return !m_told.insert({one.condition, one.step, one.bodies}).second;
    });
    return begun;
}

std::vector<Moment> Watch::Finish() {
    for (const auto& condition : m_conditions) condition->Finish(m_found);
    std::ranges::stable_sort(m_found, {}, &Moment::step);
    return std::move(m_found);
}

}  // namespace testbed
