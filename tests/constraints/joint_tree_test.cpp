// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The direct solve of joint trees against a dense solve in double whose Jacobians are difference quotients of the
// joints' definitions. Also: which joints form trees, and what the solve does where joints repeat each other.

#include "constraints/joint_tree.h"
#include "constraints/joint_tree_factors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <random>
#include <utility>

#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree {

namespace {

using namespace test;

using Pose = std::array<double, 3>;  ///< of the centre of mass: x, y, angle
using Poses = std::vector<Pose>;     ///< by body index

/// Runs every loop by itself.
TaskPool& Alone() {
    static TaskPool pool(1, TaskCallbacks{});
    return pool;
}

/// One scalar constraint as a function of all poses, straight from the meaning of the joint.
struct Constraint {
    int a, b;
    std::function<double(const Pose&, const Pose&)> error;
};

struct Place {
    double x, y;
};
Place ToWorld(const Pose& pose, Vec2 local) {
    const double c = std::cos(pose[2]), s = std::sin(pose[2]), x = double{local.x}, y = double{local.y};
    return {pose[0] + c * x - s * y, pose[1] + s * x + c * y};
}

/// Random bodies of masses 1 to 1000 hung on each other and on the ground by random joints; no two on the same pair.
class Forest {
public:
    Forest(unsigned seed, int count) : world(Vec2{0.0f, 0.0f}), m_random(seed) {
        m_ground = AddBody(world, staticBody, {0.0f, 0.0f});
        std::vector<Body*> bodies;
        for (int i = 0; i < count; ++i) {
            Body* body = AddBody(world, dynamicBody, {5.0f * Draw(), 5.0f * Draw()}, 3.0f * Draw());
            AddBox(body, 0.3f + 0.1f * Draw(), 0.2f, std::pow(10.0f, 1.5f + 1.5f * Draw()));
            body->SetLinearVelocity({3.0f * Draw(), 3.0f * Draw()});
            body->SetAngularVelocity(4.0f * Draw());
            if (i > 0 && Draw() > -0.8f) {
                Hang(bodies[static_cast<size_t>(m_random() % static_cast<unsigned>(std::max(1, std::min(i, 3)))) +
                            static_cast<size_t>(std::max(0, i - 3))],
                     body);
            }
            if (Draw() > 0.6f) Hang(m_ground, body);
            bodies.push_back(body);
        }
    }

    World world;
    std::vector<JointIndex> joints;
    std::vector<Constraint> constraints;

private:
    float Draw() { return std::uniform_real_distribution<float>(-1.0f, 1.0f)(m_random); }

