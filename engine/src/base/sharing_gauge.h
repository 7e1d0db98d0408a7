// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whether it pays to share steps among threads. A second core may be lent to another program, be the other half of the
// first, or be far from its caches, and no call tells. So a few steps in a hundred are taken the other way, and what
// was quicker is kept. Times decide who does the work alone: results do not depend on it.

#pragma once

#include <algorithm>
#include <limits>

namespace scree {

class SharingGauge {
public:
    /// Whether the coming step is to be shared.
    [[nodiscard]] bool Shares() const { return m_shares != IsTrying(); }
    /// After a step: how long it took, and how much there was to do. Any units; the time of a step should grow about
    /// with the work. `hasWaited`: for a thread that seems to have lost its core.
    void Note(double time, double work, bool hasWaited = false) {
        const double cost = work > 0.0 ? time / work : time;
        if (Shares() && IsLent(cost, hasWaited)) return GiveUp();
        if (IsTrying()) {
            m_tried = std::min(m_tried, cost);
            if (cost > hopeless * m_usual) m_step = m_period + trySteps - 1;  // the last of the try
        } else if (m_step >= m_period - trySteps) {
            m_usual = std::min(m_usual, cost);
        }
        if (++m_step == m_period + trySteps) Judge();
    }

private:
    // The least of some steps: what disturbs one makes it longer. The first after a change finds cold caches.
    static constexpr int trySteps = 4;
    static constexpr int firstPeriod = 12, shortPeriod = 60, longPeriod = 252;
    static constexpr double clearly = 0.97;  ///< a way that is quicker by less is not worth the change
    static constexpr double hopeless = 2.0;
    /// A step that has waited, and took so many times as long as the shortest, has lost its core.
    static constexpr double lost = 1.25;
    /// Steps after which that is forgotten. A core may be lost once; twice, and another program has it.
    static constexpr int memory = 24;

    [[nodiscard]] bool IsTrying() const { return m_step >= m_period; }
    void Judge() {
        const bool isBetter = m_tried < clearly * m_usual;
        if (isBetter) m_shares = !m_shares;
        BeginPeriod(isBetter ? shortPeriod : std::min(std::max(2 * m_period, shortPeriod), longPeriod));
    }
    /// The least of times does not show a core that is lent for a part of the time: the least is of the other part.
    void GiveUp() {
        m_shares = false;
        BeginPeriod(2 * shortPeriod);
    }
    void BeginPeriod(int period) {
        m_period = period;
        m_step = 0;
        m_usual = m_tried = m_shortest = std::numeric_limits<double>::infinity();
    }
    /// After a shared step: whether the core of a thread seems to be another program's for a part of the time.
    bool IsLent(double cost, bool hasWaited) {
        const bool isLost = hasWaited && cost > lost * m_shortest;
        m_shortest = std::min(m_shortest, cost);
        const bool isTwice = isLost && m_sinceLost < memory;
        m_sinceLost = isLost ? 0 : std::min(m_sinceLost + 1, memory);
        return isTwice;
    }

    bool m_shares = true;
    int m_period = firstPeriod;                                ///< steps before the next try
    int m_step = 0;                                            ///< of this period and the try after it
    double m_usual = std::numeric_limits<double>::infinity();  ///< least time per work before the try
    double m_tried = std::numeric_limits<double>::infinity();
    double m_shortest = std::numeric_limits<double>::infinity();  ///< the same of shared steps of this period
    int m_sinceLost = memory;                                     ///< shared steps since a core was lost
};

}  // namespace scree
