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
struct SolvedBlocks {
    const ContactBlocks& blocks;
    bool summed;                         ///< report sums over the sub-steps
    std::span<const ContactIndex> list;  ///< what `blocks` was built from
};
/// PostSolve for every contact of the list, in order; `impulses` is scratch.
void ReportBlockImpulses(const SolvedBlocks& solved, const ContactEvents& events, ContactTable& contacts,
                         std::vector<ContactImpulse>& impulses);

}  // namespace scree
