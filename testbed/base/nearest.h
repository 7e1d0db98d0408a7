// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which known name was meant by an unknown one: edit distance with swaps of neighbours (optimal string alignment, after
// Damerau 1964).

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace testbed {

/// Least number of insertions, deletions, replacements and swaps of neighbours from one text to the other, ASCII case
/// ignored. O(length × length).
[[nodiscard]] int EditDistance(std::string_view a, std::string_view b);

/// The name with the smallest distance, the first of equals; empty when all are so far off that none can be meant: more
/// than half of the longer word differs.
[[nodiscard]] std::string_view NearestName(std::string_view word, std::span<const std::string_view> names);

/// "; did you mean '<nearest>'?", or nothing.
[[nodiscard]] std::string SuggestName(std::string_view word, std::span<const std::string_view> names);

/// "unknown <what> '<word>'; did you mean '<nearest>'? Known: a, b, c", without the question where none is near.
[[nodiscard]] std::string DescribeUnknown(std::string_view what, std::string_view word,
                                          std::span<const std::string_view> names);

}  // namespace testbed
