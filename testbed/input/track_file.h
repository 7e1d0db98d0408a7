// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tracks (`*.track`): a world and its motion, as testbed/capture/ records it and scree_capture_format.h describes it.
// Opening a track decodes all of it once; afterwards any step is at hand.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// A body that was there at any time.
struct TrackBody {
    std::int64_t number = 0;  ///< that the track calls it by
    int createdAfter = 0;     ///< it is there from this step on; 0: from the start
    int destroyedAfter = -1;  ///< it is not there from this step on; −1: to the end
    std::int64_t was = -1;    ///< number of the body that it replaces, after its fixtures or type changed; −1: none
    std::string name;         ///< that the program gave it, or nothing

    [[nodiscard]] bool IsThere(int step) const {
        return createdAfter <= step && (destroyedAfter < 0 || step < destroyedAfter);
    }
};

/// A joint that was there at any time; the same rules.
struct TrackJoint {
    std::int64_t number = 0;
    int createdAfter = 0;
    int destroyedAfter = -1;

    [[nodiscard]] bool IsThere(int step) const {
        return createdAfter <= step && (destroyedAfter < 0 || step < destroyedAfter);
    }
};

struct TrackState {
    bool isThere = false;  ///< if not, the rest means nothing
    bool awake = false;    ///< static bodies never are
    scenes::Vec2 position{};
    float angle = 0.0f;
    scenes::Vec2 linearVelocity{};  ///< of the centre of mass
    float angularVelocity = 0.0f;
};

/// A fixture of a body and a child of it (a segment of a chain).
struct TrackPlace {
    int body = 0;     ///< index into GetBodies
    int fixture = 0;  ///< of that body, from 0
    int child = 0;
};

struct TrackContact {
    TrackPlace a, b;
    bool isSensor = false;
    int pointCount = 0;
    scenes::Vec2 normal{};
    std::array<scenes::Vec2, 2> points{};
    std::array<float, 2> separations{}, normalImpulses{}, tangentImpulses{};
};

/// A node of the engine's tree; the root is 0, children come after their parent.
struct TrackNode {
    scenes::Vec2 lower{}, upper{};
    int parent = -1, child1 = -1, child2 = -1;  ///< −1: none
    TrackPlace leaf{};                          ///< of a node without children
};

/// What is known of one step. Contacts, nodes and stages are empty if they were not recorded.
struct TrackStep {
    int step = 0;
    float timeStep = 0.0f;           ///< s
    std::vector<TrackState> bodies;  ///< by index into GetBodies
    std::vector<TrackContact> contacts;
    int contactCount = 0;  ///< that the engine kept, touching or not
    std::vector<TrackNode> nodes;
    std::vector<std::pair<std::string, float>> stages;  ///< names of the engine, ms
    std::vector<std::string> marks;
};

struct TrackInfo {
    int version = 1;
    std::string writer, engine;
    float timeStep = 0.0f;  ///< of the first step, s
    bool hasContacts = false, hasStages = false, hasNodes = false;
    std::size_t marks = 0;  ///< in all steps
    std::size_t bytes = 0;  ///< of the file
    /// What is wrong with the file although it could be read up to some step ("ends within a record at byte 120: read
    /// up to step 37"), or nothing.
    std::string damage;
};

class TrackFile {
public:
    /// The track in bytes; `source` names it in messages. Throws FileError with the place and the cure for what is no
    /// track. Memory stays in proportion to the bytes.
    TrackFile(std::string bytes, std::string_view source);
    ~TrackFile();
    TrackFile(TrackFile&&) noexcept;
    TrackFile& operator=(TrackFile&&) noexcept;

    [[nodiscard]] const TrackInfo& GetInfo() const;
    /// All bodies that ever were there, by age, as they were created, and all joints between them: what the indices of
    /// TrackStep and GetBodies mean. It is no state that the world ever had; SceneAt gives those.
    [[nodiscard]] const scenes::Scene& GetParts() const;
    [[nodiscard]] const std::vector<TrackBody>& GetBodies() const;
    [[nodiscard]] const std::vector<TrackJoint>& GetJoints() const;
    /// The steps that were recorded, growing. Steps may be missing (a flight recorder, a slow disk).
    [[nodiscard]] const std::vector<int>& GetSteps() const;
    [[nodiscard]] int GetLastStep() const { return GetSteps().empty() ? 0 : GetSteps().back(); }

    /// A recorded step, or 0: the world as recording began. Fast for steps in order, else a few dozen steps are
    /// decoded. Throws UsageError for a step that there is not.
    [[nodiscard]] const TrackStep& Read(int step);
    /// The world at that step, 0: as recording began, as a scene that runs from there; bodies that were created later
    /// enter as they did. Throws FileError if the world then was none that both engines can make.
    [[nodiscard]] scenes::Scene SceneAt(int step);

    struct Data;

private:
    std::unique_ptr<Data> m_data;
};

/// The track in a file. Throws FileError, also when it cannot be read.
[[nodiscard]] TrackFile ReadTrackFile(const std::filesystem::path& file);

/// Whether bytes begin as tracks do.
[[nodiscard]] bool IsTrack(std::string_view bytes);

}  // namespace testbed
