// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The list of all laws and the tiling of their scenes.

#include "testbed/jobs/tradeoff/law.h"

#include <algorithm>
#include <cmath>

#include "scenes/build.h"

namespace testbed {

Family FamilyOf(const RunSpec& setting) {
    if (setting.engine == "box2d") return Family::box2d;
    if (setting.engine == "box2d3") return Family::box2d3;
    return IsSequential(setting) ? Family::sequential : Family::soft;
}

std::string NameFamily(Family family) {
    switch (family) {
        case Family::box2d:
            return "Box2D 2.4.1";
        case Family::box2d3:
            return "Box2D 3";
        case Family::sequential:
            return "Scree, sequential impulses";
        case Family::soft:
            break;
    }
    return "Scree, soft step";
}

std::span<const Law> GetLaws() {
    static const std::vector<Law> laws = [] {
        std::vector<Law> all;
        for (auto make : {MakeMotionLaws, MakeJointLaws, MakeFrictionLaws, MakeImpactLaws, MakePileLaws}) {
            for (Law& law : make()) all.push_back(std::move(law));
        }
        return all;
    }();
    return laws;
}

scenes::Scene Tile(const scenes::Scene& scene, int copies, Point pitch) {
    scenes::Scene tiled = scene;
    tiled.bodies.clear();
    tiled.fixtures.clear();
    tiled.joints.clear();
    const int columns = static_cast<int>(std::ceil(std::sqrt(copies)));
    for (int copy = 0; copy < copies; ++copy) {
        const scenes::Vec2 shift = scenes::Point(pitch.x * (copy % columns), pitch.y * (copy / columns));
        const auto move = [shift](scenes::Vec2 p) { return scenes::Vec2{p.x + shift.x, p.y + shift.y}; };
        const int firstBody = static_cast<int>(tiled.bodies.size());
        const int firstFixture = static_cast<int>(tiled.fixtures.size());
        const int firstJoint = static_cast<int>(tiled.joints.size());
        for (scenes::Body body : scene.bodies) {
            body.position = move(body.position);
            body.firstFixture += firstFixture;
            tiled.bodies.push_back(body);
        }
        tiled.fixtures.insert(tiled.fixtures.end(), scene.fixtures.begin(), scene.fixtures.end());
        for (scenes::Joint joint : scene.joints) {
            joint.bodyA += firstBody;
            joint.bodyB += firstBody;
            joint.joint1 += firstJoint;
            joint.joint2 += firstJoint;
            joint.target = move(joint.target);
            joint.groundAnchorA = move(joint.groundAnchorA);
            joint.groundAnchorB = move(joint.groundAnchorB);
            tiled.joints.push_back(joint);
        }
    }
    return tiled;
}

scenes::Scene MakeCostScene(const Law& law, int bodies) {
    const scenes::Scene scene = law.costScene();
    const int moving = std::max(1, scenes::Count(scene).dynamicBodies);
    return Tile(scene, std::max(1, (bodies + moving / 2) / moving), law.pitch);
}

}  // namespace testbed
