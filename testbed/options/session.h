// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A session that conditions look at: a motion as it was recorded, or an engine that runs a scene.

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "testbed/engines/engine_run.h"
#include "testbed/options/options.h"

namespace testbed {

class Session {
public:
    /// `steps` of an engine's run; a motion ends where it was recorded to. With `follows`, the tree of that engine
    /// follows the motion, and times are its own.
    Session(const SceneInput& input, const RunSpec& spec, int steps, bool follows = false);

    /// False at the end.
    bool Step();
    /// Goes to the step before the first one, and ends after the last. Throws UsageError if there are no such steps.
    void Narrow(const StepRange& range);
    [[nodiscard]] int GetStep() const { return m_run->GetStep(); }
    [[nodiscard]] int GetLastStep() const { return m_lastStep; }
    /// Of the last step, s.
    [[nodiscard]] double GetTimeStep() const;
    /// Since the session's beginning, s.
    [[nodiscard]] double GetTime() const { return m_time; }
    /// Of the last step.
    [[nodiscard]] double GetStepMilliseconds() const { return m_run->GetTimes().step; }
    [[nodiscard]] Snapshot Capture(bool hasNodes = false);
    /// What the indices of bodies mean.
    [[nodiscard]] const scenes::Scene& GetScene() const { return m_start.scene; }
    /// "player (37)", or "body 37" without a name.
    [[nodiscard]] std::string NameOf(int body) const;
    /// By index of a body, nothing for one without.
    [[nodiscard]] const std::vector<std::string>& GetNames() const { return m_names; }
    /// The name alone, or nothing.
    [[nodiscard]] const std::string& GetName(int body) const { return m_names[static_cast<std::size_t>(body)]; }
    [[nodiscard]] bool IsMotion() const { return m_start.motion != nullptr; }
    /// Contacts and times are known: a motion may have been recorded without.
    [[nodiscard]] bool HasContacts() const;
    [[nodiscard]] bool HasTimes() const;

private:
    RunStart m_start;
    std::unique_ptr<EngineRun> m_run;
    std::vector<std::string> m_names;  ///< by index of a body
    int m_lastStep;
    double m_timeStep;  ///< of an engine's run
    double m_time = 0.0;
    bool m_measures;  ///< the tree that follows a motion
};

/// By index of a body, as files keep them; nothing for one without.
[[nodiscard]] std::vector<std::string> NamesIn(const RunStart& start);

/// A session as typed.
struct SessionArguments {
    std::string input;
    std::optional<int> size;
    std::string steps;  ///< N or A:B; empty: all
    InputArguments reading;
    SettingArguments settings;
    std::string engine;  ///< ENGINE[:KEY=VALUE]…; empty: scree, or a motion as it was recorded
};
/// INPUT and the options that say how it is run.
void AddSessionOptions(CLI::App& app, SessionArguments& arguments);
/// The scene or the motion that was asked for. Throws UsageError and FileError.
[[nodiscard]] SceneInput ChooseSessionInput(const SessionArguments& arguments);
/// A session and what it is called among others.
struct NamedSession {
    std::string name;
    Session session;
};
/// One for each of `engines` ([NAME=]ENGINE[:KEY=VALUE],…), each from its beginning; the trees of engines follow a
/// motion. Without engines, the one of OpenSession. Throws UsageError.
[[nodiscard]] std::vector<NamedSession> OpenSessions(const SessionArguments& arguments, const SceneInput& input,
                                                     const std::string& engines);
/// From its beginning. Throws UsageError for what cannot be meant together.
[[nodiscard]] Session OpenSession(const SessionArguments& arguments, const SceneInput& input);

}  // namespace testbed
