// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows of structures become structures of rows: lane by lane, a number at a time.

#include "constraints/island_lanes.h"

#include <algorithm>

namespace scree {

namespace {

void PackPoint(const ContactPointRow& from, size_t lane, LaneContact::Point& to) {
    to.armAX[lane] = from.rA.x, to.armAY[lane] = from.rA.y, to.armBX[lane] = from.rB.x, to.armBY[lane] = from.rB.y;
    to.normalMass[lane] = from.normalMass, to.tangentMass[lane] = from.tangentMass;
    to.bias[lane] = from.velocityBias;
    to.normalImpulse[lane] = from.normalImpulse, to.tangentImpulse[lane] = from.tangentImpulse;
}

void Pack(const ContactVelocityRow& from, size_t lane, LaneContact& to) {
    to.invMassA[lane] = from.invMassA, to.invMassB[lane] = from.invMassB;
    to.invIA[lane] = from.invIA, to.invIB[lane] = from.invIB;
    to.normalX[lane] = from.normal.x, to.normalY[lane] = from.normal.y;
    to.friction[lane] = from.friction, to.tangentSpeed[lane] = from.tangentSpeed;
    to.pointCount[lane] = static_cast<float>(from.pointCount);
    for (int p = 0; p < from.pointCount; ++p) PackPoint(from.points[p], lane, to.points[p]);
    to.isBlock[lane] = from.block ? 1.0f : 0.0f;
    if (!from.block) return;
    to.k11[lane] = from.k11, to.k12[lane] = from.k12, to.k22[lane] = from.k22;
    to.inv11[lane] = from.inv11, to.inv12[lane] = from.inv12, to.inv22[lane] = from.inv22;
}

void Pack(const ContactPositionRow& from, size_t lane, LaneContact& to) {
    to.centerAX[lane] = from.massA.localCenter.x, to.centerAY[lane] = from.massA.localCenter.y;
    to.centerBX[lane] = from.massB.localCenter.x, to.centerBY[lane] = from.massB.localCenter.y;
    to.positionCount[lane] = static_cast<float>(from.pointCount);
    to.isCircles[lane] = from.type == Manifold::e_circles ? 1.0f : 0.0f;
    to.isFaceB[lane] = from.type == Manifold::e_faceB ? 1.0f : 0.0f;
    to.localNormalX[lane] = from.localNormal.x, to.localNormalY[lane] = from.localNormal.y;
    to.localPointX[lane] = from.localPoint.x, to.localPointY[lane] = from.localPoint.y;
    to.radius[lane] = from.radius;
    for (int p = 0; p < from.pointCount; ++p) {
        to.points[p].localX[lane] = from.localPoints[p].x, to.points[p].localY[lane] = from.localPoints[p].y;
    }
}

}  // namespace

void IslandLanes::Gather(std::span<const Member> members, const BodyTable& bodies, Column<BodyIndex, int>& slotOf) {
    m_members.assign(members.begin(), members.end());
    m_bodies.clear();
    size_t contacts = 0, slots = 0;
    for (const Member& member : members) {
        contacts = std::max(contacts, member.velocity.size());
        slots = std::max(slots, member.bodies.size() + member.velocity.size());
    }
    m_contacts.resize(contacts);
    m_velocity.resize(slots * islandLanes);
    m_position.assign(slots * islandLanes, Position{});
    m_rotation.resize(slots * islandLanes);
    // Contacts that a lane lacks name the first row of the lane and have no points; the rest of them is not used.
    for (LaneContact& contact : m_contacts) {
        for (int lane = 0; lane < islandLanes; ++lane) {
            contact.bodyA[lane] = contact.bodyB[lane] = lane;
            contact.pointCount[lane] = contact.positionCount[lane] = contact.isBlock[lane] = 0.0f;
        }
    }
    std::fill(std::begin(m_active), std::end(m_active), 0.0f);
    for (size_t lane = 0; lane < members.size(); ++lane) {
        const Member& member = members[lane];
        m_active[lane] = 1.0f;
        m_slotCount[lane] = 0;
        for (const BodyIndex body : member.bodies) {
            if (bodies.type[body] != dynamicBody) continue;
            slotOf[body] = static_cast<int>(m_slotCount[lane]);
            m_bodies.push_back({m_slotCount[lane]++ * islandLanes + lane, body});
        }
        GatherContacts(lane, member, bodies, slotOf);
    }
}

void IslandLanes::GatherContacts(size_t lane, const Member& member, const BodyTable& bodies,
                                 const Column<BodyIndex, int>& slotOf) {
    const auto rowOf = [&](BodyIndex body) {
        if (bodies.type[body] == dynamicBody) return slotOf[body] * islandLanes + static_cast<int>(lane);
        const size_t row = m_slotCount[lane]++ * islandLanes + lane;
        m_bodies.push_back({row, body});
        return static_cast<int>(row);
    };
    for (size_t i = 0; i < member.velocity.size(); ++i) {
        LaneContact& contact = m_contacts[i];
        const ContactVelocityRow& row = member.velocity[i];
        contact.bodyA[lane] = rowOf(row.bodyA), contact.bodyB[lane] = rowOf(row.bodyB);
        Pack(row, lane, contact);
        Pack(member.position[i], lane, contact);
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
    for (size_t lane = 0; lane < m_members.size(); ++lane) {
        const std::span<ContactVelocityRow> rows = m_members[lane].velocity;
        for (size_t i = 0; i < rows.size(); ++i) {
            for (int p = 0; p < rows[i].pointCount; ++p) {
                rows[i].points[p].normalImpulse = m_contacts[i].points[p].normalImpulse[lane];
                rows[i].points[p].tangentImpulse = m_contacts[i].points[p].tangentImpulse[lane];
            }
        }
    }
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
        alignas(32) float smallest[islandLanes];
        kernels.solvePositions(task, m_active, smallest);
        bool isAnyLeft = false;
        for (int lane = 0; lane < islandLanes; ++lane) {
            if (smallest[lane] >= tolerance) m_active[lane] = 0.0f;
            isAnyLeft = isAnyLeft || m_active[lane] != 0.0f;
        }
        if (!isAnyLeft) break;
    }
    for (const Slot& slot : m_bodies) {
        if (bodies.mass[slot.body].invMass <= 0.0f) continue;
        const Position& now = m_position[slot.row];
        bodies.position[slot.body].c = now.c, bodies.position[slot.body].a = now.a;
    }
}

}  // namespace scree
