// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A run that goes back in time. What its user did to it is part of the record. Our engine goes back bit for bit: images
// of it are kept as far apart as a limit of memory demands, and the steps between are made again. Other engines show
// frames that were kept. A recorded motion has every step anyway.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "testbed/engines/engine_run.h"

namespace testbed {

/// Something that a user did to a run, between two steps.
struct RunAction {
    enum class Kind : std::uint8_t { apply, beginDrag, moveDrag, endDrag, bullet, edit };
    Kind kind = Kind::endDrag;
    int afterStep = 0;
    int body = -1;                          ///< beginDrag, edit
    Vec2 point{}, velocity{};               ///< beginDrag: local; moveDrag: target; bullet
    std::shared_ptr<const RunSpec> spec{};  ///< apply
    BodyEdit edit{};
};

/// Things by step, thinned out evenly where they take more than a limit; the first one always stays.
template <typename Kept>
class SparseSteps {
public:
    SparseSteps(std::size_t limit, int spacing) : m_limit(limit), m_spacing(spacing) {}

    /// Whether a thing of that step would be kept and is not yet.
    [[nodiscard]] bool Wants(int step) const { return step % m_spacing == 0 && !m_kept.contains(step); }
    void Keep(int step, Kept kept, std::size_t bytes) {
        m_kept.emplace(step, std::pair(std::move(kept), bytes));
        m_bytes += bytes;
        while (m_bytes > m_limit && m_kept.size() > 1) {
            m_spacing *= 2;
            EraseIf([&](int at) { return at % m_spacing != 0; });
        }
    }
    /// Forgets what is behind a step.
    void CutAfter(int step) {
        EraseIf([&](int at) { return at > step; });
    }
    /// The last at or before a step; something of the first step is there.
    [[nodiscard]] std::pair<int, const Kept*> Find(int step) const {
        auto at = m_kept.upper_bound(step);
        if (at != m_kept.begin()) --at;
        return {at->first, &at->second.first};
    }
    [[nodiscard]] std::size_t GetBytes() const { return m_bytes; }
    [[nodiscard]] int GetSpacing() const { return m_spacing; }
    [[nodiscard]] std::size_t GetCount() const { return m_kept.size(); }

private:
    template <typename IsOut>
    void EraseIf(IsOut&& isOut) {
        std::erase_if(m_kept, [&](const auto& one) {
            if (!isOut(one.first)) return false;
            m_bytes -= one.second.second;
            return true;
        });
    }
    std::map<int, std::pair<Kept, std::size_t>> m_kept;
    std::size_t m_bytes = 0, m_limit;
    int m_spacing;
};

class RunHistory {
public:
    using Make = std::function<std::unique_ptr<InteractiveRun>()>;

    /// `make` gives the run at step 0, the same every time. `limit`: bytes of what is kept.
    RunHistory(Make make, std::size_t limit);
    /// A motion as it was recorded, from that step on.
    RunHistory(std::shared_ptr<TrackFile> motion, int from);

    /// To the next step: into the future, or to what was there already. False at the end of a motion.
    bool Step();
    /// To a step from GetFirstStep to GetLastStep. Of a motion that left steps out, to the last one before it.
    void GoTo(int step);
    [[nodiscard]] int GetStep() const { return m_step; }
    [[nodiscard]] int GetFirstStep() const { return m_firstStep; }
    [[nodiscard]] int GetLastStep() const { return m_lastStep; }
    [[nodiscard]] bool IsMotion() const { return m_motion != nullptr; }
    /// Whether the engine itself is at this step; else a kept frame is shown, whose step Capture tells.
    [[nodiscard]] bool IsExact() const;
    void Capture(Snapshot& snapshot, const CaptureParts& parts);
    [[nodiscard]] StepTimes GetTimes() const;
    [[nodiscard]] const RunSpec& GetSpec() const;
    /// What indices of bodies mean, until something is shot or changed in the past.
    [[nodiscard]] const scenes::Scene& GetScene() const;

    // What a user does. In the past it changes the future: what was there of it is forgotten. Throws
    // std::invalid_argument as the run does, and for a motion.
    void Apply(const RunSpec& spec);
    void BeginDrag(int body, Vec2 localPoint);
    void MoveDrag(Vec2 target);
    void EndDrag();
    void ShootBullet(Vec2 position, Vec2 velocity);
    void Edit(int body, const BodyEdit& edit);

    /// Values of an object by its index in the snapshot; empty where the engine is not at this step or does not tell.
    [[nodiscard]] RunValues ValuesOfBody(int body) const;
    [[nodiscard]] RunValues ValuesOfFixture(int fixture) const;
    [[nodiscard]] RunValues ValuesOfJoint(int joint) const;

    /// The world of this step.
    [[nodiscard]] scenes::Scene MakeScene();
    /// All steps with all that the user did, as a track, through the writer of whole files.
    void WriteTrack(const std::string& path) const;

    [[nodiscard]] std::size_t GetBytes() const { return m_images.GetBytes() + m_frames.GetBytes(); }
    /// Steps from one thing that is kept to the next.
    [[nodiscard]] int GetSpacing() const { return m_goesBack ? m_images.GetSpacing() : m_frames.GetSpacing(); }
    [[nodiscard]] const std::vector<RunAction>& GetActions() const { return m_actions; }

private:
    void Do(RunAction action);
    void Perform(InteractiveRun& run, const RunAction& action) const;
    /// Forgets the future, and has the engine at this step.
    void Branch();
    void KeepImage();
    void ApplyDue();
    [[nodiscard]] std::unique_ptr<InteractiveRun> Remake(int step) const;
    /// Steps a run from its beginning to a step, with all that was done before that.
    void Play(InteractiveRun& run, int step) const;
    [[nodiscard]] bool IsAtEnd() const { return m_step == m_lastStep; }

    Make m_make;
    std::shared_ptr<TrackFile> m_motion;
    std::unique_ptr<InteractiveRun> m_run;  ///< at this step if the engine goes back, else at the last one
    std::unique_ptr<EngineRun> m_played;    ///< of a motion
    RunSpec m_motionSpec;
    bool m_goesBack = false;
    int m_step = 0, m_firstStep = 0, m_lastStep = 0;
    std::vector<RunAction> m_actions;  ///< in the order of time
    std::size_t m_applied = 0;         ///< of them, in what is shown
    SparseSteps<std::shared_ptr<const RunImage>> m_images;
    SparseSteps<Snapshot> m_frames;
};

}  // namespace testbed
