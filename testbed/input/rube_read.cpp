// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of rube_file.h: values first, then bodies and their mass, then joints, whose springs need the masses.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"
#include "testbed/base/nearest.h"
#include "testbed/base/text.h"
#include "testbed/input/area.h"
#include "testbed/input/convex_vertices.h"
#include "testbed/input/json_tree.h"
#include "testbed/input/rube_file.h"
#include "testbed/input/rube_values.h"
#include "testbed/input/scene_file.h"

namespace testbed {

namespace {

using Kind = JsonNode::Kind;
using Place = JsonPlace;
using scenes::JointType;
using scenes::ShapeType;
using scenes::Vec2;

constexpr double fullTurn = 6.283185307179586;
/// Editors compute masses in floats too, in another order.
constexpr double massTolerance = 1e-3;
/// Of a convex shape, and of the points around which its hull may be.
constexpr std::size_t mostLargeVertices = 64, mostVertices = 1000;
/// Kinds of notices with a line of their own.
constexpr std::size_t mostNotices = 40;

/// Mass properties as joints and velocities need them.
struct Mass {
    double mass = 0.0, inertia = 0.0;  ///< inertia about the body's origin
    double x = 0.0, y = 0.0;           ///< centre, in body coordinates
};

class RubeReader {
public:
    explicit RubeReader(std::string_view source) : m_values(source), m_source(source) {}

    RubeWorld Read(const JsonNode& root) {
        const Place top{};
        m_values.Expect(root, top, Kind::object);
        ReadWorld(root, top);
        m_values.List(root, top, "body", [&](const JsonNode& node, const Place& at) { ReadBody(node, at); });
        ReadJoints(root, top);
        const std::size_t images = root.Find("image") == nullptr ? 0 : root.Find("image")->items.size();
        if (images > 0) Notice(fmt::format("images are left out, {} of them", images), Place{&top, "image"});
        if (!m_names.empty()) m_scene.user = PrintJson(m_names);
        if (const std::string fault = DescribeFault(m_scene); !fault.empty()) {
            throw FileError(fmt::format("{}: {}", m_source, ToRubePlace(fault)));
        }
        RubeWorld world{std::move(m_scene), {}};
        for (const Noticed& one : m_notices) {
            world.notices.push_back(one.count == 1
                                        ? fmt::format("{}: {}", one.place, one.what)
                                        : fmt::format("{} and {} more: {}", one.place, one.count - 1, one.what));
        }
        return world;
    }

private:
    struct Noticed {
        std::string what, place;
        int count = 1;
    };

    void Notice(const std::string& what, const Place& place) {
        const auto found = std::ranges::find(m_notices, what, &Noticed::what);
        if (found != m_notices.end()) {
            ++found->count;
        } else {
            m_notices.push_back({what, place.Describe()});
        }
    }

    /// Tells of custom properties, and of keys that the format does not have.
    template <std::size_t Count>
    void CheckKeys(const JsonNode& node, const Place& place, const std::array<std::string_view, Count>& known) {
        for (const std::string& key : node.keys) {
            if (key == "customProperties") {
                Notice("custom properties are left out", place);
            } else if (key != "path" && key != "name" && std::ranges::find(known, key) == known.end()) {
                const bool isNamed = m_notices.size() < mostNotices;
                Notice(isNamed ? fmt::format("'{}' is not a key of the format and is left out", key.substr(0, 60))
                               : "has keys that the format has not, which are left out",
                       place);
            }
        }
    }

    void KeepName(const char* list, std::size_t index, const JsonNode& node, const Place& place) {
        const std::string name = m_values.Text(node, place, "name");
        if (!name.empty()) m_names[list][std::to_string(index)]["name"] = name;
    }

