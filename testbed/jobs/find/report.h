// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What was found in a session, for readers, for programs (JSON) and for CI (JUnit).

#pragma once

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
};

struct FindReport {
    std::string input{}, command{};
    int steps = 0;                          ///< looked at
    std::vector<std::string> conditions{};  ///< names, as asked for
    std::vector<FoundMoment> found{};       ///< by step
};

/// "step 512, 8.53 s: tunnel: player (37), floor (0): went through, at 45 m/s".
[[nodiscard]] std::string DescribeMoment(const FoundMoment& found, const Session& session);
/// {"schema": 1, "input", "command", "steps", "conditions": […], "moments": [{"condition", "step", …}]}.
[[nodiscard]] std::string WriteFindJson(const FindReport& report, const Session& session);
/// A test case a condition; it fails with the moments that it found.
[[nodiscard]] std::string WriteFindJUnit(const FindReport& report, const Session& session);

}  // namespace testbed
