// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What stands behind a b2World: the engine's world and the lists, callbacks and buffers that Box2D programs see.
// Objects of the two sides name each other. b2Body, b2Fixture and b2Joint hold the engine's handle. The engine's user
// data points back (for a fixture: at the b2FixtureProxy of its child).

#pragma once

#include <memory>
#include <mutex>
#include <unordered_set>
#include <vector>

#include "../box2d/box2d.h"
#include "call_file.h"
#include "scree/scree.h"

namespace scree::box2d {

/// Hears of the engine's contacts and tells the program's listener and filter.
class Events final : public ContactListener, public ContactFilter {
public:
    explicit Events(b2WorldData& data) : m_data(data) {}

    bool ShouldCollide(Fixture* fixtureA, Fixture* fixtureB) override;
    void BeginContact(Contact* contact) override;
    void EndContact(Contact* contact) override;
    void PreSolve(Contact* contact, const Manifold* oldManifold) override;
    void PostSolve(Contact* contact, const ContactImpulse* impulse) override;

private:
    b2WorldData& m_data;
};

}  // namespace scree::box2d

struct b2WorldData {
    b2WorldData(b2World* owner, const b2Vec2& gravity);

    b2World* world;
    scree::World engine;
    std::unique_ptr<scree::box2d::CallFile> callFile;  ///< null: nobody asked for one
    scree::box2d::Events events{*this};
    b2BlockAllocator allocator;  ///< of shapes

    b2ContactFilter defaultFilter;
    b2ContactFilter* filter = &defaultFilter;
    b2ContactListener* listener = nullptr;
    b2DestructionListener* destruction = nullptr;
    b2Draw* draw = nullptr;

    b2Body* bodies = nullptr;
    b2Joint* joints = nullptr;
    b2Contact* contacts = nullptr;
    std::unordered_set<b2Contact*> detached;  ///< their end is about to be told, the engine's contact is gone
    std::vector<b2Contact*> contactOfRow;     ///< by the engine's contact index; null where nobody looked yet
    std::vector<uint8_t> rowSeen;             ///< scratch of SyncContacts
    std::vector<b2Contact*> listed;           ///< scratch of SyncContacts: newest first
    bool contactsStale = false;               ///< the engine's contacts may have changed since SyncContacts
    bool stepping = false;
    int destructions = 0;            ///< calls that destroy, and have callbacks under way
    std::vector<uint8_t> endedRows;  ///< engine's contacts whose end was told before the engine removes them
    /// Of queries whose callbacks are under way; several threads may ask at once.
    std::vector<std::vector<b2Fixture*>*> reports;
    std::mutex reportsMutex;
    std::vector<b2Fixture*> refilters;  ///< whose filter a callback of the step has set

    std::vector<b2Fixture*> exposedShapes;  ///< fixtures whose shape the program may change
    int chainCount = 0;
    b2ContactManager manager;
    b2Profile profile{};
};

/// The one friend of the public classes: their private parts by name, and the upkeep of lists.
struct b2Bridge {
    static b2WorldData& Data(const b2World& world) { return *world.m_data; }
    static b2WorldData& Data(const b2Body& body) { return *body.m_world->m_data; }
    static scree::Body* Handle(const b2Body* body) { return body != nullptr ? body->m_handle : nullptr; }
    static scree::Joint* Handle(const b2Joint* joint) { return joint != nullptr ? joint->m_handle : nullptr; }
    static const b2FixtureProxy& ProxyOf(scree::Fixture* fixture) {
        return *reinterpret_cast<const b2FixtureProxy*>(fixture->GetUserData().pointer);
    }
    static b2Body* BodyOf(scree::Body* body) { return reinterpret_cast<b2Body*>(body->GetUserData().pointer); }

    // body.cpp
    static b2Body* MakeBody(b2World& world, const b2BodyDef& def, scree::Body* handle);
    static void FreeBody(b2Body* body);
    /// Copies what b2Body returns by reference.
    static void Refresh(const b2Body& body);
    static b2Body* Next(const b2Body& body) { return body.m_next; }

