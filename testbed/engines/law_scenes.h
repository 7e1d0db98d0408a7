// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the scenes of the laws are built with: grounds, boxes and disks of a material, hinges, and readings over a run.

#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "scenes/build.h"
#include "scenes/build_joints.h"
#include "testbed/engines/lab.h"
#include "testbed/engines/measure.h"

namespace testbed {

// Sequential impulses wrap polygons and edges in a skin of 1 cm and let surfaces overlap by half a centimetre at rest.
inline constexpr double skin = 0.01;                 ///< m
inline constexpr double slop = 0.005;                ///< m
inline constexpr double boxGap = 2.0 * skin - slop;  ///< between two polygons at rest, m
inline constexpr double diskGap = skin - slop;       ///< between a disk and a polygon at rest, m

/// The gap of two polygons at rest under a setting: sequential impulses keep skins apart, soft steps outlines.
[[nodiscard]] inline double BoxGapAtRest(const RunSpec& setting) { return IsSequential(setting) ? boxGap : 0.0; }
/// The same of a disk and a polygon.
[[nodiscard]] inline double DiskGapAtRest(const RunSpec& setting) { return IsSequential(setting) ? diskGap : 0.0; }

struct Material {
    double density = 1.0, friction = 0.2, restitution = 0.0;
};

inline scenes::Scene MakeEmptyScene(double g = gravity) {
    scenes::Scene scene;
    scene.gravity = scenes::Point(0.0, -g);
    return scene;
}

inline void AddPart(scenes::Scene& scene, const scenes::Shape& shape, const Material& material) {
    scenes::Fixture& fixture = scenes::AddFixture(scene, shape, material.density);
    fixture.friction = static_cast<float>(material.friction);
    fixture.restitution = static_cast<float>(material.restitution);
}

/// A body with one fixture; its index.
inline int AddOne(scenes::Scene& scene, scenes::BodyType type, Point at, const scenes::Shape& shape,
                  const Material& material = {}, double angle = 0.0) {
    scenes::AddBody(scene, type, scenes::Point(at.x, at.y)).angle = static_cast<float>(angle);
    AddPart(scene, shape, material);
    return scenes::LastBody(scene);
}
inline int AddDynamic(scenes::Scene& scene, Point at, const scenes::Shape& shape, const Material& material = {},
                      double angle = 0.0) {
    return AddOne(scene, scenes::BodyType::dynamic, at, shape, material, angle);
}
inline int AddStatic(scenes::Scene& scene, Point at, const scenes::Shape& shape, const Material& material = {},
                     double angle = 0.0) {
    return AddOne(scene, scenes::BodyType::isStatic, at, shape, material, angle);
}
/// A static body without fixtures, for joints.
inline int AddAnchor(scenes::Scene& scene, Point at) {
    scenes::AddBody(scene, scenes::BodyType::isStatic, scenes::Point(at.x, at.y));
    return scenes::LastBody(scene);
}
/// A two-sided edge along y = 0.
inline int AddFloor(scenes::Scene& scene, double halfWidth, const Material& material = {}) {
    return AddStatic(scene, {}, scenes::Edge(scenes::Point(-halfWidth, 0.0), scenes::Point(halfWidth, 0.0)), material);
}
inline void Hinge(scenes::Scene& scene, int bodyA, int bodyB, Point at) {
    scenes::AddJoint(scene, scenes::JointType::revolute, bodyA, bodyB, scenes::Point(at.x, at.y));
}
inline void Throw(scenes::Scene& scene, int body, Point velocity, double spin = 0.0) {
    scenes::Body& b = scene.bodies[static_cast<size_t>(body)];
    b.linearVelocity = scenes::Point(velocity.x, velocity.y);
    b.angularVelocity = static_cast<float>(spin);
}

/// Steps for about `seconds`: a whole number of them.
inline void Run(LabWorld& lab, const RunSpec& spec, double seconds) {
    const int steps = static_cast<int>(std::lround(seconds * GetRate(spec)));
    for (int i = 0; i < steps; ++i) lab.Step();
}

/// All bodies, static ones too.
inline std::vector<BodyReading> ReadAll(const LabWorld& lab) {
    std::vector<BodyReading> bodies;
    for (int i = 0; i < lab.GetBodyCount(); ++i) bodies.push_back(lab.Read(i));
    return bodies;
}
/// The dynamic ones.
inline std::vector<BodyReading> ReadMoving(const LabWorld& lab) {
    std::vector<BodyReading> bodies;
    for (int i = 0; i < lab.GetBodyCount(); ++i) {
        if (lab.GetScene().bodies[static_cast<size_t>(i)].type == scenes::BodyType::dynamic) {
            bodies.push_back(lab.Read(i));
        }
    }
    return bodies;
}

/// Distance between the two anchors of a joint, turned in double.
inline double JointGap(const LabWorld& lab, int joint) {
    const scenes::Joint& j = lab.GetScene().joints[static_cast<size_t>(joint)];
    const auto at = [&lab](int body, scenes::Vec2 local) {
        return lab.Read(body).ToWorld({double{local.x}, double{local.y}});
    };
    return Length(at(j.bodyA, j.localAnchorA) - at(j.bodyB, j.localAnchorB));
}

/// The largest gap of all joints.
inline double WorstJointGap(const LabWorld& lab) {
    double worst = 0.0;
    for (size_t i = 0; i < lab.GetScene().joints.size(); ++i) {
        worst = std::max(worst, JointGap(lab, static_cast<int>(i)));
    }
    return worst;
}

}  // namespace testbed
