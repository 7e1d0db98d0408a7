// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a scene must be so that all engines can make it. Box2D 2.4 ends the program where one of its assertions fails,
// so whatever would make it do so is refused here.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "scenes/outline.h"
#include "testbed/input/area.h"
#include "testbed/input/scene_fields.h"
#include "testbed/input/scene_file.h"

namespace testbed {

namespace {

using scenes::JointType;
using scenes::ShapeType;
using scenes::Vec2;

/// Squares of larger numbers leave the range of floats.
constexpr double farthest = 1e18;
/// Vertices nearer than half of Box2D's linear slop are taken for one by it.
constexpr double leastEdge = 0.0025;
/// A chain's neighbours: Box2D's linear slop.
constexpr double leastChainEdge = 0.005;
/// Box2D ends the program for polygons of less than 1.2e-7 m².
constexpr double leastArea = 1.5e-7;
/// Runs of more steps or more iterations are nothing that anyone waits for.
constexpr int mostSteps = 1'000'000, mostIterations = 1000;

bool IsNear(double value) { return std::abs(value) <= farthest; }
bool IsNear(Vec2 value) { return IsNear(value.x) && IsNear(value.y); }

double Cross(Vec2 a, Vec2 b, Vec2 c) {
    return (static_cast<double>(b.x) - a.x) * (static_cast<double>(c.y) - a.y) -
           (static_cast<double>(b.y) - a.y) * (static_cast<double>(c.x) - a.x);
}
double DistanceOf(Vec2 a, Vec2 b) { return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y); }

/// Finds the first fault of a scene and says where it is.
class Search {
public:
    explicit Search(const scenes::Scene& scene) : m_scene(scene) {}

    std::string Run() {
        CheckRun();
        for (std::size_t i = 0; i < m_scene.bodies.size() && m_fault.empty(); ++i) CheckBody(static_cast<int>(i));
        CheckSpawns();
        for (std::size_t i = 0; i < m_scene.joints.size() && m_fault.empty(); ++i) CheckJoint(static_cast<int>(i));
        return std::move(m_fault);
    }

private:
    /// Keeps the first fault.
    template <typename... Arguments>
    void Require(bool isGood, const std::string& place, fmt::format_string<Arguments...> format,
                 Arguments&&... arguments) {
        if (isGood || !m_fault.empty()) return;
        m_fault = place + ": " + fmt::format(format, std::forward<Arguments>(arguments)...);
    }

    void CheckRun() {
        const scenes::Scene& s = m_scene;
        const bool isName = !s.name.empty() && s.name.size() <= 64 && s.name.find_first_of("-.") != 0 &&
                            std::all_of(s.name.begin(), s.name.end(), [](char c) {
                                return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                       c == '-' || c == '_' || c == '.';
                            });
        Require(isName, "name", "give 1 to 64 letters, digits, '-', '_' or '.', a letter, digit or '_' first");
        Require(s.steps >= 1 && s.steps <= mostSteps, "steps", "give 1 to {}, not {}", mostSteps, s.steps);
        Require(s.showStep >= 1 && s.showStep <= s.steps, "showStep", "give a step of the run, 1 to {}", s.steps);
        Require(IsNear(s.gravity), "gravity", "give numbers of at most 1e18");
        Require(s.timeStep >= 1e-6f && s.timeStep <= 10.0f, "timeStep", "give 1e-6 to 10 s, not {}", s.timeStep);
        for (const auto& [place, count] :
             {std::pair{"velocityIterations", s.velocityIterations}, {"positionIterations", s.positionIterations}}) {
            Require(count >= 0 && count <= mostIterations, place, "give 0 to {}, not {}", mostIterations, count);
        }
        Require(s.spawns.size() <= s.bodies.size(), "spawns", "more spawns than bodies");
    }

