// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Passes over coloured blocks by several threads, without a stop at the end of each colour. Space is cut into slices,
// and each slice has a chain: its blocks, colour by colour. The border of a chain are those blocks whose bodies blocks
// of other chains push, too. It comes first in each colour, and waits for the borders of the colours before. Other
// chains did those before the rest of these colours, so that there is seldom anything to wait for. Every body meets its
// contacts in the order of colours, whoever solves them: results are those of one thread.
//
// A pass may end with a step for the bodies of each slice. It waits for the borders of the others alone. To these
// belong blocks that read of a body of another slice which moves by itself.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/index.h"
#include "constraints/body_slices.h"
#include "constraints/contact_block.h"

namespace scree {

class BlockChains {
public:
    static constexpr int most = BodySlices::most;
    static constexpr int32_t nothing = INT32_MIN;  ///< of a chain, among the needs of a step

    /// The blocks of one chain, colour and kind: those below `border` are its border.
    struct Section {
        int32_t begin, border, end;
    };
    /// What a chain does without waiting in between.
    struct Step {
        int32_t firstRange, endRange;
        int32_t needs;  ///< row of the steps that all chains must have done before; −1: none
    };

    void Clear();
    /// Room for so many chains and groups.
    void Reserve(size_t chains, size_t groups);
    /// From sections by group and chain: a group is a colour and kind, as `groups` tells.
    void Build(int chains, std::span<const Section> sections, std::span<const BlockRange> groups);

    [[nodiscard]] bool IsEmpty() const { return m_count == 0; }
    [[nodiscard]] int Count() const { return m_count; }
    /// Sections of a chain follow each other.
    [[nodiscard]] std::span<const Section> GetSections() const { return m_sections; }
    [[nodiscard]] std::span<const Step> GetSteps(int chain) const {
        const size_t begin = ToSize(m_firstStep[chain]), end = ToSize(m_firstStep[chain + 1]);
        return std::span(m_steps).subspan(begin, end - begin);
    }
    [[nodiscard]] const BlockRange& GetRange(int range) const { return m_ranges[ToSize(range)]; }
    /// How many steps each chain must have done in this pass. 0 or less: in the pass before, counted from its end.
    [[nodiscard]] std::span<const int32_t> GetNeeds(int row) const {
        return std::span(m_needs).subspan(ToSize(row) * ToSize(m_count), ToSize(m_count));
    }
    /// Steps of a chain in a pass; `withBodies` there is one more, for the bodies of its slice, which comes last.
    [[nodiscard]] int CountSteps(int chain, bool withBodies) const {
        return static_cast<int>(GetSteps(chain).size()) + (withBodies ? 1 : 0);
    }
    /// How many steps of all passes another chain must have done before this one does the step that follows on `done`.
    [[nodiscard]] int CountNeeded(int chain, int done, int other, bool withBodies) const {
        if (other == chain) return 0;
        const int count = CountSteps(chain, withBodies), passes = done / count;
        const size_t at = ToSize(done % count);
        const int before = passes * CountSteps(other, withBodies);
        if (at == GetSteps(chain).size()) return m_bordersEnd[other] > 0 ? before + m_bordersEnd[other] : 0;
        const Step& step = GetSteps(chain)[at];
        if (step.needs < 0) return 0;
        const int32_t needed = GetNeeds(step.needs)[ToSize(other)];
        // The bodies of all slices come after the borders of the pass before.
        if (withBodies) return before + (needed > 0 ? needed : 0);
        return needed != nothing && before + needed > 0 ? before + needed : 0;
    }
    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(m_sections, m_steps, m_ranges, m_needs, m_colours, m_bordersDone, m_waiting);
    }

private:
    bool AddStep(int chain, size_t firstGroup, size_t endGroup, std::span<const BlockRange> groups, bool isBorder);

    struct Groups {
        size_t begin, end;
    };
    struct Waiting {
        int32_t step;
        size_t colour;
    };

    int m_count = 0;
    std::vector<Section> m_sections;
    std::vector<Step> m_steps;  ///< by chain
    int32_t m_firstStep[most + 1] = {};
    int32_t m_bordersEnd[most] = {};  ///< by chain: steps done with all borders; 0: it has none
    std::vector<BlockRange> m_ranges;
    std::vector<int32_t> m_needs;
    // Scratch of Build.
    std::vector<Groups> m_colours;
    std::vector<int32_t> m_bordersDone;  ///< by colour and chain: steps done with borders up to that colour; 0: none
    std::vector<Waiting> m_waiting;      ///< steps at borders
};

}  // namespace scree
