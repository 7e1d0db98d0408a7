// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The trees of Box2D 3 following the poses of another run.

#include "testbed/engines/box2d3/box2d3_engine.h"
#include "testbed/engines/box2d3/box2d3_trees.h"
#include "testbed/engines/following_run.h"

namespace testbed {
namespace box2d3 {
namespace {

b2WorldTransform PoseOf(const BodyState& body) { return {b2ToPos(ToB2(body.position)), {body.cos, body.sin}}; }

class Follower final : public FollowingRun {
public:
    Follower(const scenes::Scene& scene, std::unique_ptr<EngineRun> source) : FollowingRun(scene, std::move(source)) {
        Load();
    }

protected:
    void Create(const BodyState& body) override {
        for (const scenes::Fixture& fixture : GetScene().FixturesOf(body.index)) {
            for (int child = 0; child < fixture.shape.ChildCount(); ++child) {
                m_trees.Add(body.type, MakeShape(GetScene(), scenes::ChildOf(GetScene(), fixture.shape, child)),
                            PoseOf(body));
            }
        }
    }
    void Destroy(const BodyState& body) override {
        const Slots slots = SlotsOf(body);
        for (size_t k = slots.begin; k < slots.end; ++k) m_trees.Remove(k);
    }
    void Move(const std::vector<BodyState>& before, const std::vector<BodyState>& after) override {
        m_trees.Rebuild();
        for (size_t i = 0; i < after.size(); ++i) {
            if (!WasSimulated(before[i], after[i])) continue;
            const Slots slots = SlotsOf(after[i]);
            for (size_t k = slots.begin; k < slots.end; ++k) m_trees.Move(k, PoseOf(after[i]));
        }
    }
    void CaptureBroadPhase(Snapshot& snapshot, bool nodes) override {
        snapshot.engine = "box2d3";
        snapshot.broadPhase = "b2DynamicTree x 3";
        snapshot.pairsReported = 0;
        if (nodes) m_trees.Dump(snapshot, true, [this](size_t number) { return FixtureOf(number); });
    }

private:
    Trees m_trees;
};

}  // namespace
}  // namespace box2d3

std::unique_ptr<EngineRun> MakeBox2d3Follower(const scenes::Scene& scene, const RunSpec&,
                                              std::unique_ptr<EngineRun> source) {
    return std::make_unique<box2d3::Follower>(scene, std::move(source));
}

}  // namespace testbed
