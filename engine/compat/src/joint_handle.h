// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The engine's joint behind a b2Joint, by its concrete type, for the files of the joints.

#pragma once

#include "convert.h"
#include "scree/scree.h"

namespace scree::box2d {

template <typename J>
J& As(Joint* handle) {
    return static_cast<J&>(*handle);
}

}  // namespace scree::box2d
