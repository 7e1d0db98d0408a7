// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The fixtures whose boxes, filters or being the program has edited since the last step: only their pairs can have
// begun or ended, and the coming step finds these first.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/slots.h"
#include "state/indices.h"

namespace scree {

class EditedProxies {
public:
    void Add(FixtureIndex fixture) {
        EnsureRow(m_isEdited, fixture, uint8_t{0});
        if (m_isEdited[fixture] != 0) return;
        m_fixtures.push_back(fixture);
        m_isEdited[fixture] = 1;
    }
    /// Nothing is known of what was edited.
    void AddAll() { m_all = true; }
    [[nodiscard]] bool AreAll() const { return m_all; }
    /// In the order of the edits; some may be gone.
    [[nodiscard]] const std::vector<FixtureIndex>& Fixtures() const { return m_fixtures; }
    [[nodiscard]] bool Has(FixtureIndex fixture) const { return m_isEdited.Has(fixture) && m_isEdited[fixture] != 0; }
    /// Per fixture, as far as there were edits: 1 or 0.
    [[nodiscard]] const Column<FixtureIndex, uint8_t>& Rows() const { return m_isEdited; }
    void Clear() {
        for (const FixtureIndex fixture : m_fixtures) m_isEdited[fixture] = 0;
        m_fixtures.clear();
        m_all = false;
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_fixtures, m_isEdited); }

private:
    std::vector<FixtureIndex> m_fixtures;
    Column<FixtureIndex, uint8_t> m_isEdited;
    bool m_all = false;
};

}  // namespace scree
