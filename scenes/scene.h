// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene as plain data that any 2D rigid-body engine can load: bodies, fixtures, joints, and the bodies that enter
// later. Nothing here knows an engine. A body's index in Scene::bodies is the key by which engines are compared, so an
// adapter keeps it. SI units, radians, y up, angles counter-clockwise.

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scenes {

struct Vec2 {
    float x = 0.0f, y = 0.0f;

    friend bool operator==(const Vec2&, const Vec2&) = default;
};

enum class BodyType : std::uint8_t { isStatic, kinematic, dynamic };

/// circle: center, radius. box: halfExtents, center, angle (what SetAsBox takes). polygon: vertices. edge: the first
/// two vertices, two-sided.
enum class ShapeType : std::uint8_t { circle, box, polygon, edge };

enum class JointType : std::uint8_t { revolute };

inline constexpr int maxPolygonVertices = 8;

/// A shape in body coordinates, m. Only the fields that its type names are read. The vertices are stored inline so that
/// worlds of a million fixtures cost no heap block each.
struct Shape {
    ShapeType type = ShapeType::circle;
    std::uint8_t vertexCount = 0;                     ///< polygon: 3…8, edge: 2
    float radius = 0.0f;                              ///< circle
    Vec2 center{};                                    ///< circle, box
    Vec2 halfExtents{};                               ///< box
    float angle = 0.0f;                               ///< box: its rotation about `center`, rad
    std::array<Vec2, maxPolygonVertices> vertices{};  ///< polygon: convex, counter-clockwise; edge: both ends

    /// The vertices in use: empty for circles and boxes.
    std::span<const Vec2> Vertices() const { return {vertices.data(), vertexCount}; }

    friend bool operator==(const Shape&, const Shape&) = default;
};

/// A shape with material and filter; it belongs to the body whose range holds its index.
struct Fixture {
    Shape shape{};
    float density = 0.0f;      ///< kg/m²
    float friction = 0.2f;     ///< Coulomb coefficient
    float restitution = 0.0f;  ///< 0 … 1
    bool isSensor = false;
    std::uint16_t categoryBits = 1;
    std::uint16_t maskBits = 0xFFFF;
    std::int16_t groupIndex = 0;

    friend bool operator==(const Fixture&, const Fixture&) = default;
};

/// A body and its fixtures, Scene::fixtures[firstFixture … firstFixture + fixtureCount − 1].
struct Body {
    BodyType type = BodyType::isStatic;
    bool bullet = false;
    bool allowSleep = true;
    bool awake = true;
    bool fixedRotation = false;
    Vec2 position{};               ///< of the body's origin, m
    float angle = 0.0f;            ///< rad
    Vec2 linearVelocity{};         ///< of the centre of mass, m/s
    float angularVelocity = 0.0f;  ///< rad/s
    float linearDamping = 0.0f;    ///< 1/s
    float angularDamping = 0.0f;   ///< 1/s
    float gravityScale = 1.0f;
    int firstFixture = 0;
    int fixtureCount = 0;  ///< 0 is legal: a body that only carries a joint

    friend bool operator==(const Body&, const Body&) = default;
};

/// A joint between two bodies that exist from the start, given by index.
struct Joint {
    JointType type = JointType::revolute;
    bool collideConnected = false;
    bool enableMotor = false;
    bool enableLimit = false;
    int bodyA = 0;
    int bodyB = 0;
    Vec2 localAnchorA{};          ///< in body A's coordinates, m
    Vec2 localAnchorB{};          ///< in body B's coordinates, m
    float referenceAngle = 0.0f;  ///< angle of B minus angle of A that counts as zero, rad
    float motorSpeed = 0.0f;      ///< rad/s
    float maxMotorTorque = 0.0f;  ///< N·m
    float lowerAngle = 0.0f;      ///< rad
    float upperAngle = 0.0f;      ///< rad

    friend bool operator==(const Joint&, const Joint&) = default;
};

/// `body` (an index into Scene::bodies) is created right after step `afterStep` (the first step is 1) has finished.
struct Spawn {
    int afterStep = 1;
    int body = 0;

    friend bool operator==(const Spawn&, const Spawn&) = default;
};

/// A whole world. Create bodies in index order, each with its fixtures in index order, then the joints in index order:
/// that fixes the order of everything an engine derives from it. Spawned bodies are always the last of `bodies`, in the
/// order of `spawns`, so bodies[0 … InitialBodyCount() − 1] exist before the first step.
struct Scene {
    std::string name;
    int size = 0;      ///< the size parameter it was built with
    int steps = 0;     ///< length of a full run
    int showStep = 0;  ///< the step whose picture tells most, 1 … steps
    Vec2 gravity{0.0f, -10.0f};
    float timeStep = 1.0f / 60.0f;
    int velocityIterations = 8;
    int positionIterations = 3;
    std::vector<Body> bodies;
    std::vector<Fixture> fixtures;
    std::vector<Joint> joints;
    std::vector<Spawn> spawns;  ///< sorted by afterStep

    int InitialBodyCount() const { return static_cast<int>(bodies.size() - spawns.size()); }

    /// The fixtures of bodies[body].
    std::span<const Fixture> FixturesOf(int body) const {
        const Body& b = bodies[static_cast<std::size_t>(body)];
        return std::span(fixtures).subspan(static_cast<std::size_t>(b.firstFixture),
                                           static_cast<std::size_t>(b.fixtureCount));
    }

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Totals of a scene, spawned bodies included.
struct SceneCounts {
    int staticBodies = 0;
    int kinematicBodies = 0;
    int dynamicBodies = 0;
    int staticFixtures = 0;  ///< fixtures of static bodies
    int movingFixtures = 0;  ///< fixtures of kinematic and dynamic bodies
    int joints = 0;
    int spawns = 0;

    int Bodies() const { return staticBodies + kinematicBodies + dynamicBodies; }
    int Fixtures() const { return staticFixtures + movingFixtures; }

    friend bool operator==(const SceneCounts&, const SceneCounts&) = default;
};

/// Counts what the scene holds; O(bodies).
[[nodiscard]] SceneCounts Count(const Scene& scene);

}  // namespace scenes
