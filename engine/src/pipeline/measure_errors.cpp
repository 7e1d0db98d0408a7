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

size_t Row(int index) { return static_cast<size_t>(index); }

bool IsAnyActive(const BodyTable& bodies, int a, int b) { return bodies.IsActive(a) || bodies.IsActive(b); }

/// 1 / (effective mass) of the normal at a point.
float InverseMassAt(const BodyTable& bodies, Vec2 frame, int body, Vec2 point, Vec2 normal) {
    const MassRow& mass = bodies.mass[Row(body)];
    const float arm = Cross(point - CentreIn(frame, bodies, body), normal);
    return mass.invMass + mass.invI * arm * arm;
}

/// Returns the overlap, ≥ 0, and raises the residual.
float MeasureContact(const MeasuredTables& t, int contact, float slop, float dt, float& residual) {
    const ContactPair& pair = t.contacts.pair[Row(contact)];
    const Manifold& manifold = t.contacts.manifold[Row(contact)];
    WorldManifold world;
    const Vec2 frame = FrameOf(t.bodies, pair.bodyA, pair.bodyB);
    // After a soft step bodies rest where their outlines touch, else where skins overlap by the slop.
    const bool atOutlines = t.contacts.keepsSteady;
    const auto radiusOf = [&](uint32_t fixture) {
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
    for (int contact = 0; contact < t.contacts.Size(); ++contact) {
        const ContactPair& pair = t.contacts.pair[Row(contact)];
        if ((t.contacts.flags[Row(contact)] & (pushing | ContactFlag::sensor)) != pushing) continue;
        if (!IsAnyActive(t.bodies, pair.bodyA, pair.bodyB)) continue;
        const float overlap = Told(MeasureContact(t, contact, slop, dt, errors.residual));
        errors.overlap = Max(errors.overlap, overlap);
        note(pair.bodyA, pair.bodyB, overlap, &BodyDemand::overlap);
    }
    for (int joint = t.joints.listHead; joint >= 0; joint = t.joints.info[Row(joint)].listNext) {
        const JointInfo& info = t.joints.info[Row(joint)];
        if (!IsAnyActive(t.bodies, info.bodyA, info.bodyB)) continue;
        JointTable::WithStore(t.joints, info.type, [&](const auto& store) {
            const auto& row = store.rows[Row(info.row)];
            const float gap = Told(JointTraits<std::remove_cvref_t<decltype(row)>>::GetError(t.bodies, info, row));
            errors.jointGap = Max(errors.jointGap, gap);
            note(info.bodyA, info.bodyB, gap, &BodyDemand::jointGap);
        });
    }
    return errors;
}

}  // namespace

StepErrors MeasureErrors(const MeasuredTables& t, float slop, float dt) {
    return Measure(t, slop, dt, [](int, int, float, float BodyDemand::*) {});
}

StepErrors MeasureDemand(const MeasuredTables& t, float slop, float dt, std::vector<BodyDemand>& demand) {
    return Measure(t, slop, dt, [&](int a, int b, float error, float BodyDemand::*which) {
        for (const int body : {a, b}) {
            if (t.bodies.type[Row(body)] == staticBody) continue;
            float& worst = demand[Row(body)].*which;
            worst = Max(worst, error);
        }
    });
}

}  // namespace scree