    void ReadWorld(const JsonNode& root, const Place& top) {
        static constexpr std::array<std::string_view, 18> keys{"gravity",
                                                               "allowSleep",
                                                               "autoClearForces",
                                                               "positionIterations",
                                                               "stepsPerSecond",
                                                               "velocityIterations",
                                                               "continuousPhysics",
                                                               "warmStarting",
                                                               "subStepping",
                                                               "body",
                                                               "joint",
                                                               "image",
                                                               "collisionbitplanes",
                                                               "hasDestructionListener",
                                                               "hasContactFilter",
                                                               "hasContactListener",
                                                               "sampler",
                                                               "object"};
        if (root.Find("body") == nullptr && root.Find("gravity") == nullptr) {
            m_values.Fail(top, "not a world of R.U.B.E.: it has to hold \"gravity\" and \"body\"");
        }
        CheckKeys(root, top, keys);
        m_scene.name = NameOfScene(m_source);
        m_scene.size = 1;
        m_scene.steps = m_scene.showStep = 600;
        m_scene.gravity = m_values.Vector(root, top, "gravity");
        m_scene.velocityIterations = m_values.Whole(root, top, "velocityIterations", 0, 1000, 8);
        m_scene.positionIterations = m_values.Whole(root, top, "positionIterations", 0, 1000, 3);
        const float rate = m_values.Number(root, top, "stepsPerSecond", 60.0f);
        if (!(rate >= 0.1f && rate <= 1e6f)) m_values.Fail(Place{&top, "stepsPerSecond"}, "give 0.1 to 1e6");
        m_scene.timeStep = 1.0f / rate;
        m_mayAllSleep = m_values.Flag(root, top, "allowSleep");
        for (const auto& [key, usual, cure] : {std::tuple{"warmStarting", true, "--set warmStarting=off"},
                                               std::tuple{"continuousPhysics", true, "--set continuous=off"},
                                               std::tuple{"subStepping", false, "no engine here does that"}}) {
            if (m_values.Flag(root, top, key, usual) == usual) continue;
            Notice(fmt::format("belongs to a run and not to a scene: {}", cure), Place{&top, key});
        }
    }

    // Bodies.
    void ReadBody(const JsonNode& node, const Place& place) {
        static constexpr std::array<std::string_view, 18> keys{
            "type",           "position",      "angle",      "linearVelocity",  "angularVelocity", "linearDamping",
            "angularDamping", "gravityScale",  "allowSleep", "awake",           "fixedRotation",   "bullet",
            "active",         "massData-mass", "massData-I", "massData-center", "fixture",         "id"};
        CheckKeys(node, place, keys);
        const std::size_t index = m_scene.bodies.size();
        KeepName("bodies", index, node, place);
        scenes::Body body;
        body.type = static_cast<scenes::BodyType>(m_values.Whole(node, place, "type", 0, 2, 0));
        body.position = m_values.Vector(node, place, "position");
        body.angle = m_values.Number(node, place, "angle");
        body.linearVelocity = m_values.Vector(node, place, "linearVelocity");
        body.angularVelocity = m_values.Number(node, place, "angularVelocity");
        body.linearDamping = m_values.Number(node, place, "linearDamping");
        body.angularDamping = m_values.Number(node, place, "angularDamping");
        body.gravityScale = m_values.Number(node, place, "gravityScale", 1.0f);
        body.allowSleep = m_mayAllSleep && m_values.Flag(node, place, "allowSleep", true);
        body.awake = m_values.Flag(node, place, "awake");
        body.fixedRotation = m_values.Flag(node, place, "fixedRotation");
        body.bullet = m_values.Flag(node, place, "bullet");
        body.firstFixture = static_cast<int>(m_scene.fixtures.size());
        m_isActive.push_back(m_values.Flag(node, place, "active", true));
        m_firstPlace.push_back(m_fixturePlaces.size());
        m_scene.bodies.push_back(body);
        m_values.List(node, place, "fixture", [&](const JsonNode& item, const Place& at) { ReadFixture(item, at); });
        scenes::Body& made = m_scene.bodies[index];
        if (!m_isActive.back()) {
            Notice("not active: a static body without fixtures and joints takes its place", place);
            m_scene.fixtures.resize(static_cast<std::size_t>(made.firstFixture));
            made.type = scenes::BodyType::isStatic;
            made.linearVelocity = {};
            made.angularVelocity = 0.0f;
        }
        made.fixtureCount = static_cast<int>(m_scene.fixtures.size()) - made.firstFixture;
        m_masses.push_back(ReadMass(node, place, made));
        MoveVelocityToCentre(made, m_masses.back());
    }

