// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Creation and removal of joints of any type. Rule for gears: a gear lives no longer than the joints it couples, so
// they count their gears, and whoever removes a joint removes those first.

#include "world/joints/joint_definitions.h"

#include <vector>

#include "world/refresh.h"

namespace scree {

namespace {

void CheckBodies(const JointDef& def, const WorldState& state, Guard& guard) {
    guard.NotNull(def.bodyA != nullptr, "JointDef::bodyA", "set both bodies")
        .NotNull(def.bodyB != nullptr, "JointDef::bodyB", "set both bodies");
    if (guard.Failed()) return;
    const char* cure = "use a living body of this world";
    guard.Require(Owns(state, def.bodyA), ErrorCode::foreignHandle, "JointDef::bodyA", cure)
        .Require(Owns(state, def.bodyB), ErrorCode::foreignHandle, "JointDef::bodyB", cure)
        .Require(def.bodyA != def.bodyB, ErrorCode::outOfRange, "JointDef::bodyB", "join two different bodies");
}

JointInfo& InfoOf(WorldState& s, JointIndex joint) { return s.joints.info[joint]; }

Joint* Insert(WorldState& s, JointIndex joint) {
    const JointInfo& info = InfoOf(s, joint);
    ++s.bodies.info[info.bodyA].jointCount;
    ++s.bodies.info[info.bodyB].jointCount;
    if (!info.collideConnected) RefilterBodies(s, info.bodyA, info.bodyB);
    return s.joints.handles[joint];
}

JointInfo HeadOf(const JointDef& def) {
    JointInfo head;
    head.type = def.type;
    head.collideConnected = def.collideConnected;
    head.userData = def.userData;
    head.forceThreshold = def.forceThreshold;
    head.torqueThreshold = def.torqueThreshold;
    head.breaks = def.breaks;
    return head;
}

template <typename Row>
Row MakeRowOf(const typename Row::Definition& def, const WorldState& s) {
    if constexpr (Row::type == e_distanceJoint) {
        return MakeRow(def, linearSlop * s.def.lengthScale);
    } else {
        return MakeRow(def);
    }
}

template <typename Row>
Joint* Create(WorldState& s, const JointDef& base, Guard& guard) {
    const auto& def = static_cast<const typename Row::Definition&>(base);
    CheckBodies(def, s, guard);
    Check(def, guard);
    if (guard.Failed()) return nullptr;
    const Row row = MakeRowOf<Row>(def, s);
    if (guard.Uses(FeaturesOfRow(row)).Failed()) return nullptr;
    const Recording recording = guard.Record(base);
    JointInfo head = HeadOf(def);
    head.bodyA = IndexOf(*def.bodyA);
    head.bodyB = IndexOf(*def.bodyB);
    return Insert(s, s.joints.Add(&s, head, row));
}

template <>
Joint* Create<GearRow>(WorldState& s, const JointDef& base, Guard& guard) {
    const auto& def = static_cast<const GearJointDef&>(base);
    CheckGear(def, s, guard);
    if (guard.Uses({Feature::joints}).Failed()) return nullptr;
    const Recording recording = guard.Record(base);
    const GearRow row = MakeGearRow(def, s);
    JointInfo head = HeadOf(def);
    const GearBodies bodies = BodiesOfGear(row, s.bodies);
    head.bodyA = bodies.a;
    head.bodyB = bodies.b;
    const JointIndex index = s.joints.Add(&s, head, row);
    for (const GearSide& side : row.side) ++InfoOf(s, side.joint).gearCount;
    return Insert(s, index);
}

/// A sum of forces that no number holds is stronger than any.
float BeyondNumbers(float strength) { return std::isnan(strength) ? std::numeric_limits<float>::infinity() : strength; }

}  // namespace

Joint* AddJoint(WorldState& s, const JointDef& def) {
    Guard guard(s, "World::CreateJoint");
    guard.Require(def.forceThreshold >= 0.0f && def.torqueThreshold >= 0.0f, ErrorCode::outOfRange,
                  "JointDef::forceThreshold, torqueThreshold", "give numbers of at least 0");
    if (HeadOf(def).HasThreshold()) guard.Uses({Feature::events});
    if (guard.Failed()) return nullptr;
    Joint* joint = nullptr;
    bool known = false;
    JointTable::WithStore(s.joints, def.type, [&](auto& store) {
        known = true;
        joint = Create<typename std::remove_reference_t<decltype(store)>::RowType>(s, def, guard);
    });
    guard.Require(known || guard.Failed(), ErrorCode::outOfRange, "JointDef::type",
                  "use a joint definition of this library");
    return joint;
}

JointIndex FindGearOf(const WorldState& s, JointIndex joint) {
    const JointInfo& info = s.joints.info[joint];
    if (info.gearCount == 0) return JointIndex::none;
    // A gear hangs on a body of each of its joints, mostly the second.
    for (const BodyIndex body : {info.bodyB, info.bodyA}) {
        for (const JointIndex other : s.joints.OfBody(body)) {
            const JointInfo& candidate = s.joints.info[other];
            if (candidate.type != e_gearJoint) continue;
            const GearRow& gear = s.joints.Store<GearRow>().rows[candidate.row];
            if (gear.side[0].joint == joint || gear.side[1].joint == joint) return other;
        }
    }
    return JointIndex::none;
}

void RehangGears(WorldState& s) {
    const JointStore<GearRow>& gears = s.joints.Store<GearRow>();
    for (const JointRow row : gears.slots.Rows()) {
        if (!gears.slots.IsAlive(row)) continue;
        const JointIndex joint = IndexOf(gears.handles[row]);
        const JointInfo& info = InfoOf(s, joint);
        const GearBodies now = BodiesOfGear(gears.rows[row], s.bodies);
        if (now == GearBodies{info.bodyA, info.bodyB}) continue;
        const auto count = [&](int change) {
            for (const BodyIndex body : {info.bodyA, info.bodyB}) s.bodies.info[body].jointCount += change;
        };
        count(-1);
        if (!info.collideConnected) NoteParting(s, info.bodyA, info.bodyB);
        s.joints.SetBodies(joint, now.a, now.b);
        count(1);
        if (!info.collideConnected) RefilterBodies(s, now.a, now.b);
    }
}

void RemoveJointWithGears(WorldState& s, JointIndex joint) {
    for (JointIndex gear = FindGearOf(s, joint); IsSome(gear); gear = FindGearOf(s, joint)) {
        SayGoodbye(s, s.joints.handles[gear]);
        RemoveJoint(s, gear);
    }
    RemoveJoint(s, joint);
}

void BreakStrainedJoints(WorldState& s) {
    if (s.joints.watched.IsEmpty()) return;
    const float inverseDt = s.lastInverseDt;
    std::vector<JointIndex> broken;
    s.joints.watched.ForEach([&](JointIndex joint) {
        const JointInfo& info = InfoOf(s, joint);
        if (!s.bodies.IsActive(info.bodyA) && !s.bodies.IsActive(info.bodyB)) return;
        const Joint* const handle = s.joints.handles[joint];
        const float force = BeyondNumbers(handle->GetReactionForce(inverseDt).Length());
        const float torque = BeyondNumbers(Abs(handle->GetReactionTorque(inverseDt)));
        if (force <= info.forceThreshold && torque <= info.torqueThreshold) return;
        s.log.NoteJoint({ToInt(joint), s.joints.slots.GetGeneration(joint)}, force, torque, info.breaks);
        if (info.breaks) broken.push_back(joint);
    });
    for (const JointIndex joint : broken) {
        if (s.joints.slots.IsAlive(joint)) RemoveJointWithGears(s, joint);  // else a gear that went with its joint
    }
}

void RemoveJoint(WorldState& s, JointIndex joint) {
    s.definitions.Note();  // a joint may break in a step
    const JointInfo info = InfoOf(s, joint);
    if (info.type == e_gearJoint) {
        const GearRow& gear = s.joints.Store<GearRow>().rows[info.row];
        for (const GearSide& side : gear.side) --InfoOf(s, side.joint).gearCount;
    }
    s.joints.Remove(joint);
    for (const BodyIndex body : {info.bodyA, info.bodyB}) {
        --s.bodies.info[body].jointCount;
        s.bodies.Wake(body);
    }
    if (!info.collideConnected) NoteParting(s, info.bodyA, info.bodyB);
}

}  // namespace scree
