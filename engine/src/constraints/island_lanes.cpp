// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Finds out who takes part, and keeps bodies while they are solved.

#include "constraints/island_lanes.h"

#include <algorithm>

#include "constraints/contact_block.h"

namespace scree {

namespace {

/// A lane that has no contact says what another one says, and has no points.
void Repeat(int from, int to, LaneNames& names) {
    names.contact[to] = names.contact[from];
    names.bodyA[to] = names.bodyA[from], names.bodyB[to] = names.bodyB[from];
    names.radiusA[to] = names.radiusA[from], names.radiusB[to] = names.radiusB[from];
    names.isCircles[to] = names.isCircles[from], names.isFaceB[to] = names.isFaceB[from];
    names.pointCount[to] = 0.0f;
}

}  // namespace

void IslandLanes::TakeBodies(const BodyTable& bodies, Column<BodyIndex, int>& slotOf) {
    m_bodies.clear();
    m_slotCount = {};
    size_t contacts = 0, slots[islandLanes] = {};
    for (const Member& member : m_members) {
        contacts = std::max(contacts, ToSize(member.first) + member.contacts.size());
        slots[member.lane] += member.bodies.size() + member.contacts.size();
    }
    const size_t rows = *std::max_element(slots, slots + islandLanes) * islandLanes;
    m_contacts.resize(contacts);
    m_named.assign(contacts * islandLanes, ContactIndex::none);
    m_velocity.resize(rows);
    m_position.assign(rows, Position{});
    m_rotation.resize(rows);
    for (const Member& member : m_members) {
        const size_t lane = ToSize(member.lane);
        for (size_t i = 0; i < member.contacts.size(); ++i) {
            m_named[(ToSize(member.first) + i) * islandLanes + lane] = member.contacts[i];
        }
        for (const BodyIndex body : member.bodies) {
            if (bodies.type[body] != dynamicBody) continue;
            slotOf[body] = static_cast<int>(m_slotCount[lane]);
            m_bodies.push_back({m_slotCount[lane]++ * islandLanes + lane, body});
        }
    }
}

void IslandLanes::Name(const LaneInput& input, size_t number, const Column<BodyIndex, int>& slotOf, LaneNames& names) {
    LaneContact& contact = m_contacts[number];
    names.anyCircles = names.anyPairs = false;
    int spare[islandLanes];
    int spareCount = 0, known = 0;
    for (int lane = 0; lane < islandLanes; ++lane) {
        const ContactIndex index = m_named[number * islandLanes + ToSize(lane)];
        contact.isActive[lane] = IsNone(index) ? 0.0f : 1.0f;
        if (IsNone(index)) {
            contact.bodyA[lane] = contact.bodyB[lane] = lane;  // the first row of the lane
            spare[spareCount++] = lane;
            continue;
        }
        const auto rowOf = [&](BodyIndex body) {
            if (input.bodies.type[body] == dynamicBody) return slotOf[body] * islandLanes + lane;
            const size_t row = m_slotCount[ToSize(lane)]++ * islandLanes + ToSize(lane);
            m_bodies.push_back({row, body});
            return static_cast<int>(row);
        };
        const ContactPair& pair = input.contacts.pair[index];
        const Manifold& manifold = input.contacts.manifold[index];
        contact.bodyA[lane] = rowOf(pair.bodyA), contact.bodyB[lane] = rowOf(pair.bodyB);
        names.contact[lane] = ToInt(index);
        names.bodyA[lane] = ToInt(pair.bodyA), names.bodyB[lane] = ToInt(pair.bodyB);
        names.radiusA[lane] = input.fixtures.shape[pair.fixtureA]->m_radius;
        names.radiusB[lane] = input.fixtures.shape[pair.fixtureB]->m_radius;
        const bool isCircles = manifold.type == Manifold::e_circles;
        names.isCircles[lane] = isCircles ? 1.0f : 0.0f;
        names.isFaceB[lane] = manifold.type == Manifold::e_faceB ? 1.0f : 0.0f;
        names.pointCount[lane] = static_cast<float>(manifold.pointCount);
        names.anyCircles = names.anyCircles || isCircles;
        names.anyPairs = names.anyPairs || manifold.pointCount == 2;
        known = lane;
    }
    for (int i = 0; i < spareCount; ++i) Repeat(known, spare[i], names);
}

void IslandLanes::Prepare(const LaneInput& input, std::span<const Member> members, Column<BodyIndex, int>& slotOf) {
    static_assert(sizeof(Transform) == 4 * sizeof(float) && sizeof(MassRow) == 4 * sizeof(float));
    static_assert(sizeof(Manifold) == manifoldFloats * sizeof(float));
    static_assert(sizeof(ContactMaterial) == 4 * sizeof(float));
    m_members.assign(members.begin(), members.end());
    m_isSolved.assign(members.size(), 0);
    TakeBodies(input.bodies, slotOf);
    const LaneKernels& kernels = GetLaneKernels();
    const LaneSource source{.transform = &input.bodies.transform.data()->p.x,
                            .position = &input.bodies.position.data()->c.x,
                            .velocity = &input.bodies.velocity.data()->v.x,
                            .mass = &input.bodies.mass.data()->invMass,
                            .manifold = &input.contacts.manifold.data()->points[0].localPoint.x,
                            .material = &input.contacts.material.data()->friction,
                            .impulseScale = input.impulseScale,
                            .restitution = input.restitution};
    LaneNames names;
    for (size_t number = 0; number < m_contacts.size(); ++number) {
        Name(input, number, slotOf, names);
        kernels.prepare(source, names, m_contacts[number]);
    }
}

LaneTask IslandLanes::MakeTask() {
    static_assert(sizeof(Velocity) == 4 * sizeof(float) && sizeof(Position) == 4 * sizeof(float));
    return {.contacts = m_contacts.data(),
            .count = static_cast<int32_t>(m_contacts.size()),
            .velocity = &m_velocity.data()->v.x,
            .position = &m_position.data()->c.x,
            .rotation = m_rotation.data()->data(),
            .friction = true,
            .share = 0.0f,
            .slop = 0.0f,
            .largestPush = 0.0f};
}

void IslandLanes::SolveVelocities(int iterations, bool warmStart, bool friction, BodyTable& bodies) {
    const LaneKernels& kernels = GetLaneKernels();
    for (const Slot& slot : m_bodies) m_velocity[slot.row] = bodies.velocity[slot.body];
    LaneTask task = MakeTask();
    task.friction = friction;
    if (warmStart) kernels.warmStart(task);
    kernels.solveVelocities(task, iterations);
    for (const Slot& slot : m_bodies) {
        if (bodies.mass[slot.body].invMass > 0.0f) bodies.velocity[slot.body] = m_velocity[slot.row];
    }
}

void IslandLanes::StoreImpulses(Column<ContactIndex, Manifold>& manifold) const {
    for (const Member& member : m_members) {
        const int lane = member.lane;
        for (size_t i = 0; i < member.contacts.size(); ++i) {
            const LaneContact& contact = m_contacts[ToSize(member.first) + i];
            const auto count = static_cast<int>(contact.pointCount[lane]);
            for (int p = 0; p < count; ++p) {
                ManifoldPoint& point = manifold[member.contacts[i]].points[p];
                point.normalImpulse = contact.points[p].normalImpulse[lane];
                point.tangentImpulse = contact.points[p].tangentImpulse[lane];
            }
        }
    }
}

bool IslandLanes::EndSolved(float tolerance) {
    bool isAnyLeft = false;
    for (size_t i = 0; i < m_members.size(); ++i) {
        if (m_isSolved[i] != 0) continue;
        const Member& member = m_members[i];
        const std::span<LaneContact> own(m_contacts.data() + member.first, member.contacts.size());
        const auto isWithin = [&](const LaneContact& contact) { return contact.separation[member.lane] >= tolerance; };
        if (!std::ranges::all_of(own, isWithin)) {
            isAnyLeft = true;
            continue;
        }
        m_isSolved[i] = 1;
        for (LaneContact& contact : own) contact.isActive[member.lane] = 0.0f;
    }
    return isAnyLeft;
}

void IslandLanes::SolvePositions(int iterations, float tolerance, const PushApart& how, BodyTable& bodies) {
    const LaneKernels& kernels = GetLaneKernels();
    for (const Slot& slot : m_bodies) m_position[slot.row] = bodies.position[slot.body];
    LaneTask task = MakeTask();
    task.share = how.share;
    task.slop = linearSlop * how.lengthScale;
    task.largestPush = maxLinearCorrection * how.lengthScale;
    kernels.turn(task, static_cast<int32_t>(m_position.size()));
    for (int i = 0; i < iterations; ++i) {
        kernels.solvePositions(task);
        if (!EndSolved(tolerance)) break;
    }
    for (const Slot& slot : m_bodies) {
        if (bodies.mass[slot.body].invMass <= 0.0f) continue;
        const Position& now = m_position[slot.row];
        bodies.position[slot.body].c = now.c, bodies.position[slot.body].a = now.a;
    }
}

}  // namespace scree