    /// Mass by the densities; where the file has another one that densities can give too, they are scaled.
    Mass ReadMass(const JsonNode& node, const Place& place, const scenes::Body& body) {
        if (body.type != scenes::BodyType::dynamic) return {};
        AreaSums sums;
        const auto fixtures = std::span(m_scene.fixtures).subspan(static_cast<std::size_t>(body.firstFixture));
        for (const scenes::Fixture& fixture : fixtures) {
            if (fixture.density > 0.0f) sums.Add(SumsOf(m_scene, fixture.shape), double{fixture.density});
        }
        Mass mass;
        if (sums.area > 0.0) mass = {sums.area, sums.moment, sums.x / sums.area, sums.y / sums.area};
        const double told = double{m_values.Number(node, place, "massData-mass")};
        const double toldInertia = double{m_values.Number(node, place, "massData-I")};
        const Vec2 centre = m_values.Vector(node, place, "massData-center");
        const Place at{&place, "massData-mass"};
        constexpr const char* differs =
            "its mass, centre or inertia is not what its fixtures give, and theirs counts; change fixtures and "
            "densities "
            "until both agree";
        if (told > 0.0 && sums.area == 0.0) {
            Notice(differs, at);
        } else if (told > 0.0) {
            const double scale = told / mass.mass, size = std::sqrt(mass.inertia / mass.mass);
            const bool isSameCentre = std::hypot(centre.x - mass.x, centre.y - mass.y) <= massTolerance * size;
            const bool isSameInertia = body.fixedRotation || std::abs(toldInertia - scale * mass.inertia) <=
                                                                 2.0 * massTolerance * scale * mass.inertia;
            if (!isSameCentre || !isSameInertia) {
                Notice(differs, at);
            } else if (std::abs(scale - 1.0) > massTolerance) {
                Notice("its densities are scaled, so that they give this mass", at);
                for (scenes::Fixture& fixture : fixtures) {
                    fixture.density = static_cast<float>(double{fixture.density} * scale);
                }
                mass.mass *= scale;
                mass.inertia *= scale;
            }
        }
        if (body.fixedRotation) mass.inertia = mass.mass * (mass.x * mass.x + mass.y * mass.y);
        return mass;
    }

    /// A definition gives the velocity of the origin, a scene that of the centre of mass.
    static void MoveVelocityToCentre(scenes::Body& body, const Mass& mass) {
        const double s = std::sin(double{body.angle}), c = std::cos(double{body.angle}), w{body.angularVelocity};
        body.linearVelocity.x = static_cast<float>(double{body.linearVelocity.x} - w * (s * mass.x + c * mass.y));
        body.linearVelocity.y = static_cast<float>(double{body.linearVelocity.y} + w * (c * mass.x - s * mass.y));
    }

    // Fixtures.
    void ReadFixture(const JsonNode& node, const Place& place) {
        static constexpr std::array<std::string_view, 12> keys{"density",
                                                               "friction",
                                                               "restitution",
                                                               "sensor",
                                                               "filter-categoryBits",
                                                               "filter-maskBits",
                                                               "filter-groupIndex",
                                                               "circle",
                                                               "polygon",
                                                               "chain",
                                                               "edge",
                                                               "loop"};
        CheckKeys(node, place, keys);
        scenes::Fixture fixture;
        fixture.density = m_values.Number(node, place, "density");
        fixture.friction = m_values.Number(node, place, "friction");
        fixture.restitution = m_values.Number(node, place, "restitution");
        fixture.isSensor = m_values.Flag(node, place, "sensor");
        // Some loaders write the bits as signed numbers.
        constexpr int least = std::numeric_limits<std::int16_t>::min(), most = std::numeric_limits<std::int16_t>::max();
        constexpr int allBits = std::numeric_limits<std::uint16_t>::max();
        fixture.categoryBits =
            static_cast<std::uint16_t>(m_values.Whole(node, place, "filter-categoryBits", least, allBits, 1));
        fixture.maskBits =
            static_cast<std::uint16_t>(m_values.Whole(node, place, "filter-maskBits", least, allBits, allBits));
        fixture.groupIndex =
            static_cast<std::int16_t>(m_values.Whole(node, place, "filter-groupIndex", least, most, 0));
        const std::size_t first = m_scene.fixtures.size();
        ReadShape(node, place, fixture);
        for (std::size_t i = first; i < m_scene.fixtures.size(); ++i) {
            m_fixturePlaces.push_back(place.index);
            if (m_isActive.back()) KeepName("fixtures", i, node, place);
        }
    }

