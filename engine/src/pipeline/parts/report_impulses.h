// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tells the listener what impulses a solve applied.

#pragma once

#include "constraints/contact_rows.h"
#include "pipeline/contact_events.h"

namespace scree {

/// PostSolve for every contact of `rows`, in order.
void ReportImpulses(const ContactRows& rows, const ContactEvents& events, ContactTable& contacts);

}  // namespace scree
