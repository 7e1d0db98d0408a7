// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Steps of a track: the packed states, contacts and nodes of scree_capture_format.h.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"
#include "testbed/capture/scree_capture_format.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_data.h"

namespace testbed {

namespace {

/// Goes through packed bytes; what ends too early or names what there is not is an error of `reader`'s last item.
class Unpacker {
public:
    Unpacker(CborReader& reader, ByteSpan bytes) : m_reader(reader), m_bytes(bytes) {}

    [[nodiscard]] bool IsAtEnd() const { return m_position == m_bytes.size(); }
    std::uint8_t Byte() {
        if (IsAtEnd()) Fail("ends too early");
        return m_bytes[m_position++];
    }
    std::uint32_t Little(std::size_t length) {
        if (m_bytes.size() - m_position < length) Fail("ends too early");
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < length; ++i) value |= std::uint32_t{m_bytes[m_position + i]} << (8 * i);
        m_position += length;
        return value;
    }
    float Float() { return std::bit_cast<float>(Little(4)); }
    scenes::Vec2 Vec2() {
        const float x = Float();
        return {x, Float()};
    }
    std::uint64_t Varint() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 63; shift += 7) {
            const std::uint8_t byte = Byte();
            value |= std::uint64_t{byte & 0x7Fu} << shift;
            if (byte < 0x80) return value;
        }
        Fail("a number is too large");
    }
    std::int64_t Signed() {
        const std::uint64_t zigzag = Varint();
        return static_cast<std::int64_t>(zigzag >> 1) ^ -static_cast<std::int64_t>(zigzag & 1);
    }
    [[noreturn]] void Fail(std::string_view what) const {
        m_reader.Fail(fmt::format("packed bytes, at {}: {}; record it again", m_position, what));
    }

private:
    CborReader& m_reader;
    ByteSpan m_bytes;
    std::size_t m_position = 0;
};

int FindBody(const std::vector<TrackBody>& bodies, std::int64_t number, int guess) {
    // Numbers are dense unless steps were left out, and mostly come in order.
    const auto isIt = [&](std::int64_t i) {
        return i >= 0 && i < std::ssize(bodies) && bodies[static_cast<std::size_t>(i)].number == number;
    };
    if (isIt(guess)) return guess;
    if (isIt(number)) return static_cast<int>(number);
    const auto found = std::lower_bound(bodies.begin(), bodies.end(), number,
                                        [](const TrackBody& body, std::int64_t value) { return body.number < value; });
    return found != bodies.end() && found->number == number ? static_cast<int>(found - bodies.begin()) : -1;
}

TrackPlace ReadPlace(Unpacker& in, const TrackFile::Data& data, int step) {
    const std::uint64_t number = in.Varint(), fixture = in.Varint(), child = in.Varint();
    const int body = FindBody(data.bodies, static_cast<std::int64_t>(number), -1);
    if (body < 0 || !data.bodies[static_cast<std::size_t>(body)].IsThere(step)) {
        in.Fail(fmt::format("there is no body {} at step {}", number, step));
    }
    const std::span<const scenes::Fixture> fixtures = data.parts.FixturesOf(body);
    if (fixture >= fixtures.size()) in.Fail(fmt::format("body {} has no fixture {}", number, fixture));
    const int children = fixtures[static_cast<std::size_t>(fixture)].shape.ChildCount();
    if (child >= static_cast<std::uint64_t>(children)) in.Fail(fmt::format("a fixture of {} children", children));
    return {body, static_cast<int>(fixture), static_cast<int>(child)};
}

void ReadContacts(CborReader& reader, ByteSpan packed, const TrackFile::Data& data, TrackStep& step) {
    Unpacker in(reader, packed);
    while (!in.IsAtEnd()) {
        TrackContact& contact = step.contacts.emplace_back();
        contact.a = ReadPlace(in, data, step.step);
        contact.b = ReadPlace(in, data, step.step);
        const std::uint8_t flags = in.Byte();
        contact.isSensor = (flags & 4) != 0;
        contact.pointCount = flags & 3;
        if (flags > 6 || contact.pointCount > 2) in.Fail("a contact of more than two points");
        contact.normal = in.Vec2();
        for (std::size_t i = 0; i < static_cast<std::size_t>(contact.pointCount); ++i) {
            contact.points[i] = in.Vec2();
            contact.separations[i] = in.Float();
            contact.normalImpulses[i] = in.Float();
            contact.tangentImpulses[i] = in.Float();
        }
    }
}

