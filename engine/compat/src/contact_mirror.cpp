// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The program's contact objects. One is made when somebody looks at a contact (a callback, a list). It is kept until
// the engine's contact is gone. Lists are brought up to date when they are asked for. So programs without listeners and
// lists pay nothing.

#include "convert.h"
#include "world_data.h"

namespace scree::box2d {

namespace {

/// The concrete contact.
class PairContact final : public b2Contact {
public:
    void Evaluate(b2Manifold* manifold, const b2Transform& xfA, const b2Transform& xfB) override {
        WithChild(*GetFixtureB()->GetShape(), GetChildIndexB(), [&](const auto& b) {
            WithChild(*GetFixtureA()->GetShape(), GetChildIndexA(), [&](const auto& a) {
                Manifold result{};
                Collide(&result, a, ToScree(xfA), b, ToScree(xfB));
                *manifold = ToBox2d(result);
            });
        });
    }

private:
    // The engine orders A and B as these functions want them.
    static void Collide(Manifold* m, const CircleShape& a, const Transform& xfA, const CircleShape& b,
                        const Transform& xfB) {
        CollideCircles(m, &a, xfA, &b, xfB);
    }
    static void Collide(Manifold* m, const PolygonShape& a, const Transform& xfA, const CircleShape& b,
                        const Transform& xfB) {
        CollidePolygonAndCircle(m, &a, xfA, &b, xfB);
    }
    static void Collide(Manifold* m, const PolygonShape& a, const Transform& xfA, const PolygonShape& b,
                        const Transform& xfB) {
        CollidePolygons(m, &a, xfA, &b, xfB);
    }
    static void Collide(Manifold* m, const EdgeShape& a, const Transform& xfA, const CircleShape& b,
                        const Transform& xfB) {
        CollideEdgeAndCircle(m, &a, xfA, &b, xfB);
    }
    static void Collide(Manifold* m, const EdgeShape& a, const Transform& xfA, const PolygonShape& b,
                        const Transform& xfB) {
        CollideEdgeAndPolygon(m, &a, xfA, &b, xfB);
    }
    static void Collide(Manifold* m, const Shape& a, const Transform& xfA, const Shape& b, const Transform& xfB) {
        // A polygon of more than 8 vertices; two edges never meet.
        if (a.GetType() == Shape::e_convex || b.GetType() == Shape::e_convex) CollideConvex(m, &a, xfA, &b, xfB);
    }
};

void LinkEdge(b2ContactEdge*& list, b2ContactEdge& edge) {
    edge.prev = nullptr;
    edge.next = list;
    if (list != nullptr) list->prev = &edge;
    list = &edge;
}

void UnlinkEdge(b2ContactEdge*& list, b2ContactEdge& edge) {
    if (edge.prev != nullptr) edge.prev->next = edge.next;
    if (edge.next != nullptr) edge.next->prev = edge.prev;
    if (list == &edge) list = edge.next;
}

}  // namespace

}  // namespace scree::box2d

using namespace scree::box2d;

b2Contact* b2Bridge::Mirror(b2WorldData& data, scree::Contact* contact) {
    const auto row = static_cast<size_t>(contact->GetIndex());
    if (data.contactOfRow.size() <= row) data.contactOfRow.resize(row + 1, nullptr);
    const b2FixtureProxy& a = ProxyOf(contact->GetFixtureA());
    const b2FixtureProxy& b = ProxyOf(contact->GetFixtureB());
    b2Contact*& slot = data.contactOfRow[row];
    if (slot != nullptr) {
        if (slot->m_fixtureA == a.fixture && slot->m_fixtureB == b.fixture && slot->m_indexA == a.childIndex &&
            slot->m_indexB == b.childIndex) {
            return slot;
        }
        FreeContact(data, slot);  // the row has been used again for another pair
    }
    auto* made = new PairContact;
    b2Contact* mirror = made;
    mirror->m_handle = contact;
    mirror->m_fixtureA = a.fixture;
    mirror->m_fixtureB = b.fixture;
    mirror->m_indexA = a.childIndex;
    mirror->m_indexB = b.childIndex;
    mirror->m_manifold = {};
    mirror->m_manifoldExposed = false;
    mirror->m_nodeA.contact = mirror->m_nodeB.contact = mirror;
    mirror->m_nodeA.other = b.fixture->m_body;
    mirror->m_nodeB.other = a.fixture->m_body;
    Link(data, mirror);
    data.contactOfRow[row] = mirror;
    return mirror;
}

void b2Bridge::Link(b2WorldData& data, b2Contact* mirror) {
    mirror->m_prev = nullptr;
    mirror->m_next = data.contacts;
    if (data.contacts != nullptr) data.contacts->m_prev = mirror;
    data.contacts = mirror;
    LinkEdge(mirror->m_fixtureA->m_body->m_contactList, mirror->m_nodeA);
    LinkEdge(mirror->m_fixtureB->m_body->m_contactList, mirror->m_nodeB);
}

void b2Bridge::FreeContact(b2WorldData& data, b2Contact* contact) {
    if (contact->m_prev != nullptr) contact->m_prev->m_next = contact->m_next;
    if (contact->m_next != nullptr) contact->m_next->m_prev = contact->m_prev;
    if (data.contacts == contact) data.contacts = contact->m_next;
    UnlinkEdge(contact->m_fixtureA->GetBody()->m_contactList, contact->m_nodeA);
    UnlinkEdge(contact->m_fixtureB->GetBody()->m_contactList, contact->m_nodeB);
    if (contact->m_handle != nullptr) {
        data.contactOfRow[static_cast<size_t>(contact->m_handle->GetIndex())] = nullptr;
    } else {
        data.detached.erase(contact);
    }
    delete static_cast<PairContact*>(contact);
}

