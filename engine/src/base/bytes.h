// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bytes that vectors keep, room for more elements included, and how to give them back.

#pragma once

#include <cstddef>
#include <vector>

namespace scree {

template <typename... T>
size_t BytesOf(const std::vector<T>&... columns) {
    return (size_t{0} + ... + (columns.capacity() * sizeof(T)));
}

/// Gives back the room for more elements.
template <typename... T>
void Shrink(std::vector<T>&... columns) {
    (columns.shrink_to_fit(), ...);
}

}  // namespace scree