void ReadNodes(CborReader& reader, ByteSpan packed, const TrackFile::Data& data, TrackStep& step) {
    Unpacker in(reader, packed);
    std::vector<int> open;  // nodes whose second child is to come, and under them that of the first
    while (!in.IsAtEnd()) {
        const int index = static_cast<int>(step.nodes.size());
        if (index > 0) {
            if (open.empty()) in.Fail("more nodes than the tree has");
            TrackNode& parent = step.nodes[static_cast<std::size_t>(open.back())];
            if (parent.child1 < 0) {
                parent.child1 = index;
            } else {
                parent.child2 = index;
            }
        }
        const std::uint8_t isLeaf = in.Byte();
        if (isLeaf > 1) in.Fail("neither a leaf nor another node");
        TrackNode& node = step.nodes.emplace_back();
        node.parent = open.empty() ? -1 : open.back();
        node.lower = in.Vec2();
        node.upper = in.Vec2();
        if (node.parent >= 0 && step.nodes[static_cast<std::size_t>(node.parent)].child2 == index) open.pop_back();
        if (isLeaf == 1) {
            node.leaf = ReadPlace(in, data, step.step);
        } else {
            open.push_back(index);
        }
    }
    if (!open.empty()) in.Fail("a tree without all of its leaves");
}

TrackState StateOf(const TrackBits& bits, bool isThere) {
    const auto value = [&](int i) { return std::bit_cast<float>(bits.bits[i]); };
    return {isThere, bits.awake, {value(0), value(1)}, value(2), {value(3), value(4)}, value(5)};
}

}  // namespace

void TrackFile::Data::PrepareReading() {
    created.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const scenes::Body& body = parts.bodies[i];
        const float values[6] = {body.position.x,       body.position.y,       body.angle,
                                 body.linearVelocity.x, body.linearVelocity.y, body.angularVelocity};
        for (std::size_t k = 0; k < 6; ++k) created[i].bits[k] = std::bit_cast<std::uint32_t>(values[k]);
        created[i].awake = body.type != scenes::BodyType::isStatic && body.awake;
    }
    SetStart();
}

void TrackFile::Data::SetStart() {
    state = created;
    position = -1;
    current = {};
}

void TrackFile::Data::GoTo(int index) {
    int from = index;
    while (from >= 0 && from > position && !entries[static_cast<std::size_t>(from)].isKey) --from;
    if (from < 0 || position > index) {
        // Nothing to go on from, or it lies behind: back to the last step with all states, or to the start.
        for (from = index; from >= 0 && !entries[static_cast<std::size_t>(from)].isKey;) --from;
        SetStart();
        if (from < 0) from = 0;
    } else if (from == position) {
        ++from;
    }
    for (; from <= index; ++from) Decode(from, from == index);
    position = index;
    current.bodies.clear();
    const int step = index < 0 ? 0 : steps[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        current.bodies.push_back(StateOf(state[i], bodies[i].IsThere(step)));
    }
}

