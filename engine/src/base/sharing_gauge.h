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
    /// with the work.
    void Note(double time, double work) {
        const double cost = work > 0.0 ? time / work : time;
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

    [[nodiscard]] bool IsTrying() const { return m_step >= m_period; }
    void Judge() {
        const bool isBetter = m_tried < clearly * m_usual;
        if (isBetter) m_shares = !m_shares;
        m_period = isBetter ? shortPeriod : std::min(std::max(2 * m_period, shortPeriod), longPeriod);
        m_step = 0;
        m_usual = m_tried = std::numeric_limits<double>::infinity();
    }

    bool m_shares = true;
    int m_period = firstPeriod;                                ///< steps before the next try
    int m_step = 0;                                            ///< of this period and the try after it
    double m_usual = std::numeric_limits<double>::infinity();  ///< least time per work before the try
    double m_tried = std::numeric_limits<double>::infinity();
};

}  // namespace scree
