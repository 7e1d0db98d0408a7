// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Names for objects that outlive them. A handle's slot is used again after its object is destroyed, so an old pointer
// may silently mean a new object; an id carries the slot's generation and World::Find tells that its object is gone.

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
