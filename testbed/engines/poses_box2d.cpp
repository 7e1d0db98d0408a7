// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A b2BroadPhase without a world that follows recorded poses. Calls have the order and arguments of a b2World. Proxies
// are made in the order of creation. They move from the newest body and fixture to the oldest, the edges of a chain in
// their own order. Then pairs are searched.

#include <box2d/b2_broad_phase.h>

#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/box2d_tree_dump.h"
#include "testbed/engines/following_run.h"
#include "testbed/engines/pair_count.h"
#include "testbed/engines/poses.h"

namespace testbed {
namespace {

b2Transform TransformOf(const BodyState& body) {
    b2Transform xf;
    xf.p = ToB2(body.position);
    xf.q.s = body.sin;
    xf.q.c = body.cos;
    return xf;
}

// Slot + 1, since Box2D gives null to inner nodes.
void* ToUserData(size_t slot) { return reinterpret_cast<void*>(slot + 1); }
size_t SlotOf(void* userData) { return reinterpret_cast<uintptr_t>(userData) - 1; }

/// Receives the pairs; creating contacts is not part of this run.
struct PairSink {
    int64_t count = 0;
    void AddPair(void*, void*) { ++count; }
};

class Box2dFollower final : public FollowingRun {
public:
    Box2dFollower(const scenes::Scene& scene, std::unique_ptr<EngineRun> source)
        : FollowingRun(scene, std::move(source)) {
        m_proxies.reserve(scene.fixtures.size());
        Load();
    }

protected:
    void Create(const BodyState& body) override;
    void Destroy(const BodyState& body) override;
    void Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) override;
    void CaptureBroadPhase(Snapshot& snapshot, bool nodes) override;

private:
    struct Proxy {
        Box2dShape shape;
        int32 id;
        int child;
    };

    void MoveProxy(const Proxy& proxy, const b2Transform& from, const b2Transform& to);

    b2BroadPhase m_broadPhase;
    std::vector<Proxy> m_proxies;  ///< by slot
    bool m_newProxies = false;
};

void Box2dFollower::Create(const BodyState& body) {
    const b2Transform xf = TransformOf(body);
    for (const scenes::Fixture& fixture : GetScene().FixturesOf(body.index)) {
        for (int child = 0; child < fixture.shape.ChildCount(); ++child) {
            Proxy proxy{MakeBox2dShape(Box2dShapeOf(GetScene(), scenes::ChildOf(GetScene(), fixture.shape, child))), 0,
                        child};
            b2AABB box;
            AsB2Shape(proxy.shape).ComputeAABB(&box, xf, 0);
            proxy.id = m_broadPhase.CreateProxy(box, ToUserData(m_proxies.size()));
            m_proxies.push_back(proxy);
        }
        m_newProxies = true;
    }
}

void Box2dFollower::Destroy(const BodyState& body) {
    const Slots slots = SlotsOf(body);
    for (size_t last = slots.end; last > slots.begin;) {
        const size_t first = last - 1 - static_cast<size_t>(m_proxies[last - 1].child);
        for (size_t k = first; k < last; ++k) m_broadPhase.DestroyProxy(m_proxies[k].id);
        last = first;
    }
}

void Box2dFollower::MoveProxy(const Proxy& proxy, const b2Transform& from, const b2Transform& to) {
    const b2Shape& shape = AsB2Shape(proxy.shape);
    b2AABB boxFrom, boxTo, swept;
    shape.ComputeAABB(&boxFrom, from, 0);
    shape.ComputeAABB(&boxTo, to, 0);
    swept.Combine(boxFrom, boxTo);
    m_broadPhase.MoveProxy(proxy.id, swept, boxTo.GetCenter() - boxFrom.GetCenter());
}

void Box2dFollower::Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) {
    PairSink sink;
    // A world searches pairs for new fixtures at the start of the step.
    if (m_newProxies) m_broadPhase.UpdatePairs(&sink);
    m_newProxies = false;
    for (size_t i = after.size(); i-- > 0;) {
        if (!WasSimulated(before[i], after[i])) continue;
        const b2Transform to = TransformOf(after[i]);
        const b2Transform from = after[i].awake ? TransformOf(before[i]) : to;
        const Slots slots = SlotsOf(after[i]);
        for (size_t last = slots.end; last > slots.begin;) {
            const size_t first = last - 1 - static_cast<size_t>(m_proxies[last - 1].child);
            for (size_t k = first; k < last; ++k) MoveProxy(m_proxies[k], from, to);
            last = first;
        }
    }
    m_broadPhase.UpdatePairs(&sink);
}

void Box2dFollower::CaptureBroadPhase(Snapshot& snapshot, bool nodes) {
    snapshot.engine = "box2d";
    snapshot.broadPhase = "b2DynamicTree";
    snapshot.pairsReported = 0;
    if (!nodes) return;
    DumpBox2dTree(
        m_broadPhase, [this](void* userData) { return FixtureOf(SlotOf(userData)); }, snapshot.nodes);
    snapshot.treeHeight = m_broadPhase.GetTreeHeight();
    snapshot.leafSize = snapshot.nodes.empty() ? 0 : 1;
    if (!snapshot.fixtures.empty()) snapshot.pairsReported = CountPairs(LeafBoxes(snapshot));
}

}  // namespace

std::unique_ptr<EngineRun> MakeBox2dFollower(const scenes::Scene& scene, const RunSpec&,
                                             std::unique_ptr<EngineRun> source) {
    return std::make_unique<Box2dFollower>(scene, std::move(source));
}

}  // namespace testbed
