// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Solver time per joint and step: 32 copies of each of the scenes that show one type of joint, side by side.

#include "tests/bench/micro.h"

namespace scree::bench {
namespace {

constexpr int copies = 32;
constexpr float pitch = 500.0f;  // far enough apart that copies never meet

void Move(scenes::Vec2& point, float offset) { point.x += offset; }

scenes::Scene Repeat(const scenes::Scene& one) {
    scenes::Scene all = one;
    for (int copy = 1; copy < copies; ++copy) {
        const float offset = pitch * static_cast<float>(copy);
        const auto bodies = copy * static_cast<int>(one.bodies.size());
        const auto fixtures = copy * static_cast<int>(one.fixtures.size());
        const auto joints = copy * static_cast<int>(one.joints.size());
        for (scenes::Body body : one.bodies) {
            Move(body.position, offset);
            body.firstFixture += fixtures;
            all.bodies.push_back(body);
        }
        all.fixtures.insert(all.fixtures.end(), one.fixtures.begin(), one.fixtures.end());
        for (scenes::Joint joint : one.joints) {
            joint.bodyA += bodies;
            joint.bodyB += bodies;
            joint.joint1 += joints;
            joint.joint2 += joints;
            Move(joint.target, offset);
            Move(joint.groundAnchorA, offset);
            Move(joint.groundAnchorB, offset);
            all.joints.push_back(joint);
        }
    }
    return all;
}

void BenchJoint(benchmark::State& state, const std::string& name) {
    const scenes::Scene scene = Repeat(scenes::Build(name));
    std::unique_ptr<testbed::EngineRun> run;
    int left = 0;
    for (auto _ : state) {
        if (left-- == 0) {
            run = RunScene(scene, 5);
            left = 100;  // before anything falls asleep
        }
        run->Step();
        state.SetIterationTime(run->GetTimes().solver * 1e-3);
    }
    SetItems(state, static_cast<double>(scene.joints.size()), "joint");
}

}  // namespace

void RegisterJoints() {
    for (const char* type :
         {"distance", "friction", "gear", "motor", "mouse", "prismatic", "pulley", "revolute", "weld", "wheel"}) {
        benchmark::RegisterBenchmark((std::string("joint/") + type).c_str(), BenchJoint, std::string("joint-") + type)
            ->UseManualTime();
    }
}

}  // namespace scree::bench
