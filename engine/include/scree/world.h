// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The world: owns bodies, fixtures, contacts and joints and advances them in time.

#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "scree/accuracy.h"
#include "scree/api.h"
#include "scree/body.h"
#include "scree/broad_phase_kind.h"
#include "scree/chain_shape.h"
#include "scree/contact.h"
#include "scree/draw.h"
#include "scree/errors.h"
#include "scree/events.h"
#include "scree/features.h"
#include "scree/fixture.h"
#include "scree/function_ref.h"
#include "scree/ids.h"
#include "scree/joint.h"
#include "scree/profile.h"
#include "scree/queries.h"
#include "scree/revolute_joint.h"
#include "scree/tasks.h"
#include "scree/world_callbacks.h"

namespace scree {

/// How constraints are solved.
enum class SolverKind : uint8_t {
    automatic,           ///< by the Step that is called
    sequentialImpulses,  ///< Box2D 2.4's: iterations on velocities, then on positions
    softStep,            ///< sub-steps with soft contacts
};

/// Knobs of the soft step; see the tables of engine/docs/settings.md before changing them.
struct SoftStepDef {
    /// Stiffness of contacts between two movers, 1/s, > 0; at most a quarter of the sub-steps' rate acts.
    float contactHertz = 30.0f;
    float contactDampingRatio = 10.0f;
    float contactPushSpeed = 1.0f;  ///< largest speed at which overlapping bodies are pushed apart, m/s
};

/// Input of World. Defaults are Box2D 2.4's, except that nothing caps speed.
struct WorldDef {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s²
    BroadPhaseKind broadPhase = BroadPhaseKind::automatic;
    /// Static fixtures get a tree of their own above this share of all fixtures, 0…1.
    float staticShareThreshold = 1.0f / 8.0f;
    bool allowSleep = true;
    bool warmStarting = true;
    /// Longest way a body may go in one step, m; longer ones are shortened and counted in StepReport::cappedCount.
    float maxTranslation = std::numeric_limits<float>::infinity();
    /// Largest turn of a body in one step, rad.
    float maxRotation = std::numeric_limits<float>::infinity();
    /// Nothing passes through static fixtures between two steps; bullets through nothing.
    bool continuousPhysics = true;
    /// A step ends after its first continuous event and the next Step resumes it: for debugging.
    bool subStepping = false;
    /// Positions advance by the mean of the velocities before and after a step instead of the one after: free flight is
    /// then exact, at any step size.
    bool exactDrift = false;
    /// Size of a typical moving body, m, 1e-6…1e6: the tolerances that are lengths or speeds (skin of polygons and
    /// edges, overlap left by the solver, gaps left in joints and the least length of a distance joint, the continuous
    /// collision's target, speed of pushing apart, speed of falling asleep, margin of `fat-tree`) are Box2D's times
    /// this. 1 suits bodies of 0.1 to 100 m; 0.001 a world of millimetres.
    float lengthScale = 1.0f;
    /// Once a body is farther than this from the origin in x or y, m at a length scale of 1, all positions of the world
    /// have a low-order part (Body::GetPositionRest), so that bodies behave there as they do near the origin; 16 bytes
    /// a body. 0: from the start; infinity: only once a program gives a rest (BodyDef::positionRest).
    float farDistance = 2048.0f;
    /// Which solver runs whatever Step is called: Step(dt, 8, 3) is taken for 4 sub-steps and the other way round.
    SolverKind solver = SolverKind::automatic;
    SoftStepDef softStep;
    /// Threads that share a step, the one that calls Step included, 1…maxWorkers. Results do not depend on it.
    int workerCount = 1;
    /// With callbacks the world makes no threads but hands its loops to the program's task system.
    TaskCallbacks tasks;
    /// What the world models. Results do not depend on it; steps are faster without what nobody uses.
    FeatureMode featureMode = FeatureMode::automatic;
    Features features = Features::All();  ///< of FeatureMode::fixed
};

struct WorldState;

class SCREE_API World {
public:
    /// A world of these settings. Of settings that cannot be there is no world: stderr gets one line with the field and
    /// the cure, and the constructor throws std::invalid_argument. CreateWorld, below, gives null instead.
    explicit World(Vec2 gravity);
    explicit World(const WorldDef& def);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Null and an error for bad input or while locked. O(1).
    Body* CreateBody(const BodyDef* def);
    /// Destroys a body with its fixtures, contacts and joints.
    ErrorCode DestroyBody(Body* body);
    Joint* CreateJoint(const JointDef* def);
    ErrorCode DestroyJoint(Joint* joint);