    void Add(const JointDef& def) { joints.push_back(IndexOf(*world.CreateJoint(&def))); }
    void Hang(Body* a, Body* b) {
        const Vec2 place = 0.5f * (a->GetWorldCenter() + b->GetWorldCenter());
        switch (m_random() % 5) {
            case 0: {
                RevoluteJointDef def;
                def.Initialize(a, b, place);
                Add(def);
                return AddPoint(a, b, def.localAnchorA, def.localAnchorB);
            }
            case 1: {
                WeldJointDef def;
                def.Initialize(a, b, place);
                Add(def);
                AddPoint(a, b, def.localAnchorA, def.localAnchorB);
                return AddAngle(a, b);
            }
            case 2: {
                PrismaticJointDef def;
                def.Initialize(a, b, place, {0.6f, 0.8f});
                Add(def);
                AddAngle(a, b);
                return AddLine(a, b, def.localAnchorA, def.localAnchorB, def.localAxisA);
            }
            case 3: {
                WheelJointDef def;
                def.Initialize(a, b, place, {0.8f, -0.6f});
                Add(def);
                return AddLine(a, b, def.localAnchorA, def.localAnchorB, def.localAxisA);
            }
            default: {
                DistanceJointDef def;
                def.Initialize(a, b, a->GetWorldCenter() + Vec2{0.1f, 0.2f}, b->GetWorldCenter() - Vec2{0.2f, 0.1f});
                def.minLength = def.maxLength = def.length;
                Add(def);
                const Vec2 anchorA = Local(a, def.localAnchorA), anchorB = Local(b, def.localAnchorB);
                constraints.push_back({a->GetIndex(), b->GetIndex(), [=](const Pose& pa, const Pose& pb) {
                                           const Place p = ToWorld(pa, anchorA), q = ToWorld(pb, anchorB);
                                           return std::hypot(q.x - p.x, q.y - p.y) - double{def.length};
                                       }});
            }
        }
    }
    static Vec2 Local(const Body* body, Vec2 anchor) { return anchor - body->GetLocalCenter(); }
    void AddPoint(const Body* a, const Body* b, Vec2 anchorA, Vec2 anchorB) {
        const Vec2 la = Local(a, anchorA), lb = Local(b, anchorB);
        for (const bool isX : {true, false}) {
            constraints.push_back({a->GetIndex(), b->GetIndex(), [=](const Pose& pa, const Pose& pb) {
                                       const Place p = ToWorld(pa, la), q = ToWorld(pb, lb);
                                       return isX ? q.x - p.x : q.y - p.y;
                                   }});
        }
    }
    void AddAngle(const Body* a, const Body* b) {
        const double reference = double{b->GetAngle()} - double{a->GetAngle()};
        constraints.push_back(
            {a->GetIndex(), b->GetIndex(), [=](const Pose& pa, const Pose& pb) { return pb[2] - pa[2] - reference; }});
    }
    void AddLine(const Body* a, const Body* b, Vec2 anchorA, Vec2 anchorB, Vec2 axis) {
        const Vec2 la = Local(a, anchorA), lb = Local(b, anchorB);
        constraints.push_back({a->GetIndex(), b->GetIndex(), [=](const Pose& pa, const Pose& pb) {
                                   const Place p = ToWorld(pa, la), q = ToWorld(pb, lb);
                                   const Place u = ToWorld({0.0, 0.0, pa[2]}, axis);
                                   return u.x * (q.y - p.y) - u.y * (q.x - p.x);
                               }});
    }

