// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A stand-alone broad phase of ours that follows recorded poses. It includes the engine's internal broad-phase header:
// a world of ours cannot be driven by foreign poses without simulating them.

#include <algorithm>
#include <stdexcept>

#include "engine/src/broad_phase/broad_phase.h"
#include "testbed/engines/following_run.h"
#include "testbed/engines/poses.h"
#include "testbed/engines/scree_shape.h"

namespace testbed {
namespace {

scree::Transform TransformOf(const BodyState& body) {
    scree::Rot rotation;
    rotation.s = body.sin;
    rotation.c = body.cos;
    return {ToScree(body.position), rotation};
}

scree::Motion MotionOf(scenes::BodyType type) {
    switch (type) {
        case scenes::BodyType::isStatic:
            return scree::Motion::isStatic;
        case scenes::BodyType::kinematic:
            return scree::Motion::kinematic;
        case scenes::BodyType::dynamic:
            return scree::Motion::dynamic;
    }
    return scree::Motion::isStatic;
}

scree::BroadPhaseKind KindOf(const RunSpec& spec) {
    const auto kind = scree::BroadPhaseFromName(spec.broadPhase);
    if (!kind) throw std::invalid_argument("unknown broad phase '" + spec.broadPhase + "'");
    // CreateBroadPhase resolves `automatic` to `keys` as a World does.
    return *kind == scree::BroadPhaseKind::automatic ? scree::BroadPhaseKind::keys : *kind;
}

class ScreeFollower final : public FollowingRun {
public:
    ScreeFollower(const scenes::Scene& scene, scree::BroadPhaseKind kind, std::unique_ptr<EngineRun> source)
        : FollowingRun(scene, std::move(source)), m_kind(kind), m_broadPhase(scree::CreateBroadPhase(kind)) {
        m_shapes.reserve(scene.fixtures.size());
        Load();
    }

protected:
    void Create(const BodyState& body) override;
    void Destroy(const BodyState& body) override;
    void Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) override;
    void CaptureBroadPhase(Snapshot& snapshot, bool nodes) override;

private:
    scree::BroadPhaseKind m_kind;
    std::unique_ptr<scree::BroadPhase> m_broadPhase;
    std::vector<ScreeShape> m_shapes;  ///< by slot
    std::vector<scree::Pair> m_pairs;  ///< of the last step
};

void ScreeFollower::Create(const BodyState& body) {
    const scree::Transform xf = TransformOf(body);
    for (const scenes::Fixture& fixture : GetScene().FixturesOf(body.index)) {
        for (int child = 0; child < fixture.shape.ChildCount(); ++child) {
            const ScreeShape& shape =
                m_shapes.emplace_back(MakeScreeShape(GetScene(), scenes::ChildOf(GetScene(), fixture.shape, child)));
            scree::AABB box;
            AsShape(shape).ComputeAABB(&box, xf);
            m_broadPhase->Insert(static_cast<uint32_t>(m_shapes.size() - 1), static_cast<uint32_t>(body.index),
                                 MotionOf(body.type), box);
        }
    }
}

void ScreeFollower::Destroy(const BodyState& body) {
    const Slots slots = SlotsOf(body);
    for (size_t k = slots.begin; k < slots.end; ++k) m_broadPhase->Remove(static_cast<uint32_t>(k));
}

void ScreeFollower::Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) {
    for (size_t i = 0; i < after.size(); ++i) {
        if (!WasSimulated(before[i], after[i])) continue;
        const scree::Transform xf = TransformOf(after[i]);
        const scree::Vec2 displacement = xf.p - ToScree(before[i].position);
        const Slots slots = SlotsOf(after[i]);
        for (size_t k = slots.begin; k < slots.end; ++k) {
            scree::AABB box;
            AsShape(m_shapes[k]).ComputeAABB(&box, xf);
            m_broadPhase->Update(static_cast<uint32_t>(k), box, displacement);
        }
    }
    m_broadPhase->FindPairs(m_pairs);
}

void ScreeFollower::CaptureBroadPhase(Snapshot& snapshot, bool nodes) {
    snapshot.engine = "scree";
    snapshot.broadPhase = scree::GetName(m_kind);
    snapshot.pairsReported = static_cast<int64_t>(m_pairs.size());
    if (!nodes) return;
    std::vector<scree::BvhNode> tree;
    m_broadPhase->GetNodes(tree);
    snapshot.leafSize = m_broadPhase->GetLeafSize();
    snapshot.nodes.reserve(tree.size());
    for (const scree::BvhNode& n : tree) {
        const int fixture = n.fixture < 0 ? -1 : FixtureOf(static_cast<size_t>(n.fixture));
        snapshot.nodes.push_back({FromScree(n.box), n.parent, n.child1, n.child2, fixture, n.level});
        snapshot.treeHeight = std::max(snapshot.treeHeight, n.level);
    }
}

}  // namespace

std::unique_ptr<EngineRun> MakeScreeFollower(const scenes::Scene& scene, const RunSpec& spec,
                                             std::unique_ptr<EngineRun> source) {
    return std::make_unique<ScreeFollower>(scene, KindOf(spec), std::move(source));
}

}  // namespace testbed
