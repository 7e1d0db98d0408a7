// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The forest of joints, its factors and its solves.

#include "constraints/joint_tree.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "constraints/joint_tree_rows.h"

namespace scree {

namespace {

/// A body with more joints than this would couple all of them with each other.
constexpr int mostJointsOfBody = 12;
/// A pivot below this share of its row's own inverse mass is rounding: the row repeats others.
constexpr double leastPivot = 1e-9;

struct TreeBody {
    int body;
    double invMass, invI;  ///< 0 if joints cannot push it
    double startCos, startSin;
    TreePose pose, next;  ///< now, and where its velocity leads
    double v[3];          ///< x, y, turning
};

/// Coupling of a joint with a later one on the same body: first G·M⁻¹·Gᵀ, then the block of L.
struct TreeLink {
    int later;
    double block[maxTreeRows][maxTreeRows];  ///< [row of the later joint][row of this one]
};

struct TreeJoint {
    TreeShape shape;
    int joint;
    int a, b;  ///< rows of the bodies
    int up;    ///< the one on which it is coupled with later joints
    int linkBegin, linkEnd;
    TreeRows rows;
    double inverse[maxTreeRows][maxTreeRows];  ///< of its pivot
    double rhs[maxTreeRows];                   ///< right side, then impulses
    double total[maxTreeRows];                 ///< impulses of the step
};

size_t At(int index) { return static_cast<size_t>(index); }

/// Calls use(n) with the number of rows of a joint as a constant, so that the loops over rows unroll: eliminating and
/// solving take 0.7 times as long as with a number (big-mobile, soft 4, 60 steps without contacts).
template <typename Use>
void WithCount(int count, Use&& use) {
    switch (count) {
        case 1:
            return use(std::integral_constant<int, 1>{});
        case 2:
            return use(std::integral_constant<int, 2>{});
        default:
            return use(std::integral_constant<int, 3>{});
    }
}

/// visit(0), …, visit(n − 1).
template <int n, typename Visit>
inline void Unroll(std::integral_constant<int, n>, Visit&& visit) {
    [&]<int... i>(std::integer_sequence<int, i...>) { (visit(i), ...); }
    (std::make_integer_sequence<int, n>{});
}

/// Replaces a symmetric, positive definite matrix by its inverse. Rows whose pivot is only rounding beside `scale` get
/// zeros: they repeat others (Goodnight, "A Tutorial on the SWEEP Operator", The American Statistician 33, 1979).
template <int n>
void Invert(double (&m)[maxTreeRows][maxTreeRows], std::integral_constant<int, n>, const double (&scale)[maxTreeRows]) {
    bool kept[maxTreeRows] = {};
    for (int k = 0; k < n; ++k) {
        const double pivot = m[k][k];
        if (!(pivot > leastPivot * scale[k])) continue;
        kept[k] = true;
        const double inverse = 1.0 / pivot;
        for (int i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = m[i][k] * inverse;
            for (int j = 0; j < n; ++j) {
                if (j != k) m[i][j] -= factor * m[k][j];
            }
        }
        for (int i = 0; i < n; ++i) m[i][k] *= inverse, m[k][i] = m[i][k];
        m[k][k] = -inverse;
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) m[i][j] = kept[i] && kept[j] ? -m[i][j] : 0.0;
    }
}

/// Rows of a joint on one of its bodies.
const double (&SideOf(const TreeJoint& joint, int body))[maxTreeRows][3] {
    return joint.a == body ? joint.rows.a : joint.rows.b;
}

}  // namespace

struct JointTree::Data {
    std::vector<TreeBody> bodies;
    std::vector<TreeJoint> joints;  ///< in the order of elimination
    std::vector<TreeLink> links;
    std::vector<int> others, bounded;

    // Scratch of Build.
    struct Candidate {
        int joint, a, b;
        TreeShape shape;
        bool bounded, used;
        int place;  ///< in the order of elimination
    };
    std::vector<Candidate> candidates;
    std::vector<int> rowOf;                     ///< per body of the world, −1: none
    std::vector<int> parent;                    ///< union–find over rows
    std::vector<uint8_t> spoilt;                ///< per row: its tree is none
    std::vector<int> first, entries;            ///< per row: its candidates
    std::vector<int> order, parentJoint, list;  ///< bodies breadth first; candidate towards the root; one body's list

