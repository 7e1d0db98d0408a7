// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The subcommands overlap, render and metrics, as the command line adds them.

#pragma once

#include "testbed/options/request.h"

namespace testbed {

void AddOverlapCommand(CLI::App& app, Request& request);
void AddRenderCommand(CLI::App& app, Request& request);
void AddMetricsCommand(CLI::App& app, Request& request);

}  // namespace testbed
