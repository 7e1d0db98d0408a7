// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Work on parts of a range by several threads whose results stand in the order of the range, whoever did which part.

#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/index.h"
#include "base/slots.h"
#include "base/task_pool.h"

namespace scree {

/// A range in parts of like size; one part unless the pool is open and the range has at least `least` items.
class Parts {
public:
    static constexpr int most = 64;

    Parts(const TaskPool& pool, int count, int least) : m_count(count) {
        constexpr int leastOfPart = 64, perWorker = 4;
        if (!pool.IsOpen() || count < least) return;
        m_parts = std::clamp(count / leastOfPart, 1, std::min(perWorker * pool.GetWorkerCount(), most));
    }
    [[nodiscard]] int Count() const { return m_parts; }
    [[nodiscard]] int Begin(int part) const { return static_cast<int>(int64_t{m_count} * part / m_parts); }

    /// Calls body(part, begin, end) for all parts.
    template <typename Body>
    void For(TaskPool& pool, Body&& body) const {
        pool.For(m_parts, 2, [&](int first, int last, int /*worker*/) {
            for (int part = first; part < last; ++part) body(part, Begin(part), Begin(part + 1));
        });
    }

private:
    int m_count;
    int m_parts = 1;
};

/// Whether holds(begin, end) of all parts of [0, count); on several threads if count is no less than `least`.
template <typename Holds>
bool AllOf(TaskPool& pool, int count, int least, Holds&& holds) {
    std::atomic<bool> all{true};
    pool.For(count, least, [&](int begin, int end, int /*worker*/) {
        if (all.load(std::memory_order_relaxed) && !holds(begin, end)) all.store(false, std::memory_order_relaxed);
    });
    return all.load(std::memory_order_relaxed);
}

/// Writes to the lists what part(begin, end, places) → counts keeps of parts of [0, count), in the order of the parts.
/// A part writes up to end − begin items of each list to its place, and then all move together. Returns how many items
/// each list has; what stands behind them is to spare, so that lists that are used again need not be filled anew.
template <typename T, size_t lists, typename Part>
std::array<size_t, lists> WriteParts(TaskPool& pool, int count, int least,
                                     const std::array<std::vector<T>*, lists>& out, Part&& part) {
    std::array<size_t, lists> used[Parts::most];
    for (std::vector<T>* list : out) EnsureRows(*list, ToSize(count));
    const Parts parts(pool, count, least);
    parts.For(pool, [&](int i, int begin, int end) {
        std::array<T*, lists> places;
        for (size_t k = 0; k < lists; ++k) places[k] = out[k]->data() + begin;
        used[i] = part(begin, end, places);
    });
    for (size_t k = 0; k < lists; ++k) {
        auto end = out[k]->begin() + static_cast<ptrdiff_t>(used[0][k]);
        for (int i = 1; i < parts.Count(); ++i) {
            const auto from = out[k]->begin() + parts.Begin(i);
            end = std::copy(from, from + static_cast<ptrdiff_t>(used[i][k]), end);
        }
        used[0][k] = static_cast<size_t>(end - out[k]->begin());
    }
    return used[0];
}

/// The same, and the lists have nothing but these items.
template <typename T, size_t lists, typename Part>
void GatherParts(TaskPool& pool, int count, int least, const std::array<std::vector<T>*, lists>& out, Part&& part) {
    for (std::vector<T>* list : out) list->resize(ToSize(count));
    const std::array<size_t, lists> used = WriteParts(pool, count, least, out, part);
    for (size_t k = 0; k < lists; ++k) out[k]->resize(used[k]);
}

}  // namespace scree
