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

namespace scree {

class EditedProxies {
public:
    void Add(uint32_t fixture) {
        EnsureRow(m_isEdited, static_cast<int>(fixture), uint8_t{0});
        if (m_isEdited[fixture] != 0) return;
        m_fixtures.push_back(fixture);
        m_isEdited[fixture] = 1;
    }
    /// Nothing is known of what was edited.
    void AddAll() { m_all = true; }
    [[nodiscard]] bool AreAll() const { return m_all; }
    /// In the order of the edits; some may be gone.
    [[nodiscard]] const std::vector<uint32_t>& Fixtures() const { return m_fixtures; }
    [[nodiscard]] bool Has(uint32_t fixture) const { return fixture < m_isEdited.size() && m_isEdited[fixture] != 0; }
    /// Per fixture, as far as there were edits: 1 or 0.
    [[nodiscard]] const std::vector<uint8_t>& Rows() const { return m_isEdited; }
    void Clear() {
        for (const uint32_t fixture : m_fixtures) m_isEdited[fixture] = 0;
        m_fixtures.clear();
        m_all = false;
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_fixtures, m_isEdited); }

private:
    std::vector<uint32_t> m_fixtures;
    std::vector<uint8_t> m_isEdited;
    bool m_all = false;
};

}  // namespace scree