    void ReadShape(const JsonNode& node, const Place& place, scenes::Fixture& fixture) {
        const JsonNode* shape = nullptr;
        std::string_view type;
        for (const std::string_view key : {"circle", "polygon", "edge", "chain", "loop"}) {
            if (node.Find(key) == nullptr) continue;
            if (shape != nullptr) m_values.Fail(place, fmt::format("has both '{}' and '{}'; give one", type, key));
            shape = node.Find(key);
            type = key;
        }
        if (shape == nullptr) m_values.Fail(place, "a fixture needs a \"circle\", \"polygon\", \"edge\" or \"chain\"");
        const Place at{&place, type};
        m_values.Expect(*shape, at, Kind::object);
        if (type == "circle") {
            fixture.shape.type = ShapeType::circle;
            fixture.shape.center = m_values.Vector(*shape, at, "center");
            fixture.shape.radius = m_values.Number(*shape, at, "radius");
            m_scene.fixtures.push_back(fixture);
        } else if (type == "polygon") {
            AddPolygon(m_values.Points(*shape, at), at, fixture);
        } else if (type == "edge") {
            ReadEdge(*shape, at, fixture);
        } else {
            ReadChain(*shape, at, type == "loop", fixture);
        }
    }

    void AddPolygon(std::vector<Vec2> vertices, const Place& place, scenes::Fixture& fixture) {
        if (vertices.size() == 2) return AddEdge(vertices[0], vertices[1], fixture);
        if (vertices.size() < 3 || vertices.size() > mostVertices) {
            m_values.Fail(place, fmt::format("{} vertices; give 3 to {}", vertices.size(), mostLargeVertices));
        }
        Weld(vertices);
        if (!IsConvex(vertices)) {
            std::vector<Vec2> turned(vertices.rbegin(), vertices.rend());
            vertices = IsConvex(turned) ? std::move(turned) : HullOf(std::move(vertices));
        }
        if (vertices.size() > mostLargeVertices) {
            m_values.Fail(place,
                          fmt::format("its hull has {} vertices; give at most {}", vertices.size(), mostLargeVertices));
        }
        if (vertices.size() > scenes::maxPolygonVertices) {
            Notice("more than 8 vertices: our engine takes all of them, Box2D gets a polygon of 8", place);
            fixture.shape.type = ShapeType::largePolygon;
            AddChainVertices(vertices, fixture.shape);
        } else {
            fixture.shape.type = ShapeType::polygon;
            std::ranges::copy(vertices, fixture.shape.vertices.begin());
            fixture.shape.vertexCount = static_cast<std::uint8_t>(vertices.size());
        }
        m_scene.fixtures.push_back(fixture);
    }

    void AddEdge(Vec2 a, Vec2 b, scenes::Fixture& fixture) {
        fixture.shape.type = ShapeType::edge;
        fixture.shape.vertices[0] = a;
        fixture.shape.vertices[1] = b;
        fixture.shape.vertexCount = 2;
        m_scene.fixtures.push_back(fixture);
    }

