// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of contact_data.h.

#include "testbed/jobs/timeline/contact_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace testbed {

namespace {

constexpr std::array<const char*, scenes::jointTypeCount> jointNames{
    "revolute", "distance", "friction", "gear", "motor", "mouse", "prismatic", "pulley", "weld", "wheel"};

const BodyState& BodyOf(const Snapshot& snapshot, int fixture) {
    return snapshot.bodies[static_cast<std::size_t>(snapshot.fixtures[static_cast<std::size_t>(fixture)].body)];
}

bool IsSensor(const Snapshot& snapshot, int fixture) {
    return snapshot.fixtures[static_cast<std::size_t>(fixture)].sensor;
}

/// A world point in the coordinates of a body.
Vec2 ToLocal(const BodyState& body, Vec2 point) {
    const float x = point.x - body.position.x, y = point.y - body.position.y;
    return {body.cos * x + body.sin * y, body.cos * y - body.sin * x};
}

}  // namespace

void ContactData::Add(const Snapshot& snapshot, const Grid& grid, const MotionData& motion) {
    m_stream.BeginStep();
    const auto count = std::ranges::count_if(snapshot.contacts, &ContactState::touching);
    m_stream.PutNumber(static_cast<std::uint32_t>(count));
    for (const ContactState& contact : snapshot.contacts) {
        if (!contact.touching) continue;
        const int a = BodyOf(snapshot, contact.fixtureA).index, b = BodyOf(snapshot, contact.fixtureB).index;
        const bool isSensor = IsSensor(snapshot, contact.fixtureA) || IsSensor(snapshot, contact.fixtureB);
        m_stream.PutNumber(static_cast<std::uint32_t>(a));
        m_stream.PutNumber(static_cast<std::uint32_t>(b));
        m_stream.PutByte(static_cast<unsigned>(contact.pointCount) | (isSensor ? 4u : 0u));
        m_stream.PutWord(static_cast<unsigned>(Grid::Angle(std::atan2(contact.normal.y, contact.normal.x))) & 0xFFFFu);
        for (int i = 0; i < contact.pointCount; ++i) {
            m_stream.PutSigned(grid.Length(double{contact.points[i].x} - motion.GetX(a)));
            m_stream.PutSigned(grid.Length(double{contact.points[i].y} - motion.GetY(a)));
            m_stream.PutReal(contact.normalImpulses[i]);
            m_stream.PutReal(contact.separations[i]);
        }
    }
    m_stream.EndStep();
}

void JointData::Add(const Snapshot& snapshot) {
    std::map<std::array<int, 3>, std::size_t> seen;
    std::vector<std::pair<int, float>> lengths;
    for (const JointState& joint : snapshot.joints) {
        const BodyState& a = snapshot.bodies[static_cast<std::size_t>(joint.bodyA)];
        const BodyState& b = snapshot.bodies[static_cast<std::size_t>(joint.bodyB)];
        const std::array<int, 3> key{a.index, b.index, static_cast<int>(joint.type)};
        std::vector<int>& numbers = m_numbers[key];
        const std::size_t place = seen[key]++;
        if (place == numbers.size()) {
            numbers.push_back(static_cast<int>(m_rows.size()));
            m_rows.push_back({a.index, b.index, joint.type, ToLocal(a, joint.anchorA), ToLocal(b, joint.anchorB)});
        }
        lengths.emplace_back(numbers[place],
                             std::hypot(joint.anchorB.x - joint.anchorA.x, joint.anchorB.y - joint.anchorA.y));
    }
    std::ranges::sort(lengths);
    m_stream.BeginStep();
    m_stream.PutNumber(static_cast<std::uint32_t>(lengths.size()));
    int next = 0;
    for (const auto& [number, length] : lengths) {
        m_stream.PutNumber(static_cast<std::uint32_t>(number - next));
        m_stream.PutReal(length);
        next = number + 1;
    }
    m_stream.EndStep();
}

nlohmann::ordered_json JointData::GetRows() const {
    using Json = nlohmann::ordered_json;
    Json rows = Json::array();
    for (const Row& row : m_rows) {
        rows.push_back({{"a", row.a},
                        {"b", row.b},
                        {"type", jointNames[static_cast<std::size_t>(row.type)]},
                        {"anchorA", {row.anchorA.x, row.anchorA.y}},
                        {"anchorB", {row.anchorB.x, row.anchorB.y}}});
    }
    return rows;
}

ByteStream PutNodes(const Snapshot& snapshot, const Grid& grid) {
    ByteStream stream;
    stream.BeginStep();
    const auto isInner = [](const NodeState& node) { return node.child1 >= 0; };
    stream.PutNumber(static_cast<std::uint32_t>(std::ranges::count_if(snapshot.nodes, isInner)));
    for (const NodeState& node : snapshot.nodes) {
        if (!isInner(node)) continue;
        stream.PutByte(static_cast<unsigned>(std::min(node.level, 255)));
        stream.PutSigned(grid.X(node.box.lower.x));
        stream.PutSigned(grid.Y(node.box.lower.y));
        stream.PutSigned(grid.X(node.box.upper.x));
        stream.PutSigned(grid.Y(node.box.upper.y));
    }
    stream.EndStep();
    return stream;
}

}  // namespace testbed