    std::mt19937 m_random;
    Body* m_ground;
};

Poses ReadPoses(const BodyTable& bodies) {
    Poses poses;
    for (const BodyIndex b : bodies.position.Rows()) {
        const Position& p = bodies.position[b];
        const Rot& q = bodies.transform[b].q;  // with its own rounding
        const double part = std::atan2(double{q.s}, double{q.c}), turn = 2.0 * std::acos(-1.0);
        const double whole = turn * std::round((double{p.a} - part) / turn);
        poses.push_back({double{p.c.x}, double{p.c.y}, part + whole});
    }
    return poses;
}

/// Rows of constraints over 3 numbers a body, by central differences.
std::vector<std::vector<double>> Jacobian(const std::vector<Constraint>& constraints, const Poses& poses) {
    std::vector<std::vector<double>> rows;
    for (const Constraint& c : constraints) {
        std::vector<double> row(3 * poses.size(), 0.0);
        for (const bool isA : {true, false}) {
            const auto body = static_cast<size_t>(isA ? c.a : c.b);
            for (size_t k = 0; k < 3; ++k) {
                const auto at = [&](double shift) {
                    Pose a = poses[static_cast<size_t>(c.a)], b = poses[static_cast<size_t>(c.b)];
                    (isA ? a : b)[k] += shift;
                    return c.error(a, b);
                };
                row[3 * body + k] = (at(1e-6) - at(-1e-6)) / 2e-6;
            }
        }
        rows.push_back(row);
    }
    return rows;
}

/// Gaussian elimination with pivoting. `leastPivot`: the smallest, relative to its row's diagonal.
std::vector<double> SolveDense(std::vector<std::vector<double>> m, std::vector<double> b, double& leastPivot) {
    const size_t n = b.size();
    const std::vector<std::vector<double>> start = m;
    leastPivot = 1.0;
    for (size_t k = 0; k < n; ++k) {
        size_t pivot = k;
        for (size_t i = k; i < n; ++i) pivot = std::abs(m[i][k]) > std::abs(m[pivot][k]) ? i : pivot;
        std::swap(m[k], m[pivot]), std::swap(b[k], b[pivot]);
        leastPivot = std::min(leastPivot, std::abs(m[k][k]) / start[k][k]);
        for (size_t i = k + 1; i < n; ++i) {
            const double factor = m[i][k] / m[k][k];
            for (size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; ++j) b[k] -= m[k][j] * b[j];
        b[k] /= m[k][k];
    }
    return b;
}

/// Velocities without speed along the constraints, by mass-weighted projection.
std::vector<double> ProjectDense(const Forest& forest, const BodyTable& bodies, double& leastPivot) {
    const auto g = Jacobian(forest.constraints, ReadPoses(bodies));
    std::vector<double> v, inverse;
    for (const BodyIndex b : bodies.velocity.Rows()) {
        for (const float x : {bodies.velocity[b].v.x, bodies.velocity[b].v.y, bodies.velocity[b].w})
            v.push_back(double{x});
        for (const float x : {bodies.mass[b].invMass, bodies.mass[b].invMass, bodies.mass[b].invI})
            inverse.push_back(double{x});
    }
    std::vector<std::vector<double>> matrix(g.size(), std::vector<double>(g.size(), 0.0));
    std::vector<double> right(g.size(), 0.0);
    for (size_t i = 0; i < g.size(); ++i) {
        for (size_t k = 0; k < v.size(); ++k) right[i] -= g[i][k] * v[k];
        for (size_t j = 0; j < g.size(); ++j) {
            for (size_t k = 0; k < v.size(); ++k) matrix[i][j] += g[i][k] * inverse[k] * g[j][k];
        }
    }
    for (size_t i = 0; i < g.size(); ++i) matrix[i][i] *= 1.0 + jointCompliance;
    const std::vector<double> impulse = SolveDense(matrix, right, leastPivot);
    for (size_t i = 0; i < g.size(); ++i) {
        for (size_t k = 0; k < v.size(); ++k) v[k] += inverse[k] * g[i][k] * impulse[i];
    }
    return v;
}

TEST(JointTree, RemovesTheSameSpeedAsADenseSolve) {
    int solved = 0;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        Forest forest(seed, 2 + static_cast<int>(seed % 19));
        WorldState& s = forest.world.GetState();
        JointTree tree;
        tree.Build({Alone(), s.bodies, s.joints, forest.joints, 0.0f});
        if (forest.joints.empty()) continue;
        ASSERT_TRUE(tree.GetOthers().empty()) << seed;
        double leastPivot = 0.0;
        const std::vector<double> exact = ProjectDense(forest, s.bodies, leastPivot);
        Column<BodyIndex, Velocity> delta(s.bodies.velocity.size());
        s.bodies.startPosition = s.bodies.position;
        tree.Factorize({s.bodies, delta}, 1.0f / 960.0f);
        tree.SolveAfterMove(s.bodies.velocity);
        if (!(leastPivot > 1e-3)) continue;  // joints that nearly repeat each other
        for (const std::vector<double>& row : Jacobian(forest.constraints, ReadPoses(s.bodies))) {
            double speed = 0.0, left = 0.0;  // rows that give way leave a little
            for (size_t b = 0; b < delta.size(); ++b) {
                const Velocity& v = s.bodies.velocity[ToIndex<BodyIndex>(b)];
                speed += row[3 * b] * double{v.v.x} + row[3 * b + 1] * double{v.v.y} + row[3 * b + 2] * double{v.w};
                for (size_t k = 3 * b; k < 3 * b + 3; ++k) left += row[k] * exact[k];
            }
            EXPECT_NEAR(speed, left, 1e-4) << seed;
        }
        for (size_t b = 0; b < delta.size(); ++b) {
            const Velocity& v = s.bodies.velocity[ToIndex<BodyIndex>(b)];
            EXPECT_NEAR(double{v.v.x}, exact[3 * b], 1e-4) << seed;
            EXPECT_NEAR(double{v.v.y}, exact[3 * b + 1], 1e-4) << seed;
            EXPECT_NEAR(double{v.w}, exact[3 * b + 2], 1e-3) << seed;
        }
        ++solved;
    }
    EXPECT_GT(solved, 120);
}

/// Lists of joints that hang together by moving bodies.
std::vector<std::vector<JointIndex>> SplitTrees(const WorldState& s, const std::vector<JointIndex>& joints) {
    Column<BodyIndex, BodyIndex> root(s.bodies.type.size());
    for (const BodyIndex body : root.Rows()) root[body] = body;
    const auto find = [&](BodyIndex body) {
        while (root[body] != body) body = root[body];
        return body;
    };
    const auto moves = [&](BodyIndex body) { return s.bodies.type[body] == dynamicBody; };
    for (const JointIndex joint : joints) {
        const JointInfo& info = s.joints.info[joint];
        if (moves(info.bodyA) && moves(info.bodyB)) root[find(info.bodyA)] = find(info.bodyB);
    }
    std::map<BodyIndex, std::vector<JointIndex>> trees;
    for (const JointIndex joint : joints) {
        const JointInfo& info = s.joints.info[joint];
        trees[find(moves(info.bodyA) ? info.bodyA : info.bodyB)].push_back(joint);
    }
    std::vector<std::vector<JointIndex>> lists;
    for (auto& [body, list] : trees) lists.push_back(std::move(list));
    return lists;
}

TEST(JointTree, ManyTreesAreSolvedAsEachAloneByAnyNumberOfWorkers) {
    constexpr float h = 1.0f / 960.0f;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        Forest forest(seed, 300 + 250 * static_cast<int>(seed));
        WorldState& s = forest.world.GetState();
        s.bodies.startPosition = s.bodies.position;
        const Column<BodyIndex, Velocity> before = s.bodies.velocity;
        const Column<BodyIndex, Velocity> delta(before.size());
        const auto solve = [&](TaskPool& pool, const std::vector<JointIndex>& joints, bool aims) {
            Column<BodyIndex, Velocity> velocity = before;
            JointTree tree;
            tree.Build({pool, s.bodies, s.joints, joints, 0.0f});
            EXPECT_TRUE(tree.GetOthers().empty());
            const JointTree::Poses poses{s.bodies, delta};
            if (!aims && pool.GetWorkerCount() > 1) {  // both in one, with the same bits
                tree.FactorizeAndStop(poses, h, velocity);
                return velocity;
            }
            tree.Factorize(poses, h);
            aims ? tree.SolveBeforeMove(poses, h, velocity) : tree.SolveAfterMove(velocity);
            return velocity;
        };
        const std::vector<std::vector<JointIndex>> trees = SplitTrees(s, forest.joints);
        const auto isNear = [](float one, float other) { EXPECT_NEAR(one, other, 1e-4f * (1.0f + std::abs(one))); };
        ASSERT_GT(trees.size(), 20u);
        for (const bool aims : {false, true}) {
            const Column<BodyIndex, Velocity> all = solve(Alone(), forest.joints, aims);
            for (const int workers : {2, 3, 8}) {
                TaskPool pool(workers, TaskCallbacks{});
                pool.Begin();
                const Column<BodyIndex, Velocity> shared = solve(pool, forest.joints, aims);
                pool.End();
                EXPECT_EQ(std::memcmp(all.data(), shared.data(), all.size() * sizeof(Velocity)), 0) << workers;
            }
            if (aims) continue;  // trees of one grove have the same number of iterations
            for (const std::vector<JointIndex>& tree : trees) {
                const Column<BodyIndex, Velocity> alone = solve(Alone(), tree, aims);
                for (const JointIndex joint : tree) {
                    for (const BodyIndex body : {s.joints.info[joint].bodyA, s.joints.info[joint].bodyB}) {
                        const Velocity &one = alone[body], &other = all[body];
                        isNear(one.v.x, other.v.x), isNear(one.v.y, other.v.y);
                        isNear(one.w, other.w);
                    }
                }
            }
        }
    }
}

