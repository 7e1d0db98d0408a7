// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What rests is looked at by no stage: contacts of bodies that have stirred are taken back, and what has come to rest
// is put aside.

#pragma once

#include "state/bodies.h"
#include "state/contacts.h"

namespace scree {

/// Rouses the contacts of the bodies that were listed since the last call. Returns how many of these contacts touch in
/// rows below `row`.
inline int RouseContacts(BodyTable& bodies, ContactTable& contacts, int row = 0) {
    int touching = 0;
    for (const int body : bodies.risen) touching += contacts.RouseOf(body, row);
    bodies.risen.clear();
    return touching;
}

/// Unlists the bodies that are asleep, and puts the contacts aside that no listed body has. Those that the next narrow
/// phase is to end or to ask the filters about stay.
void RestSleepers(BodyTable& bodies, ContactTable& contacts);

}  // namespace scree
