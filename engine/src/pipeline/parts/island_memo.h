// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a search for islands was told. If the next one would be told the same, its islands are those of before: piles
// that stand, or slide without a contact that begins or ends, are searched once.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/task_pool.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/islands.h"
#include "state/joints.h"

namespace scree {

class IslandMemo {
public:
    /// All that a search reads.
    struct Question {
        TaskPool& pool;
        const ContactTable& contacts;
        const JointTable& joints;
        const BodyTable& bodies;
        std::span<const ContactIndex> rows;  ///< solved contacts, in order
        bool isolatedApart;
    };

    /// Whether `islands` still are the answer. If not, and it is worth while, the question is kept for the next time.
    [[nodiscard]] bool IsAnswered(const Question& question, const IslandTable& islands);
    /// After the search for that question.
    void Stamp(IslandTable& islands) const { islands.search = m_isKept ? m_search : 0; }

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_rows, m_ends, m_listed, m_flags); }

private:
    using Ends = std::array<BodyIndex, 2>;

    [[nodiscard]] bool IsSame(const Question& question) const;
    void Keep(const Question& question);

    std::vector<ContactIndex> m_rows;  ///< of the last question, kept or not
    bool m_isKept = false;             ///< and the rest of it
    uint64_t m_search = 0;             ///< number of the last question that was kept
    std::vector<Ends> m_ends;          ///< bodies of the contacts
    std::vector<BodyIndex> m_listed;   ///< all movers
    std::vector<uint8_t> m_flags;      ///< by body
    int64_t m_jointBirths = 0;
    int m_jointCount = 0;
    bool m_isolatedApart = true;
};

}  // namespace scree