/// A list that changes from step to step: trees come and go, lists and bodies change, as when islands fall asleep.
TEST(JointTree, ChangedListsGiveTheBitsOfANewTree) {
    constexpr float h = 1.0f / 960.0f;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const auto below = [&](size_t count) { return random() % count; };
        Forest forest(seed, 900);
        WorldState& s = forest.world.GetState();
        std::vector<Body*> bodies;
        for (Body* body = forest.world.GetBodyList(); body != nullptr; body = body->GetNext()) bodies.push_back(body);
        s.bodies.startPosition = s.bodies.position;
        const Column<BodyIndex, Velocity> before = s.bodies.velocity;
        const Column<BodyIndex, Velocity> delta(before.size());
        TaskPool several(3, TaskCallbacks{});
        JointTree kept;
        const auto solve = [&](JointTree& tree, TaskPool& pool, const std::vector<JointIndex>& list, bool direct) {
            Column<BodyIndex, Velocity> velocity = before;
            tree.Build({pool, s.bodies, s.joints, list, 1.0f, jointCompliance, direct});
            const JointTree::Poses poses{s.bodies, delta};
            tree.FactorizeAndStop(poses, h, velocity);
            tree.SolveBeforeMove(poses, h, velocity);
            return velocity;
        };
        std::vector<std::vector<JointIndex>> trees = SplitTrees(s, forest.joints);
        std::vector<uint8_t> isIn(trees.size(), 1);
        for (int round = 0; round < 60; ++round) {
            SCOPED_TRACE(round);
            const size_t tree = below(trees.size());
            switch (round % 6) {
                case 0:
                case 1:
                    isIn[tree] ^= 1;
                    break;
                case 2:
                    std::ranges::shuffle(trees[tree], random);
                    break;
                case 3: {
                    Body* body = bodies[below(bodies.size())];
                    body->SetType(body->GetType() == dynamicBody ? staticBody : dynamicBody);
                    break;
                }
                case 4: {  // a loop, or two trees become one
                    RevoluteJointDef def;
                    Body* other = bodies[below(bodies.size())];
                    Body* body = bodies[below(bodies.size())];
                    if (body == other) break;
                    def.Initialize(body, other, body->GetWorldCenter());
                    trees[tree].push_back(IndexOf(*forest.world.CreateJoint(&def)));
                    break;
                }
                default: {  // another type or another body at the same number
                    const JointIndex joint = trees[tree].front();
                    WeldJointDef def;
                    Body* a = &s.bodies.handles[s.joints.info[joint].bodyA];
                    Body* b = &s.bodies.handles[s.joints.info[joint].bodyB];
                    forest.world.DestroyJoint(s.joints.handles[joint]);
                    if (round % 12 == 5) {
                        def.Initialize(a, b, b->GetWorldCenter());
                        ASSERT_EQ(IndexOf(*forest.world.CreateJoint(&def)), joint);
                        break;
                    }
                    RevoluteJointDef hinge;
                    hinge.Initialize(a, a == bodies[0] ? bodies[1] : bodies[0], a->GetWorldCenter());
                    ASSERT_EQ(IndexOf(*forest.world.CreateJoint(&hinge)), joint);
                }
            }
            std::vector<JointIndex> list;
            for (size_t i = 0; i < trees.size(); ++i) {
                if (isIn[i] != 0) list.insert(list.end(), trees[i].begin(), trees[i].end());
            }
            const bool direct = round % 20 != 19;
            JointTree fresh;
            const bool isShared = round % 2 == 0;
            if (isShared) several.Begin();
            const Column<BodyIndex, Velocity> one = solve(kept, isShared ? several : Alone(), list, direct);
            if (isShared) several.End();
            const Column<BodyIndex, Velocity> other = solve(fresh, Alone(), list, direct);
            ASSERT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(Velocity)), 0);
            ASSERT_TRUE(std::ranges::equal(kept.GetOthers(), fresh.GetOthers()));
            ASSERT_TRUE(std::ranges::equal(kept.GetBounded(), fresh.GetBounded()));
            kept.Store(1.0f, s.joints);  // both begin with these impulses the next time
        }
    }
}

