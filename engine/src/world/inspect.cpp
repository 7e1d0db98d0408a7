// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Read-only views of a world's insides.

#include "scree/inspect.h"

#include <algorithm>
#include <cstring>

#include "pipeline/parts/lane_solver.h"
#include "state/frames.h"
#include "world/world_state.h"

namespace scree::inspect {

void GetNodes(const World& world, std::vector<BvhNode>& nodes) { world.GetState().broadPhase->GetNodes(nodes); }
int GetLeafSize(const World& world) { return world.GetState().broadPhase->GetLeafSize(); }
bool IsStaticTreeSeparate(const World& world) { return world.GetState().broadPhase->GetStats().staticTreeSeparate; }
const WorldDef& GetDefinition(const World& world) { return world.GetState().def; }
BroadPhaseKind GetBroadPhase(const World& world) { return world.GetState().broadPhaseKind; }
uint64_t GetBoxTests(const World& world) { return world.GetState().broadPhase->GetStats().boxTests; }
int GetListedCount(const World& world) { return world.GetState().bodies.listedRows.Count(); }
int GetActiveContactCount(const World& world) { return world.GetState().contacts.active.Count(); }
const TOIStats& GetDistanceWork(const World& world) { return world.GetState().distanceWork; }

void GetContactColours(const World& world, std::vector<int>& colours) {
    const WorldState& s = world.GetState();
    colours.assign(s.contacts.GetNumberEnd(), -1);
    const auto note = [&](std::span<const ContactIndex> list, std::span<const int> found) {
        if (found.size() != list.size()) return;
        for (size_t i = 0; i < list.size(); ++i) {
            // A row that another contact has taken since does not touch yet.
            if (!s.contacts.IsAlive(list[i]) || !s.contacts.Has(list[i], ContactFlag::touching)) continue;
            colours[ToSize(s.contacts.GetNumber(list[i]))] = found[i];
        }
    };
    // The soft step solves all active contacts, or group by group; sequential impulses those of wide islands.
    const std::span<const SubstepGroup> groups = s.substepGroups.Get();
    const std::vector<ContactIndex>& active = groups.empty() ? s.active.contacts : groups.back().lists.contacts;
    if (!s.active.contacts.empty()) return note(active, s.solverScratch.constraints.blocks.GetColours());
    const std::span<const int> found(s.solverScratch.colours);
    if (found.size() != s.islands.contacts.size()) return;
    for (const Island& island : s.islands.islands) {
        if (!IsWide(island)) continue;
        note(Contacts(s.islands, island), found.subspan(ToSize(island.contactBegin), ToSize(CountContacts(island))));
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
    use.broadPhase = s.broadPhase->GetMemoryBytes() + BytesOf(s.pairs, s.editedPairs) + s.edited.GetMemoryBytes() +
                     s.log.GetMemoryBytes();
    use.solverScratch = s.solverScratch.GetMemoryBytes() + s.islandScratch.GetMemoryBytes() +
                        s.islands.GetMemoryBytes() + s.active.GetMemoryBytes() + s.substepGroups.GetMemoryBytes() +
                        BytesOf(s.narrowPhaseScratch.findings, s.narrowPhaseScratch.old) +
                        s.continuousScratch.GetMemoryBytes() + GetMemoryBytes(s.restScratches);
    return use;
}

void SetIsolatedPath(World& world, bool apart) {
    world.GetState().isolatedPath = apart ? IsolatedPath::apart : IsolatedPath::asIslands;
}

void SetDirectJoints(World& world, bool direct) { world.GetState().directJoints = direct; }
bool GetDirectJoints(const World& world) { return world.GetState().directJoints; }

void GetBodies(const World& world, std::vector<BodyView>& views) {
    const WorldState& s = world.GetState();
    const BodyTable& bodies = s.bodies;
    views.clear();
    for (BodyIndex b = bodies.listHead; IsSome(b); b = bodies.info[b].listNext) {
        const FixtureIndex newest = bodies.fixtureHead[b];
        const uint32_t generation = IsSome(newest) ? s.fixtures.slots.GetGeneration(newest) : 0;
        views.push_back({.body = &bodies.handles[b],
                         .generation = bodies.slots.GetGeneration(b),
                         .newestFixture = {ToInt(newest), generation},
                         .type = bodies.type[b],
                         .isAwake = bodies.Has(b, BodyFlag::awake),
                         .position = bodies.transform[b].p,
                         .linearVelocity = bodies.velocity[b].v,
                         .angle = bodies.position[b].a,
                         .angularVelocity = bodies.velocity[b].w});
    }
}

namespace {

// A contact in words. The first one tells which of the others are there.
constexpr uint32_t countBits = 3, typeShift = 2, typeBits = 3, sensorBit = 16, radiiBit = 32;
constexpr size_t mostContactWords = 5 + 2 + 10 + 4 + 4 * maxManifoldPoints;

template <typename T>
uint32_t* Put(uint32_t* out, const T& value) {
    std::memcpy(out, &value, sizeof value);
    return out + sizeof value / sizeof(uint32_t);
}
template <typename T>
void TakeTo(T& value, const uint32_t*& at) {
    std::memcpy(&value, at, sizeof value);
    at += sizeof value / sizeof(uint32_t);
}

}  // namespace

void TouchingContacts::Take(const World& world) {
    const WorldState& s = world.GetState();
    const ContactTable& contacts = s.contacts;
    const bool isFar = s.bodies.IsFar();
    if (isFar) {
        m_places.clear();
    } else {
        m_places.assign(s.bodies.transform.begin(), s.bodies.transform.end());
    }
    m_count = 0;
    // Written over the words of an earlier call: it is slow to bring memory to this core that another one has read.
    uint32_t* out = m_words.data();
    uint32_t* end = out + m_words.size();
    for (ContactIndex c = contacts.LastAliveBelow(contacts.flags.End()); IsSome(c); c = contacts.LastAliveBelow(c)) {
        if (!contacts.Has(c, ContactFlag::touching)) continue;
        if (end - out < static_cast<ptrdiff_t>(mostContactWords)) {
            const auto used = out - m_words.data();
            m_words.resize(std::max(2 * m_words.size(), 64 * mostContactWords));
            out = m_words.data() + used, end = m_words.data() + m_words.size();
        }
        const ContactPair& pair = contacts.pair[c];
        const Manifold& manifold = contacts.manifold[c];
        const float radii[] = {s.fixtures.shape[pair.fixtureA]->m_radius, s.fixtures.shape[pair.fixtureB]->m_radius};
        const bool hasRadii = radii[0] != polygonRadius || radii[1] != polygonRadius;
        const bool isSensor = (s.fixtures.isSensor[pair.fixtureA] | s.fixtures.isSensor[pair.fixtureB]) != 0;
        *out++ = static_cast<uint32_t>(manifold.pointCount) | static_cast<uint32_t>(manifold.type) << typeShift |
                 (isSensor ? sensorBit : 0) | (hasRadii ? radiiBit : 0);
        out = Put(out, pair);
        if (hasRadii) out = Put(out, radii);
        if (isFar) {
            const Vec2 frame = FrameOf(s.bodies, pair.bodyA, pair.bodyB);
            out = Put(out, TransformIn(frame, s.bodies, pair.bodyA));
            out = Put(Put(out, TransformIn(frame, s.bodies, pair.bodyB)), frame);
        }
        if (manifold.pointCount > 0) out = Put(Put(out, manifold.localNormal), manifold.localPoint);
        for (int i = 0; i < manifold.pointCount; ++i) {
            const ManifoldPoint& point = manifold.points[i];
            out = Put(Put(Put(out, point.localPoint), point.normalImpulse), point.tangentImpulse);
        }
        ++m_count;
    }
    m_used = static_cast<size_t>(out - m_words.data());
}

ContactView TouchingContacts::ViewAt(const uint32_t*& at) const {
    ContactView view{};
    const uint32_t head = *at++;
    view.isSensor = (head & sensorBit) != 0;
    view.manifold.pointCount = static_cast<int8_t>(head & countBits);
    view.manifold.type = static_cast<Manifold::Type>(head >> typeShift & typeBits);
    ContactPair pair;
    TakeTo(pair, at);
    view.fixtureA = ToInt(pair.fixtureA), view.fixtureB = ToInt(pair.fixtureB);
    view.radiusA = view.radiusB = polygonRadius;
    if ((head & radiiBit) != 0) TakeTo(view.radiusA, at), TakeTo(view.radiusB, at);
    if (m_places.empty()) {
        TakeTo(view.placeA, at), TakeTo(view.placeB, at), TakeTo(view.frame, at);
    } else {
        view.placeA = m_places[ToSize(pair.bodyA)], view.placeB = m_places[ToSize(pair.bodyB)];
    }
    if (view.manifold.pointCount > 0) TakeTo(view.manifold.localNormal, at), TakeTo(view.manifold.localPoint, at);
    for (int i = 0; i < view.manifold.pointCount; ++i) {
        ManifoldPoint& point = view.manifold.points[i];
        TakeTo(point.localPoint, at), TakeTo(point.normalImpulse, at), TakeTo(point.tangentImpulse, at);
    }
    return view;
}

WorldManifold ContactView::GetPoints() const {
    WorldManifold placed;
    placed.normal = vec2Zero;
    placed.Initialize(&manifold, placeA, radiusA, placeB, radiusB);
    if (frame == vec2Zero) return placed;
    for (int i = 0; i < manifold.pointCount; ++i) placed.points[i] += frame;
    return placed;
}

KernelSet GetKernels(const World& world) { return world.GetState().kernels; }

}  // namespace scree::inspect