    int RowOf(const BodyTable& table, int body) {
        int& row = rowOf[At(body)];
        if (row >= 0) return row;
        row = static_cast<int>(bodies.size());
        TreeBody& b = bodies.emplace_back();
        b.body = body;
        const bool moves = table.type[At(body)] == dynamicBody;
        b.invMass = moves ? double{table.mass[At(body)].invMass} : 0.0;
        b.invI = moves ? double{table.mass[At(body)].invI} : 0.0;
        const Rot& q = table.transform[At(body)].q;
        b.startCos = double{q.c}, b.startSin = double{q.s};
        parent.push_back(row);
        spoilt.push_back(0);
        return row;
    }
    [[nodiscard]] bool Moves(int row) const { return bodies[At(row)].invMass > 0.0 || bodies[At(row)].invI > 0.0; }
    int Root(int row) {
        while (parent[At(row)] != row) row = parent[At(row)] = parent[At(parent[At(row)])];
        return row;
    }
    /// A joint between two movers joins their trees, or closes a loop.
    void Join(int a, int b) {
        if (!Moves(a) || !Moves(b)) return;
        const int rootA = Root(a), rootB = Root(b);
        if (rootA == rootB) {
            spoilt[At(rootA)] = 1;
            return;
        }
        parent[At(std::max(rootA, rootB))] = std::min(rootA, rootB);
        spoilt[At(std::min(rootA, rootB))] |= spoilt[At(std::max(rootA, rootB))];
    }

    void Collect(const JointTreeInput& input);
    void FindTrees();
    void Order();
    void PlaceList(int row);
    void LinkList(int row);
    void AddLinks(TreeJoint& joint, size_t place);
    void MakeJoints();

    void FillMatrix();
    void Eliminate();
    template <typename Own, typename Later>
    void EliminateLink(const TreeJoint& joint, int at, Own n, Later rows);
    void Solve();
    void ApplyImpulses();
};

JointTree::JointTree() : m(std::make_unique<Data>()) {}
JointTree::~JointTree() = default;

bool JointTree::IsEmpty() const { return m->joints.empty(); }
std::span<const int> JointTree::GetOthers() const { return m->others; }
std::span<const int> JointTree::GetBounded() const { return m->bounded; }

size_t JointTree::GetMemoryBytes() const {
    return m->bodies.capacity() * sizeof(TreeBody) + m->joints.capacity() * sizeof(TreeJoint) +
           m->links.capacity() * sizeof(TreeLink) + m->candidates.capacity() * sizeof(Data::Candidate) +
           (m->rowOf.capacity() + m->entries.capacity()) * sizeof(int);
}

void JointTree::Data::Collect(const JointTreeInput& input) {
    for (const TreeBody& b : bodies) rowOf[At(b.body)] = -1;
    rowOf.resize(At(input.bodies.slots.Size()), -1);
    bodies.clear(), parent.clear(), spoilt.clear(), candidates.clear();
    others.clear(), bounded.clear();
    for (const int joint : input.list) {
        Candidate c{joint, -1, -1, {}, false, false, -1};
        if (!MakeTreeShape(input.bodies, input.joints, joint, c.shape, c.bounded)) continue;
        const JointInfo& info = input.joints.info[At(joint)];
        c.a = RowOf(input.bodies, info.bodyA);
        c.b = RowOf(input.bodies, info.bodyB);
        if (Moves(c.a) || Moves(c.b)) candidates.push_back(c);
    }
}

void JointTree::Data::FindTrees() {
    first.assign(bodies.size() + 1, 0);
    for (const Candidate& c : candidates) {
        Join(c.a, c.b);
        ++first[At(c.a)], ++first[At(c.b)];
    }
    int total = 0;
    for (size_t row = 0; row < bodies.size(); ++row) {
        if (Moves(static_cast<int>(row)) && first[row] > mostJointsOfBody) spoilt[At(Root(static_cast<int>(row)))] = 1;
        total += first[row];
        first[row] = total;  // the end; filling moves it to the start
    }
    first[bodies.size()] = total;
    entries.resize(At(total));
    for (size_t i = candidates.size(); i-- > 0;) {
        Candidate& c = candidates[i];
        entries[At(--first[At(c.a)])] = entries[At(--first[At(c.b)])] = static_cast<int>(i);
        c.used = spoilt[At(Root(Moves(c.a) ? c.a : c.b))] == 0;
    }
}

/// Bodies breadth first from the first of each tree.
void JointTree::Data::Order() {
    order.clear();
    parentJoint.assign(bodies.size(), -2);  // not seen
    for (size_t start = 0; start < bodies.size(); ++start) {
        const int root = static_cast<int>(start);
        if (parentJoint[start] != -2 || !Moves(root) || spoilt[At(Root(root))] != 0) continue;
        parentJoint[start] = -1;
        order.push_back(root);
        for (size_t next = order.size() - 1; next < order.size(); ++next) {
            const int row = order[next];
            for (int e = first[At(row)]; e < first[At(row) + 1]; ++e) {
                const Candidate& c = candidates[At(entries[At(e)])];
                const int other = c.a == row ? c.b : c.a;
                if (!Moves(other) || parentJoint[At(other)] != -2) continue;
                parentJoint[At(other)] = entries[At(e)];
                order.push_back(other);
            }
        }
    }
}

