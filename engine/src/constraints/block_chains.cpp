// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// From sections of blocks to steps, and which steps wait for which.

#include "constraints/block_chains.h"

#include "base/slots.h"

namespace scree {

void BlockChains::Clear() {
    m_count = 0;
    m_sections.clear();
    m_steps.clear();
    m_ranges.clear();
    m_needs.clear();
}

void BlockChains::Reserve(size_t chains, size_t groups) {
    ReserveRows(chains * groups, m_sections, m_bordersDone, m_waiting);
    ReserveRows(2 * chains * groups, m_steps, m_ranges);
    ReserveRows(chains * chains * groups, m_needs);
    ReserveRows(groups, m_colours);
}

/// Adds the border, or the rest, of a colour; false if there is none.
bool BlockChains::AddStep(int chain, size_t firstGroup, size_t endGroup, std::span<const BlockRange> groups,
                          bool isBorder) {
    const auto first = static_cast<int32_t>(m_ranges.size());
    for (size_t g = firstGroup; g < endGroup; ++g) {
        const Section& section = m_sections[ToSize(chain) * groups.size() + g];
        const int32_t begin = isBorder ? section.begin : section.border;
        const int32_t end = isBorder ? section.border : section.end;
        if (begin < end) m_ranges.push_back({begin, end, groups[g].kind, groups[g].colour});
    }
    const auto end = static_cast<int32_t>(m_ranges.size());
    if (first == end) return false;
    m_steps.push_back({first, end, -1});
    return true;
}

void BlockChains::Build(int chains, std::span<const Section> sections, std::span<const BlockRange> groups) {
    Clear();
    m_count = chains;
    for (int chain = 0; chain < chains; ++chain) {
        for (size_t g = 0; g < groups.size(); ++g) m_sections.push_back(sections[g * ToSize(chains) + ToSize(chain)]);
    }
    m_colours.clear();
    for (size_t begin = 0, end = 0; begin < groups.size(); begin = end) {
        for (end = begin; end < groups.size() && groups[end].colour == groups[begin].colour;) ++end;
        m_colours.push_back({begin, end});
    }
    m_bordersDone.assign(m_colours.size() * ToSize(chains), 0);
    m_waiting.clear();
    for (int chain = 0; chain < chains; ++chain) {
        m_firstStep[chain] = static_cast<int32_t>(m_steps.size());
        int32_t done = 0;
        for (size_t c = 0; c < m_colours.size(); ++c) {
            const auto [begin, end] = m_colours[c];
            if (AddStep(chain, begin, end, groups, true)) {
                m_waiting.push_back({static_cast<int32_t>(m_steps.size()) - 1, c});
                done = static_cast<int32_t>(m_steps.size()) - m_firstStep[chain];
            }
            m_bordersDone[c * ToSize(chains) + ToSize(chain)] = done;
            AddStep(chain, begin, end, groups, false);
        }
    }
    m_firstStep[chains] = static_cast<int32_t>(m_steps.size());
    for (int chain = 0; chain < chains; ++chain)
        m_bordersEnd[chain] =
            groups.empty() ? 0 : m_bordersDone[(m_colours.size() - 1) * ToSize(chains) + ToSize(chain)];
    for (const auto& [step, colour] : m_waiting) {
        m_steps[ToSize(step)].needs = static_cast<int32_t>(m_needs.size() / ToSize(chains));
        for (int other = 0; other < chains; ++other) {
            const int32_t steps = m_firstStep[other + 1] - m_firstStep[other];
            const bool isOwn = step >= m_firstStep[other] && step < m_firstStep[other + 1];
            const auto doneIn = [&](size_t c) { return m_bordersDone[c * ToSize(chains) + ToSize(other)]; };
            const int32_t before = colour > 0 ? doneIn(colour - 1) : 0;
            const int32_t last = doneIn(m_colours.size() - 1);
            m_needs.push_back(isOwn || last == 0 ? nothing : before > 0 ? before : last - steps);
        }
    }
}

}  // namespace scree
