// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The sweep counts what comparing every box with every box counts, and follows the pair rule at its edges.

#include "testbed/engines/pair_count.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

using namespace testbed;

namespace {

int64_t CountByBruteForce(const std::vector<PairBox>& boxes) {
    int64_t count = 0;
    for (size_t i = 0; i < boxes.size(); ++i) {
        for (size_t j = i + 1; j < boxes.size(); ++j) {
            const PairBox &a = boxes[i], &b = boxes[j];
            if (a.body == b.body || (!a.dynamic && !b.dynamic)) continue;
            if (a.box.lower.x > b.box.upper.x || b.box.lower.x > a.box.upper.x) continue;
            if (a.box.lower.y > b.box.upper.y || b.box.lower.y > a.box.upper.y) continue;
            ++count;
        }
    }
    return count;
}

PairBox Make(float x0, float y0, float x1, float y1, int body, bool dynamic) {
    return {{{x0, y0}, {x1, y1}}, body, dynamic};
}

/// Boxes on a coarse grid, so that equal bounds and shared borders are common.
std::vector<PairBox> RandomBoxes() {
    std::vector<PairBox> boxes;
    const int count = *rc::gen::inRange(0, 60);
    const int range = *rc::gen::element(1, 8, 64);
    for (int i = 0; i < count; ++i) {
        const auto x = static_cast<float>(*rc::gen::inRange(0, range)),
                   y = static_cast<float>(*rc::gen::inRange(0, range));
        const auto w = static_cast<float>(*rc::gen::inRange(0, 6)), h = static_cast<float>(*rc::gen::inRange(0, 6));
        const int body = *rc::gen::inRange(0, 20);
        boxes.push_back(Make(x, y, x + w, y + h, body, body % 3 != 0));
    }
    return boxes;
}

}  // namespace

TEST(PairCount, ClosedBoxesSharingABorderOrCornerArePairs) {
    const PairBox a = Make(0, 0, 1, 1, 0, true);
    EXPECT_EQ(CountPairs(std::vector{a, Make(1, 0, 2, 1, 1, true)}), 1);
    EXPECT_EQ(CountPairs(std::vector{a, Make(1, 1, 2, 2, 1, false)}), 1);
    EXPECT_EQ(CountPairs(std::vector{a, Make(1.5f, 0, 2, 1, 1, true)}), 0);
}

TEST(PairCount, BodiesNeverPairWithThemselvesNorStaticsWithEachOther) {
    EXPECT_EQ(CountPairs(std::vector{Make(0, 0, 1, 1, 7, true), Make(0, 0, 1, 1, 7, true)}), 0);
    EXPECT_EQ(CountPairs(std::vector{Make(0, 0, 1, 1, 1, false), Make(0, 0, 1, 1, 2, false)}), 0);
    EXPECT_EQ(CountPairs(std::vector<PairBox>{}), 0);
}

TEST(PairCount, EqualsBruteForce) {
    EXPECT_TRUE(rc::check("sweep = all against all", [] {
        const std::vector<PairBox> boxes = RandomBoxes();
        RC_ASSERT(CountPairs(boxes) == CountByBruteForce(boxes));
    }));
}
