// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The broad phase of Box2D 3 beside a world. Box2D 3 does not let programs see the three trees of its worlds. These are
// trees of the same library, one for each type of bodies, and follow the same rules. Fat boxes grow when a body leaves
// them, and what grew is rebuilt before each search.

#pragma once

#include <box2d/box2d.h>
#include <box2d/collision.h>

#include <functional>
#include <vector>

#include "testbed/engines/box2d3/box2d3_shape.h"

namespace testbed::box2d3 {

class Trees {
public:
    Trees();
    ~Trees();
    Trees(const Trees&) = delete;
    Trees& operator=(const Trees&) = delete;

    /// Adds a box; its number counts up from 0.
    void Add(scenes::BodyType type, const Shape& shape, b2WorldTransform pose);
    void Remove(size_t number);
    /// Of all that were added.
    [[nodiscard]] size_t GetCount() const { return m_proxies.size(); }
    /// After a step.
    void Move(size_t number, b2WorldTransform pose);
    /// What Box2D 3 does before it searches pairs.
    void Rebuild();
    /// The three as one tree: nodes that the library does not have join their roots. `pairs`: counts the pairs of their
    /// boxes too, of a snapshot with bodies and fixtures. `fixtureOf` maps a box's number to an index into
    /// Snapshot::fixtures; null: they are the same.
    void Dump(Snapshot& snapshot, bool pairs, const std::function<int(size_t)>& fixtureOf = nullptr) const;

private:
    struct Proxy {
        int tree, id;
        float margin;
        Shape shape;
        b2AABB fat;
    };
    b2DynamicTree m_trees[3];
    std::vector<Proxy> m_proxies;
};

}  // namespace testbed::box2d3
