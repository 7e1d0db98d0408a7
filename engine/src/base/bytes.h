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

}  // namespace scree
