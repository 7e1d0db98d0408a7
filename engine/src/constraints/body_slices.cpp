// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where slices are cut: at quantiles of a sample of contacts.

#include "constraints/body_slices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/gather_parts.h"
#include "base/slots.h"

namespace scree {

void BodySlices::Update(const TaskPool& pool, const BodyTable& bodies, const ContactTable& contacts,
                        std::span<const ContactIndex> list) {
    constexpr int leastContacts = 256, leastOfTests = 16;  // of a slice
    const int least = pool.SharesAlways() ? leastOfTests : leastContacts;
    const int possible = std::min({static_cast<int>(list.size()) / least, pool.GetWorkerCount(), most});
    const int wanted = pool.KeepsPace() ? std::max(possible, 1) : 1;
    m_mayShare = pool.GetWorkerCount() > 1;
    ++m_age;
    const bool isGood = m_count == wanted && !m_isUneven;
    if (wanted == m_wanted && (isGood || m_age < m_wait)) return;
    m_wait = wanted == m_wanted ? std::min(2 * m_wait, longWait) : shortWait;
    m_wanted = wanted;
    m_age = 0;
    m_isUneven = false;
    ++m_edition;
    m_count = wanted > 1 && Cut(bodies, contacts, list, wanted) ? wanted : 1;
}

/// Cuts by the order in which the fewest contacts of a sample are between slices, or too many for their slice; by
/// number, unless others have clearly fewer. False if these are many.
bool BodySlices::Cut(const BodyTable& bodies, const ContactTable& contacts, std::span<const ContactIndex> list,
                     int count) {
    constexpr size_t mostSamples = 256;
    const size_t samples = std::min(mostSamples, list.size());
    const size_t clearly = samples / 16, many = samples / 4;
    size_t least = many;
    const auto placeOf = [&](BodyIndex body, Order order) {
        const float place = Place(bodies, body, order);
        return std::isfinite(place) ? place : 0.0f;
    };
    for (const Order order : {Order::byNumber, Order::byX, Order::byY}) {
        std::array<std::array<float, 2>, mostSamples> places{};  // of both bodies, or twice that of the only one
        for (size_t i = 0; i < samples; ++i) {
            const ContactPair& pair = contacts.pair[list[i * list.size() / samples]];
            const bool movesA = bodies.type[pair.bodyA] == dynamicBody, movesB = bodies.type[pair.bodyB] == dynamicBody;
            places[i] = {placeOf(movesA ? pair.bodyA : pair.bodyB, order),
                         placeOf(movesB ? pair.bodyB : pair.bodyA, order)};
        }
        const auto end = places.begin() + static_cast<ptrdiff_t>(samples);
        std::array<float, most> cuts{};
        for (int i = 1; i < count; ++i) {
            const auto at = places.begin() + static_cast<ptrdiff_t>(samples * ToSize(i) / ToSize(count));
            std::nth_element(places.begin(), at, end, [](const auto& a, const auto& b) { return a[1] < b[1]; });
            cuts[ToSize(i - 1)] = (*at)[1];
        }
        const auto sliceOf = [&](float at) { return SliceOf(at, cuts, count); };
        std::array<size_t, most> sizes{};
        size_t bad = 0;
        for (size_t i = 0; i < samples; ++i) {
            const int slice = sliceOf(places[i][1]);
            const bool isCut = sliceOf(places[i][0]) != slice;
            const bool isTooMany = ++sizes[ToSize(slice)] > samples / ToSize(count) + 1;
            bad += isCut || isTooMany ? 1 : 0;
        }
        const size_t handicap = order == Order::byNumber ? 0 : clearly;
        if (bad + handicap >= least) continue;
        least = bad + handicap;
        m_order = order;
        m_cuts = cuts;
    }
    return least < many;
}

void BodySlices::Note(std::span<const int> sizes, int atBorder) {
    constexpr int64_t percent = 100, mostOfEven = 115, mostAtBorder = 25;
    const int64_t all = std::accumulate(sizes.begin(), sizes.end(), int64_t{0});
    const int64_t largest = *std::max_element(sizes.begin(), sizes.end());
    m_isUneven = largest * static_cast<int64_t>(sizes.size()) * percent > all * mostOfEven ||
                 atBorder * percent > all * mostAtBorder;
    if (!m_isUneven) m_wait = shortWait;
}

std::span<const BodyIndex> BodySlices::Sort(TaskPool& pool, const BodyTable& bodies, std::span<const BodyIndex> list,
                                            std::vector<BodyIndex>& sliced) {
    if (m_mayShare) ReserveRows(list.size(), sliced);  // a later step is not to allocate because it is shared
    if (m_count == 1) return list;
    // Counting sort, a count for each part of the list.
    constexpr int leastBodies = 1024;
    const Parts parts(pool, static_cast<int>(list.size()), leastBodies);
    std::array<std::array<size_t, most>, Parts::most> next;  // by part and slice
    parts.For(pool, [&](int part, int begin, int end) {
        std::array<size_t, most>& counts = next[ToSize(part)];
        counts = {};
        for (int i = begin; i < end; ++i) ++counts[Of(bodies, list[ToSize(i)])];
    });
    size_t begin = 0;
    for (int slice = 0; slice < m_count; ++slice) {
        m_begins[ToSize(slice)] = begin;
        for (int part = 0; part < parts.Count(); ++part)
            begin += std::exchange(next[ToSize(part)][ToSize(slice)], begin);
    }
    m_begins[ToSize(m_count)] = begin;
    sliced.resize(list.size());
    parts.For(pool, [&](int part, int first, int end) {
        std::array<size_t, most>& places = next[ToSize(part)];
        for (int i = first; i < end; ++i) sliced[places[Of(bodies, list[ToSize(i)])]++] = list[ToSize(i)];
    });
    return sliced;
}

}  // namespace scree
