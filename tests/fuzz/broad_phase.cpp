// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Any edits of any broad phase. Laws: the pairs of tight boxes are those of brute force, and queries visit what
// overlaps.

#include "broad_phase/broad_phase.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "tests/fuzz/input.h"

namespace fuzz {
namespace {

using namespace scree;

struct Item {
    bool isThere = false;
    uint32_t body = 0;
    Motion motion{};
    AABB box{};
};

bool Overlaps(const AABB& a, const AABB& b) {
    return a.lowerBound.x <= b.upperBound.x && b.lowerBound.x <= a.upperBound.x && a.lowerBound.y <= b.upperBound.y &&
           b.lowerBound.y <= a.upperBound.y;
}

/// Coordinates on a coarse lattice: boxes that only touch and equal boxes are common.
AABB ReadBox(Input& input) {
    const auto at = [&] { return 0.5f * static_cast<float>(input.Choose(64)); };
    const Vec2 low{at(), at()};
    const Vec2 size{0.5f * static_cast<float>(input.Choose(5)), 0.5f * static_cast<float>(input.Choose(5))};
    return {low, low + size};
}

std::vector<Pair> TruePairs(const std::vector<Item>& items) {
    std::vector<Pair> pairs;
    for (uint32_t a = 0; a < items.size(); ++a) {
        for (uint32_t b = a + 1; b < items.size(); ++b) {
            const Item &p = items[a], &q = items[b];
            if (!p.isThere || !q.isThere || p.body == q.body || !Overlaps(p.box, q.box)) continue;
            if (p.motion == Motion::dynamic || q.motion == Motion::dynamic) pairs.push_back({a, b});
        }
    }
    return pairs;
}

void CheckPairs(BroadPhase& broadPhase, const std::vector<Item>& items) {
    std::vector<Pair> pairs;
    broadPhase.FindPairs(pairs);
    std::sort(pairs.begin(), pairs.end());
    Demand(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end(), "no pair twice");
    // Fattened boxes may report more.
    std::erase_if(pairs, [&](Pair pair) { return !Overlaps(items[pair.a].box, items[pair.b].box); });
    Demand(pairs == TruePairs(items), "the pairs of brute force");
}

void CheckQuery(const BroadPhase& broadPhase, const std::vector<Item>& items, const AABB& box) {
    std::set<uint32_t> found;
    broadPhase.Query(box, [&](uint32_t fixture) {
        Demand(found.insert(fixture).second, "no fixture twice");
        return true;
    });
    for (uint32_t i = 0; i < items.size(); ++i) {
        if (items[i].isThere && Overlaps(items[i].box, box)) Demand(found.contains(i), "a query finds what overlaps");
        if (!items[i].isThere) Demand(!found.contains(i), "a query finds only what is there");
    }
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace fuzz;
    Input input(data, size);
    const auto kind = static_cast<BroadPhaseKind>(input.Choose(static_cast<int>(std::size(broadPhaseNames))));
    const std::unique_ptr<BroadPhase> broadPhase = CreateBroadPhase(kind, {.leafSize = input.Choose(3)});
    std::vector<Item> items(128);
    while (!input.IsEmpty()) {
        const int call = input.Choose(8);
        const uint32_t fixture = static_cast<uint32_t>(input.Choose(128));
        Item& item = items[fixture];
        if (call < 5) {
            const AABB box = ReadBox(input);
            if (item.isThere) {
                broadPhase->Update(fixture, box, box.lowerBound - item.box.lowerBound);
            } else {
                item = {true, fixture / 2, static_cast<Motion>(input.Choose(3)), box};
                item.motion = items[fixture ^ 1].isThere ? items[fixture ^ 1].motion : item.motion;
                broadPhase->Insert(fixture, item.body, item.motion, box);
            }
            item.box = box;
        } else if (call == 5 && item.isThere) {
            broadPhase->Remove(fixture);
            item.isThere = false;
        } else if (call == 6) {
            CheckQuery(*broadPhase, items, ReadBox(input));
        } else if (call == 7) {
            CheckPairs(*broadPhase, items);
        }
    }
    CheckPairs(*broadPhase, items);
    broadPhase->PrepareQueries();
    CheckQuery(*broadPhase, items, {{3.0f, 3.0f}, {9.0f, 20.0f}});
    return 0;
}
