// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Finds what bears a load, from contact to contact downwards, and lends it inertia.

#include "constraints/loaded_bodies.h"

#include <algorithm>
#include <limits>

#include "state/frames.h"

namespace scree {

/// From loads to what bears them.
class LoadSearch {
public:
    LoadSearch(const LoadInput& input, const BodyTable& bodies, LoadedBodies& found)
        : m_in(input), m_bodies(bodies), m_raised(found.m_raised), m_rowOf(found.m_rowOf), m_presses(found.m_presses) {}

    /// Most worlds are through after a look at the masses.
    void Run() {
        float largest = 0.0f, lightest = std::numeric_limits<float>::max();
        for (const BodyIndex body : m_in.bodies) {
            if (m_bodies.mass[body].invMass == 0.0f) continue;
            largest = Max(largest, MassToHold(body));
            lightest = Min(lightest, m_bodies.motion[body].mass);
        }
        if (largest <= lightest) return;
        EnsureRows(m_rowOf, m_bodies.mass.size(), -1);
        EnsureRows(m_presses, m_bodies.mass.size(), uint8_t{0});
        if (!MarkLoads(lightest)) return;
        Search();
        for (const BodyIndex body : m_in.bodies) m_presses[body] = 0;
    }

private:
    /// Marks what may be a load; false if nothing is.
    [[nodiscard]] bool MarkLoads(float lightest) {
        bool isSome = false;
        for (const BodyIndex body : m_in.bodies) {
            if (m_bodies.mass[body].invMass == 0.0f || MassToHold(body) <= lightest || IsHeld(body)) continue;
            m_presses[body] = 1;
            isSome = true;
        }
        return isSome;
    }
    /// Every other time from the last contact to the first: whichever way the list of a column goes, few times do.
    void Search() {
        constexpr int mostRounds = 32;
        for (int round = 0; round < mostRounds; ++round) {
            bool isDone = true;
            const int count = static_cast<int>(m_in.list.size());
            for (int i = 0; i < count; ++i) isDone = !HandDown(round % 2 == 0 ? i : count - 1 - i) && isDone;
            if (isDone) return;
        }
    }
    [[nodiscard]] Vec2 ForceOn(BodyIndex body) const {
        const MotionRow& motion = m_bodies.motion[body];
        return motion.gravityScale * motion.mass * m_in.gravity + m_bodies.GetForce(body).force;
    }
    /// With which a contact's spring holds the forces on a load; no more than the load has, or it would be none.
    [[nodiscard]] float MassToHold(BodyIndex load) const {
        return Min(ForceOn(load).Length() / (m_in.stiffness * m_in.depth), m_bodies.motion[load].mass);
    }
    /// Something else may hold it.
    [[nodiscard]] bool IsHeld(BodyIndex load) const {
        for (const JointIndex joint : m_in.joints.OfBody(load)) {
            const JointInfo& info = m_in.joints.info[joint];
            const BodyIndex other = info.bodyA == load ? info.bodyB : info.bodyA;
            if (m_bodies.mass[other].invMass == 0.0f) return true;
        }
        return false;
    }
    [[nodiscard]] WorldManifold PlaceOf(ContactIndex contact) const {
        const ContactPair& pair = m_in.contacts.pair[contact];
        const Vec2 frame = FrameOf(m_bodies, pair.bodyA, pair.bodyB);
        WorldManifold placed;
        placed.Initialize(&m_in.contacts.manifold[contact], TransformIn(frame, m_bodies, pair.bodyA),
                          m_in.fixtures.shape[pair.fixtureA]->m_radius, TransformIn(frame, m_bodies, pair.bodyB),
                          m_in.fixtures.shape[pair.fixtureB]->m_radius);
        return placed;
    }

