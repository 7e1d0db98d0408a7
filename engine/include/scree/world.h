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
    automatic,           ///< the one that belongs to the Step that is called
    sequentialImpulses,  ///< Box2D 2.4's: iterations on velocities, then on positions
    softStep,            ///< sub-steps with soft contacts
};

/// Knobs of the soft step; see the tables of engine/docs/settings.md before changing them.
struct SoftStepDef {
    /// Stiffness of contacts between two dynamic bodies, 1/s, > 0; limited to a quarter of the rate of sub-steps.
    float contactHertz = 30.0f;
    float contactDampingRatio = 10.0f;
    float contactPushSpeed = 1.0f;  ///< largest speed at which overlapping bodies are pushed apart, m/s
};

/// Input of World. Defaults are Box2D 2.4's, except that nothing limits speed.
struct WorldDef {
    Vec2 gravity{0.0f, -10.0f};  ///< m/s²
    BroadPhaseKind broadPhase = BroadPhaseKind::automatic;
    /// Static fixtures get a tree of their own above this share of all fixtures, 0…1.
    float staticShareThreshold = 1.0f / 8.0f;
    bool allowSleep = true;
    bool warmStarting = true;
    /// Longest translation of a body in a step, m; a longer one is cut and counted in StepReport::cappedCount.
    float maxTranslation = std::numeric_limits<float>::infinity();
    /// Largest rotation of a body in a step, rad; also counted in StepReport::cappedCount.
    float maxRotation = std::numeric_limits<float>::infinity();
    /// Bodies do not pass through static and kinematic fixtures within a step; bullets do not pass through anything.
    bool continuousPhysics = true;
    /// For debugging: a step ends after its first continuous event, and the next Step resumes it.
    bool subStepping = false;
    /// For sequential impulses: positions advance by the mean of the velocities before and after a step instead of the
    /// one after. Free flight is then exact with any time step.
    bool exactDrift = false;
    /// Size of a typical moving body, m, 1e-6…1e6. It multiplies the tolerances that are lengths: the skin of
    /// polygons and edges, remaining overlap and joint gaps, the least length of a distance joint, the target of
    /// continuous collision. Also the speeds of pushing apart and of falling asleep, and the margin of `fat-tree`.
    /// 1 suits bodies of 0.1 to 100 m, 0.001 a world of millimetres.
    float lengthScale = 1.0f;
    /// If a body is farther than this from the origin in x or y, m at length scale 1, all positions of its world
    /// have a low-order part (Body::GetPositionRest). Bodies then behave there as they do near the origin, for 16 bytes
    /// each. 0: from the start; infinity: only once the program sets a rest (BodyDef::positionRest).
    float farDistance = 2048.0f;
    /// Which solver runs, whichever Step is called: Step(dt, 8, 3) then means 4 sub-steps, and the other way round.
    SolverKind solver = SolverKind::automatic;
    SoftStepDef softStep;
    /// Threads that share a step, including the one that calls Step, 1…maxWorkers. Results do not depend on it.
    int workerCount = 1;
    /// With callbacks, the world creates no threads and gives its loops to the program's task system.
    TaskCallbacks tasks;
    /// Which features have code in a step. Results do not depend on it; steps are faster without unused features.
    FeatureMode featureMode = FeatureMode::automatic;
    Features features = Features::All();  ///< of FeatureMode::fixed
};

struct WorldState;

class SCREE_API World {
public:
    /// Creates a world. If a setting is out of range, the constructor writes one line to stderr that names the field
    /// and the allowed values, and throws std::invalid_argument. CreateWorld, below, returns null instead.
    explicit World(Vec2 gravity);
    explicit World(const WorldDef& def);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Returns null and reports an error for bad input or while the world is locked. O(1).
    Body* CreateBody(const BodyDef* def);
    /// Destroys a body with its fixtures, contacts and joints.
    ErrorCode DestroyBody(Body* body);
    Joint* CreateJoint(const JointDef* def);
    ErrorCode DestroyJoint(Joint* joint);