/// One body's joints, the one towards the root last.
void JointTree::Data::LinkList(int row) {
    list.clear();
    for (int e = first[At(row)]; e < first[At(row) + 1]; ++e) {
        if (entries[At(e)] != parentJoint[At(row)]) list.push_back(entries[At(e)]);
    }
}

void JointTree::Data::MakeJoints() {
    // From the leaves: the joints of a body but the one towards the root.
    joints.clear(), links.clear();
    for (size_t i = order.size(); i-- > 0;) {
        LinkList(order[i]);
        for (const int at : list) {
            Candidate& c = candidates[At(at)];
            c.place = static_cast<int>(joints.size());
            TreeJoint& joint = joints.emplace_back();
            joint.shape = c.shape;
            joint.joint = c.joint;
            joint.a = c.a, joint.b = c.b;
            joint.up = order[i];
            joint.linkBegin = joint.linkEnd = 0;
            for (double& t : joint.total) t = 0.0;
            joint.rows.count = RowCount(c.shape.kind);
        }
    }
    for (size_t i = order.size(); i-- > 0;) {
        LinkList(order[i]);
        const size_t own = list.size();
        if (parentJoint[At(order[i])] >= 0) list.push_back(parentJoint[At(order[i])]);
        for (size_t p = 0; p < own; ++p) {
            TreeJoint& joint = joints[At(candidates[At(list[p])].place)];
            joint.linkBegin = static_cast<int>(links.size());
            for (size_t q = p + 1; q < list.size(); ++q) links.push_back({candidates[At(list[q])].place, {}});
            joint.linkEnd = static_cast<int>(links.size());
        }
    }
}

void JointTree::Build(const JointTreeInput& input) {
    m->Collect(input);
    m->FindTrees();
    m->Order();
    m->MakeJoints();
    size_t next = 0;
    for (const int joint : input.list) {
        const bool isCandidate = next < m->candidates.size() && m->candidates[next].joint == joint;
        if (!isCandidate || !m->candidates[next].used) m->others.push_back(joint);
        if (isCandidate && m->candidates[next].used && m->candidates[next].bounded) m->bounded.push_back(joint);
        next += isCandidate ? 1 : 0;
    }
}

void JointTree::Factorize(const Poses& poses) {
    for (TreeBody& b : m->bodies) {
        const Position& start = poses.bodies.startPosition[At(b.body)];
        const bool isStatic = poses.bodies.type[At(b.body)] == staticBody;
        const Velocity delta = isStatic ? Velocity{} : poses.delta[At(b.body)];
        const Position& from = isStatic ? poses.bodies.position[At(b.body)] : start;
        const PositionRest& rests = poses.bodies.IsFar() ? poses.bodies.rest[At(b.body)] : PositionRest{};
        const Vec2 rest = isStatic ? rests.end : rests.start;
        b.pose.x = double{from.c.x} + (double{rest.x} + double{delta.v.x});
        b.pose.y = double{from.c.y} + (double{rest.y} + double{delta.v.y});
        b.pose.angle = double{from.a} + (double{from.aRest} + double{delta.w});
        Turn(b.startCos, b.startSin, double{delta.w}, b.pose);
    }
    for (TreeJoint& joint : m->joints) {
        MakeRows<true>(joint.shape, m->bodies[At(joint.a)].pose, m->bodies[At(joint.b)].pose, joint.rows);
    }
    m->FillMatrix();
    m->Eliminate();
}

void JointTree::Data::FillMatrix() {
    const auto product = [](const double(&i)[3], const double(&j)[3], const TreeBody& b) {
        return b.invMass * (i[0] * j[0] + i[1] * j[1]) + b.invI * i[2] * j[2];
    };
    for (TreeJoint& joint : joints) {
        const TreeBody& a = bodies[At(joint.a)];
        const TreeBody& b = bodies[At(joint.b)];
        WithCount(joint.rows.count, [&](auto n) {
            Unroll(n, [&](int i) {
                for (int j = 0; j <= i; ++j) {
                    joint.inverse[i][j] = joint.inverse[j][i] =
                        product(joint.rows.a[i], joint.rows.a[j], a) + product(joint.rows.b[i], joint.rows.b[j], b);
                }
            });
            const TreeBody& up = bodies[At(joint.up)];
            const auto& own = SideOf(joint, joint.up);
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                TreeLink& link = links[At(l)];
                const TreeJoint& later = joints[At(link.later)];
                const auto& other = SideOf(later, joint.up);
                WithCount(later.rows.count, [&](auto rows) {
                    Unroll(rows,
                           [&](int i) { Unroll(n, [&](int j) { link.block[i][j] = product(other[i], own[j], up); }); });
                });
            }
        });
    }
}

