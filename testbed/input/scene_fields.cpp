// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which keys belong to which type of shape and joint.

#include "testbed/input/scene_fields.h"

#include <initializer_list>
#include <vector>

namespace testbed {

namespace {

using Keys = std::vector<std::string_view>;

Keys operator+(Keys a, const Keys& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

}  // namespace

std::span<const std::string_view> KeysOf(scenes::ShapeType type) {
    static const std::array<Keys, shapeTypeNames.size()> keys{
        Keys{"radius", "center"},                      // circle
        Keys{"halfExtents", "center", "angle"},        // box
        Keys{"vertices"},                              // polygon
        Keys{"vertices"},                              // edge
        Keys{"vertices", "chainVertices"},             // chain
        Keys{"vertices", "radius"},                    // capsule
        Keys{"vertices", "radius"},                    // roundedPolygon
        Keys{"chainVertices"},                         // largePolygon
        Keys{"halfExtents", "center", "angle"},        // ellipse
        Keys{"radius", "center", "opening", "angle"},  // sector
        Keys{"support", "radius"},                     // supported
    };
    return keys[static_cast<std::size_t>(type)];
}

std::span<const std::string_view> KeysOf(scenes::JointType type) {
    static const Keys bodies{"bodyA", "bodyB", "collideConnected"};
    static const Keys anchors = bodies + Keys{"localAnchorA", "localAnchorB"};
    static const Keys motor{"enableMotor", "motorSpeed", "maxMotorTorque"};
    static const Keys spring{"stiffness", "damping"};
    static const Keys travel{"localAxisA", "enableLimit", "lowerTranslation", "upperTranslation"};
    static const std::array<Keys, jointTypeNames.size()> keys{
        anchors + Keys{"referenceAngle", "enableLimit", "lowerAngle", "upperAngle"} + motor,          // revolute
        anchors + spring + Keys{"length", "minLength", "maxLength"},                                  // distance
        anchors + Keys{"maxForce", "maxTorque"},                                                      // friction
        bodies + Keys{"joint1", "joint2", "ratio"},                                                   // gear
        bodies + Keys{"linearOffset", "angularOffset", "maxForce", "maxTorque", "correctionFactor"},  // motor
        bodies + Keys{"localAnchorB", "target", "maxForce"} + spring,                                 // mouse
        anchors + travel + Keys{"referenceAngle", "enableMotor", "motorSpeed", "maxMotorForce"},      // prismatic
        anchors + Keys{"groundAnchorA", "groundAnchorB", "lengthA", "lengthB", "ratio"},              // pulley
        anchors + spring + Keys{"referenceAngle"},                                                    // weld
        anchors + travel + spring + motor,                                                            // wheel
    };
    return keys[static_cast<std::size_t>(type)];
}

}  // namespace testbed