    /// Advances by `timeStep` seconds (≥ 0; below 1e-30 it only updates contacts) with sequential impulses. Box2D
    /// suggests 8 velocity and 3 position iterations at 1/60 s. Bad input is reported and leaves the world unchanged.
    StepReport Step(float timeStep, int velocityIterations, int positionIterations);
    /// Advances by `timeStep` seconds in `substeps` ≥ 1 sub-steps with soft contacts. At 1/60 s, 4 are for games, 8 for
    /// finer and 16 for precise results. 4 cost about as much as 8/3 sequential impulses, and are far more accurate in
    /// stacks. Free flight is exact. Bad input is reported and leaves the world unchanged.
    StepReport Step(float timeStep, int substeps);
    /// Advances by `timeStep` seconds with a named accuracy, from draft to precise.
    StepReport Step(float timeStep, Accuracy accuracy);
    /// Advances by `timeStep` seconds by the soft step. Each island gets as many sub-steps as its errors in the last
    /// such step require. StepReport has the most sub-steps of an island, their sum, and the remaining errors. Bad
    /// input is reported and leaves the world unchanged.
    StepReport Step(float timeStep, const Tolerance& tolerance);
    [[nodiscard]] const StepReport& GetReport() const;
    /// What happened in the last step. Fixtures take part as far as they report (FixtureDef::reports).
    [[nodiscard]] Events GetEvents() const;
    /// Hits with a lower approach speed are not reported, m/s; 1 by default. Refused: negative, NaN or infinite.
    ErrorCode SetHitSpeed(float speed);
    [[nodiscard]] float GetHitSpeed() const;
    /// Events then contain the bodies that were simulated, and whether they fell asleep. Off by default, at no cost.
    void SetReportMoves(bool flag);
    [[nodiscard]] bool GetReportMoves() const;
    /// Every step then ends with MeasureErrors, and its report has the result. Off by default, at no cost.
    void SetMeasureErrors(bool flag);
    [[nodiscard]] bool GetMeasureErrors() const;
    /// The errors that the last step left: deepest overlap, widest joint gap, residual. O(contacts + joints).
    [[nodiscard]] StepErrors MeasureErrors() const;

    /// Listeners and filter must live as long as the world uses them; null restores the default. Refused: a contact
    /// listener without Feature::events, a filter without Feature::filters.
    void SetDestructionListener(DestructionListener* listener);
    ErrorCode SetContactListener(ContactListener* listener);
    ErrorCode SetContactFilter(ContactFilter* filter);
    /// Acts on contacts that begin and materials that change from now on. It must live as long as the world uses it;
    /// null restores the standard rule. Images and recordings do not contain it.
    void SetMaterialMixer(MaterialMixer* mixer);
    /// Receives every refused call; null restores the default, which writes one line to stderr.
    void SetErrorHandler(ErrorHandler handler, void* context);

    /// On (default): forces are cleared at the end of a step. Off: they act until ClearForces.
    void SetAutoClearForces(bool flag);
    [[nodiscard]] bool GetAutoClearForces() const;
    void ClearForces();
    ErrorCode SetGravity(Vec2 gravity);
    [[nodiscard]] Vec2 GetGravity() const;
    /// Switching sleep off wakes all bodies. Refused: switching it on without Feature::sleeping.
    ErrorCode SetAllowSleeping(bool flag);
    [[nodiscard]] bool GetAllowSleeping() const;
    void SetWarmStarting(bool flag);
    [[nodiscard]] bool GetWarmStarting() const;
    /// Refused: switching it on without the features that the world's fixtures and bullets would then use.
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
    /// Frees memory that is not in use: scratch of past steps, and spare rows of tables. No result changes; the next
    /// step allocates its scratch again. Refused while locked.
    ErrorCode TrimMemory();
    /// True inside Step, and in callbacks of queries and of destruction.
    [[nodiscard]] bool IsLocked() const;

    /// Bodies that can move come first, then static ones; in each group the last that came into it first. See
    /// Body::GetNext.
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
    /// Statistics of the broad phase's tree, static and moving part joined under one root; 0 without a tree. Height:
    /// levels below the root. Balance: largest difference in height of two siblings. Quality: sum of all perimeters
    /// over the root's, best near 1. O(fixtures). They may rebuild the tree, so only one thread may call them at once.
    [[nodiscard]] int GetTreeHeight() const;
    [[nodiscard]] int GetTreeBalance() const;
    [[nodiscard]] float GetTreeQuality() const;
    /// Wall times of the last step.
    [[nodiscard]] const Profile& GetProfile() const;

