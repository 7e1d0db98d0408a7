// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene as plain data that any 2D rigid-body engine can load: bodies, fixtures, joints, and the bodies that enter
// later. Nothing here knows an engine. A body's index in Scene::bodies is the key by which engines are compared, so an
// adapter keeps it. SI units, radians, y up, angles counter-clockwise.

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace scenes {

struct Vec2 {
    float x = 0.0f, y = 0.0f;

    friend bool operator==(const Vec2&, const Vec2&) = default;
};

enum class BodyType : std::uint8_t { isStatic, kinematic, dynamic };

/// The kind of a shape, and the fields of Shape that it reads. From capsule on they are the further convex shapes,
/// which our engine has and Box2D gets as polygons of 8 vertices (outline.h).
enum class ShapeType : std::uint8_t {
    circle,          ///< center, radius
    box,             ///< halfExtents, center, angle: what SetAsBox takes
    polygon,         ///< vertices
    edge,            ///< vertices
    chain,           ///< a range of Scene::chainVertices, and vertices as its ghosts
    capsule,         ///< the ends as vertices, radius
    roundedPolygon,  ///< vertices, radius
    largePolygon,    ///< a range of Scene::chainVertices
    ellipse,         ///< halfExtents as semi-axes, center, angle
    sector,          ///< of a disk: center as its tip, radius, opening, angle of its middle
    supported        ///< support, radius around the body's origin
};

/// The point of a convex shape that is farthest along a direction of length 1, both in body coordinates.
using SupportFunction = Vec2 (*)(Vec2 direction);

/// What a joint keeps, and the fields of Joint that it reads beside type, bodies and collideConnected; "anchors" are
/// localAnchorA and localAnchorB.
enum class JointType : std::uint8_t {
    revolute,   ///< a hinge: anchors, referenceAngle; limit: lowerAngle, upperAngle; motor: motorSpeed, maxMotorTorque
    distance,   ///< rod, rope or spring: anchors, length, minLength, maxLength, stiffness, damping
    friction,   ///< resists any relative motion: anchors, maxForce, maxTorque
    gear,       ///< couples two joints: joint1, joint2, ratio; bodyA and bodyB are those joints' bodyB
    motor,      ///< drives B to a pose in A: linearOffset, angularOffset, maxForce, maxTorque, correctionFactor
    mouse,      ///< pulls a point of B to a world point: localAnchorB, target, maxForce, stiffness, damping
    prismatic,  ///< a slider: anchors, localAxisA, referenceAngle; limit: translations; motor: speed, maxMotorForce
    pulley,     ///< a rope over two points: groundAnchorA/B, anchors, lengthA, lengthB, ratio
    weld,       ///< glue: anchors, referenceAngle; stiffness and damping of the angle
    wheel,      ///< turns and travels: anchors, localAxisA, stiffness, damping; limit: translations; motor: as revolute
};

inline constexpr int jointTypeCount = 10;

inline constexpr int maxPolygonVertices = 8;

/// A shape in body coordinates, m. Only the fields that its type names are read. The vertices are stored inline so that
/// worlds of a million fixtures cost no heap block each.
struct Shape {
    ShapeType type = ShapeType::circle;
    std::uint8_t vertexCount = 0;  ///< polygons: 3…8; edge: 2, one-sided: 4; chain: 2, a loop: 0; capsule: 2
    float radius = 0.0f;           ///< circle, sector; capsule, roundedPolygon: of the rounding; supported: bound
    Vec2 center{};                 ///< circle, box, ellipse, sector
    Vec2 halfExtents{};            ///< box, ellipse
    float angle = 0.0f;            ///< box, ellipse: its rotation about `center`, rad; sector: of its middle
    float opening = 0.0f;          ///< sector: rad, 0.01…π
    SupportFunction support = nullptr;
    int firstChainVertex = 0;  ///< chain, largePolygon: the range in Scene::chainVertices; a loop joins its ends
    int chainVertexCount = 0;  ///< chain: ≥ 2, a loop: ≥ 3; largePolygon: 3…64
    /// polygon: convex, counter-clockwise. edge: both ends v1, v2; if one-sided also the ghosts before v1 and after v2.
    /// chain that is no loop: the ghosts before and after it. One-sided edges and chains collide on the right of their
    /// direction only.
    std::array<Vec2, maxPolygonVertices> vertices{};

    /// The vertices in use: empty for circles, boxes and loops.
    std::span<const Vec2> Vertices() const { return {vertices.data(), vertexCount}; }
    bool IsOneSidedEdge() const { return type == ShapeType::edge && vertexCount == 4; }
    bool IsLoop() const { return type == ShapeType::chain && vertexCount == 0; }

    /// Proxies in the broad phase: the segments of a chain, else 1.
    int ChildCount() const {
        if (type != ShapeType::chain) return 1;
        return IsLoop() ? chainVertexCount : chainVertexCount - 1;
    }

    friend bool operator==(const Shape&, const Shape&) = default;
};

/// A shape with material and filter; it belongs to the body whose range holds its index.
struct Fixture {
    Shape shape{};
    float density = 0.0f;      ///< kg/m²
    float friction = 0.2f;     ///< Coulomb coefficient
    float restitution = 0.0f;  ///< 0 … 1
    /// Conveyor: the speed at which the surface carries what touches it, clockwise around the shape (+x on top), m/s.
    float tangentSpeed = 0.0f;
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

/// A joint between two bodies that exist from the start, given by index: one struct for all types, each reads what
/// JointType lists. A stiffness of 0 means no spring (distance, wheel) or a rigid angle (weld).
struct Joint {
    JointType type = JointType::revolute;
    bool collideConnected = false;
    bool enableMotor = false;
    bool enableLimit = false;
    int bodyA = 0;
    int bodyB = 0;
    Vec2 localAnchorA{};                                  ///< in body A's coordinates, m
    Vec2 localAnchorB{};                                  ///< in body B's coordinates, m
    Vec2 localAxisA{1.0f, 0.0f};                          ///< direction of travel in body A, of length 1
    float referenceAngle = 0.0f;                          ///< angle of B minus angle of A that counts as zero, rad
    float lowerAngle = 0.0f;                              ///< rad
    float upperAngle = 0.0f;                              ///< rad
    float lowerTranslation = 0.0f;                        ///< m
    float upperTranslation = 0.0f;                        ///< m
    float motorSpeed = 0.0f;                              ///< rad/s; prismatic: m/s
    float maxMotorTorque = 0.0f;                          ///< N·m
    float maxMotorForce = 0.0f;                           ///< N
    float maxForce = 0.0f;                                ///< N
    float maxTorque = 0.0f;                               ///< N·m
    float stiffness = 0.0f;                               ///< N/m; weld: N·m/rad
    float damping = 0.0f;                                 ///< N·s/m; weld: N·m·s/rad
    float length = 1.0f;                                  ///< rest length, m
    float minLength = 0.0f;                               ///< m
    float maxLength = std::numeric_limits<float>::max();  ///< m; equal to minLength: a rod
    Vec2 linearOffset{};                                  ///< B's origin in body A's coordinates, m
    float angularOffset = 0.0f;                           ///< angle of B minus angle of A, rad
    float correctionFactor = 0.3f;                        ///< share of the error removed in a step, 0 … 1
    Vec2 target{};                                        ///< world, m
    Vec2 groundAnchorA{};                                 ///< world, m
    Vec2 groundAnchorB{};                                 ///< world, m
    float lengthA = 0.0f;                                 ///< lengthA + ratio · lengthB stays constant, m
    float lengthB = 0.0f;                                 ///< m
    float ratio = 1.0f;                                   ///< gear: coordinate1 + ratio · coordinate2 stays constant
    int joint1 = 0;                                       ///< an earlier revolute or prismatic one in Scene::joints
    int joint2 = 0;                                       ///< another such

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
    std::vector<Spawn> spawns;        ///< sorted by afterStep
    std::vector<Vec2> chainVertices;  ///< of all chains and large polygons, in body coordinates, m
    /// What whoever made the scene wants kept beside it, a JSON object as text, or nothing; no engine reads it.
    std::string user{};

    int InitialBodyCount() const { return static_cast<int>(bodies.size() - spawns.size()); }

    /// The fixtures of bodies[body].
    std::span<const Fixture> FixturesOf(int body) const {
        const Body& b = bodies[static_cast<std::size_t>(body)];
        return std::span(fixtures).subspan(static_cast<std::size_t>(b.firstFixture),
                                           static_cast<std::size_t>(b.fixtureCount));
    }

    /// The vertices of a chain or a large polygon of this scene.
    std::span<const Vec2> ChainVerticesOf(const Shape& chain) const {
        return std::span(chainVertices)
            .subspan(static_cast<std::size_t>(chain.firstChainVertex),
                     static_cast<std::size_t>(chain.chainVertexCount));
    }

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// What proxy `child` (0 … ChildCount() − 1) of a shape is: segment `child` of a chain as a one-sided edge with its
/// neighbours as ghosts, else the shape itself.
[[nodiscard]] Shape ChildOf(const Scene& scene, const Shape& shape, int child);

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
