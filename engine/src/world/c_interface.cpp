// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// scree/scree_c.h over the interface in C++: ids become handles and back, and arrays are the world's own.

#include "scree/scree_c.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"
#include "world/world_state.h"

struct scree_world {
    std::unique_ptr<scree::World> world;
    scree_refusal last{SCREE_OK, "", "", ""};

    /// For a call that has refused an id itself.
    scree_error Refuse(const char* function, const char* field) {
        last = {SCREE_FOREIGN_HANDLE, function, field, "use an id of this world whose object was not destroyed"};
        return last.code;
    }
};

namespace {

static_assert(static_cast<int>(SCREE_LOCKED) == static_cast<int>(scree::ErrorCode::locked));
static_assert(static_cast<int>(SCREE_DYNAMIC) == static_cast<int>(scree::dynamicBody));

/// Arrays are handed on as they are.
template <typename C, typename Cpp>
const C* AsC(const Cpp* rows) {
    static_assert(sizeof(C) == sizeof(Cpp) && alignof(C) <= alignof(Cpp) && std::is_trivially_copyable_v<Cpp>);
    return reinterpret_cast<const C*>(rows);
}

scree::Vec2 FromC(scree_vec2 v) { return {v.x, v.y}; }
scree_vec2 ToC(scree::Vec2 v) { return {v.x, v.y}; }
scree_error ToC(scree::ErrorCode code) { return static_cast<scree_error>(code); }
template <typename Cpp, typename C>
Cpp IdFrom(C id) {
    return {id.index, id.generation};
}
scree::Body* Find(const scree_world& w, scree_body id) { return w.world->Find(IdFrom<scree::BodyId>(id)); }

void Note(const scree::Error& error, void* context) {
    *static_cast<scree_refusal*>(context) = {ToC(error.code), error.function, error.field, error.cure};
}

scree_fixture IdOf(const scree_world& w, const scree::Fixture* fixture) {
    const scree::FixtureId id = w.world->GetId(fixture);
    return {id.index, id.generation};
}
scree_body IdOf(const scree_world& w, const scree::Body* body) {
    const scree::BodyId id = w.world->GetId(body);
    return {id.index, id.generation};
}

/// Calls `act` with the body, or refuses.
template <typename Act>
scree_error WithBody(scree_world* w, scree_body id, const char* function, Act&& act) {
    scree::Body* body = Find(*w, id);
    return body == nullptr ? w->Refuse(function, "body") : ToC(act(*body));
}

scree_fixture Add(scree_world* w, scree_body id, const scree_fixture_def* given, const scree::Shape& shape) {
    scree::Body* body = Find(*w, id);
    if (body == nullptr) {
        w->Refuse("scree_add", "body");
        return {-1, 0};
    }
    const scree_fixture_def from = given != nullptr ? *given : scree_default_fixture();
    scree::FixtureDef def;
    def.shape = &shape;
    def.density = from.density;
    def.friction = from.friction;
    def.restitution = from.restitution;
    def.isSensor = from.is_sensor != 0;
    def.filter = {from.category_bits, from.mask_bits, from.group_index};
    def.reports = static_cast<uint8_t>((from.reports_contacts != 0 ? scree::Report::contacts : 0) |
                                       (from.reports_hits != 0 ? scree::Report::hits : 0));
    return IdOf(*w, body->CreateFixture(&def));
}

/// Points as ours; nothing for no points or too few.
std::vector<scree::Vec2> Points(const scree_vec2* points, int32_t count) {
    std::vector<scree::Vec2> out;
    if (points == nullptr) return out;
    for (int32_t i = 0; i < count; ++i) out.push_back(FromC(points[i]));
    return out;
}

scree_fixture RefuseShape(scree_world* w, const char* function, const char* cure) {
    w->last = {SCREE_BAD_SHAPE, function, "points", cure};
    return {-1, 0};
}

template <typename Def>
void SetLimitAndMotor(Def& def, const scree_joint_def& from) {
    def.enableLimit = from.enable_limit != 0;
    def.enableMotor = from.enable_motor != 0;
    def.motorSpeed = from.motor_speed;
}
template <typename Def>
void SetSlide(Def& def, const scree_joint_def& from) {
    SetLimitAndMotor(def, from);
    def.lowerTranslation = from.lower;
    def.upperTranslation = from.upper;
}

scree::Joint* CreateJoint(scree::World& world, const scree_joint_def& from, scree::Body* a, scree::Body* b) {
    const scree::Vec2 anchor = FromC(from.anchor_a), axis = FromC(from.axis);
    const auto create = [&](auto& def) {
        def.collideConnected = from.collide_connected != 0;
        return world.CreateJoint(&def);
    };
    const auto setSpring = [&](auto& def) {
        scree::LinearStiffness(def.stiffness, def.damping, from.hertz, from.damping_ratio, a, b);
    };
    switch (from.type) {
        case SCREE_REVOLUTE: {
            scree::RevoluteJointDef def;
            def.Initialize(a, b, anchor);
            SetLimitAndMotor(def, from);
            def.lowerAngle = from.lower;
            def.upperAngle = from.upper;
            def.maxMotorTorque = from.max_motor;
            return create(def);
        }
        case SCREE_PRISMATIC: {
            scree::PrismaticJointDef def;
            def.Initialize(a, b, anchor, axis);
            SetSlide(def, from);
            def.maxMotorForce = from.max_motor;
            return create(def);
        }
        case SCREE_DISTANCE: {
            scree::DistanceJointDef def;
            def.Initialize(a, b, anchor, FromC(from.anchor_b));
            if (from.enable_limit != 0) def.minLength = from.lower, def.maxLength = from.upper;
            if (from.hertz > 0.0f) setSpring(def);
            return create(def);
        }
        case SCREE_WELD: {
            scree::WeldJointDef def;
            def.Initialize(a, b, anchor);
            if (from.hertz > 0.0f)
                scree::AngularStiffness(def.stiffness, def.damping, from.hertz, from.damping_ratio, a, b);
            return create(def);
        }
        default: {
            scree::WheelJointDef def;
            def.Initialize(a, b, anchor, axis);
            SetSlide(def, from);
            def.maxMotorTorque = from.max_motor;
            if (from.hertz > 0.0f) setSpring(def);
            return create(def);
        }
    }
}

scree_world* Own(std::unique_ptr<scree::World> world) {
    auto* made = new scree_world{std::move(world)};
    made->world->SetErrorHandler(Note, &made->last);
    return made;
}

/// What a step that was refused has told.
template <typename StepWorld>
scree_error StepAnd(scree_world* w, StepWorld&& step) {
    w->last.code = SCREE_OK;
    step(*w->world);
    return w->last.code;
}

}  // namespace