TEST(JointTree, AMoveEndsWithClosedJoints) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        Forest forest(seed, 8);
        WorldState& s = forest.world.GetState();
        JointTree tree;
        tree.Build({Alone(), s.bodies, s.joints, forest.joints, 0.0f});
        if (forest.joints.empty() || forest.constraints.size() > 3 * (s.bodies.position.size() - 1)) continue;
        // Where joints nearly repeat each other, what they give way by takes more than one move to close.
        double leastPivot = 0.0;
        ProjectDense(forest, s.bodies, leastPivot);
        if (!(leastPivot > 0.05)) continue;
        Column<BodyIndex, Velocity> delta(s.bodies.velocity.size());
        s.bodies.startPosition = s.bodies.position;
        tree.Factorize({s.bodies, delta}, 1.0f / 960.0f);
        tree.SolveAfterMove(s.bodies.velocity);  // a motion that the joints allow
        const float h = 1.0f / 960.0f;
        tree.SolveBeforeMove({s.bodies, delta}, h, s.bodies.velocity);
        Poses poses = ReadPoses(s.bodies);
        double fastest = 0.0;
        for (size_t b = 0; b < poses.size(); ++b) {
            const Velocity& v = s.bodies.velocity[ToIndex<BodyIndex>(b)];
            poses[b][0] += double{h} * double{v.v.x};
            poses[b][1] += double{h} * double{v.v.y};
            poses[b][2] += double{h} * double{v.w};
            fastest = std::max(fastest, std::abs(double{v.w}));
        }
        if (fastest > 50.0) continue;
        for (const Constraint& c : forest.constraints) {
            const double error = c.error(poses[static_cast<size_t>(c.a)], poses[static_cast<size_t>(c.b)]);
            EXPECT_LT(std::abs(error), 2e-6) << seed;  // floats of up to 5 m
        }
    }
}