    void ReadEdge(const JsonNode& node, const Place& place, scenes::Fixture& fixture) {
        const Vec2 a = m_values.Vector(node, place, "vertex1"), b = m_values.Vector(node, place, "vertex2");
        const bool hasBefore = m_values.Flag(node, place, "hasVertex0"),
                   hasAfter = m_values.Flag(node, place, "hasVertex3");
        if (!hasBefore || !hasAfter) {
            if (hasBefore || hasAfter) Notice("the ghost vertex of one end alone is left out", place);
            return AddEdge(a, b, fixture);
        }
        NoticeBothSides(place);
        const Vec2 before = m_values.Vector(node, place, "vertex0"), after = m_values.Vector(node, place, "vertex3");
        for (const auto& v : {std::array{a, b, before, after}, std::array{b, a, after, before}}) {
            fixture.shape.type = ShapeType::edge;
            std::ranges::copy(v, fixture.shape.vertices.begin());
            fixture.shape.vertexCount = 4;
            m_scene.fixtures.push_back(fixture);
        }
    }

    void NoticeBothSides(const Place& place) {
        Notice("collides on both sides in the editor's Box2D and on one in ours: made of two, one a direction", place);
    }

    void AddChainVertices(const std::vector<Vec2>& vertices, scenes::Shape& shape) {
        shape.firstChainVertex = static_cast<int>(m_scene.chainVertices.size());
        shape.chainVertexCount = static_cast<int>(vertices.size());
        m_scene.chainVertices.insert(m_scene.chainVertices.end(), vertices.begin(), vertices.end());
    }

    /// A loop is written as a chain whose last vertex is the first again, with its neighbours as ghosts or none.
    void ReadChain(const JsonNode& node, const Place& place, bool isLoop, scenes::Fixture& fixture) {
        std::vector<Vec2> v = m_values.Points(node, place);
        if (v.size() < 2) m_values.Fail(place, "give two vertices or more");
        const bool hasBefore = m_values.Flag(node, place, "hasPrevVertex"),
                   hasAfter = m_values.Flag(node, place, "hasNextVertex");
        const auto beyond = [](Vec2 end, Vec2 inner) { return Vec2{2 * end.x - inner.x, 2 * end.y - inner.y}; };
        const Vec2 before = hasBefore ? m_values.Vector(node, place, "prevVertex") : beyond(v[0], v[1]);
        const Vec2 after = hasAfter ? m_values.Vector(node, place, "nextVertex") : beyond(v.back(), v[v.size() - 2]);
        if (v.size() >= 4 && v.front() == v.back()) {
            const bool isRing = (!hasBefore || before == v[v.size() - 2]) && (!hasAfter || after == v[1]);
            if (isRing || isLoop) {
                isLoop = true;
                v.pop_back();
            }
        }
        NoticeBothSides(place);
        fixture.shape.type = ShapeType::chain;
        for (const bool isBackward : {false, true}) {
            if (isBackward) std::ranges::reverse(v);
            AddChainVertices(v, fixture.shape);
            fixture.shape.vertexCount = isLoop ? 0 : 2;
            if (!isLoop) fixture.shape.vertices = {isBackward ? after : before, isBackward ? before : after};
            m_scene.fixtures.push_back(fixture);
        }
    }

    // Joints.
    void ReadJoints(const JsonNode& root, const Place& top) {
        const JsonNode* list = root.Find("joint");
        m_jointIndices.assign(list == nullptr ? 0 : list->items.size(), -1);
        // Gears couple others, and come behind them.
        for (const bool wantsGears : {false, true}) {
            m_values.List(root, top, "joint", [&](const JsonNode& node, const Place& at) {
                const bool isGear = m_values.Text(node, at, "type") == "gear";
                if (isGear == wantsGears) ReadJoint(node, at);
            });
        }
    }

    [[nodiscard]] int BodyOf(const JsonNode& node, const Place& place, std::string_view key) const {
        return m_values.Whole(node, place, key, 0, static_cast<int>(m_scene.bodies.size()) - 1);
    }

