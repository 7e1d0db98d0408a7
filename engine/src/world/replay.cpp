// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bytes → calls. The table below has one row per recorded call; a row reads the object and the arguments and makes the
// call. Those whose arguments are plain values are listed in recorded_calls.h. Nothing that was read is believed: an
// object must be alive and of the right type.

#include <tuple>

#include "scree/inspect.h"
#include "world/guard.h"
#include "world/record.h"
#include "world/recorded_calls.h"

namespace scree {

namespace {

/// An object by its index; null if it is not alive or not of this class.
template <typename Object>
Object* ReadObject(World& world, ImageReader& in) {
    WorldState& s = world.GetState();
    if constexpr (std::is_same_v<Object, World>) {
        return &world;
    } else {
        int index = -1;
        in(index);
        if constexpr (std::is_same_v<Object, Body>) {
            return s.bodies.slots.IsAlive(BodyIndex{index}) ? &s.bodies.handles[BodyIndex{index}] : nullptr;
        } else if constexpr (std::is_same_v<Object, Fixture>) {
            return s.fixtures.slots.IsAlive(FixtureIndex{index}) ? &s.fixtures.handles[FixtureIndex{index}] : nullptr;
        } else if constexpr (std::is_same_v<Object, Contact>) {
            return s.contacts.IsAlive(ContactIndex{index}) ? s.contacts.Handle(&s, ContactIndex{index}) : nullptr;
        } else {
            if (!s.joints.slots.IsAlive(JointIndex{index})) return nullptr;
            Joint* joint = s.joints.handles[JointIndex{index}];
            bool fits = std::is_same_v<Object, Joint>;
            JointTable::WithStore(s.joints, joint->GetType(), [&](auto& store) {
                using Handle = typename std::remove_reference_t<decltype(store)>::RowType::Handle;
                fits = fits || std::is_same_v<Object, Handle>;
            });
            return fits ? static_cast<Object*>(joint) : nullptr;
        }
    }
}

template <typename Result, typename Object, typename... Arguments>
bool CallMethod(Result (Object::*method)(Arguments...), World& world, ImageReader& in) {
    Object* object = ReadObject<Object>(world, in);
    std::tuple<std::decay_t<Arguments>...> arguments;
    std::apply([&](auto&... argument) { (in(argument), ...); }, arguments);
    if (object == nullptr || in.Failed() || !in.AtEnd()) return false;
    std::apply([&](auto&... argument) { (object->*method)(argument...); }, arguments);
    return true;
}

/// A call whose arguments are plain values.
template <auto Method>
bool Call(World& world, ImageReader& in) {
    return CallMethod(Method, world, in);
}

bool CallCreateBody(World& world, ImageReader& in) {
    BodyDef def;
    in(def);
    return !in.Failed() && world.CreateBody(&def) != nullptr;
}

bool CallDestroyBody(World& world, ImageReader& in) {
    Body* body = ReadObject<Body>(world, in);
    return body != nullptr && world.DestroyBody(body) == ErrorCode::ok;
}

bool CallCreateFixture(World& world, ImageReader& in) {
    Body* body = ReadObject<Body>(world, in);
    FixtureDef def;
    Shape::Type type = Shape::e_circle;
    in(def);
    in(type);
    if (body == nullptr || in.Failed()) return false;
    bool made = false;
    const auto create = [&]<typename T>(std::type_identity<T>) {
        T shape;
        in(shape);
        if (in.Failed() || !IsSafe(shape)) return;
        def.shape = &shape;
        made = body->CreateFixture(&def) != nullptr;
    };
    type == Shape::e_chain ? create(std::type_identity<ChainShape>{}) : void(WithShapeType(type, create));
    return made;
}

bool CallSetShape(World& world, ImageReader& in) {
    auto* fixture = ReadObject<Fixture>(world, in);
    Shape::Type type = Shape::e_circle;
    in(type);
    if (fixture == nullptr || in.Failed()) return false;
    bool isSet = false;
    WithShapeType(type, [&]<typename T>(std::type_identity<T>) {
        T shape;
        in(shape);
        isSet = !in.Failed() && IsSafe(shape) && fixture->SetShape(shape) == ErrorCode::ok;
    });
    return isSet;
}

bool CallDestroyFixture(World& world, ImageReader& in) {
    Body* body = ReadObject<Body>(world, in);
    Fixture* fixture = ReadObject<Fixture>(world, in);
    return body != nullptr && fixture != nullptr && body->DestroyFixture(fixture) == ErrorCode::ok;
}

bool CallDestroyChain(World& world, ImageReader& in) {
    Body* body = ReadObject<Body>(world, in);
    Fixture* fixture = ReadObject<Fixture>(world, in);
    return body != nullptr && fixture != nullptr && body->DestroyChain(fixture) == ErrorCode::ok;
}

bool CallSetMassData(World& world, ImageReader& in) {
    Body* body = ReadObject<Body>(world, in);
    MassData data;
    in(data);
    return body != nullptr && !in.Failed() && body->SetMassData(&data) == ErrorCode::ok;
}

bool CallCreateJoint(World& world, ImageReader& in) {
    JointType type = e_unknownJoint;
    JointUserData userData;
    bool collideConnected = false;
    float forceThreshold = 0.0f, torqueThreshold = 0.0f;
    bool breaks = false;
    in(type, userData, collideConnected, forceThreshold, torqueThreshold, breaks);
    Body* bodyA = ReadObject<Body>(world, in);
    Body* bodyB = ReadObject<Body>(world, in);
    if (in.Failed()) return false;
    Joint* made = nullptr;
    JointTable::WithStore(world.GetState().joints, type, [&](auto& store) {
        using Row = typename std::remove_reference_t<decltype(store)>::RowType;
        typename Row::Definition def;
        def.userData = userData;
        def.collideConnected = collideConnected;
        def.bodyA = bodyA;
        def.bodyB = bodyB;
        def.forceThreshold = forceThreshold;
        def.torqueThreshold = torqueThreshold;
        def.breaks = breaks;
        Row::DefinitionFields(def, in);
        if constexpr (std::is_same_v<decltype(def), GearJointDef>) {
            def.joint1 = ReadObject<Joint>(world, in);
            def.joint2 = ReadObject<Joint>(world, in);
        }
        if (!in.Failed()) made = world.CreateJoint(&def);
    });
    return made != nullptr;
}

bool CallDestroyJoint(World& world, ImageReader& in) {
    Joint* joint = ReadObject<Joint>(world, in);
    return joint != nullptr && world.DestroyJoint(joint) == ErrorCode::ok;
}

struct Row {
    std::string_view name;
    bool (*call)(World&, ImageReader&);
};

constexpr Row calls[] = {
    {"World::CreateBody", CallCreateBody},
    {"World::DestroyBody", CallDestroyBody},
    {"World::CreateJoint", CallCreateJoint},
    {"World::DestroyJoint", CallDestroyJoint},
    {"World::Step", Call<static_cast<StepReport (World::*)(float, int, int)>(&World::Step)>},
    {"World::Step (sub-steps)", Call<static_cast<StepReport (World::*)(float, int)>(&World::Step)>},
    {"World::Step (tolerance)", Call<static_cast<StepReport (World::*)(float, const Tolerance&)>(&World::Step)>},
    {"Body::CreateFixture", CallCreateFixture},
    {"Body::DestroyFixture", CallDestroyFixture},
    {"Body::DestroyChain", CallDestroyChain},
    {"Body::SetMassData", CallSetMassData},
    {"Fixture::SetShape", CallSetShape},
#define SCREE_CALL(method) {#method, Call<&method>},
    SCREE_RECORDED_CALLS(SCREE_CALL)};
#undef SCREE_CALL

bool MakeCall(uint32_t number, World& world, std::span<const std::byte> arguments) {
    for (const Row& row : calls) {
        if (CallNumber(row.name) != number) continue;
        ImageReader in(arguments);
        return row.call(world, in) && in.AtEnd();
    }
    return false;
}

/// What stands in front of the calls.
struct Head {
    uint64_t magic, size;  ///< of the image
};
static_assert(sizeof(Head) == 16);

bool IsHash(std::span<const std::byte> bytes, uint64_t hash) {
    ImageReader in(bytes);
    uint64_t recorded = 0;
    in(recorded);
    return !in.Failed() && recorded == hash;
}

constexpr uint32_t stepCall = CallNumber("World::Step");
constexpr uint32_t subStepsCall = CallNumber("World::Step (sub-steps)");
constexpr uint32_t toleranceCall = CallNumber("World::Step (tolerance)");

RecordedStep ReadStep(uint32_t number, std::span<const std::byte> arguments) {
    RecordedStep step;
    ImageReader in(arguments);
    in(step.timeStep);
    if (number == stepCall) in(step.velocityIterations, step.positionIterations);
    if (number == subStepsCall) in(step.substeps);
    return step;
}

}  // namespace

Player::Player(std::span<const std::byte> recording, const std::function<void(World&)>& prepare) : m_bytes(recording) {
    ImageReader in(recording);
    Head head{};
    in(head.magic);
    in(head.size);
    if (!in.Failed() && head.magic == recordingMagic && head.size <= recording.size() - sizeof(Head)) {
        m_report.world = LoadWorld(in.Take(head.size), &m_report.image);
    }
    m_hasEnded = m_report.world == nullptr;
    if (m_hasEnded) return;
    m_report.position = sizeof(Head) + head.size;
    m_report.world->SetErrorHandler([](const Error&, void*) {}, nullptr);  // the report tells of a refused call
    if (prepare) prepare(*m_report.world);
}

Player::Entry Player::Next() {
    ImageReader in(m_bytes.subspan(m_report.position));
    m_hasEnded = true;
    if (in.AtEnd()) {
        m_report.valid = true;
        return Entry::end;
    }
    uint32_t number = 0, size = 0, checksum = 0;
    in(number);
    in(size);
    in(checksum);
    const std::span<const std::byte> arguments = in.Take(size);
    if (in.Failed() || checksum != EntryChecksum(number, arguments)) return Entry::end;
    if (number == hashRecord) {
        const bool isSame = IsHash(arguments, inspect::GetStateHash(*m_report.world));
        if (!isSame) m_report.firstDifference = m_report.steps;
        m_report.valid = !isSame;
        m_hasEnded = !isSame;
    } else {
        if (!MakeCall(number, *m_report.world, arguments)) return Entry::end;
        ++m_report.calls;
        m_hasEnded = false;
    }
    m_report.position += 3 * sizeof(uint32_t) + size;
    if (number == hashRecord) return Entry::hash;
    if (number != stepCall && number != subStepsCall && number != toleranceCall) return Entry::call;
    ++m_report.steps;
    m_report.lastStep = ReadStep(number, arguments);
    return Entry::step;
}

bool Player::Step() {
    while (!m_hasEnded) {
        if (Next() != Entry::step) continue;
        (void)Next();  // the hash of the state that it led to
        return true;
    }
    return false;
}

ReplayReport Replay(std::span<const std::byte> recording, const std::function<void(World&)>& prepare) {
    Player player(recording, prepare);
    while (player.Step()) {
    }
    return player.TakeReport();
}

std::vector<std::string_view> GetRecordedCalls() {
    std::vector<std::string_view> names;
    for (const Row& row : calls) names.push_back(row.name);
    return names;
}

}  // namespace scree
