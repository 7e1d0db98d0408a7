// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One function per layer. Sizes that must be seen at any zoom (points, lines) are in pixels, bodies in metres with a
// least size, so that a world of small circles does not vanish.

#include "testbed/view/scene_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "testbed/render/font.h"
#include "testbed/view/canvas.h"

namespace testbed {

namespace {

using scenes::BodyType;
using scenes::JointType;
using scenes::ShapeType;

struct Look {
    Color fill, border;
};

constexpr Look dynamicLook{{240, 176, 176, 84}, {250, 200, 200, 140}};
constexpr Look sleepingLook{{150, 150, 172, 80}, {170, 170, 196, 165}};
constexpr Look staticLook{{126, 190, 96, 72}, {156, 214, 120, 140}};
constexpr Look kinematicLook{{128, 140, 236, 84}, {166, 176, 250, 180}};
constexpr Look bulletLook{{255, 214, 92, 120}, {255, 232, 150, 220}};
constexpr Look sensorLook{{84, 206, 220, 36}, {110, 222, 236, 160}};

constexpr Color contactColor{255, 226, 64, 255}, normalColor{108, 204, 255, 255}, impulseColor{255, 142, 44, 255};
constexpr Color jointColor{112, 226, 214, 210}, aabbColor{132, 176, 255, 150}, labelColor{255, 255, 255, 255};

/// Levels and islands take these in turn; told apart with common colour blindness (after Okabe and Ito, "Color
/// universal design", 2008, lightened for a dark background).
constexpr std::array<Color, 7> cycle{Color{240, 176, 40, 255}, Color{104, 190, 240, 255}, Color{38, 186, 140, 255},
                                     Color{244, 232, 90, 255}, Color{70, 140, 214, 255},  Color{232, 116, 50, 255},
                                     Color{220, 144, 188, 255}};

constexpr double minRadius = 1.25;    // pixels, of a body
constexpr double pointRadius = 2.5;   // pixels, of a contact
constexpr double normalLength = 14;   // pixels
constexpr double impulseLength = 44;  // pixels, of the largest impulse of the picture
constexpr double turnMarkRadius = 5;  // pixels, of the smallest circle that shows how it is turned
constexpr size_t maxBodiesAllLabelled = 200;

class SceneDrawer {
public:
    SceneDrawer(const Snapshot& snapshot, const Camera& camera, DrawList& list)
        : m_snapshot(snapshot), m_camera(camera), m_list(list), m_canvas(list) {}

    void DrawBodies(bool byIsland);
    void DrawBoxes();
    void DrawNodes(const NodeSelection& nodes);
    void DrawJoints();
    void DrawContacts(const Layers& layers);
    void DrawLabels();

private:
    [[nodiscard]] Point ToPixel(double x, double y) const { return {m_camera.ToPixelX(x), m_camera.ToPixelY(y)}; }
    [[nodiscard]] Point ToPixel(const scenes::Vec2& v) const { return ToPixel(v.x, v.y); }
    [[nodiscard]] Point ToPixel(const BodyState& body, double localX, double localY) const {
        return ToPixel(body.position.x + body.cos * localX - body.sin * localY,
                       body.position.y + body.sin * localX + body.cos * localY);
    }
    [[nodiscard]] const BodyState& GetBody(const FixtureState& fixture) const {
        return m_snapshot.bodies[static_cast<size_t>(fixture.body)];
    }
    [[nodiscard]] Look GetLook(const FixtureState& fixture) const;
    void DrawArm(int body, Point anchor);
    void DrawFixture(const FixtureState& fixture, const Look& look);
    void DrawCircleFixture(const BodyState& body, const scenes::Shape& shape, const Look& look);
    void DrawPolygonFixture(const BodyState& body, const scenes::Shape& shape, const Look& look);

