// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The checks at the head of a public entry point, as a chain that stops at the first finding. The finding goes to the
// error handler once, and the entry point returns it.

#pragma once

#include <cmath>

#include "state/limits.h"
#include "world/record.h"
#include "world/validate.h"

namespace scree {

/// Usage: `Guard guard(state, "Body::SetTransform"); if (guard.Unlocked("…").Finite(p, "p").Failed()) return
/// guard.Code();`
class Guard {
public:
    Guard(const WorldState& state, const char* function) : m_state(state), m_function(function) {}

    /// The object of the call is alive.
    template <Index I>
    Guard& Living(const Slots<I>& slots, I index) {
        return Require(slots.IsAlive(index), ErrorCode::foreignHandle, "this", "use a handle that was not destroyed");
    }
    Guard& Unlocked(const char* cure) { return Require(!m_state.IsLocked(), ErrorCode::locked, "world", cure); }
    Guard& NotNull(bool present, const char* field, const char* cure) {
        return Require(present, ErrorCode::nullArgument, field, cure);
    }
    Guard& Finite(Vec2 v, const char* field) {
        return Require(v.IsValid(), ErrorCode::nonFinite, field, "give a finite vector");
    }
    Guard& Finite(float value, const char* field) {
        return Require(std::isfinite(value), ErrorCode::nonFinite, field, "give a finite number");
    }
    /// Finite, and no farther than squares and boxes stay finite.
    template <typename T>
    Guard& Near(T value, const char* field) {
        return Finite(value, field)
            .Require(IsInRange(value), ErrorCode::outOfRange, field, "give numbers of at most 1e18");
    }
    /// Finite and not negative.
    Guard& Amount(float value, const char* field) {
        return Finite(value, field).Require(value >= 0.0f, ErrorCode::outOfRange, field, "give a number of at least 0");
    }
    Guard& Require(bool holds, ErrorCode code, const char* field, const char* cure) {
        if (!holds && m_code == ErrorCode::ok) m_code = m_state.Refuse(code, m_function, field, cure);
        return *this;
    }
    /// The world may use all these features.
    Guard& Uses(Features features) {
        const Features missing = features - AllowedFeatures(m_state.def);
        if (missing.IsEmpty()) return *this;
        return Require(false, ErrorCode::missingFeature, GetName(missing.First()),
                       "add it to WorldDef::features, and to SCREE_FEATURES if the library was built with it");
    }
    Guard& Accept(const Finding& finding) { return Require(!finding, finding.code, finding.field, finding.cure); }

    /// Records the call, now that its arguments are good, while the result lives.
    template <typename... Arguments>
    [[nodiscard]] Recording Record(const Arguments&... arguments) const {
        return Recording(m_state, m_function, arguments...);
    }
    /// Likewise, for a call that only moves things.
    template <typename... Arguments>
    [[nodiscard]] Recording RecordMotion(const Arguments&... arguments) const {
        return Recording(Changes::motion, m_state, m_function, arguments...);
    }

    [[nodiscard]] bool Failed() const { return m_code != ErrorCode::ok; }
    [[nodiscard]] ErrorCode Code() const { return m_code; }

private:
    const WorldState& m_state;
    const char* m_function;
    ErrorCode m_code = ErrorCode::ok;
};

/// True if the object of an accessor is alive; if not, the error handler hears of it.
template <Index I>
bool IsAlive(const WorldState& state, const Slots<I>& slots, I index, const char* accessor) {
    return !Guard(state, accessor).Living(slots, index).Failed();
}

/// Holds a world locked while callbacks run, also when one throws; may be nested, and held by several threads at once.
class WorldLock {
public:
    explicit WorldLock(const WorldState& state) : m_state(state) {
        m_state.locks.fetch_add(1, std::memory_order_relaxed);
    }
    ~WorldLock() { m_state.locks.fetch_sub(1, std::memory_order_relaxed); }
    WorldLock(const WorldLock&) = delete;
    WorldLock& operator=(const WorldLock&) = delete;

private:
    const WorldState& m_state;
};

}  // namespace scree
