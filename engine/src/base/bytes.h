// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bytes that vectors keep, room for more elements included, and how to give them back.

#pragma once

#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>

#include "base/index.h"

namespace scree {

template <AnyColumn... T>
size_t BytesOf(const T&... columns) {
    return (size_t{0} + ... + (columns.capacity() * sizeof(typename T::value_type)));
}

/// Gives back the room for more elements.
template <AnyColumn... T>
void Shrink(T&... columns) {
    (columns.shrink_to_fit(), ...);
}

/// Room for as many elements as another one has. Which worker does what changes from step to step, and a step is not to
/// allocate for that.
template <AnyColumn T>
void MatchRoom(T& column, const T& other) {
    if (column.capacity() < other.capacity()) column.reserve(other.capacity());
}

/// Room in each row for whatever another one has had.
template <typename Rows>
void MatchRooms(Rows&& rows) {
    for (const auto& row : rows) std::begin(rows)->MatchRoomOf(row);
    for (auto& row : rows) row.MatchRoomOf(*std::begin(rows));
}

/// Room in the column of each row for all that was found together: the next time one worker may find all of it.
template <typename Rows, typename Column>
void ReserveEach(Rows&& rows, Column column, size_t count) {
    for (auto& row : rows) {
        auto& own = std::invoke(column, row);
        if (own.capacity() < count) own.reserve(std::bit_ceil(count));  // a little more is no reason to allocate
    }
}

}  // namespace scree
