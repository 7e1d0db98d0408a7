// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tables as comma-separated values (RFC 4180): cells in, text out. A cell with a comma, a quote or a line break stands
// in quotes, with its own quotes doubled; lines end with a line feed.

#pragma once

#include <fmt/format.h>

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace testbed {

class CsvTable {
public:
    CsvTable() = default;
    /// With a line of column names.
    explicit CsvTable(std::initializer_list<std::string_view> columns);

    void Add(std::string_view cell);
    /// Numbers read back to the same values.
    template <typename Number>
    requires std::integral<Number> || std::floating_point<Number>
    void Add(Number number) { Add(std::string_view(fmt::format("{}", number))); }
    void AddEmpty(std::size_t count);
    /// Throws std::logic_error when the row has another number of cells than the first one.
    void EndRow();

    template <typename... Cells>
    void AddCells(const Cells&... cells) {
        (Add(cells), ...);
    }
    template <typename... Cells>
    void AddRow(const Cells&... cells) {
        AddCells(cells...);
        EndRow();
    }

    [[nodiscard]] const std::string& GetText() const { return m_text; }

private:
    std::string m_text;
    std::size_t m_columns = 0;  ///< 0: the first row is not over
    std::size_t m_cells = 0;    ///< of this row
};

}  // namespace testbed
