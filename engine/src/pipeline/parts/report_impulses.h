// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tells the listener what impulses a solve applied.

#pragma once

#include "pipeline/contact_events.h"
#include "pipeline/parts/solver.h"

namespace scree {

/// PostSolve for every contact of `rows`, in order.
void ReportImpulses(const ContactRows& rows, const ContactEvents& events, ContactTable& contacts);
/// PostSolve for every contact of the list that scratch.blocks was built from, in order; `summed`: over the sub-steps.
void ReportBlockImpulses(SolverScratch& scratch, bool summed, std::span<const ContactIndex> list,
                         const ContactEvents& events, ContactTable& contacts);

}  // namespace scree
