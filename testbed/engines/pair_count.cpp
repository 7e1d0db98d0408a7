// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of pair_count.h: dynamic boxes are swept against themselves, then against the others from both sides.

#include "testbed/engines/pair_count.h"

#include <algorithm>

namespace testbed {
namespace {

/// A box seen along the sweep axis (lo, hi) and across it.
struct Interval {
    float lo, hi, acrossLo, acrossHi;
    int body;
};

Interval ToInterval(const PairBox& b, bool alongY) {
    const Box& r = b.box;
    if (alongY) return {r.lower.y, r.upper.y, r.lower.x, r.upper.x, b.body};
    return {r.lower.x, r.upper.x, r.lower.y, r.upper.y, b.body};
}

/// The axis along which the centres spread more: fewer intervals overlap there by chance.
bool SpreadsAlongY(std::span<const PairBox> boxes) {
    double sum[2] = {}, squares[2] = {};
    for (const PairBox& b : boxes) {
        const double c[2] = {0.5 * (double{b.box.lower.x} + b.box.upper.x),
                             0.5 * (double{b.box.lower.y} + b.box.upper.y)};
        for (int k = 0; k < 2; ++k) sum[k] += c[k], squares[k] += c[k] * c[k];
    }
    const double n = static_cast<double>(boxes.size());
    return squares[1] - sum[1] * sum[1] / n > squares[0] - sum[0] * sum[0] / n;
}

bool PairsAcross(const Interval& a, const Interval& b) {
    return (a.acrossLo <= b.acrossHi) & (b.acrossLo <= a.acrossHi) & (a.body != b.body);
}

int64_t CountWithin(const std::vector<Interval>& sorted) {
    int64_t count = 0;
    for (size_t i = 0; i < sorted.size(); ++i) {
        for (size_t j = i + 1; j < sorted.size() && sorted[j].lo <= sorted[i].hi; ++j) {
            count += PairsAcross(sorted[i], sorted[j]);
        }
    }
    return count;
}

/// Pairs whose interval in `others` begins inside that in `first`; ties count only where `countTies` says so, so that
/// the two calls with swapped roles see each pair once.
int64_t CountBetween(const std::vector<Interval>& first, const std::vector<Interval>& others, bool countTies) {
    int64_t count = 0;
    size_t begin = 0;
    for (const Interval& a : first) {
        while (begin < others.size() && (others[begin].lo < a.lo || (!countTies && others[begin].lo == a.lo))) ++begin;
        for (size_t j = begin; j < others.size() && others[j].lo <= a.hi; ++j) count += PairsAcross(a, others[j]);
    }
    return count;
}

}  // namespace

int64_t CountPairs(std::span<const PairBox> boxes) {
    if (boxes.empty()) return 0;
    const bool alongY = SpreadsAlongY(boxes);
    std::vector<Interval> dynamic, others;
    for (const PairBox& b : boxes) (b.dynamic ? dynamic : others).push_back(ToInterval(b, alongY));
    const auto byLow = [](const Interval& a, const Interval& b) { return a.lo < b.lo; };
    std::sort(dynamic.begin(), dynamic.end(), byLow);
    std::sort(others.begin(), others.end(), byLow);
    return CountWithin(dynamic) + CountBetween(dynamic, others, true) + CountBetween(others, dynamic, false);
}

namespace {

PairBox MakePairBox(const Snapshot& snapshot, const FixtureState& fixture, const Box& box) {
    const BodyState& body = snapshot.bodies[static_cast<size_t>(fixture.body)];
    return {box, fixture.body, body.type == scenes::BodyType::dynamic};
}

}  // namespace

std::vector<PairBox> TightBoxes(const Snapshot& snapshot) {
    std::vector<PairBox> boxes;
    boxes.reserve(snapshot.fixtures.size());
    for (const FixtureState& f : snapshot.fixtures) boxes.push_back(MakePairBox(snapshot, f, f.tight));
    return boxes;
}

std::vector<PairBox> LeafBoxes(const Snapshot& snapshot) {
    std::vector<PairBox> boxes;
    boxes.reserve(snapshot.fixtures.size());
    for (const NodeState& n : snapshot.nodes) {
        if (n.fixture < 0) continue;
        boxes.push_back(MakePairBox(snapshot, snapshot.fixtures[static_cast<size_t>(n.fixture)], n.box));
    }
    return boxes;
}

}  // namespace testbed