    /// Advances by `timeStep` seconds (≥ 0; below 1e-30 it only updates contacts) with sequential impulses. Box2D
    /// suggests 8 velocity and 3 position iterations at 1/60 s. Bad input: an error and an unchanged world.
    StepReport Step(float timeStep, int velocityIterations, int positionIterations);
    /// Advances by `timeStep` seconds in `substeps` ≥ 1 sub-steps with soft contacts: 4 for games, 8 for finer and 16
    /// for precise results at 1/60 s; at 4 about as fast as one pass of sequential impulses and far more accurate in
    /// stacks. Free bodies drift exactly. Bad input: an error and an unchanged world.
    StepReport Step(float timeStep, int substeps);
    /// Advances by `timeStep` seconds at a mark of the accuracy dial.
    StepReport Step(float timeStep, Accuracy accuracy);
    /// Advances by `timeStep` seconds by the soft step, each island in as many sub-steps as its errors of the last such
    /// step call for; StepReport tells the most of an island, the sum, and the errors that are left. Bad input: an
    /// error and an unchanged world.
    StepReport Step(float timeStep, const Tolerance& tolerance);
    [[nodiscard]] const StepReport& GetReport() const;
    /// What happened in the last step to the fixtures that report.
    [[nodiscard]] Events GetEvents() const;
    /// Blows slower than this are not reported, m/s; 1 at first. Refused: negative or not finite.
    ErrorCode SetHitSpeed(float speed);
    [[nodiscard]] float GetHitSpeed() const;
    /// Events tell which bodies were simulated, and which of them fell asleep. Off by default, and then free.
    void SetReportMoves(bool flag);
    [[nodiscard]] bool GetReportMoves() const;
    /// Every step ends with MeasureErrors and reports the result. Off by default, and then free.
    void SetMeasureErrors(bool flag);
    [[nodiscard]] bool GetMeasureErrors() const;
    /// How exact the last step left the world. O(contacts + joints).
    [[nodiscard]] StepErrors MeasureErrors() const;

    /// The listeners and the filter must outlive their use; null restores the default. Refused: a contact listener
    /// without Feature::events, a filter without Feature::filters.
    void SetDestructionListener(DestructionListener* listener);
    ErrorCode SetContactListener(ContactListener* listener);
    ErrorCode SetContactFilter(ContactFilter* filter);
    /// Acts on contacts that begin and materials that change from now on. It must outlive its use; null: the standard
    /// rule. Neither images nor recordings hold it.
    void SetMaterialMixer(MaterialMixer* mixer);
    /// Receives every refused call; null restores the default, which writes one line to stderr.
    void SetErrorHandler(ErrorHandler handler, void* context);

    /// Forces live until the end of the step; off: until ClearForces.
    void SetAutoClearForces(bool flag);
    [[nodiscard]] bool GetAutoClearForces() const;
    void ClearForces();
    ErrorCode SetGravity(Vec2 gravity);
    [[nodiscard]] Vec2 GetGravity() const;
    /// Turning sleep off wakes everything. Refused: turning it on without Feature::sleeping.
    ErrorCode SetAllowSleeping(bool flag);
    [[nodiscard]] bool GetAllowSleeping() const;
    void SetWarmStarting(bool flag);
    [[nodiscard]] bool GetWarmStarting() const;
    /// Refused: turning it on without the features that the world's fixtures and bullets would then use.
    ErrorCode SetContinuousPhysics(bool flag);
    [[nodiscard]] bool GetContinuousPhysics() const;
    void SetSubStepping(bool flag);
    [[nodiscard]] bool GetSubStepping() const;
    /// Changes WorldDef::workerCount and WorldDef::tasks, e.g. of a world that was loaded. Refused while locked.
    ErrorCode SetWorkers(int workerCount, const TaskCallbacks& tasks = {});
    [[nodiscard]] int GetWorkerCount() const;
    /// Changes WorldDef::featureMode and WorldDef::features, e.g. of a world that was loaded. Refused while locked, and
    /// if the world already uses what a fixed set does not have.
    ErrorCode SetFeatures(FeatureMode mode, Features features = Features::All());
    [[nodiscard]] FeatureMode GetFeatureMode() const;
    /// What calls on this world may use.
    [[nodiscard]] Features GetAllowedFeatures() const;
    /// The smallest set that contains what the world uses at the moment. O(objects).
    [[nodiscard]] Features GetRequiredFeatures() const;
    /// How many objects use each. O(objects).
    [[nodiscard]] FeatureUsers GetFeatureUsers() const;
    void SetExactDrift(bool flag);
    [[nodiscard]] bool GetExactDrift() const;
    /// Subtracts `newOrigin` from every position: for programs that draw near their origin. Refused while locked.
    ErrorCode ShiftOrigin(Vec2 newOrigin);
    /// Gives back what past steps needed and this one does not: scratch, and room for more rows. No result changes; the
    /// next step makes its scratch anew. Refused while locked.
    ErrorCode TrimMemory();
    /// True inside Step, and in callbacks of queries and of destruction.
    [[nodiscard]] bool IsLocked() const;

