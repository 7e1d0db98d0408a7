// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Lists of fields: one function Fields(object, visit) per structure. It is walked by whatever handles all of a world's
// state (the image, the recorder, the state hash). A list names every member, so that a member that it lacks does not
// compile. It takes the structure apart by a structured binding, whose names must be as many as the members. No binding
// can reach the members that a derived class adds to its base; these are checked by the size of the class.
//
// A visitor is called with members that belong to the state, and has these members for others:
//   visit(a, b, …)                 state: stored, and part of the hash
//   visit.Rows(rows, columns…)     the same for the columns of a table; only living rows have a meaning;
//                                  `rows` has Size(), Rows() and IsAlive(index). An empty column stands for rows of T()
//   visit.Stored(a, b, …)          stored, but nothing that a step reads: user data
//   visit.Hashed(a, b, …)          part of the hash, but not stored, since it follows from what is
//   visit.LeftOut(a, b, …)         neither: made anew, or used in a step only

#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace scree {

/// T or const T: a list serves readers and writers.
template <typename Self, typename T>
concept Is = std::is_same_v<std::remove_const_t<Self>, T>;

template <typename Base, size_t count>
struct FollowedBy : Base {
    char more[count];
};

/// Where the members of a class derived from Base begin: compilers may use the padding at the end of Base.
template <typename Base, size_t count = 1>
constexpr size_t EndOf() {
    if constexpr (sizeof(FollowedBy<Base, count + 1>) == sizeof(FollowedBy<Base, 1>)) {
        return EndOf<Base, count + 1>();
    } else {
        return sizeof(FollowedBy<Base, 1>) - count;
    }
}

/// The size of a class that adds these members, in this order, to Base.
template <typename Base, typename... Members>
constexpr size_t SizeWith() {
    size_t end = EndOf<Base>(), alignment = alignof(Base);
    const auto round = [](size_t size, size_t to) { return (size + to - 1) / to * to; };
    ((end = round(end, alignof(Members)) + sizeof(Members), alignment = std::max(alignment, alignof(Members))), ...);
    return round(end, alignment);
}

/// Compiles if `members` are all that the class of `object` adds to Base, in the order of their declaration.
template <typename Base, typename Self, typename... Members>
constexpr void NamesAllOf(const Self& /*object*/, const Members&... /*members*/) {
    static_assert(sizeof(Self) == SizeWith<Base, Members...>(), "this list of fields lacks a member of its class");
}

/// Visits the members that a class adds to Base.
template <typename Base, typename Self, typename Visit, typename... Members>
void VisitOwn(Self& object, Visit& visit, Members&... members) {
    NamesAllOf<Base>(object, members...);
    visit(members...);
}

}  // namespace scree
