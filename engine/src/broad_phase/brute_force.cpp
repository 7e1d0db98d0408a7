// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every mover against every other box: boxes in, all pairs out in O(n²). The oracle of every other algorithm, so it is
// kept free of any cleverness.

#include "broad_phase/algorithms.h"
#include "broad_phase/linear_broad_phase.h"

namespace scree::broadphase {
namespace {

class BruteForce final : public LinearBroadPhase {
public:
    void FindPairs(std::vector<Pair>& pairs) override {
        m_stats = {};
        PairSink sink(pairs);
        for (uint32_t i = 0; i < m_store.MoverCount(); ++i) {
            const AABB box = m_store.Box(i);
            for (uint32_t j = i + 1; j < m_store.Size(); ++j) {
                if (TestOverlap(box, m_store.Box(j))) sink.Emit(m_store.Id(i), m_store.Id(j));
            }
            m_stats.boxTests += m_store.Size() - i - 1;
        }
        sink.Finish();
    }
};

}  // namespace

std::unique_ptr<BroadPhase> MakeBruteForce() { return std::make_unique<BruteForce>(); }

}  // namespace scree::broadphase