RevoluteJointDef Pin(Body* a, Body* b, Vec2 place) {
    RevoluteJointDef def;
    def.Initialize(a, b, place);
    return def;
}

TEST(JointTree, TakesTreesAndLoopsAlike) {
    World world({0.0f, 0.0f});
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    std::vector<Body*> bodies;
    for (int i = 0; i < 5; ++i) {
        bodies.push_back(AddBody(world, dynamicBody, {static_cast<float>(i), 0.0f}));
        AddBox(bodies.back(), 0.5f, 0.1f);
    }
    const auto add = [&](Body* a, Body* b, Vec2 place) {
        const RevoluteJointDef def = Pin(a, b, place);
        return IndexOf(*world.CreateJoint(&def));
    };
    // A triangle of 0, 1, 2 and a bridge of 3, 4 between two fixed points.
    const std::vector<JointIndex> loop{add(bodies[0], bodies[1], {0.5f, 0.0f}), add(bodies[1], bodies[2], {1.5f, 0.0f}),
                                       add(bodies[2], bodies[0], {1.0f, 1.0f})};
    const std::vector<JointIndex> bridge{add(ground, bodies[3], {2.5f, 0.0f}), add(bodies[3], bodies[4], {3.5f, 0.0f}),
                                         add(bodies[4], ground, {4.5f, 0.0f})};
    std::vector<JointIndex> all = loop;
    all.insert(all.end(), bridge.begin(), bridge.end());
    const WorldState& s = world.GetState();
    JointTree tree;
    tree.Build({Alone(), s.bodies, s.joints, all, 0.0f});
    EXPECT_FALSE(tree.IsEmpty());
    EXPECT_TRUE(tree.GetOthers().empty());
    EXPECT_TRUE(tree.GetBounded().empty());
    tree.Build({Alone(), s.bodies, s.joints, loop, 0.0f});
    EXPECT_FALSE(tree.IsEmpty());
    EXPECT_TRUE(tree.GetOthers().empty());
}

/// Pins of columns × rows bodies in a row each; every body is pinned to the next in its row and in its column.
std::vector<JointIndex> PinGrid(World& world, int columns, int rows) {
    std::vector<Body*> bodies;
    std::vector<JointIndex> pins;
    for (int i = 0; i < columns * rows; ++i) {
        const int column = i / rows, row = i % rows;
        bodies.push_back(AddBody(world, dynamicBody, {static_cast<float>(column), static_cast<float>(row)}));
        AddBox(bodies.back(), 0.3f, 0.3f);
        const auto pin = [&](int other) {
            const RevoluteJointDef def =
                Pin(bodies[ToSize(other)], bodies.back(),
                    0.5f * (bodies[ToSize(other)]->GetPosition() + bodies.back()->GetPosition()));
            pins.push_back(IndexOf(*world.CreateJoint(&def)));
        };
        if (row > 0) pin(i - 1);
        if (column > 0) pin(i - rows);
    }
    return pins;
}

