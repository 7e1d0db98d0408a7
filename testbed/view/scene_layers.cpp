// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One function per layer. Sizes that must be seen at any zoom (points, lines) are in pixels, bodies in metres with a
// least size, so that a world of small circles does not vanish.

#include "testbed/view/scene_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "testbed/picture/font.h"
#include "testbed/view/canvas.h"
#include "testbed/view/islands.h"

namespace testbed {

namespace {

using scenes::BodyType;
using scenes::JointType;
using scenes::ShapeType;

constexpr double minRadius = 1.25;      // pixels, of a body
constexpr double pointRadius = 2.5;     // pixels, of a contact
constexpr double normalLength = 14;     // pixels
constexpr double impulseLength = 44;    // pixels, of the largest impulse of the picture
constexpr double velocityLength = 60;   // pixels, of the fastest body of the picture
constexpr double arrowHead = 5;         // pixels, at most a third of the arrow
constexpr double turnRadius = 9;        // pixels, of the arc of angular velocity
constexpr double partitionReach = 0.6;  // of the way from a contact to its bodies
constexpr double turnMarkRadius = 5;    // pixels, of the smallest circle that shows how it is turned
constexpr size_t maxBodiesAllLabelled = 200;

/// Keeps texts apart: of those that would overlap, the first stays.
class TakenPixels {
public:
    TakenPixels(int width, int height)
        : m_width(width), m_height(height), m_taken(static_cast<size_t>(width) * static_cast<size_t>(height), false) {}

    /// False, and nothing is taken, where a pixel of the box is taken already.
    bool Take(PixelBox box) {
        box = {std::max(box.x0, 0), std::max(box.y0, 0), std::min(box.x1, m_width), std::min(box.y1, m_height)};
        for (const bool isTest : {true, false}) {
            for (int y = box.y0; y < box.y1; ++y) {
                const auto row = m_taken.begin() + static_cast<std::ptrdiff_t>(y) * m_width;
                if (isTest && std::find(row + box.x0, row + box.x1, true) != row + box.x1) return false;
                if (!isTest) std::fill(row + box.x0, row + box.x1, true);
            }
        }
        return true;
    }

private:
    int m_width, m_height;
    std::vector<bool> m_taken;
};

class SceneDrawer {
public:
    SceneDrawer(const Snapshot& snapshot, const Camera& camera, const SceneLook& look, DrawList& list)
        : m_snapshot(snapshot),
          m_camera(camera),
          m_sceneLook(look),
          m_colors(GetTheme(look.theme)),
          m_list(list),
          m_canvas(list) {}

    void Draw(Layer layer);

private:
    void DrawBodies();
    void DrawIslands();
    void DrawPartitions();
    void DrawBox(const Box& box, const Color& color);
    void DrawNodes();
    void DrawFattenedBoxes();
    void DrawJoints();
    void DrawVelocities();
    void DrawTurn(Point center, double share);
    void DrawContacts(Layer layer);
    void DrawLabels();
    [[nodiscard]] const Color& Cycle(int index) const {
        return m_colors.cycle[static_cast<size_t>(index) % m_colors.cycle.size()];
    }
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
    [[nodiscard]] const Look& GetStateLook(const FixtureState& fixture) const;
    void DrawArm(int body, Point anchor);
    void DrawFixture(const FixtureState& fixture, const Look& look);
    void DrawCircleFixture(const BodyState& body, const scenes::Shape& shape, const Look& look);
    void DrawPolygonFixture(const BodyState& body, const FixtureState& fixture, const Look& look);