scree_world_def scree_default_world(void) {
    const scree::WorldDef def;
    return {ToC(def.gravity), def.lengthScale, def.workerCount, def.allowSleep, def.continuousPhysics};
}

scree_body_def scree_default_body(void) {
    const scree::BodyDef def;
    return {def.type,          ToC(def.position),  def.angle,        ToC(def.linearVelocity), def.angularVelocity,
            def.linearDamping, def.angularDamping, def.gravityScale, def.fixedRotation,       def.bullet,
            def.allowSleep};
}

scree_fixture_def scree_default_fixture(void) {
    const scree::FixtureDef def;
    return {def.filter.categoryBits,
            def.filter.maskBits,
            def.density,
            def.friction,
            def.restitution,
            def.isSensor,
            def.filter.groupIndex,
            0,
            0};
}

scree_joint_def scree_default_joint(void) {
    scree_joint_def def{};
    def.body_a.index = def.body_b.index = -1;
    def.axis = {1.0f, 0.0f};
    return def;
}

scree_world* scree_create_world(const scree_world_def* def, scree_refusal* refusal) {
    scree::WorldDef own;
    if (def != nullptr) {
        own.gravity = FromC(def->gravity);
        own.lengthScale = def->length_scale;
        own.workerCount = def->worker_count;
        own.allowSleep = def->allow_sleep != 0;
        own.continuousPhysics = def->continuous != 0;
    }
    scree_refusal why{SCREE_OK, "", "", ""};
    std::unique_ptr<scree::World> world = scree::CreateWorld(own, Note, &why);
    if (refusal != nullptr) *refusal = why;
    return world == nullptr ? nullptr : Own(std::move(world));
}

void scree_destroy_world(scree_world* world) { delete world; }
scree_refusal scree_last_error(const scree_world* world) { return world->last; }

scree_error scree_step(scree_world* world, float time_step, int32_t velocity_iterations, int32_t position_iterations) {
    return StepAnd(world, [&](scree::World& w) { w.Step(time_step, velocity_iterations, position_iterations); });
}
scree_error scree_soft_step(scree_world* world, float time_step, int32_t substeps) {
    return StepAnd(world, [&](scree::World& w) { w.Step(time_step, substeps); });
}

