// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs of others that the testbed runs: whether they are there.

#pragma once

#include <string_view>

namespace testbed {

/// Whether a program of this name is on PATH.
[[nodiscard]] bool IsInstalled(std::string_view program);

}  // namespace testbed