    const Snapshot& m_snapshot;
    const Camera& m_camera;
    const SceneLook& m_sceneLook;
    const ThemeColors& m_colors;
    DrawList& m_list;
    Canvas m_canvas;
    std::vector<Point> m_points;
};

/// Borders are a pixel wide, thinner on bodies so small that they would be all border.
double GetBorderWidth(double radius) { return std::min(1.0, radius / 3); }

Look SceneDrawer::GetLook(const FixtureState& fixture) const {
    Look look = GetStateLook(fixture);
    if (m_sceneLook.isOverCounts) {
        look.fill.a /= 2;
        look.border.a /= 2;
    }
    return look;
}

const Look& SceneDrawer::GetStateLook(const FixtureState& fixture) const {
    const BodyState& body = GetBody(fixture);
    if (fixture.sensor) return m_colors.sensor;
    if (body.type == BodyType::isStatic) return m_colors.isStatic;
    if (body.type == BodyType::kinematic) return m_colors.kinematic;
    if (!body.awake) return m_colors.sleeping;
    return body.bullet ? m_colors.bullet : m_colors.awake;
}

void SceneDrawer::DrawCircleFixture(const BodyState& body, const scenes::Shape& shape, const Look& look) {
    const Point center = ToPixel(body, shape.center.x, shape.center.y);
    const double radius = std::max(shape.radius * m_camera.pixelsPerMetre, minRadius);
    const Point axis{body.cos, -body.sin};
    m_canvas.DrawCircle(center, radius, axis, look.fill, look.border, GetBorderWidth(radius));
    if (radius < turnMarkRadius) return;
    m_canvas.DrawLine(center, {center.x + axis.x * radius, center.y + axis.y * radius}, 1, look.border);
}

void SceneDrawer::DrawPolygonFixture(const BodyState& body, const FixtureState& fixture, const Look& look) {
    const scenes::Shape& shape = fixture.shape;
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
        const std::span<const scenes::Vec2> vertices = fixture.outline.empty() ? shape.Vertices() : fixture.outline;
        for (const scenes::Vec2& vertex : vertices) m_points.push_back(ToPixel(body, vertex.x, vertex.y));
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
        default:
            return DrawPolygonFixture(body, fixture, look);
    }
}

void SceneDrawer::DrawBodies() {
    // Dynamic bodies come last, over the scenery. The layer of islands draws them itself.
    for (const bool isDynamicTurn : {false, true}) {
        if (isDynamicTurn && m_sceneLook.layers.Has(Layer::islands)) continue;
        for (const FixtureState& fixture : m_snapshot.fixtures) {
            if ((GetBody(fixture).type == BodyType::dynamic) == isDynamicTurn) DrawFixture(fixture, GetLook(fixture));
        }
    }
}

void SceneDrawer::DrawIslands() {
    const std::vector<int> islands = FindIslands(m_snapshot);
    for (const FixtureState& fixture : m_snapshot.fixtures) {
        if (GetBody(fixture).type != BodyType::dynamic) continue;
        Look look{Cycle(islands[static_cast<size_t>(fixture.body)]), {}};
        look.border = look.fill;
        const bool isAwake = GetBody(fixture).awake;
        look.fill.a = isAwake ? 150 : 60;
        look.border.a = isAwake ? 230 : 110;
        DrawFixture(fixture, look);
    }
}

void SceneDrawer::DrawPartitions() {
    const Partitions partitions = FindPartitions(m_snapshot);
    for (size_t i = 0; i < m_snapshot.contacts.size(); ++i) {
        const ContactState& contact = m_snapshot.contacts[i];
        if (partitions.contactColors[i] < 0 || contact.pointCount == 0) continue;
        Point middle{0, 0};
        for (int k = 0; k < contact.pointCount; ++k) {
            const Point point = ToPixel(contact.points[k]);
            middle.x += point.x / contact.pointCount;
            middle.y += point.y / contact.pointCount;
        }
        for (const int index : {contact.fixtureA, contact.fixtureB}) {
            const FixtureState& fixture = m_snapshot.fixtures[static_cast<size_t>(index)];
            if (GetBody(fixture).type != BodyType::dynamic) continue;
            const PixelRect rect = ProjectBox(fixture.tight, 0, m_camera);
            const Point center{(rect.x0 + rect.x1) * 0.5, (rect.y0 + rect.y1) * 0.5};
            const Point end{middle.x + (center.x - middle.x) * partitionReach,
                            middle.y + (center.y - middle.y) * partitionReach};
            m_canvas.DrawLine(middle, end, 2.5, Cycle(partitions.contactColors[i]));
        }
    }
}

void SceneDrawer::DrawBox(const Box& box, const Color& color) {
    const PixelRect rect = ProjectBox(box, 0, m_camera);
    m_canvas.DrawFrame({rect.x0, rect.y0}, {rect.x1, rect.y1}, 1, color);
}

void SceneDrawer::DrawNodes() {
    for (const NodeState& node : m_snapshot.nodes) {
        if (IsSelected(m_sceneLook.nodes, node)) DrawBox(node.box, Cycle(node.level));
    }
}

void SceneDrawer::DrawFattenedBoxes() {
    for (const NodeState& node : m_snapshot.nodes) {
        if (node.fixture >= 0) DrawBox(node.box, m_colors.fattenedBox);
    }
}

void SceneDrawer::DrawArm(int body, Point anchor) {
    const BodyState& state = m_snapshot.bodies[static_cast<size_t>(body)];
    // The origin of scenery is no place to point at.
    if (state.type != BodyType::isStatic) m_canvas.DrawLine(ToPixel(state.position), anchor, 1, m_colors.joint);
}

void SceneDrawer::DrawJoints() {
    for (const JointState& joint : m_snapshot.joints) {
        const Point a = ToPixel(joint.anchorA), b = ToPixel(joint.anchorB);
        DrawArm(joint.bodyA, a);
        DrawArm(joint.bodyB, b);
        m_canvas.DrawDisk(a, pointRadius, m_colors.joint);
        if (joint.type == JointType::gear) continue;  // a line between its wheels would hide more than it tells
        if (joint.type == JointType::pulley) {
            const Point groundA = ToPixel(joint.groundAnchorA), groundB = ToPixel(joint.groundAnchorB);
            m_canvas.DrawLine(a, groundA, 1, m_colors.joint);
            m_canvas.DrawLine(groundA, groundB, 1, m_colors.joint);
            m_canvas.DrawLine(groundB, b, 1, m_colors.joint);
        } else {
            m_canvas.DrawLine(a, b, 1, m_colors.joint);
        }
        if (joint.type != JointType::revolute) m_canvas.DrawDisk(b, pointRadius, m_colors.joint);
    }
}

/// An arc of up to three quarters of a circle from the right, counter-clockwise for a positive share, as short lines.
void SceneDrawer::DrawTurn(Point center, double share) {
    constexpr int steps = 24;
    constexpr double sine = 0.1950903220161282, cosine = 0.9807852804032304;  // of a 32nd of a turn
    const int count = std::min(steps, static_cast<int>(std::abs(share) * steps + 0.5));
    Point arm{turnRadius, 0};
    for (int i = 0; i < count; ++i) {
        const double turn = share > 0 ? -sine : sine;  // y is down on the picture
        const Point next{arm.x * cosine - arm.y * turn, arm.x * turn + arm.y * cosine};
        m_canvas.DrawLine({center.x + arm.x, center.y + arm.y}, {center.x + next.x, center.y + next.y}, 1.5,
                          m_colors.velocity);
        arm = next;
    }
    if (count > 0) m_canvas.DrawDisk({center.x + arm.x, center.y + arm.y}, 1.5, m_colors.velocity);
}

void SceneDrawer::DrawVelocities() {
    const Peaks peaks = m_sceneLook.peaks.value_or(FindPeaks(m_snapshot));
    for (const BodyState& body : m_snapshot.bodies) {
        if (body.type == BodyType::isStatic) continue;
        const Point from = ToPixel(body.position);
        if (peaks.turn > 0) DrawTurn(from, body.angularVelocity / peaks.turn);
        if (!(peaks.speed > 0)) continue;
        const double scale = velocityLength / peaks.speed;
        const Point arrow{body.linearVelocity.x * scale, -body.linearVelocity.y * scale};
        const double length = std::sqrt(arrow.x * arrow.x + arrow.y * arrow.y);
        if (!(length >= 1)) continue;
        const double head = std::min(arrowHead, length / 3);
        const Point along{arrow.x / length, arrow.y / length};
        const Point tip{from.x + arrow.x, from.y + arrow.y};
        const Point neck{tip.x - along.x * head, tip.y - along.y * head};
        m_canvas.DrawLine(from, neck, 1.5, m_colors.velocity);
        m_canvas.FillConvex(
            std::array<Point, 3>{tip, Point{neck.x - along.y * head * 0.6, neck.y + along.x * head * 0.6},
                                 Point{neck.x + along.y * head * 0.6, neck.y - along.x * head * 0.6}},
            m_colors.velocity);
    }
}

void SceneDrawer::DrawContacts(Layer layer) {
    const double largestImpulse = m_sceneLook.peaks.value_or(FindPeaks(m_snapshot)).impulse;
    for (const ContactState& contact : m_snapshot.contacts) {
        for (int i = 0; i < contact.pointCount; ++i) {
            const Point point = ToPixel(contact.points[i]);
            const auto along = [&](double length) {
                return Point{point.x + contact.normal.x * length, point.y - contact.normal.y * length};
            };
            if (layer == Layer::contacts) {
                m_canvas.DrawDisk(point, pointRadius, m_colors.contact);
            } else if (layer == Layer::normals) {
                m_canvas.DrawLine(point, along(normalLength), 1, m_colors.normal);
            } else if (largestImpulse > 0) {
                m_canvas.DrawLine(point, along(impulseLength * contact.normalImpulses[i] / largestImpulse), 2,
                                  m_colors.impulse);
            }
        }
    }
}

void SceneDrawer::DrawLabels() {
    std::vector<bool> isLabelled(m_snapshot.bodies.size(), false);
    TakenPixels taken(m_list.width, m_list.height);
    for (const FixtureState& fixture : m_snapshot.fixtures) {
        const auto index = static_cast<size_t>(fixture.body);
        const PixelRect rect = ProjectBox(fixture.tight, 0, m_camera);
        const bool isLarge = rect.y1 - rect.y0 >= capHeight + 4;
        if (isLabelled[index] || !(isLarge || m_snapshot.bodies.size() <= maxBodiesAllLabelled)) continue;
        // Off the picture, and not finite, fail alike.
        const Point center{(rect.x0 + rect.x1) * 0.5, (rect.y0 + rect.y1) * 0.5};
        if (!(center.x >= 0 && center.x < m_list.width && center.y >= 0 && center.y < m_list.height)) continue;
        const std::string text = std::to_string(m_snapshot.bodies[index].index);
        const int width = GetTextWidth(text, 1);
        const int x = static_cast<int>(center.x) - width / 2, y = static_cast<int>(center.y) - capHeight / 2;
        if (!taken.Take({x - 1, y - 1, x + width + 1, y + capHeight + 1})) continue;
        m_list.texts.push_back({x, y, 1, m_colors.label, text});
        isLabelled[index] = true;
    }
}

void SceneDrawer::Draw(Layer layer) {
    switch (layer) {
        case Layer::bodies:
            return DrawBodies();
        case Layer::islands:
            return DrawIslands();
        case Layer::partitions:
            return DrawPartitions();
        case Layer::bvh:
            return DrawNodes();
        case Layer::fattened:
            return DrawFattenedBoxes();
        case Layer::swept:
            for (const FixtureState& fixture : m_snapshot.fixtures) DrawBox(fixture.swept, m_colors.sweptBox);
            return;
        case Layer::aabbs:
            for (const FixtureState& fixture : m_snapshot.fixtures) DrawBox(fixture.tight, m_colors.tightBox);
            return;
        case Layer::joints:
            return DrawJoints();
        case Layer::velocities:
            return DrawVelocities();
        case Layer::impulses:
        case Layer::normals:
        case Layer::contacts:
            return DrawContacts(layer);
        case Layer::labels:
            return DrawLabels();
    }
}

}  // namespace