    /// True if some body has to bear more than was known.
    bool HandDown(int at) {
        const ContactPair& pair = m_in.contacts.pair[m_in.list[ToSize(at)]];
        if ((m_presses[pair.bodyA] | m_presses[pair.bodyB]) == 0) return false;
        if (m_bodies.mass[pair.bodyA].invMass == 0.0f || m_bodies.mass[pair.bodyB].invMass == 0.0f) return false;
        return HandDown(at, pair.bodyA, pair.bodyB, 1.0f) || HandDown(at, pair.bodyB, pair.bodyA, -1.0f);
    }
    bool HandDown(int at, BodyIndex from, BodyIndex to, float sign) {
        if (m_presses[from] == 0) return false;
        const int above = m_rowOf[from];
        const BodyIndex load = above < 0 ? from : m_raised[ToSize(above)].load;
        const float mass = above < 0 ? MassToHold(from) : m_raised[ToSize(above)].mass;
        const int row = m_rowOf[to];
        if (mass <= (row < 0 ? m_bodies.motion[to].mass : m_raised[ToSize(row)].mass) || load == to) return false;
        if (!m_in.raisesJointed && m_bodies.info[to].jointCount > 0) return false;
        const ContactIndex contact = m_in.list[ToSize(at)];
        const WorldManifold placed = PlaceOf(contact);
        const Vec2 normal = sign * placed.normal, force = ForceOn(load);
        constexpr float leastShare = 0.1f;  // of the force that the contact bears
        if (Dot(normal, force) < leastShare * force.Length()) return false;
        const Vec2 middle = 0.5f * (placed.points[0] + placed.points[m_in.contacts.manifold[contact].pointCount - 1]);
        Note(row, {.body = to,
                   .load = load,
                   .normal = normal,
                   .loadArm = above < 0 ? middle - CentreIn(FrameOf(m_bodies, from, to), m_bodies, from) : vec2Zero,
                   .at = at,
                   .mass = mass,
                   .own = m_bodies.mass[to],
                   .unaided = Unaided(to)});
        return true;
    }
    void Note(int row, const LoadedBodies::Raised& raised) {
        if (row >= 0) {
            m_raised[ToSize(row)] = raised;
            return;
        }
        m_rowOf[raised.body] = static_cast<int>(m_raised.size());
        m_presses[raised.body] = 1;
        m_raised.push_back(raised);
    }
    [[nodiscard]] Velocity Unaided(BodyIndex body) const {
        Velocity v = m_bodies.velocity[body];
        v.v += m_in.dt * m_bodies.mass[body].invMass * ForceOn(body);
        return v;
    }

    const LoadInput& m_in;
    const BodyTable& m_bodies;
    std::vector<LoadedBodies::Raised>& m_raised;
    Column<BodyIndex, int>& m_rowOf;
    Column<BodyIndex, uint8_t>& m_presses;
};

void LoadedBodies::Raise(const LoadInput& input, BodyTable& bodies) {
    LoadSearch(input, bodies, *this).Run();
    for (const Raised& raised : m_raised) {
        const float share = bodies.motion[raised.body].mass / raised.mass;
        bodies.mass[raised.body].invMass *= share;
        bodies.mass[raised.body].invI *= share;
    }
}

void LoadedBodies::Lower(BodyTable& bodies, std::span<const ContactImpulse> impulses) {
    for (const Raised& raised : m_raised) {
        bodies.mass[raised.body] = raised.own;
        m_rowOf[raised.body] = -1;
    }
    for (const Raised& raised : m_raised) {
        const Vec2 lost = FindLost(bodies, raised, impulses[ToSize(raised.at)]);
        const MassRow& load = bodies.mass[raised.load];
        bodies.velocity[raised.load].v += load.invMass * lost;
        bodies.velocity[raised.load].w += load.invI * Cross(raised.loadArm, lost);
    }
    m_raised.clear();
}

/// The impulse by which the load moved the inertia that was lent. What it only handed on to others, it did not lose.
Vec2 LoadedBodies::FindLost(const BodyTable& bodies, const Raised& raised, const ContactImpulse& impulse) {
    const Vec2 gained = raised.mass * (bodies.velocity[raised.body].v - raised.unaided.v);
    const float share = 1.0f - bodies.motion[raised.body].mass / raised.mass;
    const auto lost = [&](Vec2 axis, float given) {
        const float along = Dot(gained, axis);
        return given > 0.0f ? Clamp(along, 0.0f, given) : Clamp(along, given, 0.0f);
    };
    float away = 0.0f, across = 0.0f;
    for (int i = 0; i < impulse.count; ++i) away += impulse.normalImpulses[i], across += impulse.tangentImpulses[i];
    const Vec2 tangent = Cross(raised.normal, 1.0f);
    return share * (lost(raised.normal, away) * raised.normal + lost(tangent, across) * tangent);
}

}  // namespace scree
