// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The rows of all laws judged in this process, printed when the last test has run.

#include "tests/physics/law_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace scree::test {
namespace {

/// Largest error of this library as a multiple of Box2D's.
constexpr double allowedRatio = 1.05;

struct Row {
    Law law;
    Both<double> measured;
};

/// Lives as long as the test program (GoogleTest owns it) and prints at its end.
class Table final : public ::testing::Environment {
public:
    void Add(const Row& row) { m_rows.push_back(row); }

    void TearDown() override {
        if (m_rows.empty()) return;
        std::printf(
            "\n| law | exact | allowed error | ours | Box2D 2.4.1 | error ratio | soft step |\n"
            "|---|---|---|---|---|---|---|\n");
        for (const Row& row : m_rows) {
            const double ours = std::abs(row.measured.ours - row.law.exact);
            const double box2d = std::abs(row.measured.box2d - row.law.exact);
            std::printf("| %s | %.6g | ", row.law.name.c_str(), row.law.exact);
            if (row.law.tolerance == unbounded)
                std::printf("Box2D's");
            else
                std::printf("%.3g", row.law.tolerance);
            std::printf(" | %.6g | %.6g | ", row.measured.ours, row.measured.box2d);
            if (std::max(ours, box2d) <= row.law.rounding)
                std::printf("rounding |");
            else
                std::printf("%.3f |", box2d == 0.0 && ours == 0.0 ? 1.0 : ours / box2d);
            std::printf(" %.6g |\n", row.measured.soft);
        }
    }

private:
    std::vector<Row> m_rows;
};

Table& GetTable() {
    static auto* table = static_cast<Table*>(::testing::AddGlobalTestEnvironment(new Table));
    return *table;
}

/// GoogleTest wants to know its environments before the first test.
[[maybe_unused]] const Table& registered = GetTable();

}  // namespace

void Judge(const Law& law, Both<double> measured) {
    GetTable().Add({law, measured});
    const double ours = std::abs(measured.ours - law.exact);
    const double box2d = std::abs(measured.box2d - law.exact);
    EXPECT_TRUE(std::isfinite(ours)) << law.name;
    EXPECT_LE(ours, law.tolerance) << law.name << ": exact " << law.exact << ", ours " << measured.ours;
    EXPECT_LE(ours, std::max(law.rounding, allowedRatio * box2d))
        << law.name << ": exact " << law.exact << ", ours " << measured.ours << ", Box2D " << measured.box2d;
    if (law.ofSequential) return;
    const double soft = std::abs(measured.soft - law.exact);
    EXPECT_TRUE(std::isfinite(soft)) << law.name;
    const double bound = law.tolerance == unbounded ? ours : std::max(law.tolerance, ours);
    EXPECT_LE(soft, std::max(law.rounding, bound))
        << law.name << ": exact " << law.exact << ", soft step " << measured.soft << ", 8/3 " << measured.ours;
}

}  // namespace scree::test
