// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of state_judge.h.

#include "testbed/engines/state_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "scree/world.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_scene.h"

namespace testbed {
namespace {

void ThrowError(const scree::Error& error, void*) {
    throw std::invalid_argument(std::string(error.function) + ": " + error.field + ": " + scree::GetName(error.code) +
                                "; " + error.cure);
}

/// Poses beyond are those of an explosion, m: the engine's boxes would lose all digits there.
constexpr float farthest = 1e7f;

bool IsUsable(const BodyState& body) {
    return std::isfinite(body.angle) && std::abs(body.position.x) < farthest && std::abs(body.position.y) < farthest;
}

/// What moves with a dynamic body.
struct Mass {
    double mass = 0.0;        ///< kg; 0: not dynamic
    double gyration = 0.0;    ///< squared radius of gyration, m²
    double x = 0.0, y = 0.0;  ///< centre, in the body
    double gravityScale = 1.0;
};

double CentreX(const Mass& mass, const BodyState& b) {
    return double{b.position.x} + double{b.cos} * mass.x - double{b.sin} * mass.y;
}
double CentreY(const Mass& mass, const BodyState& b) {
    return double{b.position.y} + double{b.sin} * mass.x + double{b.cos} * mass.y;
}

}  // namespace

struct StateJudge::World {
    scree::World world;
    ScreeBodies bodies;
    std::vector<Mass> masses;
    std::vector<int> present;  ///< by body: the number of the last measurement that had it
    int measurement = 0;
    double bodySize = 1.0;
    bool hasJoints = false;

    static scree::WorldDef MakeDefinition() {
        scree::WorldDef def;
        def.allowSleep = false;
        def.continuousPhysics = false;
        return def;
    }
    World() : world(MakeDefinition()) {}
};

StateJudge::StateJudge(const scenes::Scene& scene) : m_world(std::make_unique<World>()) {
    World& w = *m_world;
    w.world.SetErrorHandler(ThrowError, nullptr);
    double squares = 0.0;
    int dynamicBodies = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        scree::Body* body = CreateScreeBody(w.world, scene, static_cast<int>(i));
        w.bodies.push_back(body);
        Mass mass;
        if (scene.bodies[i].type == scenes::BodyType::dynamic) {
            const scree::Vec2 centre = body->GetLocalCenter();
            mass = {.mass = double{body->GetMass()},
                    .x = double{centre.x},
                    .y = double{centre.y},
                    .gravityScale = double{scene.bodies[i].gravityScale}};
            const double offset = mass.x * mass.x + mass.y * mass.y;
            mass.gyration = std::max(0.0, double{body->GetInertia()} / mass.mass - offset);
            double side = 0.0;
            for (scree::Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
                const scree::AABB box = f->GetAABB();
                side = std::max({side, double{box.upperBound.x} - double{box.lowerBound.x},
                                 double{box.upperBound.y} - double{box.lowerBound.y}});
            }
            squares += side * side;
            ++dynamicBodies;
        }
        w.masses.push_back(mass);
    }
    ScreeJoints joints;
    for (const scenes::Joint& joint : scene.joints) {
        joints.push_back(CreateScreeJoint(w.world, joint, w.bodies, joints));
    }
    w.hasJoints = !joints.empty();
    w.present.assign(w.bodies.size(), 0);
    if (squares > 0.0) w.bodySize = std::sqrt(squares / dynamicBodies);
}

StateJudge::~StateJudge() = default;

StateErrors StateJudge::Measure(std::span<const BodyState> bodies, bool outlines) {
    constexpr double lost = std::numeric_limits<double>::infinity();
    if (!std::ranges::all_of(bodies, IsUsable)) return {lost, lost};
    World& w = *m_world;
    ++w.measurement;
    for (const BodyState& state : bodies) {
        const auto index = static_cast<std::size_t>(state.index);
        if (index >= w.bodies.size()) continue;
        w.present[index] = w.measurement;
        if (state.type == scenes::BodyType::isStatic) continue;
        w.bodies[index]->SetTransform({state.position.x, state.position.y}, state.angle);
    }
    for (std::size_t i = 0; i < w.bodies.size(); ++i) {
        const bool isPresent = w.present[i] == w.measurement;
        if (w.bodies[i]->IsEnabled() != isPresent) w.bodies[i]->SetEnabled(isPresent);
    }
    // A step of no time only finds the contacts; its kind says where shapes should rest.
    if (outlines) {
        w.world.Step(0.0f, 1);
    } else {
        w.world.Step(0.0f, 1, 0);
    }
    const scree::StepErrors errors = w.world.MeasureErrors();
    return {double{errors.overlap}, double{errors.jointGap}};
}

double StateJudge::GetEnergy(std::span<const BodyState> bodies, Vec2 gravity) const {
    double energy = 0.0, total = 0.0;
    for (const BodyState& b : bodies) {
        if (static_cast<std::size_t>(b.index) >= m_world->masses.size()) continue;
        const Mass& mass = m_world->masses[static_cast<std::size_t>(b.index)];
        if (mass.mass == 0.0) continue;
        const double vx = double{b.linearVelocity.x}, vy = double{b.linearVelocity.y}, w = double{b.angularVelocity};
        const double height = double{gravity.x} * CentreX(mass, b) + double{gravity.y} * CentreY(mass, b);
        energy += mass.mass * (0.5 * (vx * vx + vy * vy + mass.gyration * w * w) - mass.gravityScale * height);
        total += mass.mass;
    }
    return total > 0.0 ? energy / total : 0.0;
}

double StateJudge::GetDistance(std::span<const BodyState> one, std::span<const BodyState> other) const {
    double squares = 0.0;
    int count = 0;
    auto b = other.begin();
    for (const BodyState& a : one) {
        while (b != other.end() && b->index < a.index) ++b;
        if (b == other.end()) break;
        if (b->index != a.index || static_cast<std::size_t>(a.index) >= m_world->masses.size()) continue;
        const Mass& mass = m_world->masses[static_cast<std::size_t>(a.index)];
        if (mass.mass == 0.0) continue;
        const double dx = CentreX(mass, a) - CentreX(mass, *b), dy = CentreY(mass, a) - CentreY(mass, *b);
        // A mass that is turned by an angle is on average this far from where it was: 2 k² (1 − cos angle).
        const double ds = double{a.sin} - double{b->sin}, dc = double{a.cos} - double{b->cos};
        squares += dx * dx + dy * dy + mass.gyration * (ds * ds + dc * dc);
        ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : 0.0;
}

double StateJudge::GetBodySize() const { return m_world->bodySize; }
bool StateJudge::HasJoints() const { return m_world->hasJoints; }

}  // namespace testbed
