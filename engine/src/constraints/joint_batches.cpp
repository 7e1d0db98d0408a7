// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which links form trees, who is whose child, what is solved side by side; poses and velocities in and out.

#include "constraints/joint_batches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "constraints/joint_tree_factors.h"

namespace scree {

namespace {

/// The graph of moving bodies with links as edges.
struct LinkGraph {
    std::vector<BodyIndex> bodies;  ///< per node
    std::vector<int> a, b;          ///< per link: nodes, −1: does not move
    std::vector<int> begin, edges;  ///< links of each node that join two moving bodies
    std::vector<int> degree;        ///< of these, how many are left
    std::vector<int> linkOfChild;   ///< per node: with which it is eliminated, −1: none
    std::vector<uint8_t> isGone, isLooped;

    explicit LinkGraph(std::span<const TreeEdge> links) {
        std::vector<std::pair<BodyIndex, int>> byBody;  // body, 2·link + side
        a.assign(links.size(), -1), b.assign(links.size(), -1);
        for (size_t i = 0; i < links.size(); ++i) {
            const auto at = static_cast<int>(i);
            if (links[i].movesA) byBody.emplace_back(links[i].bodyA, 2 * at);
            if (links[i].movesB) byBody.emplace_back(links[i].bodyB, 2 * at + 1);
        }
        std::sort(byBody.begin(), byBody.end());
        for (const auto& [body, side] : byBody) {
            if (bodies.empty() || bodies.back() != body) bodies.push_back(body);
            (side % 2 == 0 ? a : b)[ToSize(side / 2)] = static_cast<int>(bodies.size()) - 1;
        }
        begin.assign(bodies.size() + 1, 0);
        for (const auto& [body, side] : byBody) {
            if (IsEdge(side / 2)) ++begin[ToSize((side % 2 == 0 ? a : b)[ToSize(side / 2)]) + 1];
        }
        for (size_t n = 0; n < bodies.size(); ++n) begin[n + 1] += begin[n];
        for (const auto& [body, side] : byBody) {
            if (IsEdge(side / 2)) edges.push_back(side / 2);
        }
        for (size_t n = 0; n < bodies.size(); ++n) degree.push_back(begin[n + 1] - begin[n]);
        linkOfChild.assign(bodies.size(), -1);
        isGone.assign(bodies.size(), 0), isLooped.assign(bodies.size(), 0);
    }

    [[nodiscard]] bool IsEdge(int link) const { return a[ToSize(link)] >= 0 && b[ToSize(link)] >= 0; }
    [[nodiscard]] int Other(int link, int node) const {
        return a[ToSize(link)] == node ? b[ToSize(link)] : a[ToSize(link)];
    }
    [[nodiscard]] std::span<const int> EdgesOf(int node) const {
        return std::span(edges).subspan(ToSize(begin[ToSize(node)]),
                                        ToSize(begin[ToSize(node) + 1] - begin[ToSize(node)]));
    }