    void ReadJoint(const JsonNode& node, const Place& place) {
        static constexpr std::array<std::string_view, 36> keys{"type",
                                                               "bodyA",
                                                               "bodyB",
                                                               "anchorA",
                                                               "anchorB",
                                                               "collideConnected",
                                                               "refAngle",
                                                               "enableLimit",
                                                               "lowerLimit",
                                                               "upperLimit",
                                                               "enableMotor",
                                                               "motorSpeed",
                                                               "maxMotorTorque",
                                                               "maxMotorForce",
                                                               "localAxisA",
                                                               "localAxis1",
                                                               "length",
                                                               "frequency",
                                                               "dampingRatio",
                                                               "springFrequency",
                                                               "springDampingRatio",
                                                               "maxLength",
                                                               "maxForce",
                                                               "maxTorque",
                                                               "linearOffset",
                                                               "correctionFactor",
                                                               "groundAnchorA",
                                                               "groundAnchorB",
                                                               "lengthA",
                                                               "lengthB",
                                                               "ratio",
                                                               "target",
                                                               "joint1",
                                                               "joint2",
                                                               "jointSpeed",
                                                               "id"};
        CheckKeys(node, place, keys);
        scenes::Joint joint;
        const std::string type = m_values.Text(node, place, "type");
        joint.collideConnected = m_values.Flag(node, place, "collideConnected");
        if (type == "gear") {
            if (!ReadGear(node, place, joint)) return;
        } else {
            joint.bodyA = BodyOf(node, place, "bodyA");
            joint.bodyB = BodyOf(node, place, "bodyB");
            if (!m_isActive[static_cast<std::size_t>(joint.bodyA)] ||
                !m_isActive[static_cast<std::size_t>(joint.bodyB)]) {
                Notice("joins a body that is not active, and is left out", place);
                return;
            }
            ReadJointOf(type, node, place, joint);
        }
        m_jointIndices[static_cast<std::size_t>(place.index)] = static_cast<int>(m_scene.joints.size());
        KeepName("joints", m_scene.joints.size(), node, place);
        m_scene.joints.push_back(joint);
    }

    /// False: what it couples was left out.
    bool ReadGear(const JsonNode& node, const Place& place, scenes::Joint& joint) {
        joint.type = JointType::gear;
        joint.ratio = m_values.Number(node, place, "ratio");
        const int last = static_cast<int>(m_jointIndices.size()) - 1;
        for (const auto& [key, coupled, body] :
             {std::tuple{"joint1", &joint.joint1, &joint.bodyA}, std::tuple{"joint2", &joint.joint2, &joint.bodyB}}) {
            const auto told = static_cast<std::size_t>(m_values.Whole(node, place, key, 0, last));
            *coupled = m_jointIndices[told];
            if (*coupled < 0) {
                Notice("couples a joint that is left out or a gear, and is left out", place);
                return false;
            }
            *body = m_scene.joints[static_cast<std::size_t>(*coupled)].bodyB;
        }
        return true;
    }