    /// Lists: movers first, then static bodies; newest first in each.
    [[nodiscard]] Body* GetBodyList();
    [[nodiscard]] const Body* GetBodyList() const;
    [[nodiscard]] Joint* GetJointList();
    [[nodiscard]] const Joint* GetJointList() const;
    [[nodiscard]] Contact* GetContactList();
    [[nodiscard]] const Contact* GetContactList() const;
    [[nodiscard]] int GetBodyCount() const;
    [[nodiscard]] int GetJointCount() const;
    [[nodiscard]] int GetContactCount() const;
    [[nodiscard]] int GetFixtureCount() const;
    [[nodiscard]] int GetProxyCount() const;
    /// Of the broad phase's tree, static and moving part joined under one root; 0 without a tree. Height: levels below
    /// the root. Balance: largest difference in height of two siblings. Quality: all perimeters over the root's, best
    /// near 1. O(fixtures). They make the tree if it is out of date: for one thread at a time.
    [[nodiscard]] int GetTreeHeight() const;
    [[nodiscard]] int GetTreeBalance() const;
    [[nodiscard]] float GetTreeQuality() const;
    /// Wall times of the last step.
    [[nodiscard]] const Profile& GetProfile() const;

    /// An id that stays meaningful after the object dies; the default id for null, dead or foreign handles.
    [[nodiscard]] BodyId GetId(const Body* body) const;
    [[nodiscard]] FixtureId GetId(const Fixture* fixture) const;
    [[nodiscard]] JointId GetId(const Joint* joint) const;
    /// Ids of contacts mean nothing in a world that was loaded from an image.
    [[nodiscard]] ContactId GetId(const Contact* contact) const;
    /// The object, or null if it is gone, even when its slot is used again.
    [[nodiscard]] Body* Find(BodyId id);
    [[nodiscard]] Fixture* Find(FixtureId id);
    [[nodiscard]] Joint* Find(JointId id);
    [[nodiscard]] Contact* Find(ContactId id);

    /// Queries only read: between steps any number of threads may ask at once, while nobody edits or steps the world
    /// and no error is to be told. So do all calls that only tell something of the world and its bodies, fixtures,
    /// contacts and joints, lists, visits and ids included; but not GetTreeHeight and its kind, nor Fixture::GetShape
    /// of a fixture that is not const. The world is locked while a query calls the program. After a step queries take
    /// logarithmic time; after many edits without one (a level just made), until PrepareQueries, they look at every
    /// box.
    ErrorCode PrepareQueries();
    /// Calls visit(fixture) for every fixture whose broad-phase box overlaps `aabb`, until it returns false.
    ErrorCode QueryAABB(const AABB& aabb, FunctionRef<bool(Fixture*)> visit) const;
    /// Calls visit(fixture, point, normal, fraction) for fixtures that the ray p1→p2 hits, in no particular order. It
    /// returns −1 to ignore the fixture, 0 to stop, the fraction to shorten the ray, 1 to go on.
    ErrorCode RayCast(Vec2 p1, Vec2 p2, FunctionRef<float(Fixture*, Vec2, Vec2, float)> visit) const;
    /// The same with Box2D's callback classes.
    ErrorCode QueryAABB(QueryCallback* callback, const AABB& aabb) const;
    ErrorCode RayCast(RayCastCallback* callback, Vec2 p1, Vec2 p2) const;
    /// The first fixture on the ray; none for bad input too.
    std::optional<RayHit> RayCastClosest(Vec2 p1, Vec2 p2, const QueryFilter& filter = {}) const;
    /// All fixtures on the ray, nearest first. `hits` is overwritten.
    ErrorCode RayCastAll(Vec2 p1, Vec2 p2, std::vector<RayHit>& hits, const QueryFilter& filter = {}) const;
    /// Calls visit(fixture) for every fixture that contains the point, until it returns false.
    ErrorCode QueryPoint(Vec2 point, FunctionRef<bool(Fixture*)> visit, const QueryFilter& filter = {}) const;
    /// Calls visit(fixture) for every fixture that overlaps `shape` placed at `xf` (no chain), until it returns false.
    ErrorCode OverlapShape(const Shape& shape, const Transform& xf, FunctionRef<bool(Fixture*)> visit,
                           const QueryFilter& filter = {}) const;
    /// All fixtures that `shape` (no chain) meets on its way from `xf` by `translation`, without turning, each as if it
    /// were alone; first met first. `hits` is overwritten.
    ErrorCode ShapeCast(const Shape& shape, const Transform& xf, Vec2 translation, std::vector<ShapeHit>& hits,
                        const QueryFilter& filter = {}) const;
    /// The first of them; none for bad input too.
    std::optional<ShapeHit> ShapeCastClosest(const Shape& shape, const Transform& xf, Vec2 translation,
                                             const QueryFilter& filter = {}) const;

    /// Who draws in DebugDraw; must outlive its use; null: nobody.
    void SetDebugDraw(Draw* draw);
    /// Shows the world as the drawer's flags say, in Box2D 2.4's order and colours.
    void DebugDraw();

    /// The tables behind the handles, for inspect.h.
    [[nodiscard]] WorldState& GetState() { return *m_state; }
    [[nodiscard]] const WorldState& GetState() const { return *m_state; }

private:
    std::unique_ptr<WorldState> m_state;
};

/// Makes a world. Of settings that cannot be there is none: null, and the handler hears the field and the cure. It
/// becomes the world's (World::SetErrorHandler; null: one line on stderr).
[[nodiscard]] SCREE_API std::unique_ptr<World> CreateWorld(const WorldDef& def, ErrorHandler handler = nullptr,
                                                           void* context = nullptr);

}  // namespace scree
