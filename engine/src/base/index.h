// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Indices that know what they count. Each kind of row has an enumeration of its own over int (state/indices.h). A
// Column takes the indices of its rows alone: the row of a contact in a column of bodies does not compile. An index is
// as large and as fast as an int, and images and hashes take it for one.

#pragma once

#include <concepts>
#include <cstddef>
#include <deque>
#include <initializer_list>
#include <type_traits>
#include <vector>

namespace scree {

template <typename T>
inline constexpr bool isEnumOverInt = std::is_same_v<std::underlying_type_t<T>, int>;

/// An enumeration over int with the value `none` = −1.
template <typename T>
concept TypedIndex = std::is_enum_v<T> && isEnumOverInt<T> && requires {
    T::none;
};
/// Or an int, for what has no kind of its own.
template <typename T>
concept Index = TypedIndex<T> || std::same_as<T, int>;

template <Index I>
constexpr int ToInt(I index) {
    return static_cast<int>(index);
}
/// For arrays that are no columns.
template <Index I>
constexpr size_t ToSize(I index) {
    return static_cast<size_t>(index);
}
/// The index of a row that was counted.
template <Index I>
constexpr I ToIndex(size_t row) {
    return I{static_cast<int>(row)};
}

template <Index I>
constexpr bool IsNone(I index) {
    return ToInt(index) < 0;
}
template <Index I>
constexpr bool IsSome(I index) {
    return ToInt(index) >= 0;
}
template <Index I>
constexpr I NextOf(I index) {
    return I{ToInt(index) + 1};
}
template <TypedIndex I>
constexpr I& operator++(I& index) {
    return index = I{ToInt(index) + 1};
}
template <TypedIndex I>
constexpr I& operator--(I& index) {
    return index = I{ToInt(index) - 1};
}

/// The indices from `first` on below `last`, for loops.
template <Index I>
class IndexRange {
public:
    class Iterator {
    public:
        constexpr explicit Iterator(I index) : m_index(index) {}
        constexpr I operator*() const { return m_index; }
        constexpr Iterator& operator++() { return ++m_index, *this; }
        constexpr bool operator==(const Iterator&) const = default;

    private:
        I m_index;
    };

    constexpr IndexRange(int first, int last) : m_first(first), m_last(last) {}
    [[nodiscard]] constexpr Iterator begin() const { return Iterator(I{m_first}); }
    [[nodiscard]] constexpr Iterator end() const { return Iterator(I{m_last}); }

private:
    int m_first, m_last;
};

/// A vector whose elements are found by indices of one kind only. Loops that read many columns at once may walk over
/// data().
template <Index I, typename T>
class Column : private std::vector<T> {
    using Base = std::vector<T>;

public:
    using typename Base::const_iterator;
    using typename Base::iterator;
    using typename Base::size_type;
    using typename Base::value_type;

    Column() = default;
    explicit Column(size_t count) : Base(count) {}
    Column(size_t count, const T& fill) : Base(count, fill) {}
    Column(std::initializer_list<T> values) : Base(values) {}

    [[nodiscard]] T& operator[](I index) { return Base::operator[](ToSize(index)); }
    [[nodiscard]] const T& operator[](I index) const { return Base::operator[](ToSize(index)); }
    /// Whether there is such a row. Any index may be asked.
    [[nodiscard]] bool Has(I index) const { return static_cast<unsigned>(ToInt(index)) < Base::size(); }
    [[nodiscard]] IndexRange<I> Rows() const { return {0, static_cast<int>(Base::size())}; }
    /// The index that push_back is going to give.
    [[nodiscard]] I End() const { return ToIndex<I>(Base::size()); }

    using Base::assign;
    using Base::back;
    using Base::begin;
    using Base::capacity;
    using Base::clear;
    using Base::data;
    using Base::emplace_back;
    using Base::empty;
    using Base::end;
    using Base::front;
    using Base::pop_back;
    using Base::push_back;
    using Base::reserve;
    using Base::resize;
    using Base::shrink_to_fit;
    using Base::size;
    void swap(Column& other) noexcept { Base::swap(other); }

    friend bool operator==(const Column& a, const Column& b) {
        return static_cast<const Base&>(a) == static_cast<const Base&>(b);
    }
};

/// A column whose elements stay where they are when it grows.
template <Index I, typename T>
class StableColumn : private std::deque<T> {
    using Base = std::deque<T>;

public:
    using typename Base::const_iterator;
    using typename Base::iterator;
    using typename Base::size_type;
    using typename Base::value_type;

    [[nodiscard]] T& operator[](I index) { return Base::operator[](ToSize(index)); }
    [[nodiscard]] const T& operator[](I index) const { return Base::operator[](ToSize(index)); }
    [[nodiscard]] bool Has(I index) const { return static_cast<unsigned>(ToInt(index)) < Base::size(); }
    [[nodiscard]] IndexRange<I> Rows() const { return {0, static_cast<int>(Base::size())}; }
    [[nodiscard]] I End() const { return ToIndex<I>(Base::size()); }

    using Base::begin;
    using Base::emplace_back;
    using Base::empty;
    using Base::end;
    using Base::push_back;
    using Base::size;
    void swap(StableColumn& other) noexcept { Base::swap(other); }
};

/// What holds rows: a vector or a column.
template <typename T>
inline constexpr bool isColumn = false;
template <typename T, typename A>
inline constexpr bool isColumn<std::vector<T, A>> = true;
template <typename I, typename T>
inline constexpr bool isColumn<Column<I, T>> = true;
template <typename T>
concept AnyColumn = isColumn<std::remove_const_t<T>>;

}  // namespace scree