void TrackFile::Data::Decode(int index, bool isWanted) {
    const TrackEntry& entry = entries[static_cast<std::size_t>(index)];
    CborReader reader = Open(entry.block);
    reader.SetPosition(entry.at);
    TrackStep step;
    double h = -1.0;
    std::uint64_t left = reader.NextMap("a step");
    for (; left > 0; --left) {
        const std::string_view key = reader.NextText("a key");
        if (key == "step") {
            step.step = static_cast<int>(reader.Next().whole);
        } else if (key == "dt") {
            step.timeStep = reader.NextFloat("dt");
            if (h < 0.0) h = double{step.timeStep};
        } else if (key == "h") {
            h = double{reader.NextFloat("h")};
            if (!(std::isfinite(h) && h >= 0.0)) reader.Fail("h: give a finite number that is not negative");
        } else if (key == "bodies") {
            const ByteSpan packed = reader.NextBytes("bodies");
            DecodeBodies(reader, packed, entry.isKey, entry.isKey || h < 0.0 ? 0.0 : h);
        } else if (key == "contacts") {
            const ByteSpan packed = reader.NextBytes("contacts");
            if (isWanted) ReadContacts(reader, packed, *this, step);
        } else if (key == "contactCount") {
            step.contactCount = static_cast<int>(reader.NextWhole("contactCount", 0, 1 << 30));
        } else if (key == "nodes") {
            const ByteSpan packed = reader.NextBytes("nodes");
            if (isWanted) ReadNodes(reader, packed, *this, step);
        } else if (key == "stages") {
            for (std::uint64_t stages = reader.NextMap("stages"); stages > 0; --stages) {
                const std::string_view name = reader.NextText("a stage");
                step.stages.emplace_back(name, reader.NextFloat("the time of a stage"));
            }
        } else if (key == "marks") {
            for (std::uint64_t marks = reader.NextArray("marks"); marks > 0; --marks) {
                step.marks.emplace_back(reader.NextText("a mark"));
            }
        } else {
            reader.Skip();
        }
    }
    if (isWanted) current = std::move(step);
}

void TrackFile::Data::DecodeBodies(CborReader& reader, ByteSpan packed, bool isKey, double h) {
    namespace format = scree_capture::detail;
    if (isKey) state = created;
    Unpacker in(reader, packed);
    std::int64_t number = 0;
    int guess = -1;
    while (!in.IsAtEnd()) {
        const int pose = in.Byte(), velocity = in.Byte();
        if (pose >= 250 || velocity >= 250) in.Fail("no lengths");
        std::int64_t way = -1;
        if (pose >= 125) way = in.Signed();
        if (std::abs(way) > std::int64_t{1} << 54) in.Fail("a number is too large");
        number += way;
        const int body = FindBody(bodies, number, guess);
        if (body < 0) in.Fail(fmt::format("there is no body {}", number));
        guess = body - 1;
        TrackBits& bits = state[static_cast<std::size_t>(body)];
        const int lengths[6] = {pose % 5,     pose / 5 % 5,     pose / 25 % 5,
                                velocity % 5, velocity / 5 % 5, velocity / 25 % 5};
        std::uint32_t differences[6];
        for (std::size_t i = 0; i < 6; ++i) {
            const std::uint32_t residual = in.Little(static_cast<std::size_t>(lengths[i]));
            differences[i] = residual >> 1 ^ (0u - (residual & 1u));
        }
        // Velocities first: positions are predicted from the new ones. Ordinals are their own inverse.
        for (const std::size_t i : {std::size_t{3}, std::size_t{4}, std::size_t{5}}) {
            bits.bits[i] = format::OrdinalOf(format::OrdinalOf(bits.bits[i]) + differences[i]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t predicted = format::Predict(bits.bits[i], bits.bits[i + 3], h);
            bits.bits[i] = format::OrdinalOf(format::OrdinalOf(predicted) + differences[i]);
        }
        bits.awake = velocity >= 125;
    }
}

scenes::Scene TrackFile::Data::MakeScene(int step) const {
    scenes::Scene scene = parts;
    scene.bodies.clear();
    scene.fixtures.clear();
    scene.joints.clear();
    std::vector<int> indexOf(bodies.size(), -1);
    nlohmann::ordered_json::object_t usersOf;  // of bodies, whose indices rise
    const auto add = [&](std::size_t i, const scenes::Body& body) {
        indexOf[i] = static_cast<int>(scene.bodies.size());
        scenes::Body& added = scene.bodies.emplace_back(body);
        const auto fixtures = parts.FixturesOf(static_cast<int>(i));
        added.firstFixture = static_cast<int>(scene.fixtures.size());
        scene.fixtures.insert(scene.fixtures.end(), fixtures.begin(), fixtures.end());
        const auto told = bodyUsers.find(static_cast<int>(i));
        if (told != bodyUsers.end()) usersOf.emplace_back(std::to_string(indexOf[i]), told->second);
    };
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!bodies[i].IsThere(step)) continue;
        const TrackState now = current.bodies[i];
        scenes::Body body = parts.bodies[i];
        body.position = now.position;
        body.angle = now.angle;
        body.linearVelocity = now.linearVelocity;
        body.angularVelocity = now.angularVelocity;
        body.awake = now.awake || body.type == scenes::BodyType::isStatic;
        add(i, body);
    }
    std::vector<int> jointOf(joints.size(), -1);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        scenes::Joint joint = parts.joints[i];
        const bool isGear = joint.type == scenes::JointType::gear;
        const auto indexOfJoint = [&](int old) { return jointOf[static_cast<std::size_t>(old)]; };
        joint.bodyA = indexOf[static_cast<std::size_t>(joint.bodyA)];
        joint.bodyB = indexOf[static_cast<std::size_t>(joint.bodyB)];
        if (isGear) joint.joint1 = indexOfJoint(joint.joint1), joint.joint2 = indexOfJoint(joint.joint2);
        if (!joints[i].IsThere(step) || joint.bodyA < 0 || joint.bodyB < 0) continue;
        if (isGear && (joint.joint1 < 0 || joint.joint2 < 0)) continue;
        jointOf[i] = static_cast<int>(scene.joints.size());
        scene.joints.push_back(joint);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].createdAfter <= step) continue;
        add(i, parts.bodies[i]);
        scene.spawns.push_back({.afterStep = bodies[i].createdAfter - step, .body = indexOf[i]});
    }
    const int last = steps.empty() ? 0 : steps.back();
    scene.steps = std::max(last - step, 1);
    scene.showStep = scene.steps;
    if (info.timeStep > 0.0f) scene.timeStep = info.timeStep;
    nlohmann::ordered_json users = user;
    if (!usersOf.empty()) users["bodies"] = std::move(usersOf);
    scene.user = users.empty() ? "" : PrintJson(users);
    return scene;
}

