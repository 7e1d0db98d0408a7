// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A session of one engine (or the recorded one) as a page holds it: motion, contacts, joints, kept trees, curves of the
// world, moments. Lanes of one page share the bodies and the clock.

#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/jobs/timeline/body_rows.h"
#include "testbed/jobs/timeline/contact_data.h"
#include "testbed/moments/moment.h"
#include "testbed/options/session.h"

namespace testbed {

/// Which trees a page keeps.
struct KeptTrees {
    int every = 0;           ///< each such step; 0: none
    int worst = 0;           ///< so many of the slowest steps
    std::vector<int> steps;  ///< these, growing

    [[nodiscard]] bool IsAsked() const { return every > 0 || worst > 0 || !steps.empty(); }
};
/// "every:N", "worst:K" or "at:STEP,STEP", or nothing. Throws UsageError.
[[nodiscard]] KeptTrees ParseKeptTrees(std::string_view text);

struct LaneOptions {
    bool contacts = true;
    bool exact = false;  ///< positions and angles to the bit
    KeptTrees trees;
};

/// What a lane adds to a page.
struct LaneData {
    nlohmann::ordered_json told;  ///< an entry of "lanes" in timeline_data.js
    /// Packed streams by name: motion, contacts, joints, nodes, series.
    std::vector<std::pair<std::string, std::string>> streams;
    std::vector<Moment> moments;
    std::size_t changes = 0;  ///< of a body in a step
};

/// Runs or reads the session to its end.
[[nodiscard]] LaneData RecordLane(Session& session, const std::string& name, Conditions conditions, const Grid& grid,
                                  BodyRows& bodies, const LaneOptions& options);

}  // namespace testbed