void JointTree::Data::Eliminate() {
    for (TreeJoint& joint : joints) {
        WithCount(joint.rows.count, [&](auto n) {
            // The diagonal before anything is subtracted from it.
            double scale[maxTreeRows] = {};
            const TreeBody& bodyA = bodies[At(joint.a)];
            const TreeBody& bodyB = bodies[At(joint.b)];
            Unroll(n, [&](int i) {
                const double(&a)[3] = joint.rows.a[i];
                const double(&b)[3] = joint.rows.b[i];
                scale[i] = bodyA.invMass * (a[0] * a[0] + a[1] * a[1]) + bodyA.invI * a[2] * a[2] +
                           bodyB.invMass * (b[0] * b[0] + b[1] * b[1]) + bodyB.invI * b[2] * b[2];
            });
            Invert(joint.inverse, n, scale);
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                WithCount(joints[At(links[At(l)].later)].rows.count,
                          [&](auto rows) { EliminateLink(joint, l, n, rows); });
            }
        });
    }
}

template <typename Own, typename Later>
void JointTree::Data::EliminateLink(const TreeJoint& joint, int at, Own n, Later rows) {
    TreeLink& link = links[At(at)];
    TreeJoint& later = joints[At(link.later)];
    double row[maxTreeRows][maxTreeRows];  // of L
    Unroll(rows, [&](int i) {
        Unroll(n, [&](int j) {
            row[i][j] = 0.0;
            Unroll(n, [&](int k) { row[i][j] += link.block[i][k] * joint.inverse[k][j]; });
        });
    });
    const auto reduce = [&](const TreeLink& with, auto count, double(&target)[maxTreeRows][maxTreeRows]) {
        Unroll(count, [&](int i) {
            Unroll(rows, [&](int j) { Unroll(n, [&](int k) { target[i][j] -= with.block[i][k] * row[j][k]; }); });
        });
    };
    reduce(link, rows, later.inverse);
    // Links of the later joint go to the joints that follow it in the same list.
    for (int r = at + 1; r < joint.linkEnd; ++r) {
        const TreeLink& with = links[At(r)];
        WithCount(joints[At(with.later)].rows.count,
                  [&](auto count) { reduce(with, count, links[At(later.linkBegin + (r - at - 1))].block); });
    }
    Unroll(rows, [&](int i) { Unroll(n, [&](int j) { link.block[i][j] = row[i][j]; }); });
}

/// Right sides → impulses.
void JointTree::Data::Solve() {
    for (const TreeJoint& joint : joints) {
        WithCount(joint.rows.count, [&](auto n) {
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                const TreeLink& link = links[At(l)];
                TreeJoint& later = joints[At(link.later)];
                WithCount(later.rows.count, [&](auto rows) {
                    Unroll(rows,
                           [&](int i) { Unroll(n, [&](int j) { later.rhs[i] -= link.block[i][j] * joint.rhs[j]; }); });
                });
            }
        });
    }
    for (size_t at = joints.size(); at-- > 0;) {
        TreeJoint& joint = joints[at];
        WithCount(joint.rows.count, [&](auto n) {
            double impulse[maxTreeRows];
            Unroll(n, [&](int i) {
                impulse[i] = 0.0;
                Unroll(n, [&](int j) { impulse[i] += joint.inverse[i][j] * joint.rhs[j]; });
            });
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                const TreeLink& link = links[At(l)];
                const TreeJoint& later = joints[At(link.later)];
                WithCount(later.rows.count, [&](auto rows) {
                    Unroll(rows,
                           [&](int i) { Unroll(n, [&](int j) { impulse[j] -= link.block[i][j] * later.rhs[i]; }); });
                });
            }
            Unroll(n, [&](int i) { joint.rhs[i] = impulse[i]; });
        });
    }
}

