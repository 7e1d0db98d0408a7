// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Read-only views of a world's insides.

#include "scree/inspect.h"

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
    // The soft step solves all active contacts, or group by group; sequential impulses those of large islands.
    const std::span<const SubstepGroup> groups = s.substepGroups.Get();
    const std::vector<ContactIndex>& active = groups.empty() ? s.active.contacts : groups.back().lists.contacts;
    if (!s.active.contacts.empty()) return note(active, s.solverScratch.blocks.GetColours());
    size_t wide = 0;
    for (const Island& island : s.islands.islands) {
        if (!IsWide(island) || wide == s.solverScratch.wide.size()) continue;
        note(Contacts(s.islands, island), s.solverScratch.wide[wide++].GetColours());
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
                        s.continuousScratch.GetMemoryBytes();
    return use;
}

void SetIsolatedPath(World& world, bool apart) {
    world.GetState().isolatedPath = apart ? IsolatedPath::apart : IsolatedPath::asIslands;
}

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

void GetTouchingContacts(const World& world, std::vector<ContactView>& views) {
    const WorldState& s = world.GetState();
    const ContactTable& contacts = s.contacts;
    // Written in place, and over the views of an earlier call: whoever records does this in every step.
    std::size_t count = 0;
    for (ContactIndex c = contacts.LastAliveBelow(contacts.flags.End()); IsSome(c); c = contacts.LastAliveBelow(c)) {
        if (!contacts.Has(c, ContactFlag::touching)) continue;
        const ContactPair& pair = contacts.pair[c];
        const Vec2 frame = FrameOf(s.bodies, pair.bodyA, pair.bodyB);
        if (count == views.size()) views.emplace_back();
        ContactView& view = views[count++];
        view.fixtureA = ToInt(pair.fixtureA);
        view.fixtureB = ToInt(pair.fixtureB);
        view.isSensor = (s.fixtures.isSensor[pair.fixtureA] | s.fixtures.isSensor[pair.fixtureB]) != 0;
        view.radiusA = s.fixtures.shape[pair.fixtureA]->m_radius;
        view.radiusB = s.fixtures.shape[pair.fixtureB]->m_radius;
        view.placeA = TransformIn(frame, s.bodies, pair.bodyA);
        view.placeB = TransformIn(frame, s.bodies, pair.bodyB);
        view.frame = frame;
        view.manifold = contacts.manifold[c];
    }
    views.resize(count);
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
