// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Checks of restored tables. A list is whole if a walk from its head meets only living members, as many as there should
// be, whose backward links agree. So it cannot run in a circle.

#include "world/snapshot_check.h"

#include <algorithm>
#include <cmath>

#include "state/limits.h"

namespace scree {

namespace {

template <typename... Columns>
bool HaveSize(size_t size, const Columns&... columns) {
    return ((columns.size() == size) && ...);
}

/// Bodies and their centres of mass are placed in range, but one may lie out of range by how far the other is from it.
bool IsPlace(Vec2 p) {
    constexpr float most = 8.0f * farthest;
    return Abs(p.x) <= most && Abs(p.y) <= most;
}

bool IsPossible(const BodyTable& t, BodyIndex b) {
    const Transform& xf = t.transform[b];
    const bool poses = IsPlace(t.position[b].c) && IsPlace(t.startPosition[b].c) && IsPlace(xf.p) &&
                       std::isfinite(t.position[b].a) && std::isfinite(t.startPosition[b].a);
    const bool rests = t.rest.empty() || (IsPlace(t.rest[b].end) && IsPlace(t.rest[b].start));
    const bool isRotation = Abs(xf.q.s * xf.q.s + xf.q.c * xf.q.c - 1.0f) < 1e-3f;
    return poses && rests && isRotation && t.velocity[b].v.IsValid() && std::isfinite(t.velocity[b].w);
}

/// Within what programs can give a body, and fixtures together make.
bool IsPossible(const MassRow& mass, const MotionRow& motion, float inertia) {
    const auto isAmount = [](float x) { return x >= 0.0f && std::isfinite(x); };
    return isAmount(mass.invMass) && isAmount(mass.invI) && IsInRange(mass.localCenter) && isAmount(motion.mass) &&
           inertia >= 0.0f && std::isfinite(motion.linearDamping) && std::isfinite(motion.angularDamping) &&
           std::isfinite(motion.gravityScale);
}

bool IsPossible(const BodyDemand& demand) {
    return demand.overlap >= 0.0f && demand.jointGap >= 0.0f && demand.pullRate >= 0.0f && demand.substeps >= 0 &&
           demand.wanted >= 0.0f;
}

bool IsBodyListWhole(const BodyTable& t) {
    int listed = 0;
    BodyIndex lastMover = BodyIndex::none;
    for (BodyIndex body = t.listHead, prev = BodyIndex::none; IsSome(body);
         prev = body, body = t.info[body].listNext, ++listed) {
        if (!t.slots.IsAlive(body) || t.info[body].listPrev != prev) return false;
        if (t.type[body] == staticBody) continue;
        if (lastMover != prev) return false;  // a mover behind a static body
        lastMover = body;
    }
    return listed == t.slots.Count() && lastMover == t.lastMover;
}

bool AreMoversWhole(const BodyTable& t) {
    int movers = 0;
    for (const BodyIndex body : t.slots.Rows()) {
        if (!t.slots.IsAlive(body)) continue;
        const MoverRow row = t.info[body].moverRow;
        if ((t.type[body] == staticBody) != IsNone(row)) return false;
        if (IsNone(row)) continue;
        if (!t.movers.Has(row) || t.movers[row] != body) return false;
        ++movers;
    }
    return ToSize(movers) == t.movers.size();
}

}  // namespace

bool IsPossible(const AABB& box) {
    constexpr float most = 100.0f * farthest;  // a box may be wider than what is in it, and lie ahead of it
    const auto isNear = [](Vec2 p) { return Abs(p.x) <= most && Abs(p.y) <= most; };
    return box.IsValid() && isNear(box.lowerBound) && isNear(box.upperBound);
}

bool AreBodiesConsistent(const BodyTable& t) {
    const size_t size = ToSize(t.slots.Size());
    if (!t.slots.IsConsistent() || !HaveSize(size, t.velocity, t.position, t.startPosition)) return false;
    if (!HaveSize(t.force.empty() ? 0 : size, t.force)) return false;
    if (!HaveSize(t.rest.empty() ? 0 : size, t.rest)) return false;
    if (!HaveSize(t.startVelocity.empty() ? 0 : size, t.startVelocity)) return false;
    if (!HaveSize(size, t.transform, t.mass, t.motion, t.sleepTime, t.flags, t.type, t.fixtureHead, t.info))
        return false;
    if (!HaveSize(t.demand.empty() ? 0 : size, t.demand)) return false;
    if (!std::all_of(t.demand.begin(), t.demand.end(), [](const BodyDemand& d) { return IsPossible(d); })) return false;
    for (const BodyIndex b : t.slots.Rows()) {
        if (t.type[b] > dynamicBody) return false;
        if (!t.slots.IsAlive(b)) continue;
        if (!IsPossible(t, b) || !IsPossible(t.mass[b], t.motion[b], t.info[b].inertia)) return false;
    }
    return IsBodyListWhole(t) && AreMoversWhole(t);
}

bool AreFixturesConsistent(const FixtureTable& t, const BodyTable& bodies) {
    if (!t.slots.IsConsistent()) return false;
    if (!HaveSize(ToSize(t.slots.Size()), t.body, t.type, t.isSensor, t.filter, t.material, t.next, t.info))
        return false;
    // Every fixture in the list of its own body and in no other; a list cannot be longer than its body says.
    int listed = 0;
    for (const BodyIndex body : bodies.slots.Rows()) {
        if (!bodies.slots.IsAlive(body)) continue;
        int count = 0;
        for (const FixtureIndex f : t.From(bodies.fixtureHead[body])) {
            if (!t.slots.IsAlive(f) || t.body[f] != body || ++count > t.slots.Count()) return false;
            if (t.info[f].inBroadPhase != bodies.Has(body, BodyFlag::enabled)) return false;
            if ((t.info[f].reports & ~Report::all) != 0) return false;
            const Material& material = t.material[f];
            if (material.frictionRule > MixRule::custom || material.restitutionRule > MixRule::custom) return false;
        }
        if (count != bodies.info[body].fixtureCount) return false;
        listed += count;
    }
    return listed == t.slots.Count();
}

bool AreContactsConsistent(const ContactTable& t, const FixtureTable& fixtures) {
    for (const ContactIndex contact : t.flags.Rows()) {
        if (!t.IsAlive(contact)) continue;
        const ContactPair& pair = t.pair[contact];
        if (!fixtures.slots.IsAlive(pair.fixtureA) || !fixtures.slots.IsAlive(pair.fixtureB)) return false;
        if (fixtures.body[pair.fixtureA] != pair.bodyA || fixtures.body[pair.fixtureB] != pair.bodyB) return false;
        if (pair.bodyA == pair.bodyB) return false;
        const Manifold& m = t.manifold[contact];
        if (m.pointCount < 0 || m.pointCount > maxManifoldPoints || m.type > Manifold::e_faceB) return false;
    }
    return true;
}

bool AreJointsConsistent(const JointTable& t, const BodyTable& bodies) {
    Column<JointIndex, int> gears(ToSize(t.slots.Size()), 0);
    Column<BodyIndex, int> counts(ToSize(bodies.slots.Size()), 0);
    for (const JointIndex joint : t.slots.Rows()) {
        if (!t.slots.IsAlive(joint)) continue;
        const JointInfo& info = t.info[joint];
        if (!bodies.slots.IsAlive(info.bodyA) || !bodies.slots.IsAlive(info.bodyB)) return false;
        ++counts[info.bodyA];
        ++counts[info.bodyB];
        if (info.type != e_gearJoint) continue;
        const GearRow& gear = t.Store<GearRow>().rows[info.row];
        for (const GearSide& side : gear.side) {
            if (!t.slots.IsAlive(side.joint)) return false;
            const JointInfo& part = t.info[side.joint];
            if (part.type != (side.slides ? e_prismaticJoint : e_revoluteJoint)) return false;
            if (part.bodyB != side.body || part.bodyA != side.against) return false;
            ++gears[side.joint];
        }
        const auto isOfSide = [&gear](int side, BodyIndex body) {
            return body == gear.side[side].body || body == gear.side[side].against;
        };
        if (!isOfSide(0, info.bodyA) || !isOfSide(1, info.bodyB)) return false;
    }
    for (const JointIndex joint : t.slots.Rows()) {
        if (t.slots.IsAlive(joint) && t.info[joint].gearCount != gears[joint]) return false;
    }
    for (const BodyIndex body : bodies.slots.Rows()) {
        if (bodies.slots.IsAlive(body) && bodies.info[body].jointCount != counts[body]) return false;
    }
    return true;
}

}  // namespace scree