scree_body scree_create_body(scree_world* world, const scree_body_def* given) {
    const scree_body_def from = given != nullptr ? *given : scree_default_body();
    if (from.type < SCREE_STATIC || from.type > SCREE_DYNAMIC) {
        world->last = {SCREE_OUT_OF_RANGE, "scree_create_body", "type", "give one of scree_body_type"};
        return {-1, 0};
    }
    scree::BodyDef def;
    def.type = static_cast<scree::BodyType>(from.type);
    def.position = FromC(from.position);
    def.angle = from.angle;
    def.linearVelocity = FromC(from.linear_velocity);
    def.angularVelocity = from.angular_velocity;
    def.linearDamping = from.linear_damping;
    def.angularDamping = from.angular_damping;
    def.gravityScale = from.gravity_scale;
    def.fixedRotation = from.fixed_rotation != 0;
    def.bullet = from.bullet != 0;
    def.allowSleep = from.allow_sleep != 0;
    return IdOf(*world, world->world->CreateBody(&def));
}

scree_error scree_destroy_body(scree_world* world, scree_body body) {
    return WithBody(world, body, "scree_destroy_body", [&](scree::Body& b) { return world->world->DestroyBody(&b); });
}
scree_error scree_set_transform(scree_world* world, scree_body body, scree_vec2 position, float angle) {
    return WithBody(world, body, "scree_set_transform",
                    [&](scree::Body& b) { return b.SetTransform(FromC(position), angle); });
}
scree_error scree_set_velocity(scree_world* world, scree_body body, scree_vec2 linear, float angular) {
    return WithBody(world, body, "scree_set_velocity", [&](scree::Body& b) {
        const scree::Vec2 before = b.GetLinearVelocity();
        const scree::ErrorCode code = b.SetLinearVelocity(FromC(linear));
        if (code != scree::ErrorCode::ok) return code;
        const scree::ErrorCode turned = b.SetAngularVelocity(angular);
        if (turned != scree::ErrorCode::ok) b.SetLinearVelocity(before);
        return turned;
    });
}
scree_error scree_apply_force(scree_world* world, scree_body body, scree_vec2 force, scree_vec2 point) {
    return WithBody(world, body, "scree_apply_force",
                    [&](scree::Body& b) { return b.ApplyForce(FromC(force), FromC(point), true); });
}
scree_error scree_apply_impulse(scree_world* world, scree_body body, scree_vec2 impulse, scree_vec2 point) {
    return WithBody(world, body, "scree_apply_impulse",
                    [&](scree::Body& b) { return b.ApplyLinearImpulse(FromC(impulse), FromC(point), true); });
}
int32_t scree_is_awake(const scree_world* world, scree_body body) {
    const scree::Body* b = Find(*world, body);
    return b != nullptr && b->IsAwake() ? 1 : 0;
}
float scree_get_mass(const scree_world* world, scree_body body) {
    const scree::Body* b = Find(*world, body);
    return b != nullptr ? b->GetMass() : 0.0f;
}

scree_fixture scree_add_circle(scree_world* world, scree_body body, const scree_fixture_def* def, scree_vec2 centre,
                               float radius) {
    scree::CircleShape circle;
    circle.m_p = FromC(centre);
    circle.m_radius = radius;
    return Add(world, body, def, circle);
}
scree_fixture scree_add_box(scree_world* world, scree_body body, const scree_fixture_def* def, scree_vec2 half_extents,
                            scree_vec2 centre, float angle) {
    scree::PolygonShape box;
    box.SetAsBox(half_extents.x, half_extents.y, FromC(centre), angle);
    return Add(world, body, def, box);
}
scree_fixture scree_add_polygon(scree_world* world, scree_body body, const scree_fixture_def* def,
                                const scree_vec2* points, int32_t count) {
    const std::vector<scree::Vec2> own = Points(points, std::min(count, scree::maxPolygonVertices + 1));
    scree::PolygonShape polygon;
    if (!polygon.Set(own.data(), static_cast<int>(own.size())))
        return RefuseShape(world, "scree_add_polygon", "give 3 to 8 points that span an area");
    return Add(world, body, def, polygon);
}
scree_fixture scree_add_capsule(scree_world* world, scree_body body, const scree_fixture_def* def, scree_vec2 from,
                                scree_vec2 to, float radius) {
    return Add(world, body, def, scree::MakeCapsule(FromC(from), FromC(to), radius));
}
scree_fixture scree_add_edge(scree_world* world, scree_body body, const scree_fixture_def* def, scree_vec2 from,
                             scree_vec2 to) {
    scree::EdgeShape edge;
    edge.SetTwoSided(FromC(from), FromC(to));
    return Add(world, body, def, edge);
}
scree_fixture scree_add_loop(scree_world* world, scree_body body, const scree_fixture_def* def,
                             const scree_vec2* points, int32_t count) {
    const std::vector<scree::Vec2> own = Points(points, count);
    scree::ChainShape chain;
    if (!chain.CreateLoop(own.data(), static_cast<int>(own.size())))
        return RefuseShape(world, "scree_add_loop", "give at least 3 points, neighbours apart");
    return Add(world, body, def, chain);
}
scree_error scree_destroy_fixture(scree_world* world, scree_fixture fixture) {
    scree::Fixture* found = world->world->Find(IdFrom<scree::FixtureId>(fixture));
    if (found == nullptr) return world->Refuse("scree_destroy_fixture", "fixture");
    return ToC(found->GetBody()->DestroyFixture(found));
}
scree_body scree_get_body(const scree_world* world, scree_fixture fixture) {
    scree::Fixture* found = world->world->Find(IdFrom<scree::FixtureId>(fixture));
    return found == nullptr ? scree_body{-1, 0} : IdOf(*world, found->GetBody());
}

