// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Read-only views and the hash of the engine's whole state.

#include "scree/inspect.h"

#include <bit>
#include <type_traits>

#include "base/bytes.h"
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

void AddDemand(const BodyDemand& demand, Hasher& hash) {
    for (const float value : {demand.overlap, demand.jointGap, demand.pullRate, demand.wanted}) hash.Add(value);
    hash.Add(static_cast<uint64_t>(demand.substeps));
}

void AddBodies(const BodyTable& bodies, Hasher& hash) {
    for (int body = 0; body < bodies.slots.Size(); ++body) {
        if (!bodies.slots.IsAlive(body)) continue;
        const auto b = static_cast<size_t>(body);
        hash.Add(static_cast<uint64_t>(body));
        hash.Add(bodies.position[b].c);
        hash.Add(bodies.position[b].a);
        hash.Add(bodies.position[b].aRest);
        if (bodies.IsFar()) hash.Add(bodies.rest[b].end);
        hash.Add(bodies.velocity[b].v);
        hash.Add(bodies.velocity[b].w);
        const ForceRow force = bodies.GetForce(body);
        hash.Add(force.force);
        hash.Add(force.torque);
        hash.Add(bodies.mass[b].invMass);
        hash.Add(bodies.mass[b].invI);
        hash.Add(bodies.mass[b].localCenter);
        hash.Add(bodies.motion[b].gravityScale);
        hash.Add(bodies.motion[b].linearDamping);
        hash.Add(bodies.motion[b].angularDamping);
        if (!bodies.demand.empty()) AddDemand(bodies.demand[b], hash);
        hash.Add(bodies.sleepTime[b]);
        hash.Add(static_cast<uint64_t>(bodies.flags[b]) << 8 | bodies.type[b]);
        hash.Add(static_cast<uint64_t>(bodies.info[b].fixtureCount));
    }
}

void AddFixtures(const FixtureTable& fixtures, Hasher& hash) {
    for (int fixture = 0; fixture < fixtures.slots.Size(); ++fixture) {
        if (!fixtures.slots.IsAlive(fixture)) continue;
        const auto f = static_cast<size_t>(fixture);
        hash.Add(static_cast<uint64_t>(fixture) << 32 | static_cast<uint64_t>(fixtures.body[f]));
        const Filter& filter = fixtures.filter[f];
        hash.Add(static_cast<uint64_t>(filter.categoryBits) << 32 | static_cast<uint64_t>(filter.maskBits) << 16 |
                 static_cast<uint16_t>(filter.groupIndex));
        hash.Add(fixtures.material[f].friction);
        hash.Add(fixtures.material[f].restitution);
        hash.Add(fixtures.material[f].restitutionThreshold);
        hash.Add(fixtures.info[f].density);
        hash.Add(static_cast<uint64_t>(fixtures.isSensor[f]) << 1 | (fixtures.info[f].inBroadPhase ? 1u : 0u));
        hash.Add(static_cast<uint64_t>(fixtures.info[f].chainId) << 32 |
                 static_cast<uint32_t>(fixtures.info[f].chainIndex));
    }
}

void AddSettings(const WorldState& s, Hasher& hash) {
    hash.Add(s.def.gravity);
    hash.Add(s.lastInverseDt);
    const bool flags[] = {s.def.allowSleep,  s.def.warmStarting, s.def.continuousPhysics,
                          s.def.subStepping, s.def.exactDrift,   s.autoClearForces,
                          s.pairsStale};
    for (const bool flag : flags) hash.Add(static_cast<uint64_t>(flag));
}

void AddContacts(const ContactTable& contacts, Hasher& hash) {
    for (int contact = 0; contact < contacts.Size(); ++contact) {
        if (!contacts.Has(contact, ContactFlag::alive)) continue;
        const auto c = static_cast<size_t>(contact);
        hash.Add(static_cast<uint64_t>(contact) << 8 | contacts.flags[c]);
        hash.Add(static_cast<uint64_t>(contacts.pair[c].fixtureA) << 32 | contacts.pair[c].fixtureB);
        const Manifold& m = contacts.manifold[c];
        hash.Add(static_cast<uint64_t>(m.pointCount));
        hash.Add(contacts.material[c].friction);
        hash.Add(contacts.material[c].restitution);
        hash.Add(contacts.material[c].restitutionThreshold);
        hash.Add(contacts.material[c].tangentSpeed);
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
        hash.Add(static_cast<uint64_t>(joint) << 8 | info.type);
        hash.Add(static_cast<uint64_t>(info.bodyA) << 32 | static_cast<uint64_t>(info.bodyB));
        hash.Add(static_cast<uint64_t>(info.collideConnected));
        JointTable::WithStore(joints, info.type, [&](const auto& store) {
            const auto& row = store.rows[static_cast<size_t>(info.row)];
            row.Fields(row, [&](const auto& field) {
                if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(field)>>) {
                    hash.Add(static_cast<uint64_t>(field));
                } else {
                    hash.Add(field);
                }
            });
        });
    }
}

}  // namespace

