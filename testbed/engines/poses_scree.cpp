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
        m_bodyBegin.reserve(scene.bodies.size());
        Load();
    }

protected:
    void Create(const BodyState& body) override;
    void Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) override;
    void CaptureBroadPhase(Snapshot& snapshot, bool nodes) override;

private:
    scree::BroadPhaseKind m_kind;
    std::unique_ptr<scree::BroadPhase> m_broadPhase;
    std::vector<ScreeShape> m_shapes;  ///< by index into Snapshot::fixtures
    std::vector<size_t> m_bodyBegin;   ///< by body: its first entry in m_shapes
    std::vector<scree::Pair> m_pairs;  ///< of the last step
};

void ScreeFollower::Create(const BodyState& body) {
    m_bodyBegin.push_back(m_shapes.size());
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

void ScreeFollower::Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) {
    for (size_t i = 0; i < after.size(); ++i) {
        if (!WasSimulated(before[i], after[i])) continue;
        const scree::Transform xf = TransformOf(after[i]);
        const scree::Vec2 displacement = xf.p - ToScree(before[i].position);
        const size_t end = i + 1 < m_bodyBegin.size() ? m_bodyBegin[i + 1] : m_shapes.size();
        for (size_t k = m_bodyBegin[i]; k < end; ++k) {
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
        snapshot.nodes.push_back({FromScree(n.box), n.parent, n.child1, n.child2, n.fixture, n.level});
        snapshot.treeHeight = std::max(snapshot.treeHeight, n.level);
    }
}

}  // namespace

std::unique_ptr<EngineRun> MakeScreeFollower(const scenes::Scene& scene, const RunSpec& spec,
                                             std::unique_ptr<EngineRun> source) {
    return std::make_unique<ScreeFollower>(scene, KindOf(spec), std::move(source));
}

}  // namespace testbed
