// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies with joints on which something lies that is far heavier than they are. Their trees are solved otherwise
// (joint_tree.h). What such bodies lack to hold the load, loaded_bodies.h lends them.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/task_pool.h"
#include "state/bodies.h"
#include "state/contacts.h"

namespace scree {

class LoadBearers {
public:
    /// Those of the contacts of a list. O(contacts).
    void Find(TaskPool& pool, const BodyTable& bodies, const ContactTable& contacts,
              std::span<const ContactIndex> list);
    /// Before other bodies can come.
    void Forget();
    [[nodiscard]] bool IsEmpty() const { return m_bearers.empty(); }
    /// Of a body that was there at Find, if some bear.
    [[nodiscard]] bool Has(BodyIndex body) const { return m_bears[body] != 0; }

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_bearers, m_bears); }

private:
    std::vector<BodyIndex> m_bearers;
    Column<BodyIndex, uint8_t> m_bears;  ///< 1: it is listed; all 0 between steps
};

}  // namespace scree
