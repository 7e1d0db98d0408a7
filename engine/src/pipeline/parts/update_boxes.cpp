// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Boxes of moved fixtures, handed over in blocks: no virtual call per box.

#include "pipeline/parts/update_boxes.h"

#include <algorithm>

#include "base/simd.h"
#include "geometry/boxes.h"
#include "state/frames.h"

namespace scree {

namespace {

/// Inlined: it runs for each box.
SCREE_INLINE AABB BoxOfFixture(const FixtureTable& fixtures, FixtureIndex fixture, const Transform& xf) {
    const Shape& shape = *fixtures.shape[fixture];
    switch (fixtures.type[fixture]) {
        case Shape::e_circle:
            return BoxOf(static_cast<const CircleShape&>(shape), xf);
        case Shape::e_polygon:
            return BoxOf(static_cast<const PolygonShape&>(shape), xf);
        default: {
            AABB box;
            shape.ComputeAABB(&box, xf);
            return box;
        }
    }
}

/// Boxes on their way to the broad phase; few enough for the first-level cache. `isFar`: positions have rests.
template <bool isFar>
class BoxBatch {
public:
    /// `isShared`: other threads have batches of other bodies at the same time.
    BoxBatch(const BodyTable& bodies, const FixtureTable& fixtures, BroadPhase& broadPhase, bool isShared = false)
        : m_bodies(bodies),
          m_fixtures(fixtures),
          m_broadPhase(broadPhase),
          m_usesDisplacement(broadPhase.UsesDisplacement()),
          m_isShared(isShared) {}

    SCREE_INLINE void Add(BodyIndex body) {
        static_assert(sizeof(Position) == 4 * sizeof(float));
        m_farthest = Max4(Abs4(Load4(&m_bodies.position[body].c.x)), m_farthest);
        const Vec2 c = m_bodies.position[body].c;
        const Vec2 displacement = m_usesDisplacement ? m_bodies.GetMotion(body) : vec2Zero;
        const Transform xf = isFar ? TransformIn(c, m_bodies, body) : m_bodies.transform[body];
        for (const FixtureIndex f : m_fixtures.From(m_bodies.fixtureHead[body])) {
            if (m_count == capacity) Flush();
            BoxUpdate& update = m_updates[m_count++];
            update.box = BoxOfFixture(m_fixtures, f, xf);
            if constexpr (isFar) update.box = ToWorld(c, update.box);
            update.displacement = displacement;
            update.fixture = ProxyOf(f);
        }
    }
    void Flush() {
        const std::span<const BoxUpdate> updates{m_updates, m_count};
        if (m_isShared) {
            m_haveChanged = m_broadPhase.UpdateMoving(updates) || m_haveChanged;
        } else {
            m_broadPhase.UpdateMany(updates);
        }
        m_count = 0;
    }
    [[nodiscard]] bool HaveChanged() const { return m_haveChanged; }
    [[nodiscard]] float GetFarthest() const { return Max(GetLane4<0>(m_farthest), GetLane4<1>(m_farthest)); }

private:
    static constexpr size_t capacity = 512;

    const BodyTable& m_bodies;
    const FixtureTable& m_fixtures;
    BroadPhase& m_broadPhase;
    const bool m_usesDisplacement, m_isShared;
    bool m_haveChanged = false;  ///< shared: some box is another one
    size_t m_count = 0;
    F4 m_farthest = Splat4(0.0f);  ///< |x| and |y| of centres, and what need not be read
    BoxUpdate m_updates[capacity];
};

/// Fewer bodies than this are not worth waking workers for.
constexpr int leastBodiesToShare = 512;

/// Boxes of the bodies that are active, by all workers. Their proxies move: those of listed bodies have been roused.
template <bool isFar>
float UpdateShared(const BodyTable& bodies, const FixtureTable& fixtures, TaskPool& pool, BroadPhase& broadPhase) {
    const std::span<const BodyIndex> listed = bodies.Listed();
    float farthest[maxWorkers] = {};
    bool haveChanged[maxWorkers] = {};
    pool.For(static_cast<int>(listed.size()), leastBodiesToShare, [&](int begin, int end, int worker) {
        BoxBatch<isFar> batch(bodies, fixtures, broadPhase, true);
        for (int i = begin; i < end; ++i) {
            if (bodies.IsActive(listed[ToSize(i)])) batch.Add(listed[ToSize(i)]);
        }
        batch.Flush();
        farthest[worker] = Max(farthest[worker], batch.GetFarthest());
        haveChanged[worker] = haveChanged[worker] || batch.HaveChanged();
    });
    broadPhase.NoteUpdated(std::any_of(haveChanged, haveChanged + maxWorkers, [](bool b) { return b; }));
    return *std::max_element(farthest, farthest + maxWorkers);
}

template <bool isFar>
float UpdateMoved(const BodyTable& bodies, const FixtureTable& fixtures, const MovedLists& solved, TaskPool& pool,
                  BroadPhase& broadPhase) {
    float farthest = 0.0f;
    BoxBatch<isFar> batch(bodies, fixtures, broadPhase);
    if (pool.IsOpen() && broadPhase.SharesUpdates()) {
        farthest = UpdateShared<isFar>(bodies, fixtures, pool, broadPhase);
    } else {
        for (const BodyIndex body : bodies.Listed()) {
            if (bodies.IsActive(body)) batch.Add(body);
        }
    }
    // Bodies that fell asleep in this step moved in it, too.
    for (const std::vector<BodyIndex>* list : solved) {
        if (list == nullptr || bodies.fellAsleep == 0) break;
        for (const BodyIndex body : *list) {
            constexpr uint16_t active = BodyFlag::awake | BodyFlag::enabled;
            const uint16_t flags = bodies.flags[body];
            if ((flags & active) == active) continue;  // done above
            if (bodies.slots.IsAlive(body) && (flags & BodyFlag::enabled) != 0) batch.Add(body);
        }
    }
    batch.Flush();
    return Max(farthest, batch.GetFarthest());
}

}  // namespace

float UpdateMovedBoxes(const BodyTable& bodies, const FixtureTable& fixtures, const MovedLists& solved, TaskPool& pool,
                       BroadPhase& broadPhase) {
    return bodies.IsFar() ? UpdateMoved<true>(bodies, fixtures, solved, pool, broadPhase)
                          : UpdateMoved<false>(bodies, fixtures, solved, pool, broadPhase);
}

AABB FindBox(const BodyTable& bodies, const FixtureTable& fixtures, FixtureIndex fixture) {
    const BodyPlace place(bodies, fixtures.body[fixture]);
    return place.OutOf(BoxOfFixture(fixtures, fixture, place.xf));
}

void UpdateBodyBoxes(const BodyTable& bodies, const FixtureTable& fixtures, BodyIndex body, Vec2 displacement,
                     BroadPhase& broadPhase) {
    const BodyPlace place(bodies, body);
    for (const FixtureIndex f : fixtures.From(bodies.fixtureHead[body])) {
        broadPhase.Update(ProxyOf(f), place.OutOf(BoxOfFixture(fixtures, f, place.xf)), displacement);
    }
}

}  // namespace scree
