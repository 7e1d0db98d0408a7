// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Overlaps and the complementarity of push and gap at the present poses, with the points that the step's manifolds
// found; errors of joints as their traits tell.

#include "pipeline/measure_errors.h"

#include <limits>
#include <type_traits>

#include "constraints/joint_constraints.h"
#include "geometry/outline.h"
#include "state/frames.h"

namespace scree {

namespace {

bool IsAnyActive(const BodyTable& bodies, BodyIndex a, BodyIndex b) { return bodies.IsActive(a) || bodies.IsActive(b); }

/// 1 / (effective mass) of the normal at a point.
float InverseMassAt(const BodyTable& bodies, Vec2 frame, BodyIndex body, Vec2 point, Vec2 normal) {
    const MassRow& mass = bodies.mass[body];
    const float arm = Cross(point - CentreIn(frame, bodies, body), normal);
    return mass.invMass + mass.invI * arm * arm;
}

/// Returns the overlap, ≥ 0, and raises the residual.
float MeasureContact(const MeasuredTables& t, ContactIndex contact, float slop, float dt, float& residual) {
    const ContactPair& pair = t.contacts.pair[contact];
    const Manifold& manifold = t.contacts.manifold[contact];
    WorldManifold world;
    const Vec2 frame = FrameOf(t.bodies, pair.bodyA, pair.bodyB);
    // After a soft step bodies rest where their outlines touch, else where skins overlap by the slop.
    const bool atOutlines = t.contacts.keepsSteady;
    const auto radiusOf = [&](FixtureIndex fixture) {
        const Shape& shape = *t.fixtures.shape[fixture];
        return atOutlines ? OutlineRadius(shape, slop / linearSlop) : shape.m_radius;
    };
    const float left = atOutlines ? 0.0f : slop;
    world.Initialize(&manifold, TransformIn(frame, t.bodies, pair.bodyA), radiusOf(pair.fixtureA),
                     TransformIn(frame, t.bodies, pair.bodyB), radiusOf(pair.fixtureB));
    float overlap = 0.0f;
    for (int i = 0; i < manifold.pointCount; ++i) {
        const float inverse = InverseMassAt(t.bodies, frame, pair.bodyA, world.points[i], world.normal) +
                              InverseMassAt(t.bodies, frame, pair.bodyB, world.points[i], world.normal);
        const float pushed = manifold.points[i].normalImpulse * inverse * dt;
        overlap = Max(overlap, -world.separations[i]);
        residual = Max(residual, Abs(Min(pushed, world.separations[i] + left)));
    }
    return overlap;
}

/// Of anchors far beyond all places the gap is a difference of infinities: it counts as infinite.
float Told(float error) { return error >= 0.0f ? error : std::numeric_limits<float>::infinity(); }

/// Calls note(body, body, overlap or gap, member of BodyDemand) for each contact and joint.
template <typename Note>
StepErrors Measure(const MeasuredTables& t, float slop, float dt, Note&& note) {
    StepErrors errors;
    constexpr uint8_t pushing = ContactFlag::alive | ContactFlag::touching | ContactFlag::enabled;
    for (const ContactIndex contact : t.contacts.flags.Rows()) {
        const ContactPair& pair = t.contacts.pair[contact];
        if ((t.contacts.flags[contact] & (pushing | ContactFlag::sensor)) != pushing) continue;
        if (!IsAnyActive(t.bodies, pair.bodyA, pair.bodyB)) continue;
        const float overlap = Told(MeasureContact(t, contact, slop, dt, errors.residual));
        errors.overlap = Max(errors.overlap, overlap);
        const float initial = t.contacts.steady.Has(contact) ? t.contacts.steady[contact].initialOverlap : 0.0f;
        note(pair.bodyA, pair.bodyB, overlap - Max(initial, 0.0f), &BodyDemand::overlap);
    }
    for (JointIndex joint = t.joints.listHead; IsSome(joint); joint = t.joints.info[joint].listNext) {
        const JointInfo& info = t.joints.info[joint];
        if (!IsAnyActive(t.bodies, info.bodyA, info.bodyB)) continue;
        JointTable::WithStore(t.joints, info.type, [&](const auto& store) {
            const auto& row = store.rows[info.row];
            const float gap = Told(JointTraits<std::remove_cvref_t<decltype(row)>>::GetError(t.bodies, info, row));
            errors.jointGap = Max(errors.jointGap, gap);
            note(info.bodyA, info.bodyB, gap, &BodyDemand::jointGap);
        });
    }
    return errors;
}

}  // namespace

StepErrors MeasureErrors(const MeasuredTables& t, float slop, float dt) {
    return Measure(t, slop, dt, [](BodyIndex, BodyIndex, float, float BodyDemand::*) {});
}

StepErrors MeasureDemand(const MeasuredTables& t, float slop, float dt, Column<BodyIndex, BodyDemand>& demand) {
    return Measure(t, slop, dt, [&](BodyIndex a, BodyIndex b, float error, float BodyDemand::*which) {
        for (const BodyIndex body : {a, b}) {
            if (t.bodies.type[body] == staticBody) continue;
            float& worst = demand[body].*which;
            worst = Max(worst, error);
        }
    });
}

}  // namespace scree