TEST(JointTree, LeavesWideNetsToTheirRowsAndHoldsNarrowStructures) {
    const struct {
        int columns, rows;
        bool isNet;
    } cases[] = {{2, 2, false}, {200, 2, false}, {60, 3, false}, {4, 4, false},
                 {8, 8, true},  {30, 30, true},  {100, 9, true}};
    for (const auto& one : cases) {
        SCOPED_TRACE(std::to_string(one.columns) + " x " + std::to_string(one.rows));
        World world({0.0f, 0.0f});
        std::vector<JointIndex> pins = PinGrid(world, one.columns, one.rows);
        // Beside another structure, the same.
        const std::vector<JointIndex> ladder = PinGrid(world, 10, 2);
        const WorldState& s = world.GetState();
        JointTree tree;
        tree.Build({Alone(), s.bodies, s.joints, pins, 0.0f});
        EXPECT_EQ(!tree.GetNets().IsEmpty(), one.isNet);
        EXPECT_EQ(tree.IsEmpty(), one.isNet);
        EXPECT_TRUE(tree.GetOthers().empty());
        pins.insert(pins.end(), ladder.begin(), ladder.end());
        tree.Build({Alone(), s.bodies, s.joints, pins, 0.0f});
        EXPECT_EQ(!tree.GetNets().IsEmpty(), one.isNet);
        EXPECT_FALSE(tree.IsEmpty()) << "the ladder";
        EXPECT_TRUE(tree.GetOthers().empty());
    }
}

/// The most that bodies move along pins at their anchors, m/s.
float WorstSpeed(const World& world) {
    float worst = 0.0f;
    for (const Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
        const Body *a = joint->GetBodyA(), *b = joint->GetBodyB();
        const Vec2 speed = b->GetLinearVelocityFromWorldPoint(joint->GetAnchorB()) -
                           a->GetLinearVelocityFromWorldPoint(joint->GetAnchorA());
        worst = std::max(worst, speed.Length());
    }
    return worst;
}

TEST(JointTree, HoldsAnyNumberOfArmsOfOneBody) {
    std::mt19937 random(7);
    const auto draw = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
    for (const int arms : {3, 14, 70, 200}) {
        World world({0.0f, 0.0f});
        Body* hub = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddCircle(hub, 1.0f);
        std::vector<JointIndex> joints;
        for (int i = 0; i < arms; ++i) {
            const Vec2 way = Mul(Rot(draw(0.0f, 6.0f)), Vec2{1.0f, 0.0f});
            Body* last = hub;
            for (float out = 1.0f; out < draw(2.0f, 4.0f); out += 0.5f) {
                Body* arm = AddBody(world, dynamicBody, (out + 0.25f) * way, draw(-1.0f, 1.0f));
                AddBox(arm, 0.2f, draw(0.05f, 0.2f), draw(1.0f, 100.0f));
                arm->SetLinearVelocity({draw(-3.0f, 3.0f), draw(-3.0f, 3.0f)});
                const RevoluteJointDef def = Pin(last, arm, out * way);
                joints.push_back(IndexOf(*world.CreateJoint(&def)));
                last = arm;
            }
        }
        WorldState& s = world.GetState();
        JointTree tree;
        tree.Build({Alone(), s.bodies, s.joints, joints, 0.0f});
        EXPECT_TRUE(tree.GetOthers().empty()) << arms;
        const Column<BodyIndex, Velocity> delta(s.bodies.velocity.size());
        s.bodies.startPosition = s.bodies.position;
        tree.Factorize({s.bodies, delta}, 1.0f / 960.0f);
        const float before = WorstSpeed(world);
        EXPECT_GT(before, 1.0f);
        tree.SolveAfterMove(s.bodies.velocity);
        // Rows give way by 1e-5 of their own inverse mass, which is up to a hundred times that of the whole.
        EXPECT_LT(WorstSpeed(world), 1e-3f * before) << arms;
    }
}

