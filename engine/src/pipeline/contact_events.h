// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Who is asked and told about contacts; handed to the stages that create, update and destroy them.

#pragma once

#include "scree/world_callbacks.h"

namespace scree {

struct WorldState;

struct ContactEvents {
    WorldState* state;          ///< only passed on to make handles
    ContactListener* listener;  ///< may be null
    ContactFilter* filter;      ///< null: the fixtures' filter data decide alone
};

}  // namespace scree