    /// An id, by which Find tells whether the object still exists; the default id for null, dead or foreign handles.
    [[nodiscard]] BodyId GetId(const Body* body) const;
    [[nodiscard]] FixtureId GetId(const Fixture* fixture) const;
    [[nodiscard]] JointId GetId(const Joint* joint) const;
    /// Ids of contacts mean nothing in a world that was loaded from an image.
    [[nodiscard]] ContactId GetId(const Contact* contact) const;
    /// The object, or null if it was destroyed, also when another object has taken its place.
    [[nodiscard]] Body* Find(BodyId id);
    [[nodiscard]] Fixture* Find(FixtureId id);
    [[nodiscard]] Joint* Find(JointId id);
    [[nodiscard]] Contact* Find(ContactId id);

    /// Makes queries fast after many changes without a step, such as a level that was just created. Until then, queries
    /// look at every box; after this call or a step they take logarithmic time. Queries only read: between steps any
    /// number of threads may call them at once, as long as none changes or steps the world and no error is reported.
    /// The same holds for all calls that change nothing, including lists, visits and ids. Not safe are the tree
    /// statistics, such as GetTreeHeight, and the non-const Fixture::GetShape. The world is locked while a query calls
    /// the program.
    ErrorCode PrepareQueries();
    /// Calls visit(fixture) for every fixture whose broad-phase box overlaps `aabb`, until it returns false.
    ErrorCode QueryAABB(const AABB& aabb, FunctionRef<bool(Fixture*)> visit) const;
    /// Calls visit(fixture, point, normal, fraction) for fixtures that the ray p1→p2 hits, in no particular order. It
    /// returns −1 to ignore the fixture, 0 to stop, the fraction to shorten the ray, 1 to continue.
    ErrorCode RayCast(Vec2 p1, Vec2 p2, FunctionRef<float(Fixture*, Vec2, Vec2, float)> visit) const;
    /// The same with Box2D's callback classes.
    ErrorCode QueryAABB(QueryCallback* callback, const AABB& aabb) const;
    ErrorCode RayCast(RayCastCallback* callback, Vec2 p1, Vec2 p2) const;
    /// The first fixture on the ray; none also for bad input.
    std::optional<RayHit> RayCastClosest(Vec2 p1, Vec2 p2, const QueryFilter& filter = {}) const;
    /// All fixtures on the ray, nearest first. `hits` is overwritten.
    ErrorCode RayCastAll(Vec2 p1, Vec2 p2, std::vector<RayHit>& hits, const QueryFilter& filter = {}) const;
    /// Calls visit(fixture) for every fixture that contains the point, until it returns false.
    ErrorCode QueryPoint(Vec2 point, FunctionRef<bool(Fixture*)> visit, const QueryFilter& filter = {}) const;
    /// Calls visit(fixture) for every fixture that overlaps `shape` placed at `xf` (no chain), until it returns false.
    ErrorCode OverlapShape(const Shape& shape, const Transform& xf, FunctionRef<bool(Fixture*)> visit,
                           const QueryFilter& filter = {}) const;
    /// All fixtures that `shape` (no chain) would hit when it moves from `xf` by `translation` without turning, each as
    /// if it were alone, in the order of their fractions. `hits` is overwritten.
    ErrorCode ShapeCast(const Shape& shape, const Transform& xf, Vec2 translation, std::vector<ShapeHit>& hits,
                        const QueryFilter& filter = {}) const;
    /// The first of them; none also for bad input.
    std::optional<ShapeHit> ShapeCastClosest(const Shape& shape, const Transform& xf, Vec2 translation,
                                             const QueryFilter& filter = {}) const;

    /// What DebugDraw calls; must live as long as it is used. Null: nothing.
    void SetDebugDraw(Draw* draw);
    /// Draws the world as the flags of the Draw say, in Box2D 2.4's order and colours.
    void DebugDraw();

    /// The tables behind the handles, for inspect.h.
    [[nodiscard]] WorldState& GetState() { return *m_state; }
    [[nodiscard]] const WorldState& GetState() const { return *m_state; }

private:
    std::unique_ptr<WorldState> m_state;
};

/// Creates a world. If a setting is out of range, returns null and tells the handler the field and the allowed values.
/// The handler becomes that of the world (World::SetErrorHandler); null writes one line to stderr.
[[nodiscard]] SCREE_API std::unique_ptr<World> CreateWorld(const WorldDef& def, ErrorHandler handler = nullptr,
                                                           void* context = nullptr);

}  // namespace scree