    void CheckBody(int index) {
        const scenes::Body& body = m_scene.bodies[static_cast<std::size_t>(index)];
        const std::string place = fmt::format("bodies[{}]", index);
        Require(IsNear(body.position), place + ".position", "give numbers of at most 1e18");
        Require(std::abs(body.angle) <= 1e6f, place + ".angle", "give an angle of at most 1e6 rad");
        Require(IsNear(body.linearVelocity), place + ".linearVelocity", "give numbers of at most 1e18");
        Require(IsNear(body.angularVelocity), place + ".angularVelocity", "give a number of at most 1e18");
        Require(IsNear(body.gravityScale), place + ".gravityScale", "give a number of at most 1e18");
        RequireAmount(body.linearDamping, place + ".linearDamping");
        RequireAmount(body.angularDamping, place + ".angularDamping");
        AreaSums mass;
        for (int i = 0; i < body.fixtureCount && m_fault.empty(); ++i) {
            const scenes::Fixture& fixture = m_scene.fixtures[static_cast<std::size_t>(body.firstFixture + i)];
            const std::string at = fmt::format("{}.fixtures[{}]", place, i);
            CheckShape(fixture.shape, at + ".shape");
            for (const auto& [key, value] : {std::pair{".density", fixture.density},
                                             {".friction", fixture.friction},
                                             {".restitution", fixture.restitution}}) {
                RequireAmount(value, at + key);
            }
            Require(IsNear(fixture.tangentSpeed), at + ".tangentSpeed", "give a number of at most 1e18");
            if (!m_fault.empty() || fixture.density == 0.0f) continue;
            const AreaSums one = SumsOf(m_scene, fixture.shape);
            CheckFixtureMass(one, fixture.density, at);
            mass.Add(one, fixture.density);
        }
        if (m_fault.empty() && body.type == scenes::BodyType::dynamic) CheckMass(mass, place);
    }

    /// Of one fixture, of whatever body. Engines compute it in floats, first without the density.
    void CheckFixtureMass(const AreaSums& one, float density, const std::string& place) {
        constexpr double least = 1e-29, most = 1e29, mostMoment = 1e35;
        const double mass = density * one.area, moment = density * one.moment;
        Require(mass == 0.0 || (mass >= least && mass <= most), place + ".density",
                "a mass of {} kg; give a density that makes 1e-29 to 1e29", mass);
        Require(
            one.moment <= mostMoment && moment <= mostMoment, place,
            "too large, or too far from its body's origin, for a moment of inertia in floats; give smaller numbers");
    }

    /// A moment about the centre of mass that is lost in the rounding of the one about the origin is none.
    void CheckMass(const AreaSums& mass, const std::string& place) {
        if (mass.area == 0.0) return;
        Require(mass.area >= 1e-18 && mass.area <= 1e18, place,
                "a mass of {} kg; give densities that make 1e-18 to 1e18", mass.area);
        const double central = mass.moment - (mass.x * mass.x + mass.y * mass.y) / mass.area;
        Require(central > 1e-5 * mass.moment, place,
                "its fixtures are too small and too far from its origin for floats; put its position nearer to them");
    }

    void RequireAmount(float value, const std::string& place) {
        Require(value >= 0.0f && IsNear(value), place, "give a number from 0 to 1e18, not {}", value);
    }

    // Shapes.
    void CheckShape(const scenes::Shape& shape, const std::string& place) {
        for (const Vec2 vertex : shape.Vertices()) {
            Require(IsNear(vertex), place + ".vertices", "give numbers of at most 1e18");
        }
        Require(IsNear(shape.center), place + ".center", "give numbers of at most 1e18");
        Require(std::abs(shape.angle) <= 1e6f, place + ".angle", "give an angle of at most 1e6 rad");
        if (!m_fault.empty()) return;
        CheckOutline(shape, place);
        const bool isRound = shape.type == ShapeType::circle || shape.type == ShapeType::capsule ||
                             shape.type == ShapeType::roundedPolygon || shape.type == ShapeType::sector ||
                             shape.type == ShapeType::supported;
        if (isRound) {
            Require(shape.radius >= leastEdge && IsNear(shape.radius), place + ".radius",
                    "give a radius of at least {} m", leastEdge);
        }
        if (shape.type == ShapeType::supported && m_fault.empty()) CheckSupport(shape, place);
        if (shape.type == ShapeType::sector) {
            Require(shape.opening >= 0.01f && shape.opening <= 3.1415928f, place + ".opening", "give 0.01 to π rad");
        }
        if (m_fault.empty() && scenes::IsFurtherConvex(shape.type)) {
            // What Box2D gets in its place must be a polygon too.
            CheckPolygon(scenes::PolygonInstead(m_scene, shape).Vertices(), 3, scenes::maxPolygonVertices, place);
        }
    }

