// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program's calls as a block of bytes, and their replay. A recording contains the world at the start and every call
// since then that changed it, with its arguments, and after each Step the hash of the state. In a replay the same calls
// must lead to the same hashes. The first hash that differs names the step in which two builds, machines or numbers of
// threads differ.
//
// GetRecordedCalls lists the calls that are recorded. Listeners and filters, and what they do inside a Step, are not:
// give the player's world the same ones. Changes through references and pointers are not recorded either: user data
// that is set after an object was made, a shape from GetShape.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "scree/api.h"
#include "scree/errors.h"
#include "scree/snapshot.h"
#include "scree/world.h"

namespace scree {

/// Increases with every change of the format; a Player reads only its own version.
inline constexpr uint32_t recordingVersion = 3;

/// The memory of a recording. It must exist as long as its world is recorded.
class SCREE_API Recorder {
public:
    /// The recording so far; complete and replayable after every call.
    [[nodiscard]] std::span<const std::byte> GetBytes() const { return m_bytes; }
    [[nodiscard]] int GetCallCount() const { return m_callCount; }

private:
    friend class Recording;
    friend ErrorCode StartRecording(World& world, Recorder& recorder);
    void Append(uint32_t call, std::span<const std::byte> arguments);

    std::vector<std::byte> m_bytes;
    int m_callCount = 0;
    int m_depth = 0;  ///< calls that are running; calls made by a recorded call are not recorded
};

/// Records every call from now on into `recorder`, which is cleared first and replaces an earlier one. Refused while
/// the world is locked.
SCREE_API ErrorCode StartRecording(World& world, Recorder& recorder);
/// Ends the recording; does nothing if there is none.
SCREE_API void StopRecording(World& world);

/// How a Step was called.
struct RecordedStep {
    float timeStep = 0.0f;                               ///< s
    int velocityIterations = 0, positionIterations = 0;  ///< of sequential impulses; 0, 0 for another call
    int substeps = 0;                                    ///< of the soft step; 0 for another call
};

/// The result of a replay.
struct ReplayReport {
    bool valid = false;       ///< the bytes are a recording, and all its calls could be made
    int calls = 0;            ///< number of calls made
    int steps = 0;            ///< calls of Step among them
    int firstDifference = 0;  ///< the step, from 1, after which the hash differed; 0: none
    size_t position = 0;      ///< the byte after the last call made, where an invalid recording is damaged
    SnapshotError image = SnapshotError::notASnapshot;  ///< ok: the world at the start could be read
    RecordedStep lastStep;                              ///< of the last Step made
    std::unique_ptr<World> world;                       ///< as it is after the last call made; null if there is none
};

/// Makes the calls of a recording step by step on a world of its own.
class SCREE_API Player {
public:
    /// The bytes must exist as long as the player. `prepare` (may be null) gets the world before the first call, to
    /// set listeners.
    explicit Player(std::span<const std::byte> recording, const std::function<void(World&)>& prepare = nullptr);

    /// Makes the calls up to and including the next Step. Returns false if there is none. Then the calls after the last
    /// Step were made, or the replay ended before. The report gives the reason: damaged bytes, or a state that differs.
    bool Step();
    /// The result so far; `valid` is set only when Step has returned false.
    [[nodiscard]] const ReplayReport& GetReport() const { return m_report; }
    /// Null if the bytes are not a recording. A program may change the world; later steps then differ.
    [[nodiscard]] World* GetWorld() { return m_report.world.get(); }
    [[nodiscard]] ReplayReport TakeReport() { return std::move(m_report); }

private:
    enum class Entry : uint8_t { call, step, hash, end };
    Entry Next();

    std::span<const std::byte> m_bytes;
    ReplayReport m_report;
    bool m_hasEnded = false;
};

/// Makes all calls of a recording on a world of its own, up to the end or the first difference. `prepare` (may be null)
/// gets the world before the first call, to set listeners. Damaged bytes end the replay with valid = false.
SCREE_API ReplayReport Replay(std::span<const std::byte> recording,
                              const std::function<void(World&)>& prepare = nullptr);

/// The names of all calls that are recorded, such as "Body::SetTransform".
SCREE_API std::vector<std::string_view> GetRecordedCalls();

}  // namespace scree
