// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Motion of a forest of joints: poses and errors in, velocities, impulses and pulls out.

#include "constraints/joint_tree.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "constraints/joint_tree_factors.h"
#include "constraints/joint_tree_forest.h"

namespace scree {

namespace {

/// spinOf(body, spin): with which a solve begins.
template <typename SpinOf>
void LoadVelocities(std::vector<TreeBody>& bodies, const Column<BodyIndex, Velocity>& velocity, SpinOf&& spinOf) {
    for (TreeBody& b : bodies) {
        const Velocity& v = velocity[b.body];
        b.v[0] = double{v.v.x}, b.v[1] = double{v.v.y}, b.v[2] = spinOf(b, double{v.w});
    }
}
void StoreVelocities(const std::vector<TreeBody>& bodies, Column<BodyIndex, Velocity>& velocity) {
    for (const TreeBody& b : bodies) {
        if (b.invMass == 0.0 && b.invI == 0.0) continue;
        Velocity& v = velocity[b.body];
        v.v = {static_cast<float>(b.v[0]), static_cast<float>(b.v[1])};
        v.w = static_cast<float>(b.v[2]);
    }
}

}  // namespace

JointTree::JointTree() : m(std::make_unique<JointForest>()) {}
JointTree::~JointTree() = default;

void JointTree::Build(const JointTreeInput& input) {
    m->Build(input.bodies, input.joints, input.list,
             {double{input.substepScale}, input.compliance, input.direct, input.pool, input.bearers});
}
bool JointTree::IsEmpty() const { return m->trees.IsEmpty() && m->joints.empty(); }
JointNet& JointTree::GetNets() { return m->nets; }
std::span<const JointIndex> JointTree::GetOthers() const { return m->others; }
std::span<const JointIndex> JointTree::GetBounded() const { return m->bounded; }
size_t JointTree::GetMemoryBytes() const { return m->GetMemoryBytes(); }

namespace {

/// A pull at the end of an arm turns its body back with a stiffness of pull times arm. Explicit integration does not
/// carry that once h²·stiffness exceeds four times the inertia. Where it comes near, the solve takes the body for as
/// inert as is safe. This is geometric stiffness (Tournier, Nesme, Gilles, Faure, "Stable Constrained Dynamics", 2015).
/// As a diagonal: Andrews, Teichmann, Kry, "Geometric Stiffness for Real-time Constrained Multibody Dynamics", 2017.
void SumPulls(JointForest& forest) {
    for (TreeBody& b : forest.bodies) b.pull = 0.0;
    for (TreeJoint& joint : forest.joints) {
        if (joint.shape.kind == TreeKind::point || joint.shape.kind == TreeKind::pointAndAngle) {
            const double x = joint.recent[0], y = joint.recent[1];
            forest.bodies[ToSize(joint.a)].pull += joint.rows.a[1][2] * x - joint.rows.a[0][2] * y;
            forest.bodies[ToSize(joint.b)].pull += joint.rows.b[1][2] * x - joint.rows.b[0][2] * y;
        }
        for (double& impulse : joint.recent) impulse = 0.0;
    }
}
bool IsSteadied(const TreeBody& b, double h) { return h * b.pull * b.invI > 1.0; }

/// With velocities that lead to a move of `h` seconds.
void FactorizeFor(JointForest& forest, double h) {
    for (TreeBody& b : forest.bodies) {
        const double before = b.steadyInvI;
        b.steadyInvI = !b.isForVelocities && IsSteadied(b, h) ? 1.0 / (h * b.pull) : b.invI;
        b.spinLeft = b.steadyInvI < before ? b.steadyInvI / before : 1.0;
    }
    FactorizeForest(forest, forest.compliance);
}

/// Loops that bear a load and are pulled get factors for the solve on velocities. False if there are none.
bool FindLoadedParts(JointForest& forest, double h) {
    const auto isPulled = [&](const TreeBody& b) { return b.isLoaded && IsSteadied(b, h); };
    if (std::ranges::none_of(forest.bodies, isPulled)) return false;
    const std::vector<uint8_t> areChosen = forest.ChooseParts(isPulled);
    for (TreeJoint& joint : forest.joints) {
        if (areChosen[ToSize(joint.part)] == 0) continue;
        joint.give = loadedCompliance - forest.compliance;
        for (const int row : {joint.a, joint.b}) forest.bodies[ToSize(row)].isForVelocities = true;
    }
    return true;
}
/// The next factors are for aiming.
void EndLoadedParts(JointForest& forest) {
    if (!forest.isForVelocities) return;
    for (TreeBody& b : forest.bodies) b.isForVelocities = false;
    for (TreeJoint& joint : forest.joints) joint.give = 0.0;
}

}  // namespace

void JointTree::Factorize(const Poses& poses, float h) {
    m->trees.Factorize(*m->pool, poses.bodies, poses.delta, double{h});
    FactorizeLoops(poses, h);
}

void JointTree::FactorizeLoops(const Poses& poses, float h) {
    if (m->joints.empty()) return;
    for (TreeBody& b : m->bodies) {
        const TreeStart start = StartOf(poses.bodies, poses.delta, b.body);
        b.pose.x = start.x, b.pose.y = start.y, b.pose.angle = start.angle;
        Turn(b.startCos, b.startSin, start.turn, b.pose);
    }
    for (TreeJoint& joint : m->joints) {
        MakeRows<true>(joint.shape, m->bodies[ToSize(joint.a)].pose, m->bodies[ToSize(joint.b)].pose, joint.rows);
    }
    SumPulls(*m);
    m->isForVelocities = FindLoadedParts(*m, double{h});
    FactorizeFor(*m, double{h});
    EndLoadedParts(*m);
}

namespace {

void Lead(JointForest& forest, double h) {
    for (TreeBody& b : forest.bodies) {
        b.next.x = b.pose.x + h * b.v[0];
        b.next.y = b.pose.y + h * b.v[1];
        b.next.angle = b.pose.angle + h * b.v[2];
        Turn(b.pose.cos, b.pose.sin, h * b.v[2], b.next);
    }
}
TreeRows ErrorsAhead(const JointForest& forest, const TreeJoint& joint) {
    TreeRows next;
    next.count = joint.rows.count;
    MakeRows<false>(joint.shape, forest.bodies[ToSize(joint.a)].next, forest.bodies[ToSize(joint.b)].next, next);
    return next;
}
double LargestOf(const TreeRows& rows) {
    double largest = 0.0;
    for (int i = 0; i < rows.count; ++i) largest = std::max(largest, std::abs(rows.error[i]));
    return largest;
}

/// Returns the most that the solve leaves, as TreeBody::left.
double AimAll(JointForest& forest, double h, const Column<BodyIndex, Velocity>& velocity) {
    // Each iteration gains two orders in h: the Jacobians of the present pose stand for those of the next one.
    constexpr int iterations = 2;
    const double inverse = 1.0 / h;
    // The spin that the body has is that of its own inertia: what is added must not bring energy with it.
    LoadVelocities(forest.bodies, velocity, [](const TreeBody& b, double spin) {
        return b.steadyInvI < b.invI ? spin * (b.steadyInvI / b.invI) : spin;
    });
    for (TreeBody& b : forest.bodies) std::ranges::copy(b.v, b.coasted);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        Lead(forest, h);
        for (TreeBody& b : forest.bodies) b.left = b.v[2];
        for (TreeJoint& joint : forest.joints) {
            const TreeRows next = ErrorsAhead(forest, joint);
            if (iteration == 0) joint.coasted = LargestOf(next);
            for (int i = 0; i < next.count; ++i) joint.rhs[i] = -inverse * next.error[i];
        }
        SolveForest(forest);
    }
    double most = 0.0;
    for (TreeBody& b : forest.bodies) {
        const double turn = std::abs(b.v[2] - b.left);
        b.left = h * h * (turn * (std::abs(b.v[2]) + turn));
        most = std::max(most, b.left);
    }
    return most;
}

/// In loops whose aim misleads. All impulses of the last aim are taken back then. False if there are none.
bool GiveWay(JointForest& forest, double h, double compliance, const std::vector<TreeSums>& before) {
    struct Loop {
        double left = 0.0;  ///< the largest
        TreeCourse coasted, aimed;
    };
    std::map<int, Loop> loops;
    std::vector<int> partOf(forest.bodies.size(), -1);
    Lead(forest, h);
    for (const TreeJoint& joint : forest.joints) {
        Loop& loop = loops[joint.part];
        for (const int row : {joint.a, joint.b}) {
            loop.left = std::max(loop.left, forest.bodies[ToSize(row)].left);
            partOf[ToSize(row)] = joint.part;
        }
        loop.coasted.error = std::max(loop.coasted.error, joint.coasted);
        loop.aimed.error = std::max(loop.aimed.error, LargestOf(ErrorsAhead(forest, joint)));
    }
    for (size_t row = 0; row < forest.bodies.size(); ++row) {
        const TreeBody& b = forest.bodies[row];
        if (partOf[row] < 0) continue;
        loops[partOf[row]].coasted.energy += EnergyOf(b.coasted, b.invMass, b.steadyInvI);
        loops[partOf[row]].aimed.energy += EnergyOf(b.v, b.invMass, b.steadyInvI);
    }
    const auto gives = [](const Loop& loop) { return Misleads(loop.left, loop.aimed, loop.coasted); };
    if (std::ranges::none_of(loops, [&](const auto& loop) { return gives(loop.second); })) return false;
    for (size_t i = 0; i < before.size(); ++i) {
        TreeJoint& joint = forest.joints[i];
        static_cast<TreeSums&>(joint) = before[i];
        if (gives(loops[joint.part])) joint.give = compliance;
    }
    return true;
}

}  // namespace