    void ReadJointOf(const std::string& type, const JsonNode& node, const Place& place, scenes::Joint& joint) {
        static constexpr std::array<std::string_view, 11> types{"revolute", "distance", "prismatic", "wheel",
                                                                "rope",     "motor",    "weld",      "friction",
                                                                "pulley",   "mouse",    "gear"};
        joint.localAnchorA = m_values.Vector(node, place, "anchorA");
        joint.localAnchorB = m_values.Vector(node, place, "anchorB");
        const auto number = [&](std::string_view key) { return m_values.Number(node, place, key); };
        if (type == "revolute") {
            joint.type = JointType::revolute;
            joint.referenceAngle = number("refAngle");
            joint.enableLimit = m_values.Flag(node, place, "enableLimit");
            ReadLimits(node, place, joint.lowerAngle, joint.upperAngle);
            ReadMotor(node, place, joint);
        } else if (type == "prismatic" || type == "wheel") {
            joint.type = type == "wheel" ? JointType::wheel : JointType::prismatic;
            joint.localAxisA = AxisOf(node, place);
            ReadMotor(node, place, joint);
            if (joint.type == JointType::wheel) return SetLinearSpring(node, place, "springFrequency", joint);
            joint.referenceAngle = number("refAngle");
            joint.enableLimit = m_values.Flag(node, place, "enableLimit");
            ReadLimits(node, place, joint.lowerTranslation, joint.upperTranslation);
        } else if (type == "distance") {
            joint.type = JointType::distance;
            joint.length = std::max(linearSlop, number("length"));
            SetLinearSpring(node, place, "frequency", joint);
            if (joint.stiffness == 0.0f) joint.minLength = joint.maxLength = joint.length;  // a rod
        } else if (type == "rope") {
            joint.type = JointType::distance;
            joint.length = joint.maxLength = std::max(linearSlop, number("maxLength"));
        } else if (type == "motor") {
            joint.type = JointType::motor;
            // Editors before 1.7 called it anchorA.
            joint.linearOffset = m_values.Vector(node, place, "linearOffset", joint.localAnchorA);
            joint.localAnchorA = joint.localAnchorB = {};
            joint.angularOffset = number("refAngle");
            joint.maxForce = number("maxForce");
            joint.maxTorque = number("maxTorque");
            joint.correctionFactor = number("correctionFactor");
        } else if (type == "weld") {
            joint.type = JointType::weld;
            joint.referenceAngle = number("refAngle");
            SetAngularSpring(node, place, joint);
        } else if (type == "friction") {
            joint.type = JointType::friction;
            joint.maxForce = number("maxForce");
            joint.maxTorque = number("maxTorque");
        } else if (type == "pulley") {
            joint.type = JointType::pulley;
            joint.groundAnchorA = m_values.Vector(node, place, "groundAnchorA");
            joint.groundAnchorB = m_values.Vector(node, place, "groundAnchorB");
            joint.lengthA = number("lengthA");
            joint.lengthB = number("lengthB");
            joint.ratio = number("ratio");
        } else if (type == "mouse") {
            joint.type = JointType::mouse;
            joint.localAnchorA = {};
            joint.localAnchorB = ToLocal(joint.bodyB, joint.localAnchorB);  // it alone is a point of the world
            joint.target = m_values.Vector(node, place, "target");
            joint.maxForce = number("maxForce");
            SetLinearSpring(node, place, "frequency", joint);
        } else {
            m_values.Fail(Place{&place, "type"}, DescribeUnknown("joint", type, types));
        }
    }

    void ReadLimits(const JsonNode& node, const Place& place, float& lower, float& upper) const {
        lower = m_values.Number(node, place, "lowerLimit");
        upper = m_values.Number(node, place, "upperLimit");
        if (lower > upper) m_values.Fail(Place{&place, "lowerLimit"}, "give at most upperLimit");
    }
    void ReadMotor(const JsonNode& node, const Place& place, scenes::Joint& joint) const {
        joint.enableMotor = m_values.Flag(node, place, "enableMotor");
        joint.motorSpeed = m_values.Number(node, place, "motorSpeed");
        if (joint.type == JointType::prismatic) {
            joint.maxMotorForce = m_values.Number(node, place, "maxMotorForce");
        } else {
            joint.maxMotorTorque = m_values.Number(node, place, "maxMotorTorque");
        }
    }
    [[nodiscard]] Vec2 AxisOf(const JsonNode& node, const Place& place) const {
        const std::string_view key = node.Find("localAxisA") != nullptr ? "localAxisA" : "localAxis1";
        const Vec2 axis = m_values.Vector(node, place, key, {1.0f, 0.0f});
        const double length = std::hypot(double{axis.x}, double{axis.y});
        if (!(length > 1e-6)) m_values.Fail(Place{&place, "localAxisA"}, "give a direction other than zero");
        if (std::abs(length - 1.0) < 1e-6) return axis;
        return {static_cast<float>(double{axis.x} / length), static_cast<float>(double{axis.y} / length)};
    }

    [[nodiscard]] const Mass& MassOf(int body) const { return m_masses[static_cast<std::size_t>(body)]; }
    /// What two inertias that move against each other are together; none has no part.
    static double Reduced(double a, double b) { return a > 0.0 && b > 0.0 ? a * b / (a + b) : std::max(a, b); }

