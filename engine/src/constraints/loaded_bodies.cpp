// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Finds what bears a load, from contact to contact downwards, and lends it inertia.

#include "constraints/loaded_bodies.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "base/gather_parts.h"
#include "state/frames.h"

namespace scree {

/// From loads to what bears them.
class LoadSearch {
public:
    LoadSearch(const LoadInput& input, const BodyTable& bodies, LoadedBodies& found)
        : m_in(input),
          m_bodies(bodies),
          m_raised(found.m_raised),
          m_rowOf(found.m_rowOf),
          m_presses(found.m_presses),
          m_paths(found.m_paths) {}

    /// Most worlds are through after a look at the masses.
    void Run() {
        constexpr float none = std::numeric_limits<float>::max();
        float largest[maxWorkers] = {}, smallest[maxWorkers];
        std::ranges::fill(smallest, none);
        ForBodies([&](BodyIndex body, int worker) {
            if (m_bodies.mass[body].invMass == 0.0f) return;
            largest[worker] = Max(largest[worker], MassToHold(body));
            smallest[worker] = Min(smallest[worker], m_bodies.motion[body].mass);
        });
        const float lightest = *std::ranges::min_element(smallest);
        const float heaviest = *std::ranges::max_element(largest);
        if (heaviest <= lightest) return;
        EnsureRows(m_rowOf, m_bodies.mass.size(), -1);
        EnsureRows(m_presses, m_bodies.mass.size(), uint8_t{0});
        if (!MarkLoads(lightest)) return;
        ListPaths(heaviest);
        Search();
        ForBodies([this](BodyIndex body, int /*worker*/) { m_presses[body] = 0; });
        // Contacts may reach bodies that are not among the others.
        for (const LoadedBodies::Raised& raised : m_raised) m_presses[raised.body] = 0;
    }

private:
    /// Calls one(body, worker) for all bodies.
    template <typename One>
    void ForBodies(One&& one) {
        constexpr int least = 512;
        m_in.pool.ForIfWide(static_cast<int>(m_in.bodies.size()), least, [&](int begin, int end, int worker) {
            for (int i = begin; i < end; ++i) one(m_in.bodies[ToSize(i)], worker);
        });
    }
    /// Marks what may be a load; false if nothing is.
    [[nodiscard]] bool MarkLoads(float lightest) {
        bool isSome[maxWorkers] = {};
        ForBodies([&](BodyIndex body, int worker) {
            if (m_bodies.mass[body].invMass == 0.0f || MassToHold(body) <= lightest || IsHeld(body)) return;
            m_presses[body] = 1;
            isSome[worker] = true;
        });
        return std::ranges::any_of(isSome, std::identity());
    }
    /// Lists the contacts on which some load may be handed down; none is heavier than `heaviest`.
    void ListPaths(float heaviest) {
        constexpr int least = 512;
        using Path = LoadedBodies::Path;
        const auto isPath = [&](const Path& path) {
            const bool canBeMoved = m_bodies.mass[path.a].invMass != 0.0f && m_bodies.mass[path.b].invMass != 0.0f;
            return canBeMoved && Min(m_bodies.motion[path.a].mass, m_bodies.motion[path.b].mass) < heaviest;
        };
        GatherParts<Path, 1>(m_in.pool, static_cast<int>(m_in.list.size()), least, {&m_paths},
                             [&](int begin, int end, const std::array<Path*, 1>& places) {
                                 Path* place = places[0];
                                 for (int i = begin; i < end; ++i) {
                                     const ContactPair& pair = m_in.contacts.pair[m_in.list[ToSize(i)]];
                                     *place = {i, pair.bodyA, pair.bodyB};
                                     if (isPath(*place)) ++place;
                                 }
                                 return std::array{static_cast<size_t>(place - places[0])};
                             });
    }
    /// Every other time from the last contact to the first: whichever way the list of a column goes, few times do.
    void Search() {
        constexpr int mostRounds = 32;
        for (int round = 0; round < mostRounds; ++round) {
            bool isDone = true;
            const size_t count = m_paths.size();
            for (size_t i = 0; i < count; ++i)
                isDone = !HandDown(m_paths[round % 2 == 0 ? i : count - 1 - i]) && isDone;
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
    bool HandDown(const LoadedBodies::Path& path) {
        if ((m_presses[path.a] | m_presses[path.b]) == 0) return false;
        return HandDown(path.at, path.a, path.b, 1.0f) || HandDown(path.at, path.b, path.a, -1.0f);
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
    std::vector<LoadedBodies::Path>& m_paths;
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
