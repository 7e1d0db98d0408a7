// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What b2World::GetContactManager shows: the broad phase and the contacts.

#pragma once

#include "b2_api.h"
#include "b2_broad_phase.h"

class b2Contact;
class b2ContactFilter;
class b2ContactListener;
class b2BlockAllocator;

class B2_API b2ContactManager {
public:
    b2ContactManager();

    b2BroadPhase m_broadPhase;
    b2Contact* m_contactList;
    int32 m_contactCount;
    b2ContactFilter* m_contactFilter;
    b2ContactListener* m_contactListener;
    b2BlockAllocator* m_allocator;
};
