// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Entries of the table that are those of the base class do nothing.

#include "pipeline/parts/heard_calls.h"

#include "base/compiler.h"

#if defined(SCREE_HAS_PLAIN_VIRTUAL_TABLES)
#include <array>
#include <cstring>
#endif

namespace scree {

#if defined(SCREE_HAS_PLAIN_VIRTUAL_TABLES)

namespace {

/// Behind the two entries of the destructor, as the class declares them.
enum Entry : size_t { beginContact = 2, endContact, preSolve, postSolve, entryCount };

std::array<const void*, entryCount> TableOf(const ContactListener& listener) {
    const void* table = nullptr;
    std::array<const void*, entryCount> entries;
    std::memcpy(&table, static_cast<const void*>(&listener), sizeof(table));
    std::memcpy(entries.data(), table, sizeof(entries));
    return entries;
}

}  // namespace

HeardCalls FindHeardCalls(const ContactListener& listener) {
    static_assert(sizeof(ContactListener) == sizeof(void*), "nothing but the pointer to the table");
    const auto own = TableOf(listener), silent = TableOf(ContactListener());
    const auto isReplaced = [&](Entry entry) { return own[entry] != silent[entry]; };
    return {isReplaced(beginContact), isReplaced(endContact), isReplaced(preSolve), isReplaced(postSolve)};
}

#else

HeardCalls FindHeardCalls(const ContactListener& /*listener*/) { return {}; }

#endif

}  // namespace scree
