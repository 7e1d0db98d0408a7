// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What rests is looked at by no stage: contacts and proxies of bodies that have stirred are taken back, and what has
// come to rest is put aside.

#pragma once

#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// Rouses the contacts of the bodies that were listed since the last call. Returns how many of these contacts touch in
/// rows below `row`.
inline int RouseContacts(BodyTable& bodies, ContactTable& contacts, ContactIndex row = ContactIndex{0}) {
    int touching = 0;
    for (const BodyIndex body : bodies.risen) touching += contacts.RouseOf(body, row);
    bodies.risen.clear();
    return touching;
}

/// Rouses the proxies of the bodies that were listed since the last call.
void RouseProxies(BodyTable& bodies, const FixtureTable& fixtures, BroadPhase& broadPhase);

/// Unlists the bodies that are asleep, and puts their proxies and the contacts aside that no listed body has. Contacts
/// that the next narrow phase is to end or to ask the filters about stay. `rows` is scratch.
void RestSleepers(TaskPool& pool, BodyTable& bodies, const FixtureTable& fixtures, ContactTable& contacts,
                  BroadPhase& broadPhase, std::vector<ContactIndex>& rows);

}  // namespace scree
