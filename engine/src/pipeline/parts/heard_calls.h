// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a contact listener hears, from its table of virtual functions.

#pragma once

#include "scree/world_callbacks.h"

namespace scree {

/// Which functions of a listener do something; the others need not be called, nor what they would be told found out.
struct HeardCalls {
    bool begin = true, end = true, preSolve = true, postSolve = true;
};

/// Those that the listener's class has replaced, as far as that can be known: else all.
HeardCalls FindHeardCalls(const ContactListener& listener);

}  // namespace scree
