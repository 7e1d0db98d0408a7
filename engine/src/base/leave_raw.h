// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An allocator for vectors of plain data whose new rows are written before they are read. `resize` leaves new rows as
// they are, where a vector would first fill them with zeros.

#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace scree {

template <typename T>
struct LeaveRaw : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>);

    template <typename U>
    struct rebind {  // NOLINT: the standard's name
        using other = LeaveRaw<U>;
    };

    template <typename U>
    void construct(U* row) noexcept {  // NOLINT: the standard's name
        ::new (static_cast<void*>(row)) U;
    }
    template <typename U, typename... Arguments>
    void construct(U* row, Arguments&&... arguments) {  // NOLINT: the standard's name
        ::new (static_cast<void*>(row)) U(std::forward<Arguments>(arguments)...);
    }
};

}  // namespace scree