scree_joint scree_create_joint(scree_world* world, const scree_joint_def* def) {
    const scree_joint none{-1, 0};
    if (def == nullptr || def->type < SCREE_REVOLUTE || def->type > SCREE_WHEEL) {
        world->last = {def == nullptr ? SCREE_NULL_ARGUMENT : SCREE_OUT_OF_RANGE, "scree_create_joint",
                       def == nullptr ? "def" : "type", "give a definition of one of scree_joint_type"};
        return none;
    }
    for (const float number : {def->hertz, def->damping_ratio}) {
        if (std::isfinite(number) && number >= 0.0f) continue;
        world->last = {std::isfinite(number) ? SCREE_OUT_OF_RANGE : SCREE_NON_FINITE, "scree_create_joint",
                       "hertz or damping_ratio", "give numbers of at least 0"};
        return none;
    }
    scree::Body *a = Find(*world, def->body_a), *b = Find(*world, def->body_b);
    if (a == nullptr || b == nullptr) {
        world->Refuse("scree_create_joint", a == nullptr ? "body_a" : "body_b");
        return none;
    }
    const scree::JointId id = world->world->GetId(CreateJoint(*world->world, *def, a, b));
    return {id.index, id.generation};
}
scree_error scree_destroy_joint(scree_world* world, scree_joint joint) {
    scree::Joint* found = world->world->Find(IdFrom<scree::JointId>(joint));
    if (found == nullptr) return world->Refuse("scree_destroy_joint", "joint");
    return ToC(world->world->DestroyJoint(found));
}

const scree_transform* scree_transforms(const scree_world* world, size_t* count) {
    const auto& rows = world->world->GetState().bodies.transform;
    if (count != nullptr) *count = rows.size();
    return AsC<scree_transform>(rows.data());
}
const scree_velocity* scree_velocities(const scree_world* world, size_t* count) {
    const auto& rows = world->world->GetState().bodies.velocity;
    if (count != nullptr) *count = rows.size();
    return AsC<scree_velocity>(rows.data());
}

scree_events scree_get_events(const scree_world* world) {
    const scree::Events e = world->world->GetEvents();
    const auto count = [](const auto& events) { return static_cast<int32_t>(events.size()); };
    return {AsC<scree_contact_event>(e.contactsBegun.data()),
            AsC<scree_contact_event>(e.contactsEnded.data()),
            AsC<scree_sensor_event>(e.sensorsEntered.data()),
            AsC<scree_sensor_event>(e.sensorsLeft.data()),
            AsC<scree_hit_event>(e.hits.data()),
            count(e.contactsBegun),
            count(e.contactsEnded),
            count(e.sensorsEntered),
            count(e.sensorsLeft),
            count(e.hits)};
}

scree_ray_hit scree_cast_ray(const scree_world* world, scree_vec2 from, scree_vec2 to) {
    const std::optional<scree::RayHit> hit = world->world->RayCastClosest(FromC(from), FromC(to));
    if (!hit) return {{-1, 0}, {0.0f, 0.0f}, {0.0f, 0.0f}, 0.0f};
    return {IdOf(*world, hit->fixture), ToC(hit->point), ToC(hit->normal), hit->fraction};
}

uint64_t scree_state_hash(const scree_world* world) { return scree::inspect::GetStateHash(*world->world); }

size_t scree_save_world(const scree_world* world, void* buffer, size_t capacity) {
    const std::vector<std::byte> image = scree::SaveWorld(*world->world);
    if (buffer != nullptr && capacity >= image.size()) std::memcpy(buffer, image.data(), image.size());
    return image.size();
}

scree_world* scree_load_world(const void* image, size_t size) {
    if (image == nullptr) return nullptr;
    std::unique_ptr<scree::World> world = scree::LoadWorld({static_cast<const std::byte*>(image), size});
    return world == nullptr ? nullptr : Own(std::move(world));
}
