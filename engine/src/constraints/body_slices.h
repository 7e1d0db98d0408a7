// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Space in slices, one for each thread, with about as many contacts in each. What a thread does with the bodies and
// contacts of its slice stays in its caches from loop to loop and from step to step.

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/task_pool.h"
#include "state/bodies.h"
#include "state/contacts.h"

namespace scree {

class BodySlices {
public:
    static constexpr int most = 16;

    /// For the coming step. Slices stay where they are until they have become uneven, or other threads are to share.
    void Update(const TaskPool& pool, const BodyTable& bodies, const ContactTable& contacts,
                std::span<const ContactIndex> list);
    /// How many contacts are in each slice, and how many of all push bodies that those of other slices push, too.
    void Note(std::span<const int> sizes, int atBorder);
    /// There were too few contacts for chains: until they are cut anew, slices would only cost.
    void NoteUnused() { m_count = 1; }

    /// Which slices they are: what was laid out by others is to be laid out anew.
    [[nodiscard]] int GetEdition() const { return m_edition; }
    /// 1 where threads do not share the contacts, or too many contacts would be between slices.
    [[nodiscard]] int Count() const { return m_count; }
    [[nodiscard]] uint8_t Of(const BodyTable& bodies, BodyIndex body) const {
        return static_cast<uint8_t>(SliceOf(Place(bodies, body, m_order), m_cuts, m_count));
    }
    /// Whether bodies stay in their slices wherever they go.
    [[nodiscard]] bool AreByNumber() const { return m_order == Order::byNumber; }
    /// The bodies of a list slice by slice: in `sliced`, or the list itself where there is one slice.
    [[nodiscard]] std::span<const BodyIndex> Sort(TaskPool& pool, const BodyTable& bodies,
                                                  std::span<const BodyIndex> list, std::vector<BodyIndex>& sliced);
    /// Where a slice begins and ends in what was sorted last, if there were several.
    [[nodiscard]] std::pair<size_t, size_t> GetRange(int slice) const {
        return {m_begins[ToSize(slice)], m_begins[ToSize(slice) + 1]};
    }

private:
    /// Along which bodies are cut. By number, what other loops of a step do with them stays in the same caches, too.
    enum class Order : uint8_t { byNumber, byX, byY };

    static float Place(const BodyTable& bodies, BodyIndex body, Order order) {
        if (order == Order::byNumber) return static_cast<float>(ToInt(body));
        const Vec2 centre = bodies.position[body].c;
        return order == Order::byX ? centre.x : centre.y;
    }
    static int SliceOf(float place, const std::array<float, most>& cuts, int count) {
        int slice = 0;
        for (int i = 0; i + 1 < count; ++i) slice += place >= cuts[ToSize(i)] ? 1 : 0;
        return slice;
    }
    bool Cut(const BodyTable& bodies, const ContactTable& contacts, std::span<const ContactIndex> list, int count);

    static constexpr int shortWait = 4, longWait = 256;  ///< steps

    int m_count = 1;
    int m_edition = 0;
    int m_wanted = 1;         ///< when they were cut
    int m_age = 0;            ///< steps since then
    int m_wait = shortWait;   ///< steps before they may be cut anew; longer while that does not help
    bool m_isUneven = false;  ///< or has long borders
    bool m_mayShare = false;
    Order m_order = Order::byNumber;
    std::array<float, most> m_cuts{};  ///< between slices
    std::array<size_t, most + 1> m_begins{};
};

}  // namespace scree
