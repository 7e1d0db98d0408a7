// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Edit distance by three rows of the usual table.

#include "testbed/base/nearest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <climits>
#include <numeric>
#include <utility>
#include <vector>

namespace testbed {

namespace {

char Lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

}  // namespace

int EditDistance(std::string_view a, std::string_view b) {
    std::vector<int> older(b.size() + 1), old(b.size() + 1), row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(older, old);
        std::swap(old, row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = Lower(a[i - 1]), y = Lower(b[j - 1]);
            row[j] = std::min({old[j] + 1, row[j - 1] + 1, old[j - 1] + (x == y ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && x == Lower(b[j - 2]) && Lower(a[i - 2]) == y;
            if (swapped) row[j] = std::min(row[j], older[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string_view NearestName(std::string_view word, std::span<const std::string_view> names) {
    std::string_view nearest;
    int smallest = INT_MAX;
    for (const std::string_view name : names) {
        const int distance = EditDistance(word, name);
        if (distance < smallest) {
            smallest = distance;
            nearest = name;
        }
    }
    return smallest <= std::max(1, static_cast<int>((std::max(word.size(), nearest.size()) + 1) / 2))
               ? nearest
               : std::string_view();
}

std::string SuggestName(std::string_view word, std::span<const std::string_view> names) {
    const std::string_view nearest = NearestName(word, names);
    return nearest.empty() ? std::string() : fmt::format("; did you mean '{}'?", nearest);
}

std::string DescribeUnknown(std::string_view what, std::string_view word, std::span<const std::string_view> names) {
    const std::string suggestion = SuggestName(word, names);
    return fmt::format("unknown {} '{}'{} {}: {}", what, word, suggestion.empty() ? ";" : suggestion,
                       suggestion.empty() ? "known" : "Known", fmt::join(names, ", "));
}

}  // namespace testbed