    const Snapshot& m_snapshot;
    const Camera& m_camera;
    DrawList& m_list;
    Canvas m_canvas;
    std::vector<Point> m_points;
};

/// Borders are a pixel wide, thinner on bodies so small that they would be all border.
double GetBorderWidth(double radius) { return std::min(1.0, radius / 3); }

Look SceneDrawer::GetLook(const FixtureState& fixture) const {
    const BodyState& body = GetBody(fixture);
    if (fixture.sensor) return sensorLook;
    if (body.type == BodyType::isStatic) return staticLook;
    if (body.type == BodyType::kinematic) return kinematicLook;
    if (!body.awake) return sleepingLook;
    return body.bullet ? bulletLook : dynamicLook;
}

void SceneDrawer::DrawCircleFixture(const BodyState& body, const scenes::Shape& shape, const Look& look) {
    const Point center = ToPixel(body, shape.center.x, shape.center.y);
    const double radius = std::max(shape.radius * m_camera.pixelsPerMetre, minRadius);
    const Point axis{body.cos, -body.sin};
    m_canvas.DrawCircle(center, radius, axis, look.fill, look.border, GetBorderWidth(radius));
    if (radius < turnMarkRadius) return;
    m_canvas.DrawLine(center, {center.x + axis.x * radius, center.y + axis.y * radius}, 1, look.border);
}

void SceneDrawer::DrawPolygonFixture(const BodyState& body, const scenes::Shape& shape, const Look& look) {
    m_points.clear();
    if (shape.type == ShapeType::box) {
        // The library's cos and sin serve turned boxes alone, and only a drawing: the engines' poses are not touched.
        const double c = shape.angle == 0 ? 1 : std::cos(shape.angle);
        const double s = shape.angle == 0 ? 0 : std::sin(shape.angle);
        constexpr std::array<std::array<int, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        for (const auto& [signX, signY] : corners) {
            const double x = signX * shape.halfExtents.x, y = signY * shape.halfExtents.y;
            m_points.push_back(ToPixel(body, shape.center.x + c * x - s * y, shape.center.y + s * x + c * y));
        }
    } else {
        for (const scenes::Vec2& vertex : shape.Vertices()) m_points.push_back(ToPixel(body, vertex.x, vertex.y));
    }
    Point center{0, 0};
    for (const Point& point : m_points) {
        center.x += point.x / static_cast<double>(m_points.size());
        center.y += point.y / static_cast<double>(m_points.size());
    }
    double nearest = 1e300, farthest = 0;  // distances of corners from the centre
    for (const Point& point : m_points) {
        const double dx = point.x - center.x, dy = point.y - center.y;
        const double distance = std::sqrt(dx * dx + dy * dy);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    if (farthest < minRadius) {
        m_canvas.DrawDisk(center, minRadius, look.border);
    } else {
        m_canvas.DrawConvex(m_points, look.fill, look.border, GetBorderWidth(nearest));
    }
}

void SceneDrawer::DrawFixture(const FixtureState& fixture, const Look& look) {
    const BodyState& body = GetBody(fixture);
    switch (fixture.shape.type) {
        case ShapeType::circle:
            return DrawCircleFixture(body, fixture.shape, look);
        case ShapeType::chain:  // a snapshot lists its edges
            return;
        case ShapeType::edge: {
            const std::span<const scenes::Vec2> ends = fixture.shape.Vertices();
            return m_canvas.DrawLine(ToPixel(body, ends[0].x, ends[0].y), ToPixel(body, ends[1].x, ends[1].y), 1.5,
                                     look.border);
        }
        case ShapeType::box:
        case ShapeType::polygon:
            return DrawPolygonFixture(body, fixture.shape, look);
    }
}

void SceneDrawer::DrawBodies(bool byIsland) {
    const std::vector<int> islands = byIsland ? FindIslands(m_snapshot) : std::vector<int>{};
    // Dynamic bodies come last, over the scenery.
    for (const bool isDynamicTurn : {false, true}) {
        for (const FixtureState& fixture : m_snapshot.fixtures) {
            if ((GetBody(fixture).type == BodyType::dynamic) != isDynamicTurn) continue;
            Look look = GetLook(fixture);
            if (byIsland && isDynamicTurn) {
                const auto island = static_cast<size_t>(islands[static_cast<size_t>(fixture.body)]);
                const bool isAwake = GetBody(fixture).awake;
                look.fill = look.border = cycle[island % cycle.size()];
                look.fill.a = isAwake ? 150 : 60;
                look.border.a = isAwake ? 230 : 110;
            }
            DrawFixture(fixture, look);
        }
    }
}

void SceneDrawer::DrawBoxes() {
    for (const FixtureState& fixture : m_snapshot.fixtures) {
        const PixelRect rect = ProjectBox(fixture.tight, 0, m_camera);
        m_canvas.DrawFrame({rect.x0, rect.y0}, {rect.x1, rect.y1}, 1, aabbColor);
    }
}

void SceneDrawer::DrawNodes(const NodeSelection& nodes) {
    for (const NodeState& node : m_snapshot.nodes) {
        if (!IsSelected(nodes, node)) continue;
        const PixelRect rect = ProjectBox(node.box, 0, m_camera);
        m_canvas.DrawFrame({rect.x0, rect.y0}, {rect.x1, rect.y1}, 1,
                           cycle[static_cast<size_t>(node.level) % cycle.size()]);
    }
}

void SceneDrawer::DrawArm(int body, Point anchor) {
    const BodyState& state = m_snapshot.bodies[static_cast<size_t>(body)];
    // The origin of scenery is no place to point at.
    if (state.type != BodyType::isStatic) m_canvas.DrawLine(ToPixel(state.position), anchor, 1, jointColor);
}

void SceneDrawer::DrawJoints() {
    for (const JointState& joint : m_snapshot.joints) {
        const Point a = ToPixel(joint.anchorA), b = ToPixel(joint.anchorB);
        DrawArm(joint.bodyA, a);
        DrawArm(joint.bodyB, b);
        m_canvas.DrawDisk(a, pointRadius, jointColor);
        if (joint.type == JointType::gear) continue;  // a line between its wheels would hide more than it tells
        if (joint.type == JointType::pulley) {
            const Point groundA = ToPixel(joint.groundAnchorA), groundB = ToPixel(joint.groundAnchorB);
            m_canvas.DrawLine(a, groundA, 1, jointColor);
            m_canvas.DrawLine(groundA, groundB, 1, jointColor);
            m_canvas.DrawLine(groundB, b, 1, jointColor);
        } else {
            m_canvas.DrawLine(a, b, 1, jointColor);
        }
        if (joint.type != JointType::revolute) m_canvas.DrawDisk(b, pointRadius, jointColor);
    }
}

void SceneDrawer::DrawContacts(const Layers& layers) {
    float largestImpulse = 0;
    for (const ContactState& contact : m_snapshot.contacts) {
        for (int i = 0; i < contact.pointCount; ++i)
            largestImpulse = std::max(largestImpulse, contact.normalImpulses[i]);
    }
    for (const ContactState& contact : m_snapshot.contacts) {
        for (int i = 0; i < contact.pointCount; ++i) {
            const Point point = ToPixel(contact.points[i]);
            const auto along = [&](double length) {
                return Point{point.x + contact.normal.x * length, point.y - contact.normal.y * length};
            };
            if (layers.normals) m_canvas.DrawLine(point, along(normalLength), 1, normalColor);
            if (layers.impulses && largestImpulse > 0) {
                m_canvas.DrawLine(point, along(impulseLength * contact.normalImpulses[i] / largestImpulse), 2,
                                  impulseColor);
            }
            if (layers.contacts) m_canvas.DrawDisk(point, pointRadius, contactColor);
        }
    }
}

void SceneDrawer::DrawLabels() {
    std::vector<bool> isLabelled(m_snapshot.bodies.size(), false);
    for (const FixtureState& fixture : m_snapshot.fixtures) {
        const auto index = static_cast<size_t>(fixture.body);
        const PixelRect rect = ProjectBox(fixture.tight, 0, m_camera);
        const bool isLarge = rect.y1 - rect.y0 >= glyphHeight + 3;
        if (isLabelled[index] || !(isLarge || m_snapshot.bodies.size() <= maxBodiesAllLabelled)) continue;
        // Off the picture, and not finite, fail alike.
        const Point center{(rect.x0 + rect.x1) * 0.5, (rect.y0 + rect.y1) * 0.5};
        if (!(center.x >= 0 && center.x < m_list.width && center.y >= 0 && center.y < m_list.height)) continue;
        const std::string text = std::to_string(m_snapshot.bodies[index].index);
        m_list.texts.push_back({static_cast<int>(center.x) - GetTextWidth(text, 1) / 2, static_cast<int>(center.y) - 4,
                                1, labelColor, text});
        isLabelled[index] = true;
    }
}

}  // namespace

std::vector<int> FindIslands(const Snapshot& snapshot) {
    std::vector<int> parents(snapshot.bodies.size());
    std::iota(parents.begin(), parents.end(), 0);
    const auto find = [&parents](int body) {
        while (parents[static_cast<size_t>(body)] != body) {
            int& parent = parents[static_cast<size_t>(body)];
            parent = parents[static_cast<size_t>(parent)];
            body = parent;
        }
        return body;
    };
    const auto isDynamic = [&snapshot](int body) {
        return snapshot.bodies[static_cast<size_t>(body)].type == BodyType::dynamic;
    };
    const auto join = [&](int bodyA, int bodyB) {
        if (!isDynamic(bodyA) || !isDynamic(bodyB)) return;
        const int a = find(bodyA), b = find(bodyB);
        parents[static_cast<size_t>(std::max(a, b))] = std::min(a, b);  // the root is the smallest index
    };
    for (const ContactState& contact : snapshot.contacts) {
        const FixtureState& a = snapshot.fixtures[static_cast<size_t>(contact.fixtureA)];
        const FixtureState& b = snapshot.fixtures[static_cast<size_t>(contact.fixtureB)];
        if (contact.touching && !a.sensor && !b.sensor) join(a.body, b.body);
    }
    for (const JointState& joint : snapshot.joints) join(joint.bodyA, joint.bodyB);
    std::vector<int> islands(parents.size(), -1);
    for (int body = 0; body < static_cast<int>(parents.size()); ++body) {
        if (isDynamic(body)) islands[static_cast<size_t>(body)] = find(body);
    }
    return islands;
}

DrawList BuildDrawList(const Snapshot& snapshot, const Camera& camera, const Layers& layers, const NodeSelection& nodes,
                       int supersampling) {
    DrawList list;
    list.width = camera.width;
    list.height = camera.height;
    list.supersampling = supersampling;
    SceneDrawer drawer(snapshot, camera, list);
    if (layers.bodies || layers.islands) drawer.DrawBodies(layers.islands);
    if (layers.aabbs) drawer.DrawBoxes();
    if (layers.bvh) drawer.DrawNodes(nodes);
    if (layers.joints) drawer.DrawJoints();
    if (layers.contacts || layers.normals || layers.impulses) drawer.DrawContacts(layers);
    if (layers.labels) drawer.DrawLabels();
    return list;
}

}  // namespace testbed
