// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Generation and editing of random worlds of boxes.

#include "tests/broad_phase/test_world.h"

#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace scree::test {

TestWorld::TestWorld(const WorldShape& shape) : m_shape(shape), m_random(shape.seed) {}

AABB TestWorld::RandomBox() {
    // Sizes spread evenly over the orders of magnitude 1e-2 … 1e2, some boxes without any size.
    const auto size = [this] { return Index(16) == 0 ? 0.0f : std::pow(10.0f, Uniform(-2.0f, 2.0f)); };
    const float world = 10.0f * std::sqrt(static_cast<float>(m_shape.count));
    Vec2 centre{Uniform(-world, world), Uniform(-world, world)};
    Vec2 half{0.5f * size(), 0.5f * size()};
    switch (m_shape.layout) {
        case Layout::spread:
            break;
        case Layout::clusters: {
            const float pitch = 0.5f * world;
            centre = {pitch * static_cast<float>(Index(3)) + Uniform(0.0f, 0.01f),
                      pitch * static_cast<float>(Index(3)) + Uniform(0.0f, 0.01f)};
            half = {0.01f * half.x, 0.01f * half.y};
            break;
        }
        case Layout::onePoint:
            centre = {3.0f, -2.0f};
            half = {0.5f, 0.5f};
            break;
        case Layout::line:
            centre.y = 1.0f;
            break;
        case Layout::grid:
            // Borders coincide exactly: a closed-box test must see the touch.
            centre = {static_cast<float>(Index(20)), static_cast<float>(Index(20))};
            half = {0.5f, 0.5f};
            break;
        case Layout::outlier:
            if (Index(50) == 0) centre = {1.0e7f, -1.0e7f};
            break;
        case Layout::count:
            break;
    }
    return {centre - half, centre + half};
}

uint32_t TestWorld::NewFixtureIndex() {
    if (!m_freeIndices.empty() && Index(2) == 0) {
        const uint32_t index = m_freeIndices.back();
        m_freeIndices.pop_back();
        return index;
    }
    // An odd factor permutes the 32-bit numbers, so indices stay distinct.
    return m_shape.sparseIndices ? 0x9E3779B1u * ++m_nextIndex & 0x7FFFFFFFu : m_nextIndex++;
}

void TestWorld::InsertOne(BroadPhase& broadPhase) {
    if (m_bodyFixturesLeft == 0) {
        ++m_nextBody;
        m_bodyFixturesLeft = m_shape.fixturesPerBody;
        const float kind = Uniform(0.0f, 1.0f);
        m_bodyMotion = kind < m_shape.staticShare                            ? Motion::isStatic
                       : kind < m_shape.staticShare + m_shape.kinematicShare ? Motion::kinematic
                                                                             : Motion::dynamic;
    }
    --m_bodyFixturesLeft;
    const TestFixture fixture{NewFixtureIndex(), m_nextBody, m_bodyMotion, RandomBox()};
    m_fixtures.push_back(fixture);
    broadPhase.Insert(fixture.fixture, fixture.body, fixture.motion, fixture.box);
}

void TestWorld::RemoveOne(BroadPhase& broadPhase) {
    if (m_fixtures.empty()) return;
    TestFixture& fixture = m_fixtures[static_cast<size_t>(Index(static_cast<int>(m_fixtures.size())))];
    broadPhase.Remove(fixture.fixture);
    m_freeIndices.push_back(fixture.fixture);
    fixture = m_fixtures.back();
    m_fixtures.pop_back();
}

void TestWorld::Fill(BroadPhase& broadPhase) {
    for (int i = 0; i < m_shape.count; ++i) InsertOne(broadPhase);
}

void TestWorld::Edit(BroadPhase& broadPhase, int edits) {
    for (int i = 0; i < edits; ++i) {
        const int kind = Index(8);
        if (kind == 0 || m_fixtures.empty()) {
            InsertOne(broadPhase);
        } else if (kind == 1) {
            RemoveOne(broadPhase);
        } else {
            TestFixture& fixture = m_fixtures[static_cast<size_t>(Index(static_cast<int>(m_fixtures.size())))];
            if (fixture.motion == Motion::isStatic && Index(20) != 0) continue;
            const AABB box = RandomBox();
            const Vec2 displacement = box.GetCenter() - fixture.box.GetCenter();
            fixture.box = box;
            broadPhase.Update(fixture.fixture, box, displacement);
        }
    }
}

