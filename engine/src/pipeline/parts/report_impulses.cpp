// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Post-solve reports.

#include "pipeline/parts/report_impulses.h"

namespace scree {

void ReportImpulses(const ContactRows& rows, const ContactEvents& events, ContactTable& contacts) {
    if (!events.HearsPostSolve()) return;
    for (const ContactVelocityRow& row : rows.velocity) {
        if (events.listener == nullptr) return;  // it took itself away
        ContactImpulse impulse{};
        impulse.count = row.pointCount;
        for (int i = 0; i < row.pointCount; ++i) {
            impulse.normalImpulses[i] = row.points[i].normalImpulse;
            impulse.tangentImpulses[i] = row.points[i].tangentImpulse;
        }
        events.listener->PostSolve(contacts.Handle(events.state, row.contact), &impulse);
    }
}

void ReportBlockImpulses(const SolvedBlocks& solved, const ContactEvents& events, ContactTable& contacts,
                         std::vector<ContactImpulse>& impulses) {
    if (!events.HearsPostSolve()) return;
    solved.blocks.GetImpulses(solved.summed, impulses);
    for (size_t i = 0; i < solved.list.size() && events.listener != nullptr; ++i) {
        events.listener->PostSolve(contacts.Handle(events.state, solved.list[i]), &impulses[i]);
    }
}

}  // namespace scree
