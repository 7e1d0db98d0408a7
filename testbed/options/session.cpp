// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of session.h.

#include "testbed/options/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "testbed/base/errors.h"
#include "testbed/base/progress.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/saved_world.h"
#include "testbed/engines/track_run.h"
#include "testbed/input/body_names.h"
#include "testbed/input/track_file.h"

namespace testbed {

namespace {

std::vector<std::string> NamesIn(const TrackFile& track) {
    std::vector<std::string> names;
    for (const TrackBody& body : track.GetBodies()) names.push_back(body.name);
    return names;
}

}  // namespace

std::vector<std::string> NamesIn(const RunStart& start) {
    return start.motion != nullptr ? NamesIn(*start.motion) : NamesIn(start.scene);
}

Session::Session(const SceneInput& input, const RunSpec& spec, int steps, bool follows)
    : m_start(input.Start()),
      m_lastStep(steps),
      m_timeStep(double{m_start.scene.timeStep}),
      m_measures(follows && m_start.motion != nullptr && spec.engine != recordedEngine) {
    if (IsMotion()) {
        m_run = follows ? MakeFollower(m_start, spec) : MakeTrackRun(m_start.motion, m_start.step);
        m_names = NamesIn(m_start);
        m_lastStep = m_start.motion->GetLastStep();
        return;
    }
    std::unique_ptr<InteractiveRun> run = MakeRun(m_start, spec);
    m_timeStep = testbed::GetTimeStep(run->GetSpec());
    m_run = std::move(run);
    m_names = NamesIn(m_start);
}

bool Session::Step() {
    if (m_run->GetStep() >= m_lastStep) return false;
    m_run->Step();
    m_time += GetTimeStep();
    return true;
}

void Session::Narrow(const StepRange& range) {
    if (range.first > m_lastStep) {
        throw UsageError(fmt::format("--steps {}:{}: the last step is {}", range.first, range.last, m_lastStep));
    }
    m_lastStep = std::min(m_lastStep, range.last);
    const int before = range.first - 1;
    Progress progress(fmt::format("to step {}", before), std::max(1, before - GetStep()));
    while (GetStep() < before && m_run->GetStep() < m_lastStep) {
        Step();
        progress.Advance(1);
    }
}

double Session::GetTimeStep() const {
    return IsMotion() ? double{m_start.motion->Read(m_run->GetStep()).timeStep} : m_timeStep;
}

Snapshot Session::Capture(bool hasNodes) {
    Snapshot snapshot;
    m_run->Capture(snapshot, {.nodes = hasNodes, .pairs = false});
    snapshot.times = m_run->GetTimes();
    return snapshot;
}

std::string Session::NameOf(int body) const {
    const std::string name = ToPrintable(GetName(body));
    return name.empty() ? fmt::format("body {}", body) : fmt::format("{} ({})", name, body);
}

bool Session::HasContacts() const { return !IsMotion() || m_start.motion->GetInfo().hasContacts; }

bool Session::HasTimes() const {
    if (!IsMotion() || m_measures) return true;
    TrackFile& track = *m_start.motion;
    return !track.GetSteps().empty() && !track.Read(track.GetSteps().front()).stages.empty();
}

void AddSessionOptions(CLI::App& app, SessionArguments& arguments) {
    app.add_option("INPUT", arguments.input, DescribeSceneArgument("A session or a scene"));
    app.add_option("--size", arguments.size, "Size of a scene that `scree list` shows; its default if not given");
    arguments.reading.poses.clear();
    AddInputOptions(app, arguments.reading);
    app.add_option("--engine", arguments.engine,
                   "What runs a scene: ENGINE[:KEY=VALUE]..; scree if not given. A motion is taken as it was recorded")
        ->type_name("ENGINE");
    app.add_option("--steps", arguments.steps, "Which steps: the first N, or A:B; all if not given")
        ->type_name("N|A:B");
    AddSetOption(app, arguments.settings, "Runs begin with preset=own: the engine's own defaults");
}

SceneInput ChooseSessionInput(const SessionArguments& arguments) {
    if (arguments.input.empty()) throw UsageError("where? Give a file or the name of a scene; `scree list` shows all");
    return ChooseScene(arguments.input, arguments.size, arguments.reading);
}

namespace {

StepRange RangeOf(const SessionArguments& arguments, int steps) {
    if (arguments.steps.empty()) return {.first = 1, .last = steps};
    const StepRange range = ParseSteps(arguments.steps, true);
    if (range.stride != 1) {
        throw UsageError(fmt::format("--steps {}: every step is looked at; give first:last", arguments.steps));
    }
    return range;
}

}  // namespace

std::vector<NamedSession> OpenSessions(const SessionArguments& arguments, const SceneInput& input,
                                       const std::string& engines) {
    if (!engines.empty() && !arguments.engine.empty()) {
        throw UsageError("--engine and --engines: give one of them");
    }
    const bool isMotion = input.motion != nullptr;
    const bool isAsRecorded = isMotion && engines.empty();
    if (isMotion && (!arguments.engine.empty() || (isAsRecorded && !arguments.settings.typed.empty()))) {
        throw UsageError(
            fmt::format("{} is taken as it was recorded: --engine and --set need --from K", arguments.input));
    }
    const StepRange range = RangeOf(arguments, isMotion ? maxStep : input.steps);
    std::vector<NamedSession> sessions;
    if (isAsRecorded) {
        sessions.push_back({"as recorded", {input, RunSpec{}, input.steps}});
        if (!arguments.steps.empty()) sessions.back().session.Narrow(range);
        return sessions;
    }
    const std::string text = !engines.empty() ? engines : arguments.engine.empty() ? "scree" : arguments.engine;
    const std::string_view base = input.world != nullptr ? std::string_view(input.world->settings) : std::string_view();
    for (const Pane& pane : ParsePanes(text, arguments.settings.typed, base)) {
        sessions.push_back({pane.name, {input, pane.spec, range.last, isMotion}});
        if (!arguments.steps.empty()) sessions.back().session.Narrow(range);
    }
    return sessions;
}

Session OpenSession(const SessionArguments& arguments, const SceneInput& input) {
    std::vector<NamedSession> sessions = OpenSessions(arguments, input, {});
    if (sessions.size() != 1) throw UsageError(fmt::format("{}: give one engine", arguments.engine));
    return std::move(sessions.front().session);
}

}  // namespace testbed