void TestWorld::Rest(BroadPhase& broadPhase, int count) {
    for (int i = 0; i < count && !m_fixtures.empty(); ++i) {
        TestFixture& fixture = m_fixtures[static_cast<size_t>(Index(static_cast<int>(m_fixtures.size())))];
        if (fixture.motion == Motion::isStatic) continue;
        fixture.isResting = Index(3) != 0;
        broadPhase.SetResting(fixture.fixture, fixture.isResting);
    }
}

void TestWorld::Drift(BroadPhase& broadPhase, float step) {
    std::vector<BoxUpdate> updates;
    for (TestFixture& fixture : m_fixtures) {
        if (fixture.motion == Motion::isStatic || fixture.isResting) continue;
        const Vec2 d{Uniform(-step, step), Uniform(-step, step)};
        fixture.box = {fixture.box.lowerBound + d, fixture.box.upperBound + d};
        updates.push_back({fixture.box, d, fixture.fixture});
    }
    broadPhase.UpdateMany(updates);
}

std::vector<Pair> TestWorld::WithoutResting(std::vector<Pair> pairs) const {
    std::set<uint32_t> resting;
    for (const TestFixture& fixture : m_fixtures) {
        if (fixture.isResting || fixture.motion == Motion::isStatic) resting.insert(fixture.fixture);
    }
    std::erase_if(pairs, [&](const Pair& pair) { return resting.contains(pair.a) && resting.contains(pair.b); });
    return pairs;
}

std::vector<Pair> TestWorld::TruePairs() const {
    std::vector<Pair> pairs;
    for (size_t i = 0; i < m_fixtures.size(); ++i) {
        for (size_t j = i + 1; j < m_fixtures.size(); ++j) {
            const TestFixture& a = m_fixtures[i];
            const TestFixture& b = m_fixtures[j];
            if (a.body == b.body) continue;
            if (a.motion != Motion::dynamic && b.motion != Motion::dynamic) continue;
            const bool apart = a.box.upperBound.x < b.box.lowerBound.x || b.box.upperBound.x < a.box.lowerBound.x ||
                               a.box.upperBound.y < b.box.lowerBound.y || b.box.upperBound.y < a.box.lowerBound.y;
            if (!apart) pairs.push_back({std::min(a.fixture, b.fixture), std::max(a.fixture, b.fixture)});
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<Pair> TestWorld::TightOnly(const std::vector<Pair>& pairs) const {
    std::unordered_map<uint32_t, AABB> boxes;
    for (const TestFixture& fixture : m_fixtures) boxes[fixture.fixture] = fixture.box;
    std::vector<Pair> tight;
    for (const Pair pair : pairs) {
        if (TestOverlap(boxes.at(pair.a), boxes.at(pair.b))) tight.push_back(pair);
    }
    std::sort(tight.begin(), tight.end());
    return tight;
}

WorldShape AnyWorldShape(int maxCount) {
    WorldShape shape;
    shape.layout = static_cast<Layout>(*rc::gen::inRange(0, static_cast<int>(Layout::count)));
    shape.count = *rc::gen::inRange(0, maxCount + 1);
    shape.staticShare = static_cast<float>(*rc::gen::inRange(0, 11)) / 10.0f;
    shape.kinematicShare = static_cast<float>(*rc::gen::inRange(0, 6)) / 10.0f;
    shape.fixturesPerBody = *rc::gen::element(1, 1, 3, 40);
    shape.sparseIndices = *rc::gen::inRange(0, 4) == 0;
    shape.seed = *rc::gen::arbitrary<uint32_t>();
    return shape;
}

bool HasDuplicates(std::vector<Pair> pairs) {
    std::sort(pairs.begin(), pairs.end());
    return std::adjacent_find(pairs.begin(), pairs.end()) != pairs.end();
}

}  // namespace scree::test