    /// Frequency and damping ratio as stiffness and damping (Box2D's b2LinearStiffness).
    void SetSpring(const JsonNode& node, const Place& place, std::string_view key, double inertia,
                   scenes::Joint& joint) const {
        const float frequency = m_values.Number(node, place, key);
        const std::string_view ratioKey = key == "springFrequency" ? "springDampingRatio" : "dampingRatio";
        const float ratio = m_values.Number(node, place, ratioKey);
        if (frequency < 0.0f) m_values.Fail(Place{&place, key}, "give a frequency of 0 or more, in Hz");
        if (ratio < 0.0f) m_values.Fail(Place{&place, ratioKey}, "give a ratio of 0 or more");
        const double omega = fullTurn * double{frequency};
        joint.stiffness = static_cast<float>(inertia * omega * omega);
        joint.damping = static_cast<float>(2.0 * inertia * double{ratio} * omega);
    }
    void SetLinearSpring(const JsonNode& node, const Place& place, std::string_view key, scenes::Joint& joint) const {
        SetSpring(node, place, key, Reduced(MassOf(joint.bodyA).mass, MassOf(joint.bodyB).mass), joint);
    }
    void SetAngularSpring(const JsonNode& node, const Place& place, scenes::Joint& joint) const {
        SetSpring(node, place, "frequency", Reduced(MassOf(joint.bodyA).inertia, MassOf(joint.bodyB).inertia), joint);
    }

    [[nodiscard]] Vec2 ToLocal(int index, Vec2 point) const {
        const scenes::Body& body = m_scene.bodies[static_cast<std::size_t>(index)];
        const double s = std::sin(double{body.angle}), c = std::cos(double{body.angle});
        const double dx = double{point.x} - body.position.x, dy = double{point.y} - body.position.y;
        return {static_cast<float>(c * dx + s * dy), static_cast<float>(c * dy - s * dx)};
    }

    /// A fault of the scene, "bodies[3].fixtures[1].shape…", with its place in the file.
    [[nodiscard]] std::string ToRubePlace(const std::string& fault) const {
        const auto indexAt = [&](std::string_view list, std::size_t at) -> std::optional<std::size_t> {
            if (fault.compare(at, list.size(), list) != 0) return std::nullopt;
            std::size_t index = 0;
            const char* const begin = fault.data() + at + list.size();
            return std::from_chars(begin, fault.data() + fault.size(), index).ec == std::errc() ? std::optional(index)
                                                                                                : std::nullopt;
        };
        if (const auto joint = indexAt("joints[", 0)) {
            const auto told = std::ranges::find(m_jointIndices, static_cast<int>(*joint)) - m_jointIndices.begin();
            return fmt::format("joint[{}]{}", told, fault.substr(fault.find(']') + 1));
        }
        const auto body = indexAt("bodies[", 0);
        if (!body) return fault;
        const std::size_t end = fault.find(']') + 1;
        if (const auto fixture = indexAt(".fixtures[", end)) {
            const std::size_t place = m_firstPlace[*body] + *fixture;
            return fmt::format("body[{}].fixture[{}]{}", *body, m_fixturePlaces[place],
                               fault.substr(fault.find(']', end) + 1));
        }
        return fmt::format("body[{}]{}", *body, fault.substr(end));
    }

    RubeValues m_values;
    std::string_view m_source;
    scenes::Scene m_scene;
    nlohmann::json m_names;
    std::vector<Noticed> m_notices;
    bool m_mayAllSleep = true;
    std::vector<bool> m_isActive;           ///< by body
    std::vector<Mass> m_masses;             ///< by body
    std::vector<std::size_t> m_firstPlace;  ///< by body, into m_fixturePlaces
    std::vector<int> m_fixturePlaces;       ///< which fixture of its body in the file became each of the scene's
    std::vector<int> m_jointIndices;        ///< by joint of the file, in the scene; −1: none
};

}  // namespace

RubeWorld ReadRube(std::string_view text, std::string_view source) {
    return RubeReader(source).Read(ParseJson(text, source));
}

}  // namespace testbed
