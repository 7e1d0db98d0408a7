// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What was found in a session, for readers, for programs (JSON) and for CI (JUnit).

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "testbed/moments/moment.h"
#include "testbed/options/session.h"

namespace testbed {

/// A moment with what is said of it.
struct FoundMoment {
    Moment moment;
    std::string picture{};  ///< its file, or nothing
    std::string link{};     ///< to the moment in a page of `scree timeline`, or nothing
};

struct FindReport {
    std::string input{}, command{};
    int steps = 0;                          ///< looked at
    std::vector<std::string> conditions{};  ///< names, as asked for
    std::vector<FoundMoment> found{};       ///< by step
    std::string timeline{};                 ///< the page that links lead to, or nothing
};

/// Where a page of `scree timeline` shows a moment: its step, with its bodies chosen and followed.
[[nodiscard]] std::string LinkTo(const std::string& timeline, const Moment& moment);

/// "step 512, 8.53 s: tunnel: player (37), floor (0): went through, at 45 m/s".
[[nodiscard]] std::string DescribeMoment(const FoundMoment& found, const Session& session);
/// "2 moments in 600 steps: tunnel, non-finite".
[[nodiscard]] std::string Summarize(const FindReport& report);
/// {"schema": 1, "input", "command", "steps", "conditions": […], "moments": [{"condition", "step", …}]}.
[[nodiscard]] std::string WriteFindJson(const FindReport& report, const Session& session);
/// A test case a condition; it fails with the moments that it found.
[[nodiscard]] std::string WriteFindJUnit(const FindReport& report, const Session& session);
/// The moments as a page, with their pictures inside and links that are relative to it.
void WriteFindPage(const std::filesystem::path& file, const FindReport& report, const Session& session);

}  // namespace testbed