void JointTree::SolveBeforeMove(const Poses&, float h, Column<BodyIndex, Velocity>& velocity) {
    m->trees.SolveBeforeMove(*m->pool, velocity);
    if (m->joints.empty()) return;
    const auto factorize = [&] { FactorizeFor(*m, double{h}); };
    if (m->isForVelocities) factorize();
    m->before.assign(m->joints.begin(), m->joints.end());  // as sums
    double left = AimAll(*m, double{h}, velocity);
    if (TurnsTooFar(left)) {
        for (double give = leastGive; TurnsTooFar(left) && give <= mostGive; give *= giveFactor) {
            if (!GiveWay(*m, double{h}, give, m->before)) break;
            factorize();
            left = AimAll(*m, double{h}, velocity);
        }
        for (TreeJoint& joint : m->joints) joint.give = 0.0;
    }
    StoreVelocities(m->bodies, velocity);
}

void JointTree::SolveAfterMove(Column<BodyIndex, Velocity>& velocity) {
    m->trees.SolveAfterMove(*m->pool, velocity);
    StopLoops(velocity);
}

void JointTree::FactorizeAndStop(const Poses& poses, float h, Column<BodyIndex, Velocity>& velocity) {
    m->trees.FactorizeAndStop(*m->pool, poses.bodies, poses.delta, double{h}, velocity);
    FactorizeLoops(poses, h);
    StopLoops(velocity);
}

