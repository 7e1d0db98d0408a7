// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Snapshots made by hand for tests of pictures: bodies of every kind with contacts, joints and a tree, without engine.

#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "testbed/engines/snapshot.h"

namespace testbed {

inline Box JoinBoxes(const Box& a, const Box& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

/// Adds the subtree over fixtures first…last − 1, halved in index order; returns its root's index.
inline int AddSubtree(Snapshot& snapshot, int first, int last, int parent, int level) {
    const int index = static_cast<int>(snapshot.nodes.size());
    Box box = snapshot.fixtures[static_cast<size_t>(first)].tight;
    for (int i = first; i < last; ++i) box = JoinBoxes(box, snapshot.fixtures[static_cast<size_t>(i)].tight);
    snapshot.nodes.push_back({box, parent, -1, -1, last - first == 1 ? first : -1, level});
    if (last - first == 1) return index;
    const int middle = (first + last) / 2;
    const int child1 = AddSubtree(snapshot, first, middle, index, level + 1);
    const int child2 = AddSubtree(snapshot, middle, last, index, level + 1);
    snapshot.nodes[static_cast<size_t>(index)].child1 = child1;
    snapshot.nodes[static_cast<size_t>(index)].child2 = child2;
    return index;
}

inline void AddBody(Snapshot& snapshot, scenes::BodyType type, scenes::Vec2 position, const scenes::Shape& shape) {
    BodyState body{};
    body.index = static_cast<int>(snapshot.bodies.size());
    body.type = type;
    body.position = position;
    body.sin = 0.6f;
    body.cos = 0.8f;
    body.awake = body.index % 5 != 4;
    body.bullet = body.index % 7 == 6;
    FixtureState fixture{};
    fixture.body = fixture.fixture = body.index;
    fixture.shape = shape;
    fixture.sensor = body.index % 11 == 10;
    fixture.tight = {{position.x - 1, position.y - 1}, {position.x + 1, position.y + 1}};
    snapshot.bodies.push_back(body);
    snapshot.fixtures.push_back(fixture);
}

/// `columns` × `rows` bodies, 2 m apart, of all types and shapes, each touching its right neighbour.
inline Snapshot MakeSampleSnapshot(int columns, int rows, const std::string& engine) {
    using scenes::BodyType;
    using scenes::ShapeType;
    Snapshot snapshot;
    snapshot.engine = engine;
    snapshot.broadPhase = "unified";
    snapshot.scene = "sample";
    snapshot.size = columns;
    snapshot.step = 3;
    scenes::Shape circle, box, triangle, edge;
    circle.radius = 0.7f;
    box.type = ShapeType::box;
    box.halfExtents = {0.9f, 0.4f};
    box.angle = 0.3f;
    triangle.type = ShapeType::polygon;
    triangle.vertexCount = 3;
    triangle.vertices = {scenes::Vec2{-0.8f, -0.5f}, scenes::Vec2{0.8f, -0.5f}, scenes::Vec2{0, 0.9f}};
    edge.type = ShapeType::edge;
    edge.vertexCount = 2;
    edge.vertices = {scenes::Vec2{-1, 0}, scenes::Vec2{1, 0.2f}};
    const scenes::Shape* shapes[] = {&circle, &box, &triangle, &edge};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int index = row * columns + column;
            const BodyType type =
                row == 0 ? BodyType::isStatic : (index % 9 == 8 ? BodyType::kinematic : BodyType::dynamic);
            const scenes::Vec2 position{2.0f * static_cast<float>(column), 2.0f * static_cast<float>(row)};
            AddBody(snapshot, type, position, *shapes[index % 4]);
            if (column == 0) continue;
            const scenes::Vec2 point{position.x - 1, position.y};
            snapshot.contacts.push_back({index - 1, index, index % 3 != 0, 1, {1, 0}, {point, {}}, {}, {2.0f, 0}, {}});
        }
    }
    snapshot.joints.push_back({0, columns + 1, {0, 1}, {0.5f, 1}});
    AddSubtree(snapshot, 0, static_cast<int>(snapshot.fixtures.size()), -1, 0);
    return snapshot;
}

}  // namespace testbed