void b2Bridge::Detach(b2WorldData& data, b2Contact* contact) {
    const scree::Contact& from = *contact->m_handle;
    contact->m_manifold = ToBox2d(contact->m_handle->GetManifold());
    contact->m_enabled = from.IsEnabled();
    contact->m_friction = from.GetFriction();
    contact->m_restitution = from.GetRestitution();
    contact->m_restitutionThreshold = from.GetRestitutionThreshold();
    contact->m_tangentSpeed = from.GetTangentSpeed();
    data.contactOfRow[static_cast<size_t>(from.GetIndex())] = nullptr;
    contact->m_handle = nullptr;
    data.detached.insert(contact);
}

void b2Bridge::FreeContactsOf(b2WorldData& data, const b2Fixture* fixture) {
    for (b2ContactEdge* edge = fixture->m_body->m_contactList; edge != nullptr;) {
        b2Contact* contact = edge->contact;
        edge = edge->next;
        if (contact->m_fixtureA == fixture || contact->m_fixtureB == fixture) FreeContact(data, contact);
    }
}

void b2Bridge::OrderContacts(b2WorldData& data) {
    for (b2Contact* contact : data.listed) {
        contact->m_fixtureA->m_body->m_contactList = nullptr;
        contact->m_fixtureB->m_body->m_contactList = nullptr;
    }
    data.contacts = nullptr;
    for (size_t i = data.listed.size(); i-- > 0;) Link(data, data.listed[i]);
}

void b2Bridge::SyncContacts(b2WorldData& data) {
    // In a step the engine's table changes under the callbacks.
    if (!data.contactsStale && !data.stepping) return;
    data.contactsStale = false;
    data.rowSeen.assign(data.contactOfRow.size(), 0);
    data.listed.clear();
    for (b2Contact* c = data.detached.empty() ? nullptr : data.contacts; c != nullptr; c = c->m_next) {
        if (c->m_handle == nullptr) data.listed.push_back(c);
    }
    for (scree::Contact* contact = data.engine.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
        if (HasEnded(data, static_cast<size_t>(contact->GetIndex()))) continue;
        data.listed.push_back(Mirror(data, contact));
        if (data.rowSeen.size() < data.contactOfRow.size()) data.rowSeen.resize(data.contactOfRow.size(), 0);
        data.rowSeen[static_cast<size_t>(contact->GetIndex())] = 1;
    }
    for (size_t row = 0; row < data.contactOfRow.size(); ++row) {
        if (data.contactOfRow[row] != nullptr && data.rowSeen[row] == 0) FreeContact(data, data.contactOfRow[row]);
    }
    OrderContacts(data);
}

void b2Bridge::EndCallback(b2Contact& contact) {
    if (!contact.m_manifoldExposed) return;
    contact.m_manifoldExposed = false;
    contact.m_handle->SetManifold(ToScree(contact.m_manifold));
}

namespace scree::box2d {

bool Events::ShouldCollide(Fixture* fixtureA, Fixture* fixtureB) {
    if (m_data.filter == nullptr) return true;
    return m_data.filter->ShouldCollide(b2Bridge::ProxyOf(fixtureA).fixture, b2Bridge::ProxyOf(fixtureB).fixture);
}

void Events::BeginContact(Contact* contact) {
    if (m_data.listener == nullptr) return;  // a callback has taken it away
    b2Contact* mirror = b2Bridge::Mirror(m_data, contact);
    b2Bridge::BeginCallback(*mirror);
    m_data.listener->BeginContact(mirror);
    b2Bridge::EndCallback(*mirror);
}

void Events::EndContact(Contact* contact) {
    m_data.contactsStale = true;
    if (!m_data.stepping || m_data.listener == nullptr) return;  // told before the engine's edit: b2Bridge::EndContacts
    b2Contact* mirror = b2Bridge::Mirror(m_data, contact);
    b2Bridge::BeginCallback(*mirror);
    m_data.listener->EndContact(mirror);
    b2Bridge::BeginCallback(*mirror);  // a contact that ends has no manifold to change
}

void Events::PreSolve(Contact* contact, const Manifold* oldManifold) {
    if (m_data.listener == nullptr) return;
    b2Contact* mirror = b2Bridge::Mirror(m_data, contact);
    const b2Manifold old = ToBox2d(*oldManifold);
    b2Bridge::BeginCallback(*mirror);
    m_data.listener->PreSolve(mirror, &old);
    b2Bridge::EndCallback(*mirror);
}

void Events::PostSolve(Contact* contact, const ContactImpulse* impulse) {
    if (m_data.listener == nullptr) return;
    b2Contact* mirror = b2Bridge::Mirror(m_data, contact);
    b2ContactImpulse converted{};
    converted.count = impulse->count;
    for (int i = 0; i < impulse->count; ++i) {
        converted.normalImpulses[i] = impulse->normalImpulses[i];
        converted.tangentImpulses[i] = impulse->tangentImpulses[i];
    }
    b2Bridge::BeginCallback(*mirror);
    m_data.listener->PostSolve(mirror, &converted);
    b2Bridge::EndCallback(*mirror);
}

}  // namespace scree::box2d

bool b2ContactFilter::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) {
    const b2Filter& a = fixtureA->GetFilterData();
    const b2Filter& b = fixtureB->GetFilterData();
    if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
    return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}