    /// Takes leaves off until only loops are left; what hangs on these is marked with them.
    void Peel() {
        std::vector<int> queue;
        for (size_t n = 0; n < bodies.size(); ++n) {
            if (degree[n] <= 1) queue.push_back(static_cast<int>(n));
        }
        for (size_t next = 0; next < queue.size(); ++next) {
            const int node = queue[next];
            isGone[ToSize(node)] = 1;
            for (const int link : EdgesOf(node)) {
                const int other = Other(link, node);
                if (isGone[ToSize(other)] != 0) continue;
                linkOfChild[ToSize(node)] = link;
                if (--degree[ToSize(other)] == 1) queue.push_back(other);
            }
        }
        queue.clear();
        for (size_t n = 0; n < bodies.size(); ++n) {
            if (isGone[n] == 0) isLooped[n] = 1, queue.push_back(static_cast<int>(n));
        }
        for (size_t next = 0; next < queue.size(); ++next) {
            for (const int link : EdgesOf(queue[next])) {
                const int other = Other(link, queue[next]);
                if (isLooped[ToSize(other)] == 0) isLooped[ToSize(other)] = 1, queue.push_back(other);
            }
        }
    }
};

/// Links become ready once all that hang on their child are done.
class LinkQueue {
public:
    void Push(int place) { m_ready.push_back(place); }
    [[nodiscard]] size_t Size() const { return m_ready.size() - m_next; }
    /// Up to four with different parents, in their order.
    template <typename ParentOf>
    std::span<const int> TakeFour(ParentOf&& parentOf) {
        constexpr size_t window = 64;  // of links that are looked at
        const size_t end = std::min(m_ready.size(), m_next + window);
        size_t taken = 0, left = 0, next = m_next;
        int passed[window];
        for (; next < end && taken < ToSize(jointLanes); ++next) {
            const int place = m_ready[next];
            const auto hasItsParent = [&](int other) { return parentOf(other) == parentOf(place); };
            const bool isFree = std::none_of(m_taken, m_taken + taken, hasItsParent);
            (isFree ? m_taken[taken++] : passed[left++]) = place;
        }
        // Those that were passed over come first the next time.
        m_next = next - left;
        std::copy(passed, passed + left, m_ready.begin() + static_cast<std::ptrdiff_t>(m_next));
        return {m_taken, taken};
    }

private:
    std::vector<int> m_ready;
    size_t m_next = 0;
    int m_taken[jointLanes] = {};
};

}  // namespace

void JointBatchScratch::Ensure(size_t bodyCount, size_t pointCount, size_t rowCount) {
    for (auto* ofBodies : {&aimed, &next, &shift, &impulse}) EnsureRows(*ofBodies, bodyCount);
    EnsureRows(mobility, 2 * bodyCount);
    for (auto* lanes : {&nextAngle, &left}) EnsureRows(*lanes, bodyCount / ToSize(jointLanes));
    EnsureRows(points, pointCount);
    EnsureRows(rows, rowCount);
}

size_t JointBatches::GetMemoryBytes() const {
    return BytesOf(m_bodies, m_places, m_points, m_rows, m_order, m_roots, m_others, m_pose, m_course, m_velocity,
                   m_mass, m_stiffness, m_tree, m_isLoaded, m_isChosen, m_kept);
}

int JointBatches::AddRow(BodyIndex body) {
    m_bodies.push_back(body);
    return static_cast<int>(m_bodies.size()) - 1;
}

void JointBatches::Plan(std::span<TreeEdge> links) {
    LinkGraph graph(links);
    graph.Peel();
    m_bodies.assign(1, BodyIndex::none);
    m_places.clear();
    std::vector<int> rowOf(graph.bodies.size(), -1);
    for (size_t n = 0; n < graph.bodies.size(); ++n) {
        if (graph.isLooped[n] == 0) rowOf[n] = AddRow(graph.bodies[n]);
    }
    for (size_t i = 0; i < links.size(); ++i) {
        TreeEdge& link = links[i];
        const int a = graph.a[i], b = graph.b[i];
        link.isTree = graph.isLooped[ToSize(a >= 0 ? a : b)] == 0;
        if (!link.isTree) continue;
        Place& place = m_places.emplace_back();
        place.shape = link.shape, place.joint = link.joint;
        place.isPoint = link.kind == TreeKind::point, place.isLine = link.kind == TreeKind::line;
        place.kind = link.kind;
        // What is fixed is a leaf.
        place.childIsB = a >= 0 && (b < 0 || graph.linkOfChild[ToSize(b)] == static_cast<int>(i));
        const int rowA = a >= 0 ? rowOf[ToSize(a)] : AddRow(link.bodyA);
        const int rowB = b >= 0 ? rowOf[ToSize(b)] : AddRow(link.bodyB);
        place.child = place.childIsB ? rowB : rowA;
        place.parent = place.childIsB ? rowA : rowB;
    }
    while (m_bodies.size() % ToSize(jointLanes) != 0) AddRow(BodyIndex::none);
    PutIntoLanes();
    ListRootsAndOthers();
    for (auto* rows : {&m_pose, &m_course, &m_velocity, &m_mass}) rows->assign(m_bodies.size(), BodyRow{});
    m_stiffness.assign(m_bodies.size() / ToSize(jointLanes), LaneRow{});
}

void JointBatches::Renumber(std::span<const TreeEdge> links) {
    auto place = m_places.begin();
    for (const TreeEdge& link : links) {
        if (link.isTree) (place++)->shape = link.shape;
    }
}

void JointBatches::ListRootsAndOthers() {
    m_roots.clear(), m_others.clear();
    std::vector<uint8_t> isChild(m_bodies.size(), 0);
    m_tree.resize(m_bodies.size());
    std::iota(m_tree.begin(), m_tree.end(), 0);
    for (const Place& place : m_places) m_tree[ToSize(place.child)] = place.parent;
    for (size_t row = 0; row < m_tree.size(); ++row) {
        int root = m_tree[row];
        while (m_tree[ToSize(root)] != root) root = m_tree[ToSize(root)];
        // The whole way, or the rows of a long chain would each walk it.
        for (auto at = static_cast<int>(row); m_tree[ToSize(at)] != root;) at = std::exchange(m_tree[ToSize(at)], root);
    }
    for (size_t i = 0; i < m_places.size(); ++i) {
        Place& place = m_places[i];
        isChild[ToSize(place.child)] = 1;
        place.other = place.isPoint || place.isLine ? -1 : static_cast<int>(m_others.size());
        if (place.other < 0) continue;
        Other& other = m_others.emplace_back();
        other.place = static_cast<int>(i);
        other.rows.count = RowCount(place.kind);
    }
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        if (isChild[row] == 0) m_roots.push_back(static_cast<int32_t>(row));
    }
}

