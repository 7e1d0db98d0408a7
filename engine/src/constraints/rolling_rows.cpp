// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Preparation and ends of rolling rows.

#include "constraints/rolling_rows.h"

#include "geometry/outline.h"

namespace scree {

namespace {

/// Of the disk that would roll on a plane as these two roll on each other, m; 0 between flat sides.
float RollingRadius(const Shape& a, const Shape& b, float lengthScale) {
    const float radiusA = OutlineRadius(a, lengthScale), radiusB = OutlineRadius(b, lengthScale);
    if (radiusA > 0.0f && radiusB > 0.0f) return radiusA / (1.0f + radiusA / radiusB);
    return Max(radiusA, radiusB);
}

}  // namespace

void RollingRows::Prepare(const RollingInput& in) {
    m_rows.clear();
    for (size_t at = 0; at < in.list.size(); ++at) {
        const ContactIndex contact = in.list[at];
        const ContactPair& pair = in.contacts.pair[contact];
        const float resistance = Max(in.fixtures.material[pair.fixtureA].rollingResistance,
                                     in.fixtures.material[pair.fixtureB].rollingResistance);
        if (resistance == 0.0f) continue;
        const float arm = resistance * RollingRadius(*in.fixtures.shape[pair.fixtureA],
                                                     *in.fixtures.shape[pair.fixtureB], in.lengthScale);
        const float invIA = in.bodies.mass[pair.bodyA].invI;
        const float invIB = in.bodies.mass[pair.bodyB].invI;
        const float mass = invIA + invIB > 0.0f ? 1.0f / (invIA + invIB) : 0.0f;
        if (arm == 0.0f || mass == 0.0f) continue;
        float pressure = 0.0f;
        const Manifold& manifold = in.contacts.manifold[contact];
        for (int i = 0; i < manifold.pointCount; ++i) pressure += manifold.points[i].normalImpulse;
        // A contact that was not there in the last step has pushed with nothing.
        const float before = in.contacts.rolling.Has(contact) ? in.contacts.rolling[contact] : 0.0f;
        const float impulse = in.impulseScale * Clamp(before, -arm * pressure, arm * pressure);
        m_rows.push_back({pair.bodyA, pair.bodyB, contact, static_cast<int>(at), arm, invIA, invIB, mass, impulse});
    }
}

void RollingRows::WarmStart(Column<BodyIndex, Velocity>& velocity) const {
    for (const RollingRow& row : m_rows) {
        Apply(row, row.impulse, velocity[row.bodyA], velocity[row.bodyB]);
    }
}

void RollingRows::Store(float scale, Column<ContactIndex, float>& impulse) const {
    for (const RollingRow& row : m_rows) impulse[row.contact] = scale * row.impulse;
}

}  // namespace scree