TEST(JointTree, LeavesALoopToItselfAndHoldsTheTreesBesideIt) {
    // The same chain alone and beside a loop moves by the same bits.
    const auto run = [](bool withLoop) {
        World world({0.0f, -10.0f});
        Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
        Body* last = ground;
        for (int i = 0; i < 7; ++i) {
            Body* link = AddBody(world, dynamicBody, {0.5f + static_cast<float>(i), 0.0f});
            AddBox(link, 0.5f, 0.1f);
            const RevoluteJointDef def = Pin(last, link, {static_cast<float>(i), 0.0f});
            world.CreateJoint(&def);
            last = link;
        }
        const Body* end = last;
        if (withLoop) {
            Body* first = AddBody(world, dynamicBody, {40.0f, 0.0f});
            Body* second = AddBody(world, dynamicBody, {41.0f, 0.0f});
            AddBox(first, 0.4f, 0.1f), AddBox(second, 0.4f, 0.1f);
            for (const float y : {0.1f, -0.1f}) {
                const RevoluteJointDef def = Pin(first, second, {40.5f, y});
                world.CreateJoint(&def);
            }
        }
        for (int i = 0; i < 60; ++i) world.Step(1.0f / 60.0f, Accuracy::game);
        return std::pair{end->GetPosition().x, end->GetAngle()};
    };
    EXPECT_EQ(run(false), run(true));
}

TEST(JointTree, HoldsABodyThatIsWeldedTwice) {
    World world({0.0f, -10.0f});
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    Body* plank = AddBody(world, dynamicBody, {0.0f, 2.0f});
    AddBox(plank, 2.0f, 0.1f);
    for (const float x : {-2.0f, 2.0f}) {
        WeldJointDef def;
        def.Initialize(ground, plank, {x, 2.0f});
        world.CreateJoint(&def);
    }
    for (int i = 0; i < 120; ++i) world.Step(1.0f / 60.0f, Accuracy::game);
    EXPECT_NEAR(plank->GetPosition().y, 2.0f, 1e-5f);
    EXPECT_NEAR(plank->GetAngle(), 0.0f, 1e-5f);
}

TEST(JointTree, LimitsAndMotorsOfATreeAreKept) {
    // An arm that falls onto its limit, and one that a motor turns.
    World world({0.0f, -10.0f});
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    Body* arm = AddBody(world, dynamicBody, {0.5f, 0.0f});
    Body* wheel = AddBody(world, dynamicBody, {5.0f, 0.0f});
    AddBox(arm, 0.5f, 0.05f), AddCircle(wheel, 0.5f);
    RevoluteJointDef limited = Pin(ground, arm, {0.0f, 0.0f});
    limited.enableLimit = true;
    limited.lowerAngle = -0.5f, limited.upperAngle = 0.5f;
    world.CreateJoint(&limited);
    RevoluteJointDef driven = Pin(ground, wheel, {5.0f, 0.0f});
    driven.enableMotor = true;
    driven.motorSpeed = 3.0f;
    driven.maxMotorTorque = 0.2f;
    world.CreateJoint(&driven);
    const float inertia = wheel->GetInertia();
    for (int i = 0; i < 30; ++i) world.Step(1.0f / 60.0f, Accuracy::game);
    EXPECT_NEAR(wheel->GetAngularVelocity(), std::min(3.0f, 0.2f * 0.5f / inertia), 1e-3f);
    for (int i = 0; i < 270; ++i) world.Step(1.0f / 60.0f, Accuracy::game);
    EXPECT_NEAR(arm->GetAngle(), -0.5f, angularSlop);
    EXPECT_NEAR(arm->GetAngularVelocity(), 0.0f, 1e-3f);
    EXPECT_NEAR(wheel->GetAngularVelocity(), 3.0f, 1e-3f);
}

}  // namespace

}  // namespace scree
