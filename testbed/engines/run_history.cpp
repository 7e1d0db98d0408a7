// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of run_history.h.

#include "testbed/engines/run_history.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "testbed/engines/record_track.h"
#include "testbed/engines/track_run.h"
#include "testbed/input/track_file.h"

namespace testbed {

namespace {

constexpr int imageSpacing = 4;  // steps that going back makes again cost less than an image of each

/// Roughly what a frame takes.
std::size_t BytesOf(const Snapshot& s) {
    std::size_t bytes = sizeof s + s.bodies.size() * sizeof(BodyState) + s.fixtures.size() * sizeof(FixtureState) +
                        s.contacts.size() * sizeof(ContactState) + s.joints.size() * sizeof(JointState);
    for (const FixtureState& fixture : s.fixtures) bytes += fixture.outline.size() * sizeof(Vec2);
    return bytes;
}

}  // namespace

RunHistory::RunHistory(Make make, std::size_t limit)
    : m_make(std::move(make)), m_run(m_make()), m_images(limit, imageSpacing), m_frames(limit, 1) {
    m_step = m_firstStep = m_lastStep = m_run->GetStep();
    KeepImage();
    if (m_goesBack) return;
    Snapshot first;
    Capture(first, {.nodes = false, .pairs = false});
}

RunHistory::RunHistory(std::shared_ptr<TrackFile> motion, int from)
    : m_motion(std::move(motion)), m_played(MakeTrackRun(m_motion, from)), m_images(0, 1), m_frames(0, 1) {
    m_motionSpec = Resolve(RunSpec{}, m_motion->GetParts());
    m_step = m_firstStep = from;
    m_lastStep = m_motion->GetLastStep();
}

void RunHistory::KeepImage() {
    if (!m_images.Wants(m_step)) return;
    std::shared_ptr<const RunImage> image = m_run->Save();
    m_goesBack = image != nullptr;
    if (!m_goesBack) return;
    const std::size_t bytes = image->GetBytes();
    m_images.Keep(m_step, std::move(image), bytes);
}

bool RunHistory::IsExact() const { return m_goesBack || IsMotion() || IsAtEnd(); }

bool RunHistory::Step() {
    if (IsMotion()) {
        if (m_step >= m_lastStep) return false;
        m_played->Step();
        m_step = m_played->GetStep();
        return true;
    }
    if (!m_goesBack && !IsAtEnd()) {
        ++m_step;
        return true;
    }
    ApplyDue();
    m_run->Step();
    ++m_step;
    m_lastStep = std::max(m_lastStep, m_step);
    if (m_goesBack) KeepImage();
    return true;
}

void RunHistory::ApplyDue() {
    for (; m_applied < m_actions.size() && m_actions[m_applied].afterStep <= m_step; ++m_applied) {
        Perform(*m_run, m_actions[m_applied]);
    }
}

void RunHistory::GoTo(int step) {
    step = std::clamp(step, m_firstStep, m_lastStep);
    if (IsMotion()) {
        const std::vector<int>& steps = m_motion->GetSteps();
        const auto after = std::upper_bound(steps.begin(), steps.end(), step);
        step = after == steps.begin() ? m_firstStep : std::max(m_firstStep, *std::prev(after));
        m_played = MakeTrackRun(m_motion, step);
        m_step = step;
        return;
    }
    if (!m_goesBack) {
        m_step = step;
        return;
    }
    if (step == m_step) return;
    const auto [at, image] = m_images.Find(step);
    if (step < m_step || at > m_step) {
        m_run->Restore(**image);
        m_step = at;
        // An image is of the moment after its step, before what was done there.
        m_applied = static_cast<std::size_t>(std::ranges::lower_bound(m_actions, at, {}, &RunAction::afterStep) -
                                             m_actions.begin());
    }
    while (m_step < step) (void)Step();
    if (IsAtEnd()) ApplyDue();
}

void RunHistory::Capture(Snapshot& snapshot, const CaptureParts& parts) {
    if (IsMotion()) return m_played->Capture(snapshot, parts);
    if (!IsExact()) {
        snapshot = *m_frames.Find(m_step).second;
        return;
    }
    m_run->Capture(snapshot, parts);
    if (m_goesBack || !m_frames.Wants(m_step)) return;
    Snapshot kept = snapshot;
    kept.nodes = {};
    const std::size_t bytes = BytesOf(kept);
    m_frames.Keep(m_step, std::move(kept), bytes);
}

StepTimes RunHistory::GetTimes() const {
    if (IsMotion()) return m_played->GetTimes();
    return IsExact() ? m_run->GetTimes() : m_frames.Find(m_step).second->times;
}

const RunSpec& RunHistory::GetSpec() const { return IsMotion() ? m_motionSpec : m_run->GetSpec(); }

const scenes::Scene& RunHistory::GetScene() const { return IsMotion() ? m_motion->GetParts() : m_run->GetScene(); }

std::unique_ptr<InteractiveRun> RunHistory::Remake(int step) const {
    std::unique_ptr<InteractiveRun> run = m_make();
    Play(*run, step);
    return run;
}

void RunHistory::Play(InteractiveRun& run, int step) const {
    std::size_t next = 0;
    while (run.GetStep() < step) {
        for (; next < m_actions.size() && m_actions[next].afterStep <= run.GetStep(); ++next) {
            Perform(run, m_actions[next]);
        }
        run.Step();
    }
}

void RunHistory::Branch() {
    if (IsAtEnd() && m_applied == m_actions.size()) return;
    if (!m_goesBack) {
        m_run = Remake(m_step);
        m_applied = static_cast<std::size_t>(std::ranges::lower_bound(m_actions, m_step, {}, &RunAction::afterStep) -
                                             m_actions.begin());
        m_frames.CutAfter(m_step);
    } else {
        m_images.CutAfter(m_step);
    }
    m_actions.resize(m_applied);
    m_lastStep = m_step;
    // Nobody holds the body any more that was dragged here.
    const auto drag = std::find_if(m_actions.rbegin(), m_actions.rend(), [](const RunAction& action) {
        return action.kind == RunAction::Kind::beginDrag || action.kind == RunAction::Kind::endDrag;
    });
    if (drag != m_actions.rend() && drag->kind == RunAction::Kind::beginDrag) EndDrag();
}

void RunHistory::Perform(InteractiveRun& run, const RunAction& action) const {
    switch (action.kind) {
        case RunAction::Kind::apply:
            return run.Apply(*action.spec);
        case RunAction::Kind::beginDrag:
            return run.BeginDrag(action.body, action.point);
        case RunAction::Kind::moveDrag:
            return run.MoveDrag(action.point);
        case RunAction::Kind::endDrag:
            return run.EndDrag();
        case RunAction::Kind::bullet:
            run.ShootBullet(action.point, action.velocity);
            return;
        case RunAction::Kind::edit:
            return run.Edit(action.body, action.edit);
    }
}

void RunHistory::Do(RunAction action) {
    if (IsMotion()) {
        throw std::invalid_argument("a recorded motion cannot be changed; --from K runs engines from its step K");
    }
    Branch();
    Perform(*m_run, action);
    action.afterStep = m_step;
    m_actions.push_back(std::move(action));
    m_applied = m_actions.size();
}

void RunHistory::Apply(const RunSpec& spec) {
    if (IsMotion()) return;
    Do({.kind = RunAction::Kind::apply, .spec = std::make_shared<const RunSpec>(spec)});
}
void RunHistory::BeginDrag(int body, Vec2 localPoint) {
    Do({.kind = RunAction::Kind::beginDrag, .body = body, .point = localPoint});
}
void RunHistory::MoveDrag(Vec2 target) { Do({.kind = RunAction::Kind::moveDrag, .point = target}); }
void RunHistory::EndDrag() { Do({.kind = RunAction::Kind::endDrag}); }
void RunHistory::ShootBullet(Vec2 position, Vec2 velocity) {
    Do({.kind = RunAction::Kind::bullet, .point = position, .velocity = velocity});
}
void RunHistory::Edit(int body, const BodyEdit& edit) {
    Do({.kind = RunAction::Kind::edit, .body = body, .edit = edit});
}

RunValues RunHistory::ValuesOfBody(int body) const {
    return m_run == nullptr || !IsExact() ? RunValues{} : m_run->ValuesOfBody(body);
}
RunValues RunHistory::ValuesOfFixture(int fixture) const {
    return m_run == nullptr || !IsExact() ? RunValues{} : m_run->ValuesOfFixture(fixture);
}
RunValues RunHistory::ValuesOfJoint(int joint) const {
    return m_run == nullptr || !IsExact() ? RunValues{} : m_run->ValuesOfJoint(joint);
}

scenes::Scene RunHistory::MakeScene() {
    if (IsMotion()) return m_motion->SceneAt(m_step);
    return IsExact() ? m_run->MakeScene() : Remake(m_step)->MakeScene();
}

void RunHistory::WriteTrack(const std::string& path) const {
    if (IsMotion()) throw std::invalid_argument("this is a recorded motion already");
    const std::unique_ptr<InteractiveRun> run = m_make();
    RecordTrack(path, {}, *run, [&] { Play(*run, m_lastStep); });
}

}  // namespace testbed
