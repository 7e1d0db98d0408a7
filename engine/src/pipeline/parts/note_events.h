// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Part of the stages that compute manifolds: what World::GetEvents is to tell of a contact.

#pragma once

#include "state/bodies.h"
#include "state/contacts.h"
#include "state/event_log.h"
#include "state/fixtures.h"

namespace scree {

/// Notes that a contact has begun or ended.
void NoteChange(ContactIndex contact, const ContactTable& contacts, EventLog& log);
/// Notes the blow of a contact that touches and is going to be solved, if its fixtures report that: how fast they come
/// together at its points.
void NoteHit(ContactIndex contact, const FixtureTable& fixtures, const BodyTable& bodies, const ContactTable& contacts,
             EventLog& log);

}  // namespace scree
