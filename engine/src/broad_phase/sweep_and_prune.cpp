// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sweep and prune (Baraff 1992; Tsamis 2020, §3.2): the boxes stay sorted by their lower bound along one axis, and each
// is tested against those that start before it ends. Between steps the order changes little, so an insertion sort
// repairs it; when too many boxes changed places a full sort takes over. The axis is the one along which the centres
// vary more.

#include <algorithm>

#include "broad_phase/algorithms.h"
#include "broad_phase/bounds.h"
#include "broad_phase/linear_broad_phase.h"

namespace scree::broadphase {
namespace {

/// A proxy in sorted order, its box at hand.
struct Entry {
    Bounds box;
    ItemId id;
};

/// The other axis must vary this much more before all boxes are sorted anew along it.
constexpr double switchRatio = 1.5;
/// An insertion sort that shifts more entries than this per proxy costs more than a full sort.
constexpr size_t shiftsPerProxy = 8;

/// Sum and sum of squares of the centres.
struct Spread {
    double sum[2] = {0.0, 0.0}, squares[2] = {0.0, 0.0};

    void Add(const Bounds& box) {
        const double centre[2] = {static_cast<double>(box.lx) - box.nux, static_cast<double>(box.ly) - box.nuy};
        for (int axis = 0; axis < 2; ++axis) {
            sum[axis] += centre[axis];
            squares[axis] += centre[axis] * centre[axis];
        }
    }
    [[nodiscard]] double Variance(int axis, double count) const {
        return squares[axis] - sum[axis] * sum[axis] / count;
    }
};

class SweepAndPrune final : public LinearBroadPhase {
public:
    void FindPairs(std::vector<Pair>& pairs) override {
        m_stats = {};
        const bool axisChanged = Refresh();
        if (axisChanged || !InsertionSort()) {
            std::sort(m_entries.begin(), m_entries.end(),
                      [this](const Entry& a, const Entry& b) { return Before(a, b); });
            m_stats.rebuiltProxies = static_cast<uint32_t>(m_entries.size());
        }
        Sweep(pairs);
    }

    [[nodiscard]] size_t GetMemoryBytes() const override {
        return m_store.GetMemoryBytes() + m_entries.capacity() * sizeof(Entry);
    }

private:
    [[nodiscard]] float LowOf(const Entry& entry) const { return m_axis == 0 ? entry.box.lx : entry.box.ly; }
    /// A total order, so that both sorts give the same result.
    [[nodiscard]] bool Before(const Entry& a, const Entry& b) const {
        const float lowA = LowOf(a), lowB = LowOf(b);
        return lowA < lowB || (lowA == lowB && a.id.fixture < b.id.fixture);
    }

    /// Drops removed proxies, takes over new boxes and new proxies, chooses the axis; true if it changed.
    bool Refresh() {
        // The store's free field tells which slots have been met in this pass; what is left over is new.
        m_pass = m_pass + 1 == noPlace ? 0 : m_pass + 1;
        Spread spread;
        size_t kept = 0;
        for (const Entry& entry : m_entries) {
            const uint32_t slot = m_store.Find(entry.id.fixture);
            if (slot == noSlot) continue;
            m_store.Place(slot) = m_pass;
            m_entries[kept++] = {ToBounds(m_store.Box(slot)), m_store.Id(slot)};
            spread.Add(m_entries[kept - 1].box);
        }
        m_entries.resize(kept);
        for (uint32_t slot = 0; slot < m_store.Size() && m_entries.size() < m_store.Size(); ++slot) {
            if (m_store.Place(slot) == m_pass) continue;
            m_store.Place(slot) = m_pass;
            m_entries.push_back({ToBounds(m_store.Box(slot)), m_store.Id(slot)});
            spread.Add(m_entries.back().box);
        }
        if (m_entries.empty()) return false;
        const auto count = static_cast<double>(m_entries.size());
        if (spread.Variance(1 - m_axis, count) <= switchRatio * spread.Variance(m_axis, count)) return false;
        m_axis = 1 - m_axis;
        return true;
    }

    /// False if it gave up because the order has changed too much.
    bool InsertionSort() {
        size_t budget = shiftsPerProxy * m_entries.size();
        for (size_t i = 1; i < m_entries.size(); ++i) {
            const Entry entry = m_entries[i];
            size_t j = i;
            for (; j > 0 && Before(entry, m_entries[j - 1]); --j) m_entries[j] = m_entries[j - 1];
            m_entries[j] = entry;
            if (i - j > budget) return false;
            budget -= i - j;
        }
        return true;
    }

    void Sweep(std::vector<Pair>& pairs) {
        PairSink sink(pairs);
        for (size_t i = 0; i < m_entries.size(); ++i) {
            const Entry& entry = m_entries[i];
            const F4 probe = ProbeOf(Load(entry.box));
            const float end = m_axis == 0 ? -entry.box.nux : -entry.box.nuy;
            size_t j = i + 1;
            for (; j < m_entries.size() && LowOf(m_entries[j]) <= end; ++j) {
                if (Overlaps(Load(m_entries[j].box), probe)) sink.Emit(entry.id, m_entries[j].id);
            }
            m_stats.boxTests += j - i - 1;
        }
        sink.Finish();
    }

    std::vector<Entry> m_entries;
    int m_axis = 0;
    uint32_t m_pass = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> MakeSweepAndPrune() { return std::make_unique<SweepAndPrune>(); }

}  // namespace scree::broadphase
