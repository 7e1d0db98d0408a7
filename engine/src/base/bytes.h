// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bytes that vectors keep, room for more elements included, and how to give them back.

#pragma once

#include <cstddef>

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

}  // namespace scree