Peaks FindPeaks(const Snapshot& snapshot) {
    Peaks peaks;
    for (const ContactState& contact : snapshot.contacts) {
        for (int i = 0; i < contact.pointCount; ++i) {
            peaks.impulse = std::max(peaks.impulse, double{contact.normalImpulses[i]});
        }
    }
    for (const BodyState& body : snapshot.bodies) {
        if (body.type == BodyType::isStatic) continue;
        const double x = body.linearVelocity.x, y = body.linearVelocity.y;
        peaks.speed = std::max(peaks.speed, std::sqrt(x * x + y * y));
        peaks.turn = std::max(peaks.turn, std::abs(double{body.angularVelocity}));
    }
    return peaks;
}

Peaks JoinPeaks(const Peaks& a, const Peaks& b) {
    return {std::max(a.impulse, b.impulse), std::max(a.speed, b.speed), std::max(a.turn, b.turn)};
}

DrawList BuildDrawList(const Snapshot& snapshot, const Camera& camera, const SceneLook& look) {
    DrawList list;
    list.width = camera.width;
    list.height = camera.height;
    list.supersampling = look.supersampling;
    SceneDrawer drawer(snapshot, camera, look, list);
    for (const LayerInfo& info : layerTable) {
        if (look.layers.Has(info.layer)) drawer.Draw(info.layer);
    }
    return list;
}

}  // namespace testbed
