// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What ends outside of a step: contacts of what is destroyed, disabled or given another type, then the objects. The
// listeners hear of it while the engine is not locked, as in Box2D, so they may create and destroy. Therefore each
// callback comes before the engine's edit; a contact that was told leaves the lists at once (the engine keeps its row
// until the edit), and what is about to go is marked busy, so that nobody destroys it a second time.

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

void b2Bridge::EndContacts(b2WorldData& data, b2Body& body, const b2Fixture* only) {
    if (data.listener == nullptr) return;
    std::vector<std::pair<size_t, b2Contact*>> ends;
    body.m_handle->VisitContacts([&](scree::Contact* contact) {
        const auto row = static_cast<size_t>(contact->GetIndex());
        if (!contact->IsTouching() || HasEnded(data, row)) return true;
        b2Contact* mirror = Mirror(data, contact);
        const bool concerned = only == nullptr || mirror->m_fixtureA == only || mirror->m_fixtureB == only;
        if (concerned && !mirror->m_ending) ends.emplace_back(row, mirror);
        return true;
    });
    for (const auto& [row, contact] : ends) {
        // A callback may have destroyed the contact's other body meanwhile, or taken the listener away.
        const auto lives = [&, r = row, c = contact] { return data.contactOfRow[r] == c; };
        if (!lives() || contact->m_ending) continue;
        contact->m_ending = true;
        if (data.listener != nullptr) data.listener->EndContact(contact);
        if (!lives()) continue;
        FreeContact(data, contact);
        if (data.endedRows.size() <= row) data.endedRows.resize(row + 1, 0);
        data.endedRows[row] = 1;
    }
}

void b2Bridge::DestroyFixture(b2WorldData& data, b2Body& body, b2Fixture* fixture) {
    if (fixture->m_busy > 0) return Complain("b2Body::DestroyFixture", "this fixture is being destroyed already");
    {
        const Busy bodyBusy(data, body.m_busy);
        fixture->m_busy = 1;  // for good
        EndContacts(data, body, fixture);
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
        if (!flag && !data.stepping) EndContacts(data, body, nullptr);
        body.m_handle->SetEnabled(flag);
    }
    Touch(data);
}

void b2Bridge::SetType(b2WorldData& data, b2Body& body, b2BodyType type) {
    {
        const Busy busy(data, body.m_busy);
        if (!data.stepping && body.GetType() != type) EndContacts(data, body, nullptr);
        body.m_handle->SetType(static_cast<scree::BodyType>(type));
    }
    Refresh(body);
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
        EndContacts(data, *body, nullptr);
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
    for (std::vector<b2Fixture*>* reported : data.reports) {
        std::replace(reported->begin(), reported->end(), const_cast<b2Fixture*>(fixture),
                     static_cast<b2Fixture*>(nullptr));
    }
}