void GetNodes(const World& world, std::vector<BvhNode>& nodes) { world.GetState().broadPhase->GetNodes(nodes); }
int GetLeafSize(const World& world) { return world.GetState().broadPhase->GetLeafSize(); }
bool IsStaticTreeSeparate(const World& world) { return world.GetState().broadPhase->GetStats().staticTreeSeparate; }
BroadPhaseKind GetBroadPhase(const World& world) { return world.GetState().broadPhaseKind; }
uint64_t GetBoxTests(const World& world) { return world.GetState().broadPhase->GetStats().boxTests; }
int GetListedCount(const World& world) { return static_cast<int>(world.GetState().bodies.Listed().size()); }
int GetActiveContactCount(const World& world) { return world.GetState().contacts.active.Count(); }
const TOIStats& GetDistanceWork(const World& world) { return world.GetState().distanceWork; }

void GetContactColours(const World& world, std::vector<int>& colours) {
    const WorldState& s = world.GetState();
    colours.assign(s.contacts.GetNumberEnd(), -1);
    // The soft step solves all active contacts, or group by group; sequential impulses those of large islands.
    const std::span<const SubstepGroup> groups = s.substepGroups.Get();
    const std::vector<int>& active = groups.empty() ? s.active.contacts : groups.back().lists.contacts;
    const std::vector<int>& list = s.active.contacts.empty() ? s.solverScratch.wide.contacts : active;
    const std::span<const int> found = s.solverScratch.blocks.GetColours();
    if (list.empty() || found.size() != list.size()) return;
    for (size_t i = 0; i < list.size(); ++i) {
        // A row that another contact has taken since does not touch yet.
        if (!s.contacts.IsAlive(list[i]) || !s.contacts.Has(list[i], ContactFlag::touching)) continue;
        colours[static_cast<size_t>(s.contacts.GetNumber(list[i]))] = found[i];
    }
}

MemoryUse GetMemoryUse(const World& world) {
    const WorldState& s = world.GetState();
    MemoryUse use;
    use.bytesPerBody = sizeof(Velocity) + 2 * sizeof(Position) + sizeof(Transform) + sizeof(MassRow) +
                       (s.bodies.force.empty() ? 0 : sizeof(ForceRow)) +
                       (s.bodies.rest.empty() ? 0 : sizeof(PositionRest)) +
                       (s.bodies.startVelocity.empty() ? 0 : sizeof(Velocity)) + sizeof(MotionRow) +
                       (s.bodies.demand.empty() ? 0 : sizeof(BodyDemand)) + sizeof(float) + sizeof(uint16_t) +
                       sizeof(BodyType) + sizeof(int) + sizeof(BodyInfo) + sizeof(Body);
    use.bytesPerFixture = FixtureTable::GetBytesPerRow();
    use.bytesPerContact = ContactTable::GetBytesPerRow();
    const BodyTable& b = s.bodies;
    use.bodies = BytesOf(b.velocity, b.startVelocity, b.position, b.startPosition, b.rest, b.transform, b.mass, b.force,
                         b.motion, b.demand, b.sleepTime, b.flags, b.type, b.fixtureHead, b.info, b.movers) +
                 b.handles.size() * sizeof(Body);
    use.fixtures = s.fixtures.GetMemoryBytes();
    use.contacts = s.contacts.GetMemoryBytes();
    use.joints = s.joints.GetMemoryBytes();
    use.broadPhase = s.broadPhase->GetMemoryBytes() + BytesOf(s.pairs);
    use.solverScratch = s.solverScratch.GetMemoryBytes() + s.islandScratch.GetMemoryBytes() +
                        s.islands.GetMemoryBytes() + s.active.GetMemoryBytes() + s.substepGroups.GetMemoryBytes() +
                        BytesOf(s.narrowPhaseScratch.findings) + s.continuousScratch.GetMemoryBytes();
    return use;
}

void SetIsolatedPath(World& world, bool apart) {
    world.GetState().isolatedPath = apart ? IsolatedPath::apart : IsolatedPath::asIslands;
}

KernelSet GetKernels(const World& world) { return world.GetState().kernels; }

uint64_t GetStateHash(const World& world) {
    Hasher hash;
    AddBodies(world.GetState().bodies, hash);
    AddFixtures(world.GetState().fixtures, hash);
    AddSettings(world.GetState(), hash);
    AddContacts(world.GetState().contacts, hash);
    AddJoints(world.GetState().joints, hash);
    return hash.Get();
}

}  // namespace scree::inspect
