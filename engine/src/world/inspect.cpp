// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Read-only views and the hash of the engine's whole state.

#include "scree/inspect.h"

#include <bit>

#include "world/world_state.h"

namespace scree::inspect {

namespace {

/// Order-dependent 64-bit hash; the finaliser is MurmurHash3's (Appleby, 2011).
class Hasher {
public:
    void Add(uint64_t word) {
        word ^= word >> 33;
        word *= 0xff51afd7ed558ccdull;
        word ^= word >> 33;
        m_hash = (m_hash ^ word) * 0x9E3779B97F4A7C15ull;
        m_hash ^= m_hash >> 29;
    }
    void Add(float value) { Add(static_cast<uint64_t>(std::bit_cast<uint32_t>(value + 0.0f))); }  // −0 + 0 = +0
    void Add(Vec2 v) {
        Add(v.x);
        Add(v.y);
    }
    [[nodiscard]] uint64_t Get() const { return m_hash; }

private:
    uint64_t m_hash = 0x5CEEull;
};

void AddBodies(const BodyTable& bodies, Hasher& hash) {
    for (int body = 0; body < bodies.slots.Size(); ++body) {
        if (!bodies.slots.IsAlive(body)) continue;
        const auto b = static_cast<size_t>(body);
        hash.Add(static_cast<uint64_t>(body));
        hash.Add(bodies.position[b].c);
        hash.Add(bodies.position[b].a);
        hash.Add(bodies.velocity[b].v);
        hash.Add(bodies.velocity[b].w);
        hash.Add(bodies.force[b].force);
        hash.Add(bodies.force[b].torque);
        hash.Add(bodies.mass[b].invMass);
        hash.Add(bodies.mass[b].invI);
        hash.Add(bodies.motion[b].gravityScale);
        hash.Add(bodies.motion[b].linearDamping);
        hash.Add(bodies.motion[b].angularDamping);
        hash.Add(bodies.sleepTime[b]);
        hash.Add(static_cast<uint64_t>(bodies.flags[b]) << 8 | bodies.type[b]);
        hash.Add(static_cast<uint64_t>(bodies.info[b].fixtureCount));
    }
}

void AddContacts(const ContactTable& contacts, Hasher& hash) {
    for (int contact = 0; contact < contacts.Size(); ++contact) {
        if (!contacts.Has(contact, ContactFlag::alive)) continue;
        const auto c = static_cast<size_t>(contact);
        hash.Add(static_cast<uint64_t>(contact) << 8 | contacts.flags[c]);
        hash.Add(static_cast<uint64_t>(contacts.pair[c].fixtureA) << 32 | contacts.pair[c].fixtureB);
        const Manifold& m = contacts.manifold[c];
        hash.Add(static_cast<uint64_t>(m.pointCount));
        for (int i = 0; i < m.pointCount; ++i) {
            hash.Add(m.points[i].localPoint);
            hash.Add(m.points[i].normalImpulse);
            hash.Add(m.points[i].tangentImpulse);
            hash.Add(static_cast<uint64_t>(m.points[i].id.key));
        }
    }
}

void AddJoints(const JointTable& joints, Hasher& hash) {
    for (int joint = 0; joint < joints.slots.Size(); ++joint) {
        if (!joints.slots.IsAlive(joint)) continue;
        const JointInfo& info = joints.info[static_cast<size_t>(joint)];
        const RevoluteRow& row = joints.revolute[static_cast<size_t>(info.row)];
        hash.Add(static_cast<uint64_t>(info.bodyA) << 32 | static_cast<uint64_t>(info.bodyB));
        hash.Add(row.impulse);
        hash.Add(row.motorImpulse);
        hash.Add(row.lowerImpulse);
        hash.Add(row.upperImpulse);
        hash.Add(row.motorSpeed);
        hash.Add(row.maxMotorTorque);
        hash.Add(row.lowerAngle);
        hash.Add(row.upperAngle);
    }
}

}  // namespace

void GetNodes(const World& world, std::vector<BvhNode>& nodes) { world.GetState().broadPhase->GetNodes(nodes); }
int GetLeafSize(const World& world) { return world.GetState().broadPhase->GetLeafSize(); }
bool IsStaticTreeSeparate(const World& world) { return world.GetState().broadPhase->GetStats().staticTreeSeparate; }
BroadPhaseKind GetBroadPhase(const World& world) { return world.GetState().broadPhaseKind; }
uint64_t GetBoxTests(const World& world) { return world.GetState().broadPhase->GetStats().boxTests; }

MemoryUse GetMemoryUse(const World& world) {
    const WorldState& s = world.GetState();
    MemoryUse use;
    use.bytesPerBody = sizeof(Velocity) + 2 * sizeof(Position) + sizeof(Transform) + sizeof(MassRow) +
                       sizeof(ForceRow) + sizeof(MotionRow) + sizeof(float) + sizeof(uint16_t) + sizeof(BodyType) +
                       sizeof(BodyInfo) + sizeof(Body);
    use.bytesPerFixture = FixtureTable::GetBytesPerRow();
    use.bytesPerContact = ContactTable::GetBytesPerRow();
    use.bodies = static_cast<size_t>(s.bodies.slots.Size()) * use.bytesPerBody;
    use.fixtures = s.fixtures.GetMemoryBytes();
    use.contacts = s.contacts.GetMemoryBytes();
    use.joints = s.joints.info.size() * (sizeof(JointInfo) + sizeof(RevoluteRow) + sizeof(RevoluteJoint));
    use.broadPhase = s.broadPhase->GetMemoryBytes() + s.pairs.capacity() * sizeof(Pair);
    use.solverScratch = s.solverScratch.contacts.velocity.capacity() * sizeof(ContactVelocityRow) +
                        s.solverScratch.contacts.position.capacity() * sizeof(ContactPositionRow) +
                        s.solverScratch.joints.capacity() * sizeof(RevoluteConstraint) +
                        (s.islandScratch.first.capacity() + s.islandScratch.entries.capacity()) * sizeof(int);
    return use;
}

uint64_t GetStateHash(const World& world) {
    Hasher hash;
    AddBodies(world.GetState().bodies, hash);
    AddContacts(world.GetState().contacts, hash);
    AddJoints(world.GetState().joints, hash);
    return hash.Get();
}

}  // namespace scree::inspect
