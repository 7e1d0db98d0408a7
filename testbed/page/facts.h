// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How a page of measurements says where they come from.

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "testbed/page/page.h"

namespace testbed {

/// Adds what provenances (ToJson of engines/provenance.h) have: several where runs were merged, and each value once.
void AddFacts(Page& page, std::span<const nlohmann::ordered_json> provenances);
/// Of one run: its command before that.
void AddFacts(Page& page, const std::string& command, const nlohmann::ordered_json& provenance);

}  // namespace testbed