void JointBatches::PutIntoLanes() {
    m_points.clear(), m_rows.clear(), m_order.clear();
    std::vector<int> waiting(m_bodies.size(), 0), placeOfChild(m_bodies.size(), -1);
    for (size_t i = 0; i < m_places.size(); ++i) {
        ++waiting[ToSize(m_places[i].parent)];
        placeOfChild[ToSize(m_places[i].child)] = static_cast<int>(i);
    }
    LinkQueue queues[1 + static_cast<size_t>(TreeKind::rod)];  // by kind
    const auto push = [&](int place) { queues[static_cast<size_t>(m_places[ToSize(place)].kind)].Push(place); };
    const auto longest = [&] {
        return std::ranges::max_element(queues, {}, [](const LinkQueue& queue) { return queue.Size(); });
    };
    for (size_t i = 0; i < m_places.size(); ++i) {
        if (waiting[ToSize(m_places[i].child)] == 0) push(static_cast<int>(i));
    }
    for (LinkQueue* queue = longest(); queue->Size() > 0; queue = longest()) {
        const bool isPoint = queue == &queues[static_cast<size_t>(TreeKind::point)];
        const std::span<const int> taken = queue->TakeFour([&](int place) { return m_places[ToSize(place)].parent; });
        const auto fill = [&](auto& batches) {
            auto& batch = batches.emplace_back();
            batch = {};
            for (size_t lane = 0; lane < taken.size(); ++lane) {
                Place& place = m_places[ToSize(taken[lane])];
                place.batch = static_cast<int>(batches.size()) - 1, place.lane = static_cast<int>(lane);
                batch.child[lane] = place.child, batch.parent[lane] = place.parent;
            }
            return static_cast<int32_t>(batches.size()) - 1;
        };
        m_order.push_back(isPoint ? fill(m_points) : ~fill(m_rows));
        if (!isPoint) {
            m_rows.back().count = RowCount(m_places[ToSize(taken.front())].kind);
            m_rows.back().isLine = m_places[ToSize(taken.front())].isLine;
        }
        for (const int place : taken) {
            const int parent = m_places[ToSize(place)].parent;
            if (--waiting[ToSize(parent)] == 0 && placeOfChild[ToSize(parent)] >= 0) push(placeOfChild[ToSize(parent)]);
        }
    }
}