    // fixture.cpp
    static b2Fixture* MakeFixture(b2Body& body, const b2FixtureDef& def);
    /// Takes a fixture off its body's list, where it may be missing already.
    static void Unlink(const b2Fixture* fixture);
    /// The mirror only: takes it off its body's list and frees it. The engine's fixtures are gone or will be.
    static void FreeFixture(b2Fixture* fixture);
    static scree::Fixture* FirstHandle(const b2Fixture& fixture) { return fixture.m_handles[0]; }
    /// Hands changes of exposed shapes to the engine.
    static void SyncShapes(b2WorldData& data);
    static void ForgetShape(b2WorldData& data, b2Fixture* fixture);
    /// Hands the fixture's filter to the engine, whose contacts are asked about again.
    static void ApplyFilter(b2Fixture& fixture);
    static b2FixtureProxy& Proxy(const b2Fixture& fixture, int32 child) { return fixture.m_proxies[child]; }
    static int32 ChildCount(const b2Fixture& fixture) { return fixture.m_childCount; }
    static b2Fixture* Fixtures(const b2Body& body) { return body.m_fixtureList; }

    // contact_mirror.cpp
    /// The program's object of an engine's contact, made on first use.
    static b2Contact* Mirror(b2WorldData& data, scree::Contact* contact);
    static void FreeContact(b2WorldData& data, b2Contact* contact);
    static void Link(b2WorldData& data, b2Contact* mirror);
    /// Links what is listed anew: newest first, whoever was looked at first.
    static void OrderContacts(b2WorldData& data);
    /// Makes the lists agree with the engine's contacts. Free when nothing changed.
    static void SyncContacts(b2WorldData& data);
    /// Cuts a touching contact off the engine's, which is about to go: it keeps what it was, and its place in lists.
    static void Detach(b2WorldData& data, b2Contact* contact);
    static void FreeContactsOf(b2WorldData& data, const b2Fixture* fixture);
    static bool HasEnded(const b2WorldData& data, size_t row) {
        return row < data.endedRows.size() && data.endedRows[row] != 0;
    }
    static void BeginCallback(b2Contact& contact) { contact.m_manifoldExposed = false; }
    /// Hands a manifold that the callback may have changed to the engine.
    static void EndCallback(b2Contact& contact);

    // joint.cpp, joint_create.cpp
    static b2Joint* MakeJoint(b2WorldData& data, const b2JointDef& def);
    /// Anchors and axis as the definition gives them: what b2Joint returns by reference.
    static void CopyLocals(b2Joint& joint, const b2JointDef& def);
    static void Link(b2WorldData& data, b2Joint* joint);
    static void FreeJoint(b2WorldData& data, b2Joint* joint);

    // endings.cpp
    /// A contact whose end is to be told, and the engine's row of it, or `detachedRow`.
    struct Ending {
        b2Contact* contact;
        size_t row;
    };
    static constexpr size_t detachedRow = ~size_t{0};
    /// The touching contacts of a body, or of one fixture of it. None when nobody listens.
    static std::vector<Ending> FindEndings(b2WorldData& data, b2Body& body, const b2Fixture* only);
    static void TellEndings(b2WorldData& data, const std::vector<Ending>& endings);
    /// Cuts a body's touching contacts off the engine's, to tell their ends after the engine's edit.
    static std::vector<Ending> DetachContacts(b2WorldData& data, b2Body& body);
    static void DestroyFixture(b2WorldData& data, b2Body& body, b2Fixture* fixture);
    /// Both sides of a fixture, without callbacks.
    static void RemoveFixture(b2WorldData& data, b2Body& body, b2Fixture* fixture);
    static void SetEnabled(b2WorldData& data, b2Body& body, bool flag);
    static void SetType(b2WorldData& data, b2Body& body, b2BodyType type);
    static void DestroyBody(b2WorldData& data, b2Body* body);
    /// Destroys a joint on both sides, gears on it first.
    static void DestroyJoint(b2WorldData& data, b2Joint* joint);
    /// Takes a fixture out of what queries are about to report.
    static void ForgetReports(b2WorldData& data, const b2Fixture* fixture);
    static bool IsDying(const b2Body& body) { return body.m_dying; }

    // broad_phase.cpp
    static void ShowWorld(b2BroadPhase& broadPhase, const b2World* world);
    static void Touch(b2WorldData& data);
};
