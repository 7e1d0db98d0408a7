// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of extremes says first where a rival does better.

#include "testbed/jobs/extremes/report.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {
namespace {

ExtremeResult Graded(std::size_t number, const std::string& setting, Grade grade) {
    ExtremeResult result;
    result.name = GetExtremeCases()[number].name;
    result.setting = setting;
    result.verdict.grade = grade;
    return result;
}

/// The first note of the section of grades, or nothing.
std::string NoteOf(const std::vector<ExtremeResult>& results) {
    const Page page = MakeExtremesPage(results, {}, "scree extremes");
    const auto* note = std::get_if<PageNote>(&page.sections.front().blocks.front());
    return note == nullptr ? "" : note->text;
}

TEST(ExtremesPage, SaysFirstWhereARivalIsBetter) {
    std::vector<ExtremeResult> results{
        Graded(0, "box2d 8/3", Grade::survives),   Graded(0, "scree 8/3", Grade::survives),
        Graded(0, "scree soft 4", Grade::abort),   Graded(1, "box2d 8/3", Grade::accurate),
        Graded(1, "scree 8/3", Grade::survives),   Graded(1, "scree soft 4", Grade::accurate),
        Graded(2, "box2d 8/3", Grade::survives),   Graded(2, "scree 8/3", Grade::notFinished),
        Graded(2, "scree soft 4", Grade::explodes)};
    const std::string first = results[0].name, second = results[3].name, third = results[6].name;
    EXPECT_EQ(NoteOf(results), "box2d 8/3 has a better grade than scree 8/3 in 1 case: " + second +
                                   ". box2d 8/3 has a better grade than scree soft 4 in 2 cases: " + first + ", " +
                                   third + ".");
    for (ExtremeResult& result : results) result.verdict.grade = Grade::survives;
    EXPECT_EQ(NoteOf(results), "");
}

}  // namespace
}  // namespace testbed