void JointBatches::SetLine(const Place& place, const TreeShape& s, RowBatch& batch) {
    const size_t lane = ToSize(place.lane);
    batch.bodyA[lane] = place.childIsB ? place.parent : place.child;
    batch.bodyB[lane] = place.childIsB ? place.child : place.parent;
    batch.childIsB.v[lane] = place.childIsB ? 1.0 : 0.0;
    batch.anchorA[0].v[lane] = s.ax, batch.anchorA[1].v[lane] = s.ay;
    batch.anchorB[0].v[lane] = s.bx, batch.anchorB[1].v[lane] = s.by;
    batch.localAxis[0].v[lane] = s.axisX, batch.localAxis[1].v[lane] = s.axisY;
}

void JointBatches::MarkLoaded(const LoadBearers* bearers) {
    m_isLoaded.clear();
    if (bearers == nullptr) return;
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        if (IsNone(m_bodies[row]) || !bearers->Has(m_bodies[row])) continue;
        m_isLoaded.resize(m_bodies.size(), 0);
        m_isLoaded[ToSize(m_tree[row])] = 1;
    }
}

void JointBatches::Refresh(const BodyTable& bodies, const JointTable& joints, const TreeInput& input) {
    m_compliance = input.compliance;
    MarkLoaded(input.bearers);
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        if (IsNone(m_bodies[row])) continue;
        const BodyIndex body = m_bodies[row];
        const bool moves = bodies.type[body] == dynamicBody;
        const double invMass = moves ? double{bodies.mass[body].invMass} : 0.0;
        const double invI = moves ? double{bodies.mass[body].invI} : 0.0;
        m_mass[row] = {{invMass, invI, invI, 1.0}};
        m_velocity[row].v[2] = 0.0;
        const Rot& q = bodies.transform[body].q;
        m_course[row] = {{0.0, 0.0, double{q.c}, double{q.s}}};
    }
    m_shapes = input.shapes;
    for (const Place& place : m_places) {
        const TreeShape& s = m_shapes[ToSize(place.shape)];
        const size_t lane = ToSize(place.lane);
        double recent[maxTreeRows];
        LoadImpulse(place.joint, joints, input.recentScale, recent);
        const auto begin = [&](auto& batch, double sign, int count) {
            for (int i = 0; i < count; ++i) {
                batch.total[i].v[lane] = 0.0;
                batch.recent[i].v[lane] = sign * recent[i];
            }
        };
        if (!place.isPoint) {
            RowBatch& batch = m_rows[ToSize(place.batch)];
            begin(batch, 1.0, batch.count);
            if (place.isLine) SetLine(place, s, batch);
            continue;
        }
        PointBatch& batch = m_points[ToSize(place.batch)];
        batch.anchorChild[0].v[lane] = place.childIsB ? s.bx : s.ax,
        batch.anchorChild[1].v[lane] = place.childIsB ? s.by : s.ay;
        batch.anchorParent[0].v[lane] = place.childIsB ? s.ax : s.bx,
        batch.anchorParent[1].v[lane] = place.childIsB ? s.ay : s.by;
        begin(batch, place.childIsB ? 1.0 : -1.0, 2);
    }
}

JointBatchTask JointBatches::Task(JointBatchScratch& scratch) {
    const auto turnFar = [](double cos, double sin, double angle, double* cosSin) {
        TreePose pose;
        Turn(cos, sin, angle, pose);
        cosSin[0] = pose.cos, cosSin[1] = pose.sin;
    };
    return {.bodyCount = static_cast<int32_t>(m_bodies.size()),
            .pose = m_pose.data(),
            .course = m_course.data(),
            .velocity = m_velocity.data(),
            .mass = m_mass.data(),
            .stiffness = &m_stiffness.data()->v[0],
            .points = m_points.data(),
            .pointCount = static_cast<int32_t>(m_points.size()),
            .rows = m_rows.data(),
            .rowCount = static_cast<int32_t>(m_rows.size()),
            .aimed = scratch.aimed.data(),
            .next = scratch.next.data(),
            .nextAngle = scratch.nextAngle.data(),
            .left = scratch.left.data(),
            .mobility = scratch.mobility.data(),
            .shift = scratch.shift.data(),
            .impulse = scratch.impulse.data(),
            .pointNotes = scratch.points.data(),
            .rowNotes = scratch.rows.data(),
            .order = m_order.data(),
            .batchCount = static_cast<int32_t>(m_order.size()),
            .roots = m_roots.data(),
            .rootCount = static_cast<int32_t>(m_roots.size()),
            .h = m_h,
            .compliance = m_compliance,
            .leastPivot = leastPivot,
            .turnFar = turnFar};
}

