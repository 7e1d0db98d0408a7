// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What ends outside of a step: contacts of what is destroyed, disabled or given another type, then the objects. The
// listeners hear of it while the engine is not locked, as in Box2D, so they may create and destroy. Of what is
// destroyed they hear before the engine's edit. A contact that was told leaves the lists at once; the engine keeps its
// row until the edit. Of a body that is disabled or given another type they hear after the edit, when the body says
// what it now is. Its contacts are cut off the engine's first and remember what they were. What is about to go is
// marked busy, so that nobody destroys it a second time.

#include <algorithm>

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

namespace {

/// Holds an object busy, and the world's step back, while callbacks of its destruction run.
class Busy {
public:
    Busy(b2WorldData& data, int& count) : m_data(data), m_count(count) {
        ++m_count;
        ++m_data.destructions;
    }
    ~Busy() {
        --m_count;
        if (--m_data.destructions == 0) m_data.endedRows.clear();
    }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

private:
    b2WorldData& m_data;
    int& m_count;
};

b2Joint* GearOn(b2WorldData& data, const b2Joint* joint) {
    for (b2Joint* other = data.joints; other != nullptr; other = other->GetNext()) {
        auto* gear = other->GetType() == e_gearJoint ? static_cast<b2GearJoint*>(other) : nullptr;
        if (gear != nullptr && (gear->GetJoint1() == joint || gear->GetJoint2() == joint)) return gear;
    }
    return nullptr;
}

}  // namespace

std::vector<b2Bridge::Ending> b2Bridge::FindEndings(b2WorldData& data, b2Body& body, const b2Fixture* only) {
    std::vector<Ending> endings;
    if (data.listener == nullptr) return endings;
    const auto add = [&](b2Contact* contact, size_t row) {
        const bool concerned = only == nullptr || contact->m_fixtureA == only || contact->m_fixtureB == only;
        if (concerned && !contact->m_ending) endings.push_back({contact, row});
    };
    body.m_handle->VisitContacts([&](scree::Contact* contact) {
        const auto row = static_cast<size_t>(contact->GetIndex());
        if (contact->IsTouching() && !HasEnded(data, row)) add(Mirror(data, contact), row);
        return true;
    });
    for (b2ContactEdge* edge = data.detached.empty() ? nullptr : body.m_contactList; edge != nullptr;
         edge = edge->next) {
        if (edge->contact->m_handle == nullptr) add(edge->contact, detachedRow);
    }
    return endings;
}

void b2Bridge::TellEndings(b2WorldData& data, const std::vector<Ending>& endings) {
    for (const auto& [contact, row] : endings) {
        // A callback may have destroyed the contact's other body meanwhile, or taken the listener away.
        const auto lives = [&, c = contact, r = row] {
            return r == detachedRow ? data.detached.contains(c) : data.contactOfRow[r] == c;
        };
        if (!lives() || contact->m_ending) continue;
        contact->m_ending = true;
        if (data.listener != nullptr) data.listener->EndContact(contact);
        if (!lives()) continue;
        FreeContact(data, contact);
        if (row == detachedRow) continue;
        if (data.endedRows.size() <= row) data.endedRows.resize(row + 1, 0);
        data.endedRows[row] = 1;
    }
}

std::vector<b2Bridge::Ending> b2Bridge::DetachContacts(b2WorldData& data, b2Body& body) {
    std::vector<Ending> endings = FindEndings(data, body, nullptr);
    for (auto& [contact, row] : endings) {
        if (row != detachedRow) Detach(data, contact);
        row = detachedRow;
    }
    return endings;
}

void b2Bridge::DestroyFixture(b2WorldData& data, b2Body& body, b2Fixture* fixture) {
    if (fixture->m_busy > 0) return Complain("b2Body::DestroyFixture", "this fixture is being destroyed already");
    {
        const Busy bodyBusy(data, body.m_busy);
        fixture->m_busy = 1;  // for good
        Unlink(fixture);
        TellEndings(data, FindEndings(data, body, fixture));
        RemoveFixture(data, body, fixture);
    }
    Refresh(body);
    Touch(data);
}