TrackFile::TrackFile(std::string bytes, std::string_view source) : m_data(std::make_unique<Data>()) {
    m_data->source = source;
    m_data->bytes = std::move(bytes);
    m_data->info.bytes = m_data->bytes.size();
    m_data->BuildIndex();
    m_data->PrepareReading();
    // All is decoded once, so that no later step ends in an error.
    for (int i = 0; i < static_cast<int>(m_data->steps.size()); ++i) m_data->GoTo(i);
}

TrackFile::~TrackFile() = default;
TrackFile::TrackFile(TrackFile&&) noexcept = default;
TrackFile& TrackFile::operator=(TrackFile&&) noexcept = default;

const TrackInfo& TrackFile::GetInfo() const { return m_data->info; }
const scenes::Scene& TrackFile::GetParts() const { return m_data->parts; }
const std::vector<TrackBody>& TrackFile::GetBodies() const { return m_data->bodies; }
const std::vector<TrackJoint>& TrackFile::GetJoints() const { return m_data->joints; }
const std::vector<int>& TrackFile::GetSteps() const { return m_data->steps; }

const TrackStep& TrackFile::Read(int step) {
    const std::vector<int>& steps = m_data->steps;
    const auto found = std::lower_bound(steps.begin(), steps.end(), step);
    if (step != 0 && (found == steps.end() || *found != step)) {
        throw UsageError(steps.empty() ? fmt::format("{} has no step but 0, its start", m_data->source)
                                       : fmt::format("{} has no step {}: give 0 or one from {} to {}", m_data->source,
                                                     step, steps.front(), steps.back()));
    }
    const int index = step == 0 ? -1 : static_cast<int>(found - steps.begin());
    if (index != m_data->position || m_data->current.bodies.empty()) m_data->GoTo(index);
    return m_data->current;
}

scenes::Scene TrackFile::SceneAt(int step) {
    (void)Read(step);
    scenes::Scene scene = m_data->MakeScene(step);
    if (const std::string fault = DescribeFault(scene); !fault.empty()) {
        throw FileError(fmt::format("{}, step {}: {}", m_data->source, step, fault));
    }
    return scene;
}

}  // namespace testbed