    /// The radius bounds how far the function reaches; a far larger one tells nothing about it.
    void CheckSupport(const scenes::Shape& shape, const std::string& place) {
        constexpr int directions = 1024;
        constexpr double twoPi = 6.283185307179586;
        double reach = 0.0;
        for (int i = 0; i < directions; ++i) {
            const double angle = twoPi * i / directions;
            const Vec2 point =
                shape.support({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))});
            reach = std::max(reach, std::hypot(double{point.x}, double{point.y}));
        }
        Require(shape.radius >= reach && shape.radius <= 1000.0 * reach, place + ".radius",
                "give {} m, how far its support function reaches, or up to 1000 times that", reach);
    }

    void CheckOutline(const scenes::Shape& shape, const std::string& place) {
        const std::string vertices = place + ".vertices", chain = place + ".chainVertices",
                          extents = place + ".halfExtents";
        const double least = 0.5 * leastEdge;
        switch (shape.type) {
            case ShapeType::polygon:
            case ShapeType::roundedPolygon:
                CheckPolygon(shape.Vertices(), 3, scenes::maxPolygonVertices, vertices);
                break;
            case ShapeType::largePolygon:
                CheckChainVertices(shape, 3, 64, place);
                if (m_fault.empty()) CheckPolygon(m_scene.ChainVerticesOf(shape), 3, 64, chain);
                break;
            case ShapeType::box:
            case ShapeType::ellipse:
                Require(shape.halfExtents.x >= least && shape.halfExtents.y >= least && IsNear(shape.halfExtents) &&
                            4.0 * shape.halfExtents.x * shape.halfExtents.y >= leastArea,
                        extents, "give lengths that make an area of at least {} m²", leastArea);
                Require(IsNear(CornerOf(shape)), extents, "its corners reach beyond 1e18; give smaller numbers");
                break;
            case ShapeType::edge:
            case ShapeType::capsule:
                CheckEnds(shape, vertices);
                break;
            case ShapeType::chain:
                Require(shape.vertexCount == 0 || shape.vertexCount == 2, vertices,
                        "give the two ghosts before and after the chain, or none for a loop");
                CheckChainVertices(shape, shape.IsLoop() ? 3 : 2, 10'000'000, place);
                CheckChain(shape, chain);
                break;
            default:
                break;
        }
    }

    /// How far a box or an ellipse reaches from its body's origin at most, by coordinates.
    static Vec2 CornerOf(const scenes::Shape& shape) {
        constexpr double rounding = 1e-6;  // of sines and cosines in floats
        const double angle = double{shape.angle}, slack = angle == 0.0 ? 1.0 : 1.0 + rounding;
        const double c = slack * std::abs(std::cos(angle)), s = slack * std::abs(std::sin(angle));
        const double x = double{shape.halfExtents.x}, y = double{shape.halfExtents.y};
        return {static_cast<float>(std::abs(double{shape.center.x}) + c * x + s * y),
                static_cast<float>(std::abs(double{shape.center.y}) + s * x + c * y)};
    }

    void CheckEnds(const scenes::Shape& shape, const std::string& place) {
        const bool isEdge = shape.type == ShapeType::edge;
        Require(shape.vertexCount == 2 || (isEdge && shape.vertexCount == 4), place, "{} vertices; give both ends{}",
                shape.vertexCount, isEdge ? ", and for a one-sided edge the ghosts before and after" : "");
        Require(DistanceOf(shape.vertices[0], shape.vertices[1]) > leastEdge, place, "the ends are nearer than {} m",
                leastEdge);
    }

    void CheckPolygon(std::span<const Vec2> v, std::size_t least, std::size_t most, const std::string& place) {
        Require(v.size() >= least && v.size() <= most, place, "{} vertices; give {} to {}", v.size(), least, most);
        if (!m_fault.empty()) return;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const std::size_t next = (i + 1) % v.size();
            Require(DistanceOf(v[i], v[next]) > leastEdge, place, "vertices {} and {} are nearer than {} m", i, next,
                    leastEdge);
            for (std::size_t k = 0; k < v.size(); ++k) {
                if (k == i || k == next) continue;
                Require(Cross(v[i], v[next], v[k]) > 0.0, place,
                        "not convex and counter-clockwise at vertex {}; split it, or turn its order round", k);
            }
        }
        Require(SumsOf(v).area >= leastArea, place, "an area below {} m²", leastArea);
    }

    void CheckChainVertices(const scenes::Shape& shape, int least, int most, const std::string& place) {
        Require(shape.chainVertexCount >= least && shape.chainVertexCount <= most, place + ".chainVertices",
                "{} vertices; give {} to {}", shape.chainVertexCount, least, most);
    }

    void CheckChain(const scenes::Shape& chain, const std::string& place) {
        if (!m_fault.empty()) return;
        const std::span<const Vec2> v = m_scene.ChainVerticesOf(chain);
        const std::size_t edges = chain.IsLoop() ? v.size() : v.size() - 1;
        for (std::size_t i = 0; i < v.size(); ++i) {
            Require(IsNear(v[i]), place + fmt::format("[{}]", i), "give numbers of at most 1e18");
            if (i < edges) {
                Require(DistanceOf(v[i], v[(i + 1) % v.size()]) > leastChainEdge, place + fmt::format("[{}]", i),
                        "the next vertex is nearer than {} m", leastChainEdge);
            }
        }
    }

    // Bodies that enter later, and joints.
    void CheckSpawns() {
        if (!m_fault.empty()) return;
        int body = m_scene.InitialBodyCount(), step = 1;
        for (std::size_t i = 0; i < m_scene.spawns.size(); ++i) {
            const scenes::Spawn& spawn = m_scene.spawns[i];
            const std::string place = fmt::format("spawns[{}]", i);
            Require(spawn.body == body, place + ".body",
                    "give {}: the bodies that enter later are the last ones, in order", body);
            Require(spawn.afterStep >= step, place + ".afterStep", "give {} or more: in the order of time", step);
            ++body;
            step = spawn.afterStep;
        }
    }

    void CheckJoint(int index) {
        const scenes::Joint& joint = m_scene.joints[static_cast<std::size_t>(index)];
        const std::string place = fmt::format("joints[{}]", index);
        const int bodies = m_scene.InitialBodyCount();
        for (const auto& [key, body] : {std::pair{".bodyA", joint.bodyA}, {".bodyB", joint.bodyB}}) {
            Require(body >= 0 && body < bodies, place + key, "{} is not a body that exists from the start, 0 to {}",
                    body, bodies - 1);
        }
        Require(joint.bodyA != joint.bodyB, place + ".bodyB", "give another body than bodyA");
        using scenes::Joint;
        static constexpr auto amounts = {&Joint::maxMotorTorque, &Joint::maxMotorForce, &Joint::maxForce,
                                         &Joint::maxTorque,      &Joint::stiffness,     &Joint::damping};
        ForEachField<scenes::Joint>([&](const auto& field) {
            const auto& value = joint.*field.member;
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, Vec2>) {
                Require(IsNear(value), place + "." + std::string(field.name), "give numbers of at most 1e18");
            } else if constexpr (std::is_same_v<Value, float>) {
                const std::string at = place + "." + std::string(field.name);
                // Programs give the largest number for a motor without a limit.
                for (const float Joint::*amount : amounts) {
                    if (field.member != amount) continue;
                    Require(value >= 0.0f && std::isfinite(value), at, "give a finite number of at least 0, not {}",
                            value);
                    return;
                }
                Require(IsNear(value) || field.member == &Joint::maxLength, at, "give a number of at most 1e18");
            }
        });
        if (joint.type == JointType::gear) return CheckGear(joint, index, place);
        Require(joint.lowerAngle <= joint.upperAngle, place + ".lowerAngle", "give at most upperAngle");
        Require(joint.lowerTranslation <= joint.upperTranslation, place + ".lowerTranslation",
                "give at most upperTranslation");
        Require(joint.minLength >= 0.0f && joint.minLength <= joint.maxLength, place + ".minLength",
                "give 0 to maxLength");
        Require(joint.correctionFactor >= 0.0f && joint.correctionFactor <= 1.0f, place + ".correctionFactor",
                "give 0 to 1");
        if (joint.type == JointType::distance) {
            Require(joint.length >= leastChainEdge, place + ".length", "give at least {} m", leastChainEdge);
        }
        if (joint.type == JointType::prismatic || joint.type == JointType::wheel) {
            const double length = std::hypot(joint.localAxisA.x, joint.localAxisA.y);
            Require(std::abs(length - 1.0) < 1e-3, place + ".localAxisA", "give a direction of length 1, not {}",
                    length);
        }
        if (joint.type == JointType::pulley) {
            Require(joint.ratio != 0.0f, place + ".ratio", "give a ratio other than 0");
            RequireAmount(joint.lengthA, place + ".lengthA");
            RequireAmount(joint.lengthB, place + ".lengthB");
        }
    }

    void CheckGear(const scenes::Joint& gear, int index, const std::string& place) {
        Require(gear.ratio != 0.0f, place + ".ratio", "give a ratio other than 0");
        for (const auto& [key, coupled, body] :
             {std::tuple{".joint1", gear.joint1, gear.bodyA}, {".joint2", gear.joint2, gear.bodyB}}) {
            Require(coupled >= 0 && coupled < index, place + key, "give the index of an earlier joint");
            if (!m_fault.empty()) return;
            const scenes::Joint& joint = m_scene.joints[static_cast<std::size_t>(coupled)];
            Require(joint.type == JointType::revolute || joint.type == JointType::prismatic, place + key,
                    "give a revolute or a prismatic joint");
            Require(joint.bodyB == body, place + key, "its bodyB has to be the gear's {}",
                    key == std::string_view(".joint1") ? "bodyA" : "bodyB");
        }
    }

    const scenes::Scene& m_scene;
    std::string m_fault;
};

}  // namespace

std::string DescribeFault(const scenes::Scene& scene) { return Search(scene).Run(); }

}  // namespace testbed
