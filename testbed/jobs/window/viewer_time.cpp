// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The viewer in time: steps on and back, what stops it, and what it saves.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"
#include "testbed/base/new_file.h"
#include "testbed/input/body_names.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "testbed/jobs/window/viewer.h"

namespace testbed {

namespace {

/// A name of a file without what file systems and shells read into it.
std::string FileName(std::string name) {
    for (char& c : name) {
        if (c == '/' || c == ' ') c = '-';
    }
    return name;
}

/// What stands at this step stops whoever comes along.
void StopAtMoment(Viewer& viewer) {
    for (const BreakMoment& one : viewer.moments) {
        if (one.moment.step != GetStep(viewer)) continue;
        viewer.isPaused = true;
        viewer.message = DescribeMoment(viewer, one);
        return;
    }
}

/// The pane that knows this step best.
EnginePane& GetExactPane(Viewer& viewer) {
    const auto exact = std::ranges::find_if(viewer.panes, [](const EnginePane& pane) { return pane.run->IsExact(); });
    return exact != viewer.panes.end() ? *exact : viewer.panes.front();
}

}  // namespace

std::string DescribeMoment(const Viewer& viewer, const BreakMoment& one) {
    std::string bodies;
    for (const int body : one.moment.bodies) bodies += (bodies.empty() ? "" : ", ") + NameOfBody(viewer, body);
    return fmt::format("{}: step {}: {}: {}{}{}", viewer.panes[one.pane].name, one.moment.step, one.moment.condition,
                       bodies, bodies.empty() ? "" : ": ", one.moment.what);
}

int FindBody(const Snapshot& snapshot, int index) {
    const auto isThere = [&](const BodyState& body) { return body.index == index; };
    if (index < 0) return -1;
    const auto guess = static_cast<size_t>(index);
    if (guess < snapshot.bodies.size() && isThere(snapshot.bodies[guess])) return index;
    const auto found = std::ranges::find_if(snapshot.bodies, isThere);
    return found == snapshot.bodies.end() ? -1 : static_cast<int>(found - snapshot.bodies.begin());
}

std::string NameOfBody(const Viewer& viewer, int body) {
    const auto index = static_cast<size_t>(body);
    if (body < 0 || index >= viewer.names.size() || viewer.names[index].empty()) return fmt::format("body {}", body);
    return fmt::format("{} ({})", viewer.names[index], body);
}

void PickBody(Viewer& viewer, std::string_view text) {
    int index = -1;
    const auto named = std::ranges::find(viewer.names, text);
    if (!text.empty() && named != viewer.names.end()) {
        index = static_cast<int>(named - viewer.names.begin());
    } else {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
        if (error != std::errc() || end != text.data() + text.size()) index = -1;
    }
    if (FindBody(viewer.panes.front().snapshot, index) < 0) {
        viewer.message = fmt::format("no body is called '{}' or has that number now", text);
    } else {
        viewer.pickedBody = index;
    }
}

int GetStep(const Viewer& viewer) { return viewer.panes.front().run->GetStep(); }
int GetFirstStep(const Viewer& viewer) { return viewer.panes.front().run->GetFirstStep(); }
int GetLastStep(const Viewer& viewer) { return viewer.panes.front().run->GetLastStep(); }

void RenewWatch(Viewer& viewer, size_t index) {
    EnginePane& pane = viewer.panes[index];
    const int step = pane.run->GetStep();
    std::erase_if(viewer.moments, [&](const BreakMoment& one) { return one.pane == index && one.moment.step > step; });
    pane.watch.reset();
    pane.watched = step;
    if (!IsAnyAsked(viewer.conditions)) return;
    const bool isMotion = pane.run->IsMotion();
    const bool hasContacts = !isMotion || viewer.scene.motion->GetInfo().hasContacts;
    AskedConditions asked =
        MakeConditions(viewer.conditions, viewer.session, viewer.scene, {viewer.names, hasContacts, !isMotion});
    pane.watch = std::make_unique<Watch>(pane.run->GetScene(), std::move(asked.conditions));
    // What holds already where somebody begins to look is nothing new, but at the beginning of the session.
    const size_t count = viewer.moments.size();
    const bool mustStop = viewer.mustStop;
    ShowToWatch(viewer, index);
    if (step == pane.run->GetFirstStep()) return;
    viewer.moments.resize(count);
    viewer.mustStop = mustStop;
}

void ShowToWatch(Viewer& viewer, size_t index) {
    EnginePane& pane = viewer.panes[index];
    if (pane.watch == nullptr || pane.run->GetStep() < pane.watched) return;
    pane.watched = pane.run->GetStep();
    Snapshot now = pane.snapshot;
    now.nodes.clear();
    const double timeStep =
        pane.run->IsMotion() ? double{viewer.scene.motion->GetInfo().timeStep} : GetTimeStep(pane.run->GetSpec());
    pane.watch->Show(std::move(now), timeStep);
    for (Moment& moment : pane.watch->TakeNew()) {
        viewer.moments.push_back({index, std::move(moment)});
        viewer.mustStop = true;
    }
}

void StopWhen(Viewer& viewer, const std::string& text) {
    const ConditionArguments before = viewer.conditions;
    viewer.conditions.when.clear();
    if (!text.empty()) viewer.conditions.when.push_back(text);
    try {
        viewer.moments.clear();
        for (size_t i = 0; i < viewer.panes.size(); ++i) RenewWatch(viewer, i);
    } catch (...) {
        viewer.conditions = before;
        for (size_t i = 0; i < viewer.panes.size(); ++i) RenewWatch(viewer, i);
        throw;
    }
    viewer.mustStop = false;
    viewer.message = text.empty() ? "stops at nothing" : "stops when " + text;
}

void GoToStep(Viewer& viewer, int step) {
    viewer.isPaused = true;
    ComeToStep(viewer, step);
}

void ComeToStep(Viewer& viewer, int step) {
    if (viewer.drag) EndDrag(viewer);
    viewer.press.reset();
    step = std::clamp(step, GetFirstStep(viewer), GetLastStep(viewer));
    for (EnginePane& pane : viewer.panes) {
        const int before = pane.run->GetStep();
        pane.run->GoTo(step);
        const auto back = static_cast<size_t>(std::max(0, before - pane.run->GetStep()));
        pane.history.resize(pane.history.size() - std::min(back, pane.history.size()));
        Capture(viewer, pane);
    }
}

void PlayBackward(Viewer& viewer, bool isOn) {
    viewer.playsBackward = isOn;
    viewer.isPaused = !isOn;
}

void Advance(Viewer& viewer) {
    if (viewer.isPaused) return;
    if (viewer.playsBackward) {
        if (GetStep(viewer) > GetFirstStep(viewer)) ComeToStep(viewer, GetStep(viewer) - 1);
        if (GetStep(viewer) == GetFirstStep(viewer)) viewer.isPaused = true;
        return StopAtMoment(viewer);
    }
    const bool isPast = GetStep(viewer) < GetLastStep(viewer);
    StepAll(viewer);
    if (viewer.panes.front().run->IsMotion() && GetStep(viewer) == GetLastStep(viewer)) viewer.isPaused = true;
    if (isPast) StopAtMoment(viewer);
}

void StopIfFound(Viewer& viewer) {
    if (!std::exchange(viewer.mustStop, false)) return;
    viewer.isPaused = true;
    const int step = viewer.moments.back().moment.step;
    const BreakMoment found =
        *std::ranges::find_if(viewer.moments, [&](const BreakMoment& one) { return one.moment.step == step; });
    // Some are certain only later.
    if (found.moment.step < GetStep(viewer)) ComeToStep(viewer, found.moment.step);
    viewer.message = DescribeMoment(viewer, found);
}

void EditBody(Viewer& viewer, const BodyEdit& edit) {
    std::string refusal;
    bool isDone = false;
    for (size_t i = 0; i < viewer.panes.size(); ++i) {
        try {
            DoInPane(viewer, i, false, [&](RunHistory& run) { run.Edit(viewer.pickedBody, edit); });
            isDone = true;
        } catch (const std::invalid_argument& error) {
            refusal = error.what();
        }
        Capture(viewer, viewer.panes[i]);
    }
    if (!isDone) throw std::invalid_argument(refusal);
    viewer.message =
        fmt::format("{} changed{}{}", NameOfBody(viewer, viewer.pickedBody), refusal.empty() ? "" : "; ", refusal);
}

void SaveScene(Viewer& viewer) {
    EnginePane& pane = GetExactPane(viewer);
    scenes::Scene scene = pane.run->MakeScene();
    scene.name = FileName(viewer.scene.name);
    if (scene.user.empty()) {
        nlohmann::json user;
        for (size_t i = 0; i < std::min(viewer.names.size(), scene.bodies.size()); ++i) {
            if (!viewer.names[i].empty()) user["bodies"][std::to_string(i)]["name"] = viewer.names[i];
        }
        if (!user.empty()) scene.user = PrintJson(user);
    }
    const std::string name = fmt::format("{}-{:04}.scene.json", FileName(viewer.scene.name), pane.run->GetStep());
    WriteTextFile(name, WriteScene(WithWriter(std::move(scene))));
    viewer.message = fmt::format("wrote {} of {}", name, pane.name);
}

void SaveTracks(Viewer& viewer) {
    if (viewer.drag) EndDrag(viewer);
    std::string names;
    for (const EnginePane& pane : viewer.panes) {
        const std::string name = fmt::format("{}-{}.track", FileName(viewer.scene.name), FileName(pane.name));
        pane.run->WriteTrack(name);
        names += (names.empty() ? "" : ", ") + name;
    }
    viewer.message = "wrote " + names;
}

}  // namespace testbed