void b2Bridge::RemoveFixture(b2WorldData& data, b2Body& body, b2Fixture* fixture) {
    scree::Fixture* first = fixture->m_handles[0];
    if (fixture->GetType() == b2Shape::e_chain) {
        body.m_handle->DestroyChain(first);
    } else {
        body.m_handle->DestroyFixture(first);
    }
    FreeFixture(fixture);
    data.contactsStale = true;
}

void b2Bridge::SetEnabled(b2WorldData& data, b2Body& body, bool flag) {
    {
        const Busy busy(data, body.m_busy);
        std::vector<Ending> endings;
        if (!flag && !data.stepping) endings = DetachContacts(data, body);
        body.m_handle->SetEnabled(flag);
        Touch(data);
        TellEndings(data, endings);
    }
    Touch(data);
}

void b2Bridge::SetType(b2WorldData& data, b2Body& body, b2BodyType type) {
    {
        const Busy busy(data, body.m_busy);
        std::vector<Ending> endings;
        const bool changes = type <= b2_dynamicBody && body.GetType() != type;
        if (changes && !data.stepping) endings = DetachContacts(data, body);
        body.m_handle->SetType(static_cast<scree::BodyType>(type));
        Refresh(body);
        Touch(data);
        TellEndings(data, endings);
    }
    Touch(data);
}

/// Box2D's order: each joint says goodbye and goes, then contacts end, then each fixture says goodbye and goes.
void b2Bridge::DestroyBody(b2WorldData& data, b2Body* body) {
    if (body->m_busy > 0) {
        return Complain("b2World::DestroyBody", "this body is being changed by a call that this callback belongs to");
    }
    scree::Body* handle = body->m_handle;
    {
        const Busy busy(data, body->m_busy);
        body->m_dying = true;
        while (b2JointEdge* edge = body->m_jointList) {
            b2Joint* joint = edge->joint;
            if (data.destruction != nullptr) data.destruction->SayGoodbye(joint);
            const bool isStillThere = body->m_jointList != nullptr && body->m_jointList->joint == joint;
            if (isStillThere) DestroyJoint(data, joint);
        }
        TellEndings(data, FindEndings(data, *body, nullptr));
        body->m_goesBare = true;
        while (b2Fixture* fixture = data.destruction != nullptr ? body->m_fixtureList : nullptr) {
            data.destruction->SayGoodbye(fixture);
            if (body->m_fixtureList == fixture) RemoveFixture(data, *body, fixture);
        }
        data.engine.DestroyBody(handle);
        while (body->m_fixtureList != nullptr) FreeFixture(body->m_fixtureList);
    }
    FreeBody(body);
    Touch(data);
}

void b2Bridge::DestroyJoint(b2WorldData& data, b2Joint* joint) {
    if (joint->m_busy > 0) return Complain("b2World::DestroyJoint", "this joint is being destroyed already");
    {
        const Busy busy(data, joint->m_busy);
        // Box2D leaves such a gear with a dangling pointer; here it goes, and the program is told.
        while (b2Joint* gear = GearOn(data, joint)) {
            if (data.destruction != nullptr) data.destruction->SayGoodbye(gear);
            if (GearOn(data, joint) == gear) DestroyJoint(data, gear);
        }
    }
    if (data.engine.DestroyJoint(joint->m_handle) == scree::ErrorCode::ok) FreeJoint(data, joint);
}

void b2Bridge::ForgetReports(b2WorldData& data, const b2Fixture* fixture) {
    const std::lock_guard lock(data.reportsMutex);
    for (std::vector<b2Fixture*>* reported : data.reports) {
        std::replace(reported->begin(), reported->end(), const_cast<b2Fixture*>(fixture),
                     static_cast<b2Fixture*>(nullptr));
    }
}
