// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A Snapshot is what one engine's world looks like after a step, in one form for every engine. It is the only thing
// that the views, the metrics and the reports know of an engine. Bodies and fixtures keep the indices of scenes::Scene.

#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

using scenes::Vec2;

/// A closed axis-aligned box, m.
struct Box {
    Vec2 lower, upper;
};

/// The smallest box around two.
[[nodiscard]] inline Box Join(const Box& a, const Box& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

/// Whether two boxes touch or overlap; without branches, since trees are counted with it.
[[nodiscard]] inline bool Overlaps(const Box& a, const Box& b) {
    return (a.lower.x <= b.upper.x) & (b.lower.x <= a.upper.x) & (a.lower.y <= b.upper.y) & (b.lower.y <= a.upper.y);
}

/// State of one body; `index` is its index in scenes::Scene::bodies.
struct BodyState {
    int index;
    scenes::BodyType type;
    Vec2 position;   ///< origin of the body, world
    float sin, cos;  ///< rotation
    float angle;     ///< rad, not wrapped
    Vec2 linearVelocity;
    float angularVelocity;
    bool awake;
    bool bullet;
};

/// What one proxy of the broad phase stands for: a fixture, or one edge of a fixture that is a chain. Its shape is in
/// body coordinates and never a chain.
struct FixtureState {
    int body;     ///< index into Snapshot::bodies
    int fixture;  ///< index into scenes::Scene::fixtures
    int child;    ///< which edge of a chain; those of one chain follow each other
    scenes::Shape shape;
    bool sensor;
    Box tight;  ///< tight AABB at the snapshot's pose, skin included
    /// Around `tight` and the tight box before the last step; equals `tight` unless RunNeeds::sweptBoxes asks for it.
    Box swept{};
    /// Of the further convex shapes (scenes/outline.h): the farthest points along outlineDirections, in body
    /// coordinates. Else empty.
    std::vector<Vec2> outline{};
};
/// Of FixtureState::outline: chords of 3.75 degrees.
inline constexpr int outlineDirections = 96;

/// A contact (touching or not) with its manifold in world coordinates.
struct ContactState {
    int fixtureA, fixtureB;  ///< indices into Snapshot::fixtures
    bool touching;
    int pointCount;
    Vec2 normal;  ///< from A to B
    Vec2 points[2];
    float separations[2];
    float normalImpulses[2];  ///< N·s
    float tangentImpulses[2];
    /// The group in which the solver works on it: contacts of one colour share no dynamic body. −1: the engine does not
    /// tell. It is also −1 where the solver does not see this contact.
    int color = -1;
};

struct JointState {
    int bodyA, bodyB;  ///< indices into Snapshot::bodies
    Vec2 anchorA, anchorB;
    scenes::JointType type = scenes::JointType::revolute;
    Vec2 groundAnchorA{}, groundAnchorB{};  ///< pulley: where its rope is hung
};

/// A node of the broad-phase tree; children come after parents, the root is 0.
struct NodeState {
    Box box;
    int parent, child1, child2;  ///< −1: none
    int fixture;                 ///< index into Snapshot::fixtures for a leaf, else −1
    int level;                   ///< root 0
};

/// Wall times of one step by stage, ms.
struct StepTimes {
    double broadPhase = 0;  ///< AABB update + build + detection + matching + contact creation and removal
    double narrowPhase = 0;
    double solver = 0;      ///< finding islands included
    double islands = 0;     ///< the part of `solver` that finds islands; Box2D does not tell it: 0
    double continuous = 0;  ///< times of impact and their events
    double step = 0;
    double cpu = 0;  ///< processor time of the step, all threads together: not lengthened by other programs
};

struct Snapshot {
    std::string engine;      ///< a name of engine_list.h
    std::string pane;        ///< where one engine runs several times: its pane's name; else empty or the engine's
    std::string settings;    ///< of the pane, as PrintSettings writes them
    std::string broadPhase;  ///< the algorithm's name
    std::string scene;
    int size = 0;
    int step = 0;  ///< steps taken; 0: as loaded
    int threads = 1;

    std::vector<BodyState> bodies;
    std::vector<FixtureState> fixtures;
    std::vector<ContactState> contacts;
    std::vector<JointState> joints;
    std::vector<NodeState> nodes;  ///< empty: the algorithm keeps no tree
    int leafSize = 0;              ///< boxes per leaf of the production tree
    int treeHeight = 0;            ///< of the engine's own tree, as it reports it (ours: of `nodes`)

    int contactCount = 0;  ///< all contacts the engine keeps
    int touchingCount = 0;
    int64_t pairsReported = 0;  ///< by the broad phase, before any tight test
    StepTimes times;            ///< of the last step
    uint64_t stateHash = 0;
    int64_t memoryBytes = 0;  ///< heap held by the engine, scene data excluded

    /// What it is called among others.
    [[nodiscard]] const std::string& GetName() const { return pane.empty() ? engine : pane; }
};

/// Empties what a capture of a world fills in; scene, size, step, threads, times and memory stay.
inline void ClearWorld(Snapshot& snapshot) {
    snapshot.bodies.clear();
    snapshot.fixtures.clear();
    snapshot.contacts.clear();
    snapshot.joints.clear();
    snapshot.nodes.clear();
    snapshot.leafSize = snapshot.treeHeight = snapshot.contactCount = snapshot.touchingCount = 0;
    snapshot.pairsReported = 0;
    snapshot.stateHash = 0;
}

}  // namespace testbed
