// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of body_rows.h.

#include "testbed/jobs/timeline/body_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "testbed/base/errors.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

/// Corners of what is drawn as a polygon or a line, in the body's coordinates; none for a circle.
std::vector<Vec2> CornersOf(const FixtureState& fixture) {
    const scenes::Shape& shape = fixture.shape;
    if (!fixture.outline.empty()) return fixture.outline;
    if (shape.type == scenes::ShapeType::circle) return {};
    if (shape.type == scenes::ShapeType::edge) return {shape.vertices[0], shape.vertices[1]};
    if (shape.type == scenes::ShapeType::box) {
        const float c = std::cos(shape.angle), s = std::sin(shape.angle);
        std::vector<Vec2> corners;
        for (const Vec2 sign : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
            const float x = sign.x * shape.halfExtents.x, y = sign.y * shape.halfExtents.y;
            corners.push_back({c * x - s * y + shape.center.x, s * x + c * y + shape.center.y});
        }
        return corners;
    }
    return {shape.Vertices().begin(), shape.Vertices().end()};
}

/// Area, its first moments and its second one about the origin.
std::array<double, 4> MomentsOf(const FixtureState& fixture, const std::vector<Vec2>& corners) {
    if (corners.empty()) {
        const double r2 = double{fixture.shape.radius} * fixture.shape.radius, area = std::numbers::pi * r2;
        const double x = fixture.shape.center.x, y = fixture.shape.center.y;
        return {area, area * x, area * y, area * (r2 / 2 + x * x + y * y)};
    }
    std::array<double, 4> sums{};
    for (std::size_t i = 0; corners.size() > 2 && i < corners.size(); ++i) {
        const Vec2 p = corners[i], q = corners[(i + 1) % corners.size()];
        const double px = p.x, py = p.y, qx = q.x, qy = q.y, cross = px * qy - py * qx;
        sums[0] += cross / 2;
        sums[1] += cross * (px + qx) / 6;
        sums[2] += cross * (py + qy) / 6;
        sums[3] += cross * (px * px + px * qx + qx * qx + py * py + py * qy + qy * qy) / 12;
    }
    return sums;
}

}  // namespace

BodyRows::BodyRows(const scenes::Scene& scene, const std::vector<std::string>& names)
    : m_scene(scene),
      m_rows(Json::array()),
      m_isKnown(scene.bodies.size()),
      m_sums(scene.bodies.size()),
      m_masses(scene.bodies.size()) {
    const std::size_t count = scene.bodies.size();
    if (count > mostTimelineBodies) {
        throw UsageError(fmt::format("{} bodies: a page holds at most {}", count, mostTimelineBodies));
    }
    for (std::size_t i = 0; i < count; ++i) {
        constexpr const char* types[] = {"static", "kinematic", "dynamic"};
        m_rows.push_back({{"name", names[i]},
                          {"type", types[static_cast<std::size_t>(scene.bodies[i].type)]},
                          {"reach", 0.0},
                          {"mass", 0.0},
                          {"inertia", 0.0},
                          {"shapes", Json::array()}});
    }
}

void BodyRows::AddShape(const Snapshot& snapshot, const FixtureState& fixture) {
    const BodyState& body = snapshot.bodies[static_cast<std::size_t>(fixture.body)];
    const auto index = static_cast<std::size_t>(body.index);
    Json& row = m_rows[index];
    const std::vector<Vec2> corners = CornersOf(fixture);
    const scenes::Shape& shape = fixture.shape;
    double reach = std::hypot(shape.center.x, shape.center.y) + double{shape.radius};
    if (corners.empty()) {
        row["shapes"].push_back({{"x", shape.center.x}, {"y", shape.center.y}, {"r", shape.radius}});
    } else {
        Json numbers = Json::array();
        reach = 0;
        for (const Vec2 p : corners) {
            numbers.push_back(p.x), numbers.push_back(p.y);
            reach = std::max(reach, std::hypot(double{p.x}, double{p.y}));
        }
        row["shapes"].push_back({{"v", numbers}});
    }
    row["reach"] = std::max(row["reach"].get<double>(), reach);
    if (body.type != scenes::BodyType::dynamic) return;
    const double density = m_scene.fixtures[static_cast<std::size_t>(fixture.fixture)].density;
    const std::array<double, 4> moments = MomentsOf(fixture, corners);
    Sum& sum = m_sums[index];
    sum.mass += density * moments[0];
    sum.x += density * moments[1];
    sum.y += density * moments[2];
    sum.inertia += density * moments[3];
}

void BodyRows::Note(const Snapshot& snapshot) {
    const auto isNew = [&](const BodyState& body) { return !m_isKnown[static_cast<std::size_t>(body.index)]; };
    if (std::ranges::none_of(snapshot.bodies, isNew)) return;
    for (const FixtureState& fixture : snapshot.fixtures) {
        if (isNew(snapshot.bodies[static_cast<std::size_t>(fixture.body)])) AddShape(snapshot, fixture);
    }
    for (const BodyState& body : snapshot.bodies) {
        if (!isNew(body)) continue;
        const auto index = static_cast<std::size_t>(body.index);
        m_isKnown[index] = true;
        if (body.type != scenes::BodyType::dynamic) continue;
        const Sum& sum = m_sums[index];
        BodyMass& mass = m_masses[index];
        // An engine gives a dynamic body without mass one of 1 kg.
        mass.mass = sum.mass > 0 ? sum.mass : 1.0;
        if (sum.mass > 0 && !m_scene.bodies[index].fixedRotation) {
            mass.inertia = std::max(0.0, sum.inertia - (sum.x * sum.x + sum.y * sum.y) / sum.mass);
        }
        m_rows[index]["mass"] = mass.mass;
        m_rows[index]["inertia"] = mass.inertia;
    }
}

}  // namespace testbed
