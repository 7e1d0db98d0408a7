// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rolling resistance: a torque between two round bodies in contact that stops their turning against each other. It is
// at most a length times the normal force; the length is what the surfaces give way to each side. One row a contact
// beside those of contact_rows.h and contact_blocks.h, solved one after the other. Only contacts of materials that have
// some get one.

#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

struct RollingRow {
    BodyIndex bodyA, bodyB;
    ContactIndex contact;
    int at;     ///< position of the contact in the solver's list
    float arm;  ///< largest torque over the normal force, m
    float invIA, invIB;
    float mass;     ///< effective, kg·m²
    float impulse;  ///< on body B, N·m·s
};

struct RollingInput {
    const BodyTable& bodies;
    const FixtureTable& fixtures;
    const ContactTable& contacts;
    std::span<const ContactIndex> list;  ///< contacts, in order
    float impulseScale;                  ///< of warm starting: the solver's step / last dt, 0 without
    float lengthScale;
};

class RollingRows {
public:
    void Clear() { m_rows.clear(); }
    [[nodiscard]] bool IsEmpty() const { return m_rows.empty(); }
    void Prepare(const RollingInput& input);
    /// Applies the impulses of the last step.
    void WarmStart(Column<BodyIndex, Velocity>& velocity) const;
    /// One iteration. `pressure(at)` is the sum of a contact's normal impulses.
    template <typename Pressure>
    void Solve(Column<BodyIndex, Velocity>& velocity, Pressure&& pressure) {
        for (RollingRow& row : m_rows) {
            Velocity& a = velocity[row.bodyA];
            Velocity& b = velocity[row.bodyB];
            const float limit = row.arm * pressure(row.at);
            const float total = Clamp(row.impulse - row.mass * (b.w - a.w), -limit, limit);
            Apply(row, total - row.impulse, a, b);
            row.impulse = total;
        }
    }
    /// Writes the impulses back, times `scale`.
    void Store(float scale, Column<ContactIndex, float>& impulse) const;
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_rows); }
    void MatchRoomOf(const RollingRows& other) { MatchRoom(m_rows, other.m_rows); }

private:
    /// Bodies that cannot be turned are not written.
    static void Apply(const RollingRow& row, float impulse, Velocity& a, Velocity& b) {
        if (row.invIA > 0.0f) a.w -= row.invIA * impulse;
        if (row.invIB > 0.0f) b.w += row.invIB * impulse;
    }

    std::vector<RollingRow> m_rows;
};

}  // namespace scree