/// The impulses of the last solve.
void JointTree::Data::ApplyImpulses() {
    for (TreeJoint& joint : joints) {
        TreeBody& a = bodies[At(joint.a)];
        TreeBody& b = bodies[At(joint.b)];
        WithCount(joint.rows.count, [&](auto n) {
            Unroll(n, [&](int i) {
                const double impulse = joint.rhs[i];
                joint.total[i] += impulse;
                for (int k = 0; k < 2; ++k) {
                    a.v[k] += a.invMass * impulse * joint.rows.a[i][k];
                    b.v[k] += b.invMass * impulse * joint.rows.b[i][k];
                }
                a.v[2] += a.invI * impulse * joint.rows.a[i][2];
                b.v[2] += b.invI * impulse * joint.rows.b[i][2];
            });
        });
    }
}

namespace {

void LoadVelocities(std::vector<TreeBody>& bodies, const std::vector<Velocity>& velocity) {
    for (TreeBody& b : bodies) {
        const Velocity& v = velocity[At(b.body)];
        b.v[0] = double{v.v.x}, b.v[1] = double{v.v.y}, b.v[2] = double{v.w};
    }
}
void StoreVelocities(const std::vector<TreeBody>& bodies, std::vector<Velocity>& velocity) {
    for (const TreeBody& b : bodies) {
        if (b.invMass == 0.0 && b.invI == 0.0) continue;
        Velocity& v = velocity[At(b.body)];
        v.v = {static_cast<float>(b.v[0]), static_cast<float>(b.v[1])};
        v.w = static_cast<float>(b.v[2]);
    }
}

}  // namespace

void JointTree::SolveBeforeMove(const Poses&, float h, std::vector<Velocity>& velocity) {
    // Each iteration gains two orders in h: the Jacobians of the present pose stand for those of the next one.
    constexpr int iterations = 2;
    const double step = double{h}, inverse = 1.0 / step;
    LoadVelocities(m->bodies, velocity);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        for (TreeBody& b : m->bodies) {
            b.next.x = b.pose.x + step * b.v[0];
            b.next.y = b.pose.y + step * b.v[1];
            b.next.angle = b.pose.angle + step * b.v[2];
            Turn(b.pose.cos, b.pose.sin, step * b.v[2], b.next);
        }
        for (TreeJoint& joint : m->joints) {
            TreeRows next;
            next.count = joint.rows.count;
            MakeRows<false>(joint.shape, m->bodies[At(joint.a)].next, m->bodies[At(joint.b)].next, next);
            for (int i = 0; i < next.count; ++i) joint.rhs[i] = -inverse * next.error[i];
        }
        m->Solve();
        m->ApplyImpulses();
    }
    StoreVelocities(m->bodies, velocity);
}

void JointTree::SolveAfterMove(std::vector<Velocity>& velocity) {
    LoadVelocities(m->bodies, velocity);
    for (TreeJoint& joint : m->joints) {
        const double(&a)[3] = m->bodies[At(joint.a)].v;
        const double(&b)[3] = m->bodies[At(joint.b)].v;
        for (int i = 0; i < joint.rows.count; ++i) {
            double speed = 0.0;
            for (int k = 0; k < 3; ++k) speed += joint.rows.a[i][k] * a[k] + joint.rows.b[i][k] * b[k];
            joint.rhs[i] = -speed;
        }
    }
    m->Solve();
    m->ApplyImpulses();
    StoreVelocities(m->bodies, velocity);
}

void JointTree::NotePullRates(float dt, std::vector<BodyDemand>& demand) const {
    for (const TreeJoint& joint : m->joints) {
        if (joint.rows.count < 2) continue;
        const double pull = std::hypot(joint.total[0], joint.total[1]) / double{dt};
        const auto note = [&](const TreeBody& body, double x, double y) {
            if (body.invMass == 0.0 || body.invI == 0.0) return;
            // A rod pulled at its end: inertia m·l²/3 about the other end of the arm l/2.
            const double arm = std::hypot(x, y), inertia = 1.0 / body.invI + arm * arm / body.invMass;
            float& rate = demand[At(body.body)].pullRate;
            rate = std::max(rate, static_cast<float>(std::sqrt(pull * arm / (1.5 * inertia))));
        };
        note(m->bodies[At(joint.a)], joint.shape.ax, joint.shape.ay);
        note(m->bodies[At(joint.b)], joint.shape.bx, joint.shape.by);
    }
}

void JointTree::Store(float scale, JointTable& joints) const {
    for (const TreeJoint& joint : m->joints) {
        float impulse[maxTreeRows] = {};
        for (int i = 0; i < joint.rows.count; ++i) impulse[i] = scale * static_cast<float>(joint.total[i]);
        StoreImpulse(joint.shape, joint.rows, impulse, joint.joint, joints);
    }
}

}  // namespace scree
