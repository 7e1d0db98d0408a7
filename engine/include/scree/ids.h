// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Ids of objects, which may outlive them. After an object is destroyed its handle is used again, so an old pointer may
// mean a new object. An id contains a generation, by which World::Find tells that the object no longer exists.

#pragma once

#include <cstdint>

namespace scree {

/// A slot and how often it had been freed when the id was taken. The default id names nothing.
template <typename Tag>
struct ObjectId {
    int32_t index = -1;
    uint32_t generation = 0;
    friend bool operator==(const ObjectId&, const ObjectId&) = default;
};

using BodyId = ObjectId<class Body>;
using FixtureId = ObjectId<class Fixture>;
using JointId = ObjectId<class Joint>;
using ContactId = ObjectId<class Contact>;

}  // namespace scree
