// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The hook of the recorder: one object at the head of every call that changes the world. It is made when the arguments
// of the call have been found good. It writes the call's number (a hash of its name) and the arguments. While it lives,
// calls made by this one are not recorded, since the replayed call makes them again. Without a recorder it costs one
// comparison. It also notes that definitions have changed (scree/rollback.h), unless the call says that it only moves
// things.

#pragma once

#include <string_view>
#include <type_traits>

#include "scree/recording.h"
#include "world/image.h"
#include "world/state_fields.h"

namespace scree {

/// FNV-1a, 32 bits, of a call's name.
constexpr uint32_t CallNumber(std::string_view name) {
    uint32_t sum = 0x811c9dc5u;
    for (const char c : name) sum = (sum ^ static_cast<uint8_t>(c)) * 0x01000193u;
    return sum;
}

/// In front of every recording: letters and, in the highest byte, the version of the format.
inline constexpr uint64_t recordingMagic = 0x0063657265726373ull | uint64_t{recordingVersion} << 56;

/// Follows every Step in a recording.
inline constexpr uint32_t hashRecord = CallNumber("state hash");

/// A changed number of iterations would still be a call, but one that may take for ever.
inline uint32_t EntryChecksum(uint32_t call, std::span<const std::byte> arguments) {
    return call ^ static_cast<uint32_t>(ChecksumOf(arguments) >> 32);
}

template <Is<MotionLocks> Self, typename Visit>
void Fields(Self& locks, Visit& visit) {
    auto& [x, y, angle] = locks;
    visit(x, y, angle);
}
template <Is<BodyDef> Self, typename Visit>
void Fields(Self& def, Visit& visit) {
    auto& [type, position, positionRest, angle, linearVelocity, angularVelocity, linearDamping, angularDamping,
           allowSleep, awake, fixedRotation, bullet, enabled, userData, gravityScale, locks] = def;
    visit(type, position, angle, linearVelocity, angularVelocity, linearDamping, angularDamping, allowSleep, awake);
    visit(fixedRotation, bullet, enabled, userData, gravityScale, positionRest, locks);
}
/// The shape is written behind it.
template <Is<FixtureDef> Self, typename Visit>
void Fields(Self& def, Visit& visit) {
    auto& [shape, userData, friction, restitution, restitutionThreshold, density, isSensor, filter, reports,
           tangentSpeed, rollingResistance, frictionRule, restitutionRule, materialId] = def;
    visit(userData, friction, restitution, restitutionThreshold, density, isSensor, filter, reports, tangentSpeed,
          rollingResistance, frictionRule, restitutionRule, materialId);
    visit.LeftOut(shape);
}
template <Is<Tolerance> Self, typename Visit>
void Fields(Self& tolerance, Visit& visit) {
    auto& [overlap, jointGap, leastSubsteps, mostSubsteps] = tolerance;
    visit(overlap, jointGap, leastSubsteps, mostSubsteps);
}

/// What a call changes: objects and settings, or only what a step changes too.
enum class Changes : bool { definitions, motion };

class Recording {
public:
    template <typename... Arguments>
    Recording(const WorldState& state, const char* call, const Arguments&... arguments)
        : Recording(Changes::definitions, state, call, arguments...) {}
    template <typename... Arguments>
    Recording(Changes changes, const WorldState& state, const char* call, const Arguments&... arguments)
        : m_state(state), m_recorder(state.recorder) {
        if (changes == Changes::definitions) state.definitions.Note();
        if (m_recorder == nullptr || m_recorder->m_depth++ > 0) return;
        ImageWriter out;
        (Write(out, arguments), ...);
        m_recorder->Append(CallNumber(call), out.Bytes());
        ++m_recorder->m_callCount;
    }
    ~Recording() {
        if (IsStillOn()) --m_recorder->m_depth;
    }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    /// The state that a Step has led to.
    void NoteHash(uint64_t hash) const;
    [[nodiscard]] bool IsOn() const { return IsStillOn() && m_recorder->m_depth == 1; }

private:
    /// A callback may have stopped the recording, and its recorder may be gone.
    [[nodiscard]] bool IsStillOn() const { return m_recorder != nullptr && m_recorder == m_state.recorder; }
    template <typename T>
    static void Write(ImageWriter& out, const T& value) {
        out(value);
    }
    /// Its type in front.
    static void Write(ImageWriter& out, const Shape& shape);
    /// A definition with its shape.
    static void Write(ImageWriter& out, const FixtureDef& def);
    /// A definition of any type, with bodies and joints as indices.
    static void Write(ImageWriter& out, const JointDef& def);

    const WorldState& m_state;
    Recorder* m_recorder;
};

}  // namespace scree