namespace {

/// A body's pose of a row (x, y, cos, sin) and its angle.
TreePose PoseOf(const BodyRow& row, double angle) {
    const double(&p)[4] = row.v;
    return {p[0], p[1], angle, p[2], p[3]};
}

/// The next solve finds no joint that gives way.
void StandFirm(const JointBatchTask& task) {
    for (int i = 0; i < task.pointCount; ++i) task.pointNotes[i].give = {};
    for (int i = 0; i < task.rowCount; ++i) task.rowNotes[i].give = {};
}

}  // namespace

/// Jacobians of joints that are neither points nor on lines.
void JointBatches::MakeJacobians() {
    for (Other& other : m_others) {
        const Place& place = m_places[ToSize(other.place)];
        const auto pose = [&](int row) { return PoseOf(m_pose[ToSize(row)], m_course[ToSize(row)].v[0]); };
        const TreePose child = pose(place.child), parent = pose(place.parent);
        MakeRows<true>(m_shapes[ToSize(place.shape)], place.childIsB ? parent : child, place.childIsB ? child : parent,
                       other.rows);
        RowBatch& batch = m_rows[ToSize(place.batch)];
        const size_t lane = ToSize(place.lane);
        for (int i = 0; i < batch.count; ++i) {
            for (int k = 0; k < 3; ++k) {
                batch.rowChild[i][k].v[lane] = (place.childIsB ? other.rows.b : other.rows.a)[i][k];
                batch.rowParent[i][k].v[lane] = (place.childIsB ? other.rows.a : other.rows.b)[i][k];
            }
        }
        // A pull at the end of an arm, as of points.
        if (place.kind == TreeKind::pointAndAngle) {
            const double x = batch.recent[0].v[lane], y = batch.recent[1].v[lane];
            const auto note = [&](int row, const double(&jacobian)[maxTreeRows][3], double sign) {
                m_stiffness[ToSize(row) / ToSize(jointLanes)].v[ToSize(row) % ToSize(jointLanes)] +=
                    sign * (jacobian[1][2] * x - jacobian[0][2] * y);
            };
            note(place.childIsB ? place.parent : place.child, other.rows.a, 1.0);
            note(place.childIsB ? place.child : place.parent, other.rows.b, 1.0);
        }
        for (LaneRow& recent : batch.recent) recent.v[lane] = 0.0;
    }
}

void JointBatches::MeasureRows(const JointBatchTask& task) const {
    const auto pose = [&](int row) {
        return PoseOf(task.next[row], task.nextAngle[row / jointLanes].v[row % jointLanes]);
    };
    for (const Other& other : m_others) {
        const Place& place = m_places[ToSize(other.place)];
        const TreePose child = pose(place.child), parent = pose(place.parent);
        TreeRows rows;
        MakeRows<false>(m_shapes[ToSize(place.shape)], place.childIsB ? parent : child, place.childIsB ? child : parent,
                        rows);
        SolveNotes<rowLimit>& notes = task.rowNotes[place.batch];
        for (int i = 0; i < RowCount(place.kind); ++i) notes.right[i].v[place.lane] = -rows.error[i] / m_h;
    }
}

/// Trees that bear a load and have a body that counts as more inert for a pull. False if there are none.
bool JointBatches::FindLoadedTrees() {
    if (m_isLoaded.empty()) return false;
    m_isChosen.assign(m_bodies.size(), 0);
    bool isAny = false;
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        const size_t tree = ToSize(m_tree[row]);
        const double stiffness = m_stiffness[row / ToSize(jointLanes)].v[row % ToSize(jointLanes)];
        if (m_isLoaded[tree] != 0 && m_h * stiffness * m_mass[row].v[1] > 1.0) m_isChosen[tree] = 1, isAny = true;
    }
    return isAny;
}

