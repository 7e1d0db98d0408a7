// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The world object: creation and destruction, settings, lists. Queries and drawing have files of their own.

#include "scree/world.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "base/compiler.h"
#include "pipeline/measure_errors.h"
#include "world/guard.h"
#include "world/joints/joint_definitions.h"
#include "world/refresh.h"

namespace scree {

namespace {

void WriteError(const Error& error, void*) {
    std::fprintf(stderr, "scree: %s: %s: %s; %s\n", error.function, error.field, GetName(error.code), error.cure);
}

/// Which of these features bodies and fixtures would use, were all settings on.
Features UsedIn(const WorldState& s, Features features) { return s.featureCounts.used & features; }

}  // namespace

ErrorCode WorldState::Refuse(ErrorCode code, const char* function, const char* field, const char* cure) const {
    const Error error{code, function, field, cure};
    (errorHandler != nullptr ? errorHandler : WriteError)(error, errorContext);
    return code;
}

void WorldState::MakePool() {
    pool = std::make_unique<TaskPool>(def.workerCount, def.tasks);
    broadPhase->ShareWork(*pool);
}

World::World(Vec2 gravity)
    : World([&] {
          WorldDef def;
          def.gravity = gravity;
          return def;
      }()) {}

World::World(const WorldDef& def) : m_state(std::make_unique<WorldState>()) {
    WorldState& s = *m_state;
    s.world = this;
    if (const Finding bad = Check(def)) {
        s.Refuse(bad.code, "World::World", bad.field, bad.cure);
#if defined(SCREE_HAS_EXCEPTIONS)
        throw std::invalid_argument(std::string("scree: World::World: ") + bad.field + ": " + bad.cure);
#else
        std::abort();
#endif
    }
    s.def = def;
    s.broadPhaseKind = s.def.broadPhase == BroadPhaseKind::automatic ? BroadPhaseKind::keys : s.def.broadPhase;
    s.broadPhase = CreateBroadPhase(
        s.broadPhaseKind, {.staticShareThreshold = s.def.staticShareThreshold, .lengthScale = s.def.lengthScale});
    s.MakePool();
}

World::~World() = default;

std::unique_ptr<World> CreateWorld(const WorldDef& def, ErrorHandler handler, void* context) {
    if (const Finding bad = Check(def)) {
        (handler != nullptr ? handler : WriteError)({bad.code, "CreateWorld", bad.field, bad.cure}, context);
        return nullptr;
    }
    auto world = std::make_unique<World>(def);
    world->SetErrorHandler(handler, context);
    return world;
}

Body* World::CreateBody(const BodyDef* def) {
    WorldState& s = *m_state;
    const char* name = "World::CreateBody";
    if (def == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "def", "pass a BodyDef"), nullptr;
    if (s.IsLocked()) return s.Refuse(ErrorCode::locked, name, "world", "create bodies outside of Step"), nullptr;
    if (const Finding bad = Check(*def)) return s.Refuse(bad.code, name, bad.field, bad.cure), nullptr;
    const bool sleeps = !def->awake && def->type != staticBody;  // whatever the world allows
    const Features used = UnderSettings(FeaturesOf(*def), s.def).Add(Feature::sleeping, sleeps);
    if (Guard(s, name).Uses(used).Failed()) return nullptr;
    const Recording recording(s, name, *def);
    NotePosition(s, def->position, def->positionRest);
    const BodyIndex index = s.bodies.Add(&s, *def);
    AddBodyFeatures(s, index, 1);
    return &s.bodies.handles[index];
}

ErrorCode World::DestroyBody(Body* body) {
    WorldState& s = *m_state;
    const char* name = "World::DestroyBody";
    if (body == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "body", "pass a body");
    if (!Owns(s, body)) return s.Refuse(ErrorCode::foreignHandle, name, "body", "pass a living body of this world");
    if (s.IsLocked()) return s.Refuse(ErrorCode::locked, name, "world", "destroy bodies outside of Step");
    const BodyIndex index = IndexOf(*body);
    const Recording recording(s, name, index);
    for (JointIndex j = s.joints.OfBody(index).Front(); IsSome(j); j = s.joints.OfBody(index).Front()) {
        Joint* joint = s.joints.handles[j];
        SayGoodbye(s, joint);
        DestroyJoint(joint);
    }
    DestroyContactsOfBody(s, index);
    FixtureIndex& head = s.bodies.fixtureHead[index];
    while (IsSome(head)) {
        const FixtureIndex fixture = head;
        SayGoodbye(s, &s.fixtures.handles[fixture]);
        RemoveProxy(s, fixture);
        head = s.fixtures.next[fixture];
        --s.bodies.info[index].fixtureCount;
        AddFixtureFeatures(s, fixture, -1);
        s.fixtures.Remove(fixture);
    }
    AddBodyFeatures(s, index, -1);
    s.bodies.Remove(index);
    return ErrorCode::ok;
}

Joint* World::CreateJoint(const JointDef* def) {
    WorldState& s = *m_state;
    const char* name = "World::CreateJoint";
    if (def == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "def", "pass a joint definition"), nullptr;
    if (s.IsLocked()) return s.Refuse(ErrorCode::locked, name, "world", "create joints outside of Step"), nullptr;
    return AddJoint(s, *def);
}

ErrorCode World::DestroyJoint(Joint* joint) {
    WorldState& s = *m_state;
    const char* name = "World::DestroyJoint";
    if (joint == nullptr) return s.Refuse(ErrorCode::nullArgument, name, "joint", "pass a joint");
    if (!Owns(s, joint)) return s.Refuse(ErrorCode::foreignHandle, name, "joint", "pass a living joint of this world");
    if (s.IsLocked()) return s.Refuse(ErrorCode::locked, name, "world", "destroy joints outside of Step");
    const JointIndex index = IndexOf(*joint);
    const Recording recording(s, name, index);
    RemoveJointWithGears(s, index);
    return ErrorCode::ok;
}

const StepReport& World::GetReport() const { return m_state->report; }
const Profile& World::GetProfile() const { return m_state->report.profile; }

void World::SetDestructionListener(DestructionListener* listener) { m_state->destructionListener = listener; }
ErrorCode World::SetContactListener(ContactListener* listener) {
    Guard guard(*m_state, "World::SetContactListener");
    if (listener != nullptr && guard.Uses({Feature::events}).Failed()) return guard.Code();
    m_state->listener = listener;
    if (listener != nullptr) m_state->heard = FindHeardCalls(*listener);
    return ErrorCode::ok;
}

Events World::GetEvents() const { return m_state->log.Get(); }

ErrorCode World::SetHitSpeed(float speed) {
    Guard guard(*m_state, "World::SetHitSpeed");
    if (guard.Amount(speed, "speed").Failed()) return guard.Code();
    m_state->log.hitSpeed = speed;
    return ErrorCode::ok;
}
float World::GetHitSpeed() const { return m_state->log.hitSpeed; }

void World::SetReportMoves(bool flag) { m_state->log.reportsMoves = flag; }
bool World::GetReportMoves() const { return m_state->log.reportsMoves; }

ErrorCode World::SetContactFilter(ContactFilter* filter) {
    Guard guard(*m_state, "World::SetContactFilter");
    if (filter != nullptr && guard.Uses({Feature::filters}).Failed()) return guard.Code();
    m_state->filter = filter;
    m_state->contacts.refused.Clear();
    m_state->contacts.filtersAgree = false;
    // The coming step asks it about all pairs without a contact.
    m_state->contacts.mustMatch = true;
    for (const BodyIndex body : m_state->bodies.movers) m_state->bodies.List(body);
    return ErrorCode::ok;
}

void World::SetMaterialMixer(MaterialMixer* mixer) { m_state->mixer = mixer; }

void World::SetErrorHandler(ErrorHandler handler, void* context) {
    m_state->errorHandler = handler;
    m_state->errorContext = context;
}

void World::SetAutoClearForces(bool flag) {
    const Recording recording(Changes::motion, *m_state, "World::SetAutoClearForces", flag);
    m_state->autoClearForces = flag;
}
bool World::GetAutoClearForces() const { return m_state->autoClearForces; }

void World::ClearForces() {
    const Recording recording(Changes::motion, *m_state, "World::ClearForces");
    if (!m_state->featureCounts.forces && GetFeatureMode() != FeatureMode::full) return;  // they are zero
    for (const BodyIndex body : m_state->bodies.Listed()) m_state->bodies.ClearForce(body);
    m_state->featureCounts.forces = false;
}

ErrorCode World::SetGravity(Vec2 gravity) {
    if (!gravity.IsValid())
        return m_state->Refuse(ErrorCode::nonFinite, "World::SetGravity", "gravity", "give a finite vector");
    const Recording recording(*m_state, "World::SetGravity", gravity);
    m_state->def.gravity = gravity;
    return ErrorCode::ok;
}
Vec2 World::GetGravity() const { return m_state->def.gravity; }

ErrorCode World::SetAllowSleeping(bool flag) {
    if (m_state->def.allowSleep == flag) return ErrorCode::ok;
    Guard guard(*m_state, "World::SetAllowSleeping");
    if (flag && guard.Uses(UsedIn(*m_state, {Feature::sleeping})).Failed()) return guard.Code();
    const Recording recording = guard.Record(flag);
    m_state->def.allowSleep = flag;
    if (flag) return ErrorCode::ok;
    for (const BodyIndex body : m_state->bodies.movers) m_state->bodies.Wake(body);
    return ErrorCode::ok;
}
bool World::GetAllowSleeping() const { return m_state->def.allowSleep; }

void World::SetWarmStarting(bool flag) {
    const Recording recording(*m_state, "World::SetWarmStarting", flag);
    m_state->def.warmStarting = flag;
}
bool World::GetWarmStarting() const { return m_state->def.warmStarting; }
ErrorCode World::SetContinuousPhysics(bool flag) {
    Guard guard(*m_state, "World::SetContinuousPhysics");
    if (flag) guard.Uses(UsedIn(*m_state, {Feature::continuousStatic, Feature::continuousBullet}));
    if (guard.Failed()) return guard.Code();
    const Recording recording = guard.Record(flag);
    m_state->def.continuousPhysics = flag;
    return ErrorCode::ok;
}
bool World::GetContinuousPhysics() const { return m_state->def.continuousPhysics; }
void World::SetSubStepping(bool flag) {
    const Recording recording(*m_state, "World::SetSubStepping", flag);
    m_state->def.subStepping = flag;
}
bool World::GetSubStepping() const { return m_state->def.subStepping; }
void World::SetExactDrift(bool flag) {
    const Recording recording(*m_state, "World::SetExactDrift", flag);
    m_state->def.exactDrift = flag;
}
ErrorCode World::SetWorkers(int workerCount, const TaskCallbacks& tasks) {
    WorldState& s = *m_state;
    Guard guard(s, "World::SetWorkers");
    guard.Unlocked("change workers outside of Step and callbacks");
    WorldDef def = s.def;
    def.workerCount = workerCount;
    def.tasks = tasks;
    if (guard.Accept(Check(def)).Failed()) return guard.Code();
    s.def = def;
    s.MakePool();
    return ErrorCode::ok;
}
int World::GetWorkerCount() const { return m_state->def.workerCount; }
ErrorCode World::SetFeatures(FeatureMode mode, Features features) {
    WorldState& s = *m_state;
    Guard guard(s, "World::SetFeatures");
    guard.Unlocked("change features outside of Step and callbacks");
    WorldDef def = s.def;
    def.featureMode = mode;
    def.features = features;
    guard.Accept(Check(def));
    if (guard.Failed()) return guard.Code();
    const Features missing = GetRequiredFeatures() - AllowedFeatures(def);
    if (!missing.IsEmpty())
        return s.Refuse(ErrorCode::missingFeature, "World::SetFeatures", GetName(missing.First()),
                        "add it to the set: the world uses it");
    s.def = def;
    return ErrorCode::ok;
}
FeatureMode World::GetFeatureMode() const { return m_state->def.featureMode; }
Features World::GetAllowedFeatures() const { return AllowedFeatures(m_state->def); }
FeatureUsers World::GetFeatureUsers() const { return CountFeatureUsers(*m_state); }
Features World::GetRequiredFeatures() const { return UsedOf(GetFeatureUsers()); }
void World::SetMeasureErrors(bool flag) { m_state->measureErrors = flag; }
bool World::GetMeasureErrors() const { return m_state->measureErrors; }
StepErrors World::MeasureErrors() const {
    const WorldState& s = *m_state;
    const float dt = s.lastInverseDt > 0.0f ? 1.0f / s.lastInverseDt : 0.0f;
    return scree::MeasureErrors({s.bodies, s.fixtures, s.contacts, s.joints}, linearSlop * s.def.lengthScale, dt);
}
ErrorCode World::TrimMemory() {
    WorldState& s = *m_state;
    Guard guard(s, "World::TrimMemory");
    if (guard.Unlocked("give memory back outside of Step and callbacks").Failed()) return guard.Code();
    s.solverScratch.Trim();
    s.restScratches = RestScratches{};
    s.islandScratch = {};
    s.narrowPhaseScratch = {};
    s.islands = {};
    s.active = {};
    s.substepGroups = {};
    if (!s.continuousScratch.resuming) {
        NearStatics near = s.continuousScratch.nearStatics;  // remembers whether it may be used
        near.Trim();
        s.continuousScratch = {};
        s.continuousScratch.nearStatics = near;
    }
    s.pairs.shrink_to_fit();
    s.editedPairs.shrink_to_fit();
    s.contacts.Trim();
    return ErrorCode::ok;
}

bool World::GetExactDrift() const { return m_state->def.exactDrift; }
bool World::IsLocked() const { return m_state->IsLocked(); }

Body* World::GetBodyList() {
    const BodyIndex head = m_state->bodies.listHead;
    return IsNone(head) ? nullptr : &m_state->bodies.handles[head];
}
const Body* World::GetBodyList() const { return const_cast<World*>(this)->GetBodyList(); }

Joint* World::GetJointList() {
    const JointIndex head = m_state->joints.listHead;
    return IsNone(head) ? nullptr : m_state->joints.handles[head];
}
const Joint* World::GetJointList() const { return const_cast<World*>(this)->GetJointList(); }

Contact* World::GetContactList() {
    ContactTable& contacts = m_state->contacts;
    const ContactIndex last = contacts.LastAliveBelow(contacts.flags.End());
    return IsSome(last) ? contacts.Handle(m_state.get(), last) : nullptr;
}
const Contact* World::GetContactList() const { return const_cast<World*>(this)->GetContactList(); }

int World::GetBodyCount() const { return m_state->bodies.slots.Count(); }
int World::GetJointCount() const { return m_state->joints.slots.Count(); }
int World::GetContactCount() const { return m_state->contacts.Count(); }
int World::GetFixtureCount() const { return m_state->fixtures.slots.Count(); }
int World::GetProxyCount() const { return m_state->broadPhase->GetProxyCount(); }

float MaterialMixer::MixFriction(const Fixture* fixtureA, const Fixture* fixtureB) {
    return scree::MixFriction(fixtureA->GetFriction(), fixtureB->GetFriction());
}
float MaterialMixer::MixRestitution(const Fixture* fixtureA, const Fixture* fixtureB) {
    return scree::MixRestitution(fixtureA->GetRestitution(), fixtureB->GetRestitution());
}

bool ContactFilter::ShouldCollide(Fixture* fixtureA, Fixture* fixtureB) {
    return scree::ShouldCollide(fixtureA->GetFilterData(), fixtureB->GetFilterData());
}

}  // namespace scree
