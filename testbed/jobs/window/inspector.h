// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// All that is known of the picked body: its values, shapes, contacts and joints. What was typed into a value becomes an
// edit.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "testbed/engines/run_values.h"
#include "testbed/jobs/window/viewer.h"

namespace testbed {

/// One shape, contact or joint of the body.
struct InspectedPart {
    std::string title;   ///< "contact with ground (0)"
    int otherBody = -1;  ///< of a contact or a joint
    RunValues values{};
};

struct Inspection {
    std::string title;  ///< "hero (1)"
    RunValues values;
    std::vector<InspectedPart> shapes, contacts, joints;
};

/// The picked body in a pane; empty if it is not there.
[[nodiscard]] Inspection Inspect(const Viewer& viewer, const EnginePane& pane);

/// Whether a value of a body can be typed.
[[nodiscard]] bool IsEditable(std::string_view name);
/// An edit of that value. Throws std::invalid_argument for a text that is no value of it.
[[nodiscard]] BodyEdit ParseEdit(std::string_view name, std::string_view text);

}  // namespace testbed
