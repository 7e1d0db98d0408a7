// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of tree_query.h.

#include "testbed/view/tree_query.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace testbed {

namespace {

bool Contains(const Box& box, Vec2 point) {
    return box.lower.x <= point.x && point.x <= box.upper.x && box.lower.y <= point.y && point.y <= box.upper.y;
}

double GetArea(const Box& box) {
    return (double{box.upper.x} - double{box.lower.x}) * (double{box.upper.y} - double{box.lower.y});
}

/// In body coordinates.
bool Contains(std::span<const Vec2> vertices, Vec2 p) {
    for (size_t i = 0; i < vertices.size(); ++i) {
        const Vec2 a = vertices[i], b = vertices[(i + 1) % vertices.size()];
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
    }
    return true;
}

bool Contains(const FixtureState& fixture, Vec2 p) {
    const scenes::Shape& shape = fixture.shape;
    switch (shape.type) {
        case scenes::ShapeType::circle: {
            const float dx = p.x - shape.center.x, dy = p.y - shape.center.y;
            return dx * dx + dy * dy <= shape.radius * shape.radius;
        }
        case scenes::ShapeType::box: {
            const float dx = p.x - shape.center.x, dy = p.y - shape.center.y;
            const float c = std::cos(shape.angle), s = std::sin(shape.angle);
            return std::abs(c * dx + s * dy) <= shape.halfExtents.x && std::abs(c * dy - s * dx) <= shape.halfExtents.y;
        }
        case scenes::ShapeType::polygon:
            return Contains(shape.Vertices(), p);
        case scenes::ShapeType::edge:
        case scenes::ShapeType::chain:
            return false;
        default:
            return Contains(fixture.outline, p);
    }
}

}  // namespace

Vec2 ToLocal(const BodyState& body, Vec2 point) {
    const float dx = point.x - body.position.x, dy = point.y - body.position.y;
    return {body.cos * dx + body.sin * dy, body.cos * dy - body.sin * dx};
}

Vec2 ToWorld(const BodyState& body, Vec2 localPoint) {
    return {body.position.x + body.cos * localPoint.x - body.sin * localPoint.y,
            body.position.y + body.sin * localPoint.x + body.cos * localPoint.y};
}

int FindBodyAt(const Snapshot& snapshot, Vec2 point) {
    for (size_t i = snapshot.fixtures.size(); i-- > 0;) {
        const FixtureState& fixture = snapshot.fixtures[i];
        const BodyState& body = snapshot.bodies[static_cast<size_t>(fixture.body)];
        if (body.type != scenes::BodyType::dynamic || !Contains(fixture.tight, point)) continue;
        if (Contains(fixture, ToLocal(body, point))) return fixture.body;
    }
    return -1;
}

int FindNodeAt(const Snapshot& snapshot, const NodeSelection& selection, Vec2 point) {
    int found = -1;
    double foundArea = 0;
    for (size_t i = 0; i < snapshot.nodes.size(); ++i) {
        const NodeState& node = snapshot.nodes[i];
        if (!IsSelected(selection, node) || !Contains(node.box, point)) continue;
        const double area = GetArea(node.box);
        const bool isBetter = found < 0 || area < foundArea ||
                              (area == foundArea && node.level >= snapshot.nodes[static_cast<size_t>(found)].level);
        if (!isBetter) continue;
        found = static_cast<int>(i);
        foundArea = area;
    }
    return found;
}

std::vector<int> GetPath(std::span<const NodeState> nodes, int node) {
    std::vector<int> path;
    for (; node >= 0; node = nodes[static_cast<size_t>(node)].parent) path.push_back(node);
    std::reverse(path.begin(), path.end());
    return path;
}

std::string DescribePath(std::span<const NodeState> nodes, int node) {
    std::string text = "root";
    const std::vector<int> path = GetPath(nodes, node);
    for (size_t i = 1; i < path.size(); ++i) {
        text += nodes[static_cast<size_t>(path[i - 1])].child1 == path[i] ? " 1" : " 2";
    }
    return text;
}

int CountLeaves(std::span<const NodeState> nodes, int node) {
    int leaves = 0;
    for (std::vector<int> stack{node}; !stack.empty();) {
        const NodeState& n = nodes[static_cast<size_t>(stack.back())];
        stack.pop_back();
        if (n.child1 < 0) {
            ++leaves;
        } else {
            stack.push_back(n.child2);
            stack.push_back(n.child1);
        }
    }
    return leaves;
}

QueryTrace TraceQuery(std::span<const NodeState> nodes, const Box& query) {
    QueryTrace trace;
    if (nodes.empty()) return trace;
    for (std::vector<int> stack{0}; !stack.empty();) {
        const int index = stack.back();
        const NodeState& node = nodes[static_cast<size_t>(index)];
        stack.pop_back();
        ++trace.tested;
        if (!Overlaps(node.box, query)) continue;
        trace.visited.push_back(index);
        if (node.child1 < 0) {
            ++trace.leaves;
        } else {
            stack.push_back(node.child2);
            stack.push_back(node.child1);
        }
    }
    return trace;
}

}  // namespace testbed
