// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene in a laboratory: stepped by either engine under a given setting, poked with velocities and forces, and read
// out in double. Both engines are read by the same code (lab_world.h), so that what is measured of one is measured of
// the other.

#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/run_spec.h"

namespace testbed {

/// A point or vector in double.
struct Point {
    double x = 0.0, y = 0.0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double Dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double Cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double Length(Point a) { return std::hypot(a.x, a.y); }

struct BodyReading {
    Point origin, centre;
    double angle = 0.0;           ///< rad: the rotation's, with the engine's count of whole turns
    double cos = 1.0, sin = 0.0;  ///< the rotation
    Point velocity;               ///< of the centre
    double spin = 0.0;            ///< rad/s
    double mass = 0.0;            ///< kg
    double inertia = 0.0;         ///< about the centre, kg·m²
    bool awake = true;

    /// A point of the body in world coordinates, turned in double.
    [[nodiscard]] Point ToWorld(Point local) const {
        return origin + Point{cos * local.x - sin * local.y, sin * local.x + cos * local.y};
    }
    [[nodiscard]] bool IsFinite() const {
        return std::isfinite(origin.x + origin.y + centre.x + centre.y + cos + sin) &&
               std::isfinite(velocity.x + velocity.y + spin);
    }
};

/// A touching contact.
struct ContactReading {
    int bodyA = 0, bodyB = 0;
    int pointCount = 0;
    Point normal;                ///< from A to B
    double separations[2] = {};  ///< of what the solver keeps apart: skins, or in the soft step outlines, m
    double impulses[2] = {};     ///< along the normal over the whole step, N·s
};

/// What a step told.
struct StepFacts {
    int capped = 0;             ///< bodies slowed by a speed cap; Box2D does not tell
    int nonFinite = 0;          ///< bodies stopped because they became non-finite; Box2D does not tell
    std::int64_t pairs = -1;    ///< reported by the broad phase; −1: not told
    int contacts = 0;           ///< kept after the step
    double milliseconds = 0.0;  ///< wall time
};

/// What a laboratory changes of the scene itself.
struct LabNeeds {
    double restitutionThreshold = 1.0;  ///< of all fixtures, m/s
    Point place{};                      ///< where the scene's origin is put, m: both engines get the sum as they can
};

class LabWorld {
public:
    virtual ~LabWorld() = default;
    LabWorld(const LabWorld&) = delete;
    LabWorld& operator=(const LabWorld&) = delete;

    /// One step of the spec's solver; of `dt` seconds instead of the spec's if given.
    virtual StepFacts Step() = 0;
    virtual StepFacts Step(double dt) = 0;

    /// By index into scenes::Scene::bodies. No spawns: all bodies exist from the start.
    [[nodiscard]] virtual BodyReading Read(int body) const = 0;
    [[nodiscard]] virtual int GetBodyCount() const = 0;
    virtual void SetVelocity(int body, Point velocity, double spin) = 0;
    virtual void SetDamping(int body, double linear, double angular) = 0;
    virtual void SetGravity(Point gravity) = 0;
    /// At the centre of mass, for the next step, N.
    virtual void ApplyForce(int body, Point force) = 0;
    virtual void DestroyBody(int body) = 0;

    // What games do between steps.
    /// Its velocity stays.
    virtual void SetPose(int body, Point origin, double angle) = 0;
    /// Destroys a body that has no joints and makes it as the scene has it.
    virtual void RemakeBody(int body) = 0;
    /// The part of the way from one point to another until the first fixture; 1 if there is none.
    [[nodiscard]] virtual double CastRay(Point from, Point to) const = 0;
    /// Fixtures whose boxes, as the engine keeps them, overlap a box.
    [[nodiscard]] virtual int CountInBox(Point low, Point high) const = 0;
    /// From now on contacts that begin and end are listened to, as the engine tells of them.
    virtual void Listen() = 0;
    /// Heard since then.
    [[nodiscard]] virtual long GetHeard() const = 0;

    /// Of the last step, mean over it, N.
    [[nodiscard]] virtual Point GetJointForce(int joint) const = 0;
    /// Replaces `contacts` by those that touch.
    virtual void GetContacts(std::vector<ContactReading>& contacts) const = 0;
    /// 64 bits over poses, velocities and awake bits in body order.
    [[nodiscard]] virtual std::uint64_t GetStateHash() const = 0;
    [[nodiscard]] const scenes::Scene& GetScene() const { return m_scene; }

protected:
    explicit LabWorld(const scenes::Scene& scene) : m_scene(scene) {}

private:
    scenes::Scene m_scene;
};

/// By the spec's engine, UsageError for one that is not in engine_list.h. Throws std::invalid_argument for a spec that
/// the engine cannot run and for a scene that it refuses.
[[nodiscard]] std::unique_ptr<LabWorld> MakeLab(const scenes::Scene& scene, const RunSpec& spec,
                                                const LabNeeds& needs = {});
[[nodiscard]] std::unique_ptr<LabWorld> MakeScreeLab(const scenes::Scene& scene, const RunSpec& spec,
                                                     const LabNeeds& needs);
[[nodiscard]] std::unique_ptr<LabWorld> MakeBox2dLab(const scenes::Scene& scene, const RunSpec& spec,
                                                     const LabNeeds& needs);

}  // namespace testbed