/// In these trees bodies count as inert as they are, and joints hardly give way.
void JointBatches::FactorizeForVelocities(const JointBatchTask& task) {
    const auto isChosen = [this](size_t row) { return m_isChosen[ToSize(m_tree[row])] != 0; };
    m_kept = m_stiffness;
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        if (isChosen(row)) m_stiffness[row / ToSize(jointLanes)].v[row % ToSize(jointLanes)] = 0.0;
    }
    for (const Place& place : m_places) {
        if (!isChosen(ToSize(place.child))) continue;
        LaneRow& give = place.isPoint ? task.pointNotes[place.batch].give : task.rowNotes[place.batch].give;
        give.v[place.lane] = loadedCompliance - m_compliance;
    }
    GetJointBatchKernels().factorize(task);
    StandFirm(task);
    m_stiffness = m_kept;
}

void JointBatches::Factorize(const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, double h,
                             JointBatchScratch& scratch) {
    m_h = h;
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        if (IsNone(m_bodies[row])) continue;
        const TreeStart from = StartOf(bodies, delta, m_bodies[row]);
        m_pose[row].v[0] = from.x, m_pose[row].v[1] = from.y;
        m_course[row].v[0] = from.angle, m_course[row].v[1] = from.turn;
    }
    const JointBatchKernels& kernels = GetJointBatchKernels();
    const JointBatchTask task = Task(scratch);
    kernels.turn(task);
    std::fill(m_stiffness.begin(), m_stiffness.end(), LaneRow{});
    kernels.reach(task);
    kernels.align(task);
    MakeJacobians();
    m_isForVelocities = FindLoadedTrees();
    m_isForVelocities ? FactorizeForVelocities(task) : kernels.factorize(task);
}

/// spinOf(spin, last, mass): with which a solve begins, of that of the body and of what the last solve ended with.
template <typename SpinOf>
void JointBatches::LoadVelocities(const Column<BodyIndex, Velocity>& velocity, SpinOf&& spinOf) {
    const size_t count = m_bodies.size();
    const BodyIndex* bodies = m_bodies.data();
    BodyRow* to = m_velocity.data();
    BodyRow* mass = m_mass.data();
    for (size_t row = 0; row < count; ++row) {
        if (IsNone(bodies[row])) continue;
        const Velocity& v = velocity[bodies[row]];
        const double spin = spinOf(double{v.w}, to[row].v[2], mass[row].v);
        to[row] = {{double{v.v.x}, double{v.v.y}, spin, 0.0}};
    }
}

void JointBatches::StoreVelocities(Column<BodyIndex, Velocity>& velocity) const {
    const size_t count = m_bodies.size();
    const BodyIndex* bodies = m_bodies.data();
    const BodyRow* rows = m_velocity.data();
    const BodyRow* mass = m_mass.data();
    for (size_t row = 0; row < count; ++row) {
        if (IsNone(bodies[row]) || (mass[row].v[0] == 0.0 && mass[row].v[1] == 0.0)) continue;
        const double(&from)[4] = rows[row].v;
        Velocity& v = velocity[bodies[row]];
        v.v = {static_cast<float>(from[0]), static_cast<float>(from[1])};
        v.w = static_cast<float>(from[2]);
    }
}

double JointBatches::AimAll(const JointBatchTask& task) const {
    // The Jacobians of the present pose stand for those of the next one. What that leaves of an error, in shares of an
    // arm, is the turn of a body times what the solve changes of it. Each iteration gains two orders in h. A chain
    // under a strong pull swings itself up where they begin at the impulses of the last time. It does so too where they
    // go on beyond the second.
    constexpr double enough = 1e-5;  // rad²
    constexpr int mostIterations = 2;
    const JointBatchKernels& kernels = GetJointBatchKernels();
    kernels.coast(task);
    double left = 0.0;
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        kernels.lead(task);
        kernels.measure(task);
        MeasureRows(task);
        left = kernels.aim(task);
        if (!(left > enough)) break;
    }
    return left;
}

