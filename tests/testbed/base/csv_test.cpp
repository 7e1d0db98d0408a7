// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A table reads back to its cells, whatever they hold, by a reader of its own that follows RFC 4180.

#include "testbed/base/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace testbed {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows ReadCsv(const std::string& text) {
    Rows rows{{}};
    std::string cell;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
            cell += text[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == ',' || c == '\n')) {
            rows.back().push_back(std::exchange(cell, {}));
            if (c == '\n') rows.emplace_back();
        } else {
            cell += c;
        }
    }
    rows.pop_back();
    return rows;
}

TEST(Csv, ReadsBackToItsCells) {
    EXPECT_TRUE(rc::check("any cells", [] {
        const int columns = *rc::gen::inRange(1, 5), count = *rc::gen::inRange(1, 5);
        const auto cell = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,;\"'\n\r ")));
        Rows rows;
        CsvTable table;
        for (int i = 0; i < count; ++i) {
            rows.push_back(*rc::gen::container<std::vector<std::string>>(static_cast<std::size_t>(columns), cell));
            for (const std::string& one : rows.back()) table.Add(std::string_view(one));
            table.EndRow();
        }
        RC_ASSERT(ReadCsv(table.GetText()) == rows);
    }));
}

TEST(Csv, QuotesOnlyWhereNeeded) {
    CsvTable table{"name", "value", "good"};
    table.AddRow("plain text", 0.1, true);
    table.AddRow("a, \"b\"", -3, false);
    table.Add("rest");
    table.AddEmpty(2);
    table.EndRow();
    EXPECT_EQ(table.GetText(), "name,value,good\nplain text,0.1,true\n\"a, \"\"b\"\"\",-3,false\nrest,,\n");
}

TEST(Csv, ARowOfAnotherLengthIsRefused) {
    CsvTable table{"a", "b"};
    EXPECT_THROW(table.AddRow(1), std::logic_error);
}

}  // namespace
}  // namespace testbed
