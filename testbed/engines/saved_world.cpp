// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of saved_world.h. Worlds are described by the headers that programs record with, so that a file from
// here says what a program's own capture would have said.

#include "testbed/engines/saved_world.h"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scree/inspect.h"
#include "scree/recording.h"
#include "scree/snapshot.h"
#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/temporary_folder.h"
#include "testbed/capture/scree_capture.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/scree_step.h"
#include "testbed/input/scene_file.h"

namespace testbed {
namespace {

std::span<const std::byte> AsBytes(std::string_view text) {
    return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

std::string SettingsOf(const scree::World& world, const scree::RecordedStep& step) {
    RunSpec spec = DescribeScreeWorld(world);
    if (step.substeps > 0) spec.solver = SoftStep{step.substeps};
    return PrintSettings(spec);
}

scenes::Scene SceneOf(scree::World& world, const scree::RecordedStep& step, std::string_view source) {
    scree_capture::Options options;
    if (step.velocityIterations > 0) {
        options.velocityIterations = step.velocityIterations;
        options.positionIterations = step.positionIterations;
    }
    scree_capture::detail::JsonWriter text;
    scree_capture::detail::Numbers bodies, joints;
    (void)scree_capture::detail::WriteWorld<scree_capture::own_engine::Api>(text, world, options, bodies, joints);
    scenes::Scene scene = ReadScene(text.GetText(), source);
    if (step.timeStep > 0.0f) scene.timeStep = step.timeStep;
    return scene;
}

/// What a scene leaves out of a world of our engine.
class LossCount {
public:
    explicit LossCount(const scree::World& world) {
        for (const scree::Body* b = world.GetBodyList(); b != nullptr; b = b->GetNext()) Count(*b);
        for (const scree::Joint* j = world.GetJointList(); j != nullptr; j = j->GetNext()) Count(*j);
    }
    [[nodiscard]] std::vector<std::string> Describe() const {
        std::vector<std::string> lines;
        const auto add = [&](int count, const char* what) {
            if (count > 0) lines.push_back(fmt::format("a scene leaves out {}: {}", what, count));
        };
        add(m_disabled, "that bodies are disabled");
        add(m_locked, "locks of motion along x and y");
        add(m_filtered, "categories of filters above the 16th");
        add(m_rolling, "rolling resistance of fixtures");
        add(m_ruled, "mixing rules of fixtures");
        add(m_springs, "springs of hinges and sliders");
        add(m_breaking, "thresholds at which joints report or break");
        return lines;
    }

private:
    void Count(const scree::Body& body) {
        const scree::MotionLocks locks = body.GetMotionLocks();
        m_disabled += !body.IsEnabled();
        m_locked += locks.x || locks.y;
        for (const scree::Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext()) {
            m_filtered += f->GetFilterData().categoryBits > 0xFFFF;
            m_rolling += f->GetRollingResistance() > 0.0f;
            m_ruled +=
                f->GetFrictionRule() != m_plain.frictionRule || f->GetRestitutionRule() != m_plain.restitutionRule;
        }
    }
    void Count(const scree::Joint& joint) {
        if (joint.GetType() == scree::e_revoluteJoint)
            m_springs += static_cast<const scree::RevoluteJoint&>(joint).IsSpringEnabled();
        if (joint.GetType() == scree::e_prismaticJoint)
            m_springs += static_cast<const scree::PrismaticJoint&>(joint).IsSpringEnabled();
        m_breaking += std::isfinite(joint.GetForceThreshold()) || std::isfinite(joint.GetTorqueThreshold());
    }

    scree::FixtureDef m_plain;
    int m_disabled = 0, m_locked = 0, m_filtered = 0, m_rolling = 0, m_ruled = 0, m_springs = 0, m_breaking = 0;
};

SavedWorld Describe(scree::World& world, const scree::RecordedStep& step, std::string_view source) {
    return {std::make_shared<const WorldImage>(scree::SaveWorld(world)), SceneOf(world, step, source),
            SettingsOf(world, step), LossCount(world).Describe()};
}

/// The motion of a replay, as it is recorded.
class Motion {
public:
    Motion(scree::World& world, const TrackContents& contents) : m_track(world, GetPath(), OptionsOf(contents)) {}
    void Step(float timeStep) { m_track.Step(timeStep); }
    [[nodiscard]] std::string Take() {
        m_track.Close();
        if (const std::string error = m_track.GetError(); !error.empty()) throw FileError(error);
        return ReadText(GetPath(), "");
    }

private:
    static scree_capture::Options OptionsOf(const TrackContents& contents) {
        scree_capture::Options options;
        options.contacts = true;
        options.tree = contents.tree;
        options.stages = contents.stages;
        options.memory = std::size_t{1} << 40;  // no step is left out
        return options;
    }
    [[nodiscard]] std::string GetPath() const { return (m_folder.GetPath() / "replay.track").string(); }

    TemporaryFolder m_folder{"scree-replay"};
    scree_capture::own_engine::Track m_track;
};

std::string DescribeEnd(const scree::ReplayReport& report) {
    if (report.firstDifference > 0) {
        return fmt::format(
            "replays differently from step {} on: a listener that is not in the recording, another version, or a fault",
            report.firstDifference);
    }
    if (report.valid) return "";
    return fmt::format("is damaged at byte {}, after call {}: replayed up to step {}", report.position, report.calls,
                       report.steps);
}

}  // namespace

int GetImageVersion() { return static_cast<int>(scree::snapshotVersion); }
int GetRecordingVersion() { return static_cast<int>(scree::recordingVersion); }

SavedWorld ReadWorldImage(std::string_view bytes, std::string_view source) {
    scree::SnapshotError error = scree::SnapshotError::ok;
    const std::unique_ptr<scree::World> world = scree::LoadWorld(AsBytes(bytes), &error);
    if (world == nullptr) {
        throw FileError(
            fmt::format("{}: not an image of a world: {}; give a file that scree::SaveWorld of this version wrote",
                        source, scree::GetName(error)));
    }
    return Describe(*world, {}, source);
}

Replayed ReplayRecording(std::string_view bytes, std::string_view source, const ReplayRequest& request) {
    scree::Player player(AsBytes(bytes));
    if (player.GetWorld() == nullptr) {
        throw FileError(
            fmt::format("{}: not a recording, for the world at its start cannot be read: {}; give a file that "
                        "scree::StartRecording or "
                        "SCREE_RECORD of this version wrote",
                        source, scree::GetName(player.GetReport().image)));
    }
    Replayed replayed;
    replayed.start = SceneOf(*player.GetWorld(), {}, source);
    std::optional<Motion> motion;
    if (request.wantsTrack) motion.emplace(*player.GetWorld(), request.contents);
    const int wanted = request.worldAt.value_or(-1);
    if (wanted == 0) replayed.world = Describe(*player.GetWorld(), {}, source);
    while (player.Step()) {
        const scree::ReplayReport& report = player.GetReport();
        if (motion) motion->Step(report.lastStep.timeStep);
        if (report.steps == wanted) replayed.world = Describe(*player.GetWorld(), report.lastStep, source);
    }
    const scree::ReplayReport& report = player.GetReport();
    if (request.worldAt && !replayed.world) {
        throw UsageError(fmt::format("{} has no step {}: give one from 0 to {}", source, wanted, report.steps));
    }
    replayed.calls = report.calls;
    replayed.steps = report.steps;
    replayed.damage = DescribeEnd(report);
    if (motion) replayed.track = motion->Take();
    return replayed;
}

}  // namespace testbed
