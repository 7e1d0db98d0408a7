// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of csv.h.

#include "testbed/base/csv.h"

#include <stdexcept>

namespace testbed {

CsvTable::CsvTable(std::initializer_list<std::string_view> columns) {
    for (const std::string_view column : columns) Add(column);
    EndRow();
}

void CsvTable::Add(std::string_view cell) {
    if (m_cells++ > 0) m_text += ',';
    if (cell.find_first_of(",\"\r\n") == std::string_view::npos) {
        m_text += cell;
        return;
    }
    m_text += '"';
    for (const char c : cell) {
        if (c == '"') m_text += c;
        m_text += c;
    }
    m_text += '"';
}

void CsvTable::AddEmpty(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) Add(std::string_view());
}

void CsvTable::EndRow() {
    if (m_columns == 0) m_columns = m_cells;
    if (m_cells != m_columns) {
        throw std::logic_error(fmt::format("a row of {} cells in a table of {}", m_cells, m_columns));
    }
    m_cells = 0;
    m_text += '\n';
}

}  // namespace testbed
