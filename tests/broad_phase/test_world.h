// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A random world of boxes that is edited step by step beside a broad phase, and the plain rule that tells its true
// pairs. Everything follows from a few numbers and a seed, so that RapidCheck can vary and shrink them.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "broad_phase/broad_phase.h"

namespace scree::test {

struct TestFixture {
    uint32_t fixture, body;
    Motion motion;
    AABB box;
    bool isResting = false;
};

/// How boxes are laid out.
enum class Layout : int { spread, clusters, onePoint, line, grid, outlier, count };

struct WorldShape {
    Layout layout = Layout::spread;
    int count = 100;
    float staticShare = 0.2f;
    float kinematicShare = 0.1f;
    int fixturesPerBody = 1;
    bool sparseIndices = false;  ///< fixture indices scattered over the whole range
    uint32_t seed = 1;
};

class TestWorld {
public:
    explicit TestWorld(const WorldShape& shape);

    /// Inserts the first boxes.
    void Fill(BroadPhase& broadPhase);
    /// Random updates, removals and insertions: `edits` of them. Statics are updated rarely.
    void Edit(BroadPhase& broadPhase, int edits);
    /// Lets some movers rest and rouses others: `count` at random.
    void Rest(BroadPhase& broadPhase, int count);
    /// Moves every mover by a small random step, all at once as a step of a world does.
    void Drift(BroadPhase& broadPhase, float step);
    void InsertOne(BroadPhase& broadPhase);
    void RemoveOne(BroadPhase& broadPhase);

    [[nodiscard]] AABB RandomBox();
    [[nodiscard]] float Uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(m_random);
    }
    [[nodiscard]] int Index(int count) { return std::uniform_int_distribution<int>(0, count - 1)(m_random); }

    [[nodiscard]] const std::vector<TestFixture>& Fixtures() const { return m_fixtures; }
    /// The true pairs by the rule of broad_phase.h, sorted.
    [[nodiscard]] std::vector<Pair> TruePairs() const;
    /// Leaves out the pairs of movers that rest with each other and with statics, which may or may not be reported.
    [[nodiscard]] std::vector<Pair> WithoutResting(std::vector<Pair> pairs) const;
    /// Those pairs whose tight boxes overlap, sorted.
    [[nodiscard]] std::vector<Pair> TightOnly(const std::vector<Pair>& pairs) const;

private:
    [[nodiscard]] uint32_t NewFixtureIndex();

    WorldShape m_shape;
    std::mt19937 m_random;
    std::vector<TestFixture> m_fixtures;
    std::vector<uint32_t> m_freeIndices;
    uint32_t m_nextIndex = 0, m_nextBody = 0;
    Motion m_bodyMotion = Motion::dynamic;
    int m_bodyFixturesLeft = 0;
};

/// Kinds that report exactly the tight pairs and keep a tree.
inline constexpr BroadPhaseKind rebuiltTreeKinds[] = {
    BroadPhaseKind::bvhBarycentre, BroadPhaseKind::bvhSah,  BroadPhaseKind::global1, BroadPhaseKind::global2,
    BroadPhaseKind::global3,       BroadPhaseKind::unified, BroadPhaseKind::keys};

inline constexpr BroadPhaseKind allKinds[] = {
    BroadPhaseKind::bruteForce, BroadPhaseKind::sweepAndPrune, BroadPhaseKind::bvhBarycentre, BroadPhaseKind::bvhSah,
    BroadPhaseKind::fatTree,    BroadPhaseKind::global1,       BroadPhaseKind::global2,       BroadPhaseKind::global3,
    BroadPhaseKind::unified,    BroadPhaseKind::keys,          BroadPhaseKind::automatic};

/// The algorithms that answer queries from a tree, not by a linear scan.
inline constexpr BroadPhaseKind treeKinds[] = {
    BroadPhaseKind::bvhBarycentre, BroadPhaseKind::bvhSah,  BroadPhaseKind::fatTree, BroadPhaseKind::global1,
    BroadPhaseKind::global2,       BroadPhaseKind::global3, BroadPhaseKind::unified, BroadPhaseKind::keys};

/// The algorithm's name as a test name.
inline std::string KindName(const testing::TestParamInfo<BroadPhaseKind>& kind) {
    std::string name(GetName(kind.param));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// A random shape of a world with up to `maxCount` boxes (inside rc::check only).
WorldShape AnyWorldShape(int maxCount);

[[nodiscard]] bool HasDuplicates(std::vector<Pair> pairs);

}  // namespace scree::test
