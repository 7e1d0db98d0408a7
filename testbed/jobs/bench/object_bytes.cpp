// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of object_bytes.h.

#include "testbed/jobs/bench/object_bytes.h"

#include <fmt/format.h>

#include <cmath>

#include "testbed/engines/engine_run.h"

namespace testbed {
namespace {

constexpr int fewObjects = 4096;
/// Tables grow by a factor, so what they hold for a row depends on how many there are. So many sizes of worlds, from
/// fewObjects to twice as many, tell the mean.
constexpr int sizes = 8;

enum class Content { bodies, fixtures, apart, touching, joints };

scenes::Fixture MakeFixture(Content content) {
    scenes::Fixture fixture;
    fixture.density = 1;
    fixture.shape.radius = 0.5f;
    if (content == Content::fixtures) {
        fixture.shape.type = scenes::ShapeType::box;
        fixture.shape.halfExtents = {0.5f, 0.5f};
    }
    return fixture;
}

/// `count` bodies; circles stand in pairs that touch or do not, and joints couple the bodies of a pair.
scenes::Scene MakeScene(Content content, int count) {
    constexpr float pitch = 4.0f;
    scenes::Scene scene;
    scene.gravity = {};
    const float gap = content == Content::touching ? 0.99f : 2.0f;
    for (int i = 0; i < count; ++i) {
        scenes::Body body;
        body.type = scenes::BodyType::dynamic;
        body.position = {static_cast<float>(i / 2 % 64) * pitch + static_cast<float>(i % 2) * gap,
                         static_cast<float>(i / 128) * pitch};
        if (content == Content::fixtures || content == Content::apart || content == Content::touching) {
            body.firstFixture = i;
            body.fixtureCount = 1;
            scene.fixtures.push_back(MakeFixture(content));
        }
        scene.bodies.push_back(body);
        if (content == Content::joints && i % 2 == 1) {
            scenes::Joint joint;
            joint.bodyA = i - 1;
            joint.bodyB = i;
            joint.localAnchorA = {1, 0};
            joint.localAnchorB = {-1, 0};
            scene.joints.push_back(joint);
        }
    }
    return scene;
}

/// Bytes held after two steps, by which time every array has its size.
double Held(std::string_view engine, Content content, int count) {
    const std::unique_ptr<EngineRun> run = MakeRun(MakeScene(content, count), MakeSpec(engine, likeBox2dPreset));
    run->Step();
    run->Step();
    return static_cast<double>(run->GetPeakBytes());
}

double PerBody(std::string_view engine, Content content) {
    double sum = 0.0;
    for (int i = 0; i < sizes; ++i) {
        const int pairs = static_cast<int>(0.5 * fewObjects * std::exp2(static_cast<double>(i) / sizes));
        const int count = 2 * pairs;
        sum += (Held(engine, content, 2 * count) - Held(engine, content, count)) / count;
    }
    return sum / sizes;
}

}  // namespace

ObjectBytes MeasureObjectBytes(std::string_view engine) {
    ObjectBytes bytes;
    bytes.body = PerBody(engine, Content::bodies);
    bytes.fixture = PerBody(engine, Content::fixtures) - bytes.body;
    // A pair of bodies has one contact or joint.
    bytes.contact = 2 * (PerBody(engine, Content::touching) - PerBody(engine, Content::apart));
    bytes.joint = 2 * (PerBody(engine, Content::joints) - bytes.body);
    return bytes;
}

std::string FormatObjectBytes(std::string_view engine, const ObjectBytes& bytes) {
    return fmt::format("{} takes {:.0f} bytes a body, {:.0f} a fixture, {:.0f} a contact, {:.0f} a joint.\n", engine,
                       bytes.body, bytes.fixture, bytes.contact, bytes.joint);
}

}  // namespace testbed