/// Where the velocities of `aimed` lead, per row that stands for a tree.
std::vector<TreeCourse> JointBatches::MeasureTrees(const JointBatchTask& task) const {
    const JointBatchKernels& kernels = GetJointBatchKernels();
    kernels.lead(task);
    kernels.measure(task);
    MeasureRows(task);
    std::vector<TreeCourse> trees(m_bodies.size());
    for (const Place& place : m_places) {
        double& largest = trees[ToSize(m_tree[ToSize(place.child)])].error;
        const auto note = [&](const LaneRow& right) {
            largest = std::max(largest, std::abs(right.v[place.lane]) * task.h);
        };
        if (place.isPoint) {
            for (const LaneRow& right : task.pointNotes[place.batch].right) note(right);
        } else {
            for (int i = 0; i < m_rows[ToSize(place.batch)].count; ++i) note(task.rowNotes[place.batch].right[i]);
        }
    }
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        const double(&mass)[4] = m_mass[row].v;
        trees[ToSize(m_tree[row])].energy += EnergyOf(task.aimed[row].v, mass[0], mass[2]);
    }
    return trees;
}

/// In trees whose aim misleads. False if there are none.
bool JointBatches::GiveWay(const JointBatchTask& task, double compliance) const {
    const std::vector<TreeCourse> aimed = MeasureTrees(task);
    const std::vector<BodyRow> velocities(task.aimed, task.aimed + task.bodyCount);
    GetJointBatchKernels().coast(task);
    const std::vector<TreeCourse> coasted = MeasureTrees(task);
    std::ranges::copy(velocities, task.aimed);
    std::vector<uint8_t> gives(m_bodies.size(), 0);
    bool doAny = false;
    for (size_t row = 0; row < m_bodies.size(); ++row) {
        const size_t tree = ToSize(m_tree[row]);
        const double left = task.left[row / ToSize(jointLanes)].v[row % ToSize(jointLanes)];
        if (Misleads(left, aimed[tree], coasted[tree])) gives[tree] = 1, doAny = true;
    }
    for (const Place& place : m_places) {
        if (gives[ToSize(m_tree[ToSize(place.child)])] == 0) continue;
        LaneRow& give = place.isPoint ? task.pointNotes[place.batch].give : task.rowNotes[place.batch].give;
        give.v[place.lane] = compliance;
    }
    return doAny;
}

void JointBatches::SolveBeforeMove(Column<BodyIndex, Velocity>& velocity, JointBatchScratch& scratch) {
    const JointBatchKernels& kernels = GetJointBatchKernels();
    const JointBatchTask task = Task(scratch);
    if (m_isForVelocities) kernels.factorize(task);
    // The spin that the body has is that of its own inertia: what is added must not bring energy with it.
    LoadVelocities(velocity, [](double spin, double, const double(&mass)[4]) {
        return mass[2] < mass[1] ? spin * (mass[2] / mass[1]) : spin;
    });
    double left = AimAll(task);
    if (TurnsTooFar(left)) {
        for (double give = leastGive; TurnsTooFar(left) && give <= mostGive; give *= giveFactor) {
            if (!GiveWay(task, give)) break;
            kernels.factorize(task);
            left = AimAll(task);
        }
        StandFirm(task);
    }
    kernels.keep(task);
    StoreVelocities(velocity);
}

void JointBatches::SolveAfterMove(Column<BodyIndex, Velocity>& velocity, JointBatchScratch& scratch) {
    LoadVelocities(velocity, [](double spin, double last, double(&mass)[4]) {
        const double taken = TakeSpin(spin, last, mass[3], mass[1], mass[2]);
        mass[3] = 1.0;
        return taken;
    });
    GetJointBatchKernels().stop(Task(scratch));
    StoreVelocities(velocity);
}

}  // namespace scree
