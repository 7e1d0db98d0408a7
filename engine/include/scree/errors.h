// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What happens with bad input. Every public function checks its arguments in every build. A refused call changes
// nothing, tells the world's error handler which argument was wrong and why, and returns a code or null.

#pragma once

#include <cstdint>

namespace scree {

enum class ErrorCode : uint8_t {
    ok,
    nullArgument,    ///< a required pointer is null
    nonFinite,       ///< NaN or infinity
    outOfRange,      ///< a finite value outside the documented range
    badShape,        ///< a degenerate shape
    foreignHandle,   ///< the object belongs to another world, or was destroyed
    missingFeature,  ///< the world's fixed set of features, or this build of the library, does not have it
    locked,  ///< inside a callback of Step, of a query or of a destruction: create, destroy and move are refused
};

constexpr const char* GetName(ErrorCode code) {
    switch (code) {
        case ErrorCode::ok:
            return "ok";
        case ErrorCode::nullArgument:
            return "null argument";
        case ErrorCode::nonFinite:
            return "not finite";
        case ErrorCode::outOfRange:
            return "out of range";
        case ErrorCode::badShape:
            return "bad shape";
        case ErrorCode::foreignHandle:
            return "foreign handle";
        case ErrorCode::missingFeature:
            return "feature not in the set";
        case ErrorCode::locked:
            return "world is locked";
    }
    return "unknown";
}

/// One refused call.
struct Error {
    ErrorCode code;
    const char* function;  ///< the function that refused, e.g. "World::CreateBody"
    const char* field;     ///< the argument or field, e.g. "BodyDef::position"
    const char* cure;      ///< how to correct it
};

/// Receives every refused call. Must not call back into the world.
using ErrorHandler = void (*)(const Error& error, void* context);

}  // namespace scree
