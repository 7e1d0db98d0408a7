// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Post-solve reports.

#include "pipeline/parts/report_impulses.h"

namespace scree {

void ReportImpulses(const ContactRows& rows, const ContactEvents& events, ContactTable& contacts) {
    if (events.listener == nullptr) return;
    for (const ContactVelocityRow& row : rows.velocity) {
        ContactImpulse impulse{};
        impulse.count = row.pointCount;
        for (int i = 0; i < row.pointCount; ++i) {
            impulse.normalImpulses[i] = row.points[i].normalImpulse;
            impulse.tangentImpulses[i] = row.points[i].tangentImpulse;
        }
        events.listener->PostSolve(contacts.Handle(events.state, row.contact), &impulse);
    }
}

}  // namespace scree