void JointTree::StopLoops(Column<BodyIndex, Velocity>& velocity) {
    if (m->joints.empty()) return;
    LoadVelocities(m->bodies, velocity, [](TreeBody& b, double spin) {
        const double taken = TakeSpin(spin, b.v[2], b.spinLeft, b.invI, b.steadyInvI);
        b.spinLeft = 1.0;
        return taken;
    });
    for (TreeJoint& joint : m->joints) {
        const double(&a)[3] = m->bodies[ToSize(joint.a)].v;
        const double(&b)[3] = m->bodies[ToSize(joint.b)].v;
        for (int i = 0; i < joint.rows.count; ++i) {
            double speed = 0.0;
            for (int k = 0; k < 3; ++k) speed += joint.rows.a[i][k] * a[k] + joint.rows.b[i][k] * b[k];
            joint.rhs[i] = -speed;
        }
    }
    SolveForest(*m);
    StoreVelocities(m->bodies, velocity);
}

void JointTree::NotePullRates(float dt, Column<BodyIndex, BodyDemand>& demand) const {
    m->ForEachResult([&](const TreeResult& result) {
        if (result.rows.count < 2) return;
        const double(&impulse)[maxTreeRows] = result.impulse;
        const double pull = std::sqrt(impulse[0] * impulse[0] + impulse[1] * impulse[1]) / double{dt};
        const auto note = [&](const TreeResult::Side& side, double x, double y) {
            if (side.invMass == 0.0 || side.invI == 0.0) return;
            // A rod pulled at its end: inertia m·l²/3 about the other end of the arm l/2.
            const double arm = std::sqrt(x * x + y * y), inertia = 1.0 / side.invI + arm * arm / side.invMass;
            float& rate = demand[side.body].pullRate;
            rate = std::max(rate, static_cast<float>(std::sqrt(pull * arm / (1.5 * inertia))));
        };
        note(result.a, result.shape.ax, result.shape.ay);
        note(result.b, result.shape.bx, result.shape.by);
    });
}

void JointTree::Store(float scale, JointTable& joints) const {
    m->ForEachResult(*m->pool, [&](const TreeResult& result) {
        float impulse[maxTreeRows] = {};
        for (int i = 0; i < result.rows.count; ++i) impulse[i] = scale * static_cast<float>(result.impulse[i]);
        StoreImpulse(result.shape, result.rows, impulse, result.joint, joints);
    });
}

}  // namespace scree
