// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// On every scene of the catalogue, every broad-phase algorithm is fed the boxes of one and the same motion. It reports
// brute force's pair set (the fattened tree after the tight test). That is checked at 20 steps spread over the run up
// to the scene's most telling step.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "broad_phase/broad_phase.h"
#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"

namespace {

using scree::BroadPhaseKind;
using scree::Pair;

scree::AABB ToBox(const testbed::Box& box) { return {{box.lower.x, box.lower.y}, {box.upper.x, box.upper.y}}; }

/// One algorithm that follows a run.
class Follower {
public:
    explicit Follower(BroadPhaseKind kind) : m_kind(kind), m_algorithm(scree::CreateBroadPhase(kind)) {}

    void Follow(const testbed::Snapshot& snapshot) {
        for (size_t i = 0; i < snapshot.fixtures.size(); ++i) {
            const testbed::FixtureState& f = snapshot.fixtures[i];
            const auto id = static_cast<uint32_t>(i);
            const testbed::BodyState& body = snapshot.bodies[static_cast<size_t>(f.body)];
            const scree::Vec2 position{body.position.x, body.position.y};
            const auto [known, isNew] = m_positions.try_emplace(id, position);
            if (isNew) {
                const scree::Motion motion = body.type == scenes::BodyType::isStatic  ? scree::Motion::isStatic
                                             : body.type == scenes::BodyType::dynamic ? scree::Motion::dynamic
                                                                                      : scree::Motion::kinematic;
                m_algorithm->Insert(id, static_cast<uint32_t>(body.index), motion, ToBox(f.tight));
            } else if (body.type != scenes::BodyType::isStatic) {
                m_algorithm->Update(id, ToBox(f.tight), position - known->second);
                known->second = position;
            }
        }
    }

    /// Sorted; the fattened tree's superset is cut down by the tight boxes.
    std::vector<Pair> FindTightPairs(const std::map<uint32_t, scree::AABB>& tight) {
        std::vector<Pair> pairs;
        m_algorithm->FindPairs(pairs);
        if (m_kind == BroadPhaseKind::fatTree) {
            std::erase_if(pairs, [&](const Pair& p) { return !TestOverlap(tight.at(p.a), tight.at(p.b)); });
        }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

private:
    BroadPhaseKind m_kind;
    std::unique_ptr<scree::BroadPhase> m_algorithm;
    std::map<uint32_t, scree::Vec2> m_positions;
};

/// A size at which brute force takes little time but the scene keeps its character.
int SmallSize(const scenes::SceneInfo& info) {
    const std::map<std::string_view, int> sizes = {{"add-pair", 300},
                                                   {"n2", 60},
                                                   {"mild-n2", 20},
                                                   {"multi-fixture", 12},
                                                   {"mixed", 600},
                                                   {"tiles", 145},
                                                   {"big-mobile", 6},
                                                   {"slow-explosion", 2000},
                                                   {"tumbler", 60},
                                                   {"diagonal", 10},
                                                   {"falling-squares", 24},
                                                   {"falling-circles", 24},
                                                   {"mostly-static-single", 24},
                                                   {"mostly-static-multi", 24}};
    const auto found = sizes.find(info.name);
    return found == sizes.end() ? info.defaultSize : found->second;
}

class PairSetsOnScenes : public ::testing::TestWithParam<std::string> {};

TEST_P(PairSetsOnScenes, EqualBruteForce) {
    const scenes::SceneInfo* info = scenes::Find(GetParam());
    ASSERT_NE(info, nullptr);
    const scenes::Scene scene = scenes::Build(info->name, SmallSize(*info));
    auto run = testbed::MakeRun(scene, testbed::MakeSpec("scree", testbed::likeBox2dPreset));
    std::vector<Follower> followers;
    for (size_t kind = 1; kind < scree::broadPhaseNames.size(); ++kind)
        followers.emplace_back(static_cast<BroadPhaseKind>(kind));

    testbed::Snapshot snapshot;
    size_t seen = 0;
    const int stride = std::max(100, info->showStep) / 20;
    for (int step = 0; step < 20 * stride; ++step) {
        run->Step();
        if (step % stride != stride - 1) continue;
        run->Capture(snapshot, {.fixtures = true, .contacts = false, .joints = false, .nodes = false});
        std::map<uint32_t, scree::AABB> tight;
        for (size_t i = 0; i < snapshot.fixtures.size(); ++i)
            tight[static_cast<uint32_t>(i)] = ToBox(snapshot.fixtures[i].tight);
        std::vector<Pair> expected;
        for (size_t i = 0; i < followers.size(); ++i) {
            followers[i].Follow(snapshot);
            const std::vector<Pair> pairs = followers[i].FindTightPairs(tight);
            ASSERT_TRUE(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end())
                << scree::broadPhaseNames[i + 1] << " reports a pair twice in step " << step;
            if (i == 0) {
                expected = pairs;  // brute force
                seen += pairs.size();
            }
            ASSERT_TRUE(pairs == expected) << scree::broadPhaseNames[i + 1] << " in step " << step << ": "
                                           << pairs.size() << " pairs, brute force " << expected.size();
        }
    }
    // Some of the classics show joints alone.
    if (!info->isClassic) {
        EXPECT_GT(seen, 0u) << "the scene made no pairs: the test would prove nothing";
    }
}

std::vector<std::string> SceneNames() {
    std::vector<std::string> names;
    for (const scenes::SceneInfo& info : scenes::Catalog()) names.emplace_back(info.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Catalog, PairSetsOnScenes, ::testing::ValuesIn(SceneNames()), [](const auto& param) {
    std::string name = param.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
