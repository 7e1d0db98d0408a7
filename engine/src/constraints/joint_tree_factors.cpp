// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Elimination from the leaves to the roots, and the two passes of a solve.

#include "constraints/joint_tree_factors.h"

#include <type_traits>
#include <utility>

namespace scree {

namespace {

/// Calls use(n) with the number of rows of a joint as a constant, so that the loops over rows unroll.
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

void FillMatrix(JointForest& forest, double compliance) {
    const auto product = [](const double(&i)[3], const double(&j)[3], const TreeBody& b) {
        return b.invMass * (i[0] * j[0] + i[1] * j[1]) + b.steadyInvI * i[2] * j[2];
    };
    for (TreeJoint& joint : forest.joints) {
        const TreeBody& a = forest.bodies[ToSize(joint.a)];
        const TreeBody& b = forest.bodies[ToSize(joint.b)];
        WithCount(joint.rows.count, [&](auto n) {
            Unroll(n, [&](int i) {
                for (int j = 0; j <= i; ++j) {
                    joint.inverse[i][j] = joint.inverse[j][i] =
                        product(joint.rows.a[i], joint.rows.a[j], a) + product(joint.rows.b[i], joint.rows.b[j], b);
                }
                joint.inverse[i][i] *= 1.0 + (compliance + joint.give);
            });
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                TreeLink& link = forest.links[ToSize(l)];
                const TreeJoint& later = forest.joints[ToSize(link.later)];
                for (auto& row : link.block) {
                    for (double& x : row) x = 0.0;
                }
                const auto add = [&](const auto& other, const auto& own, const TreeBody& shared) {
                    WithCount(later.rows.count, [&](auto rows) {
                        Unroll(rows, [&](int i) {
                            Unroll(n, [&](int j) { link.block[i][j] += product(other[i], own[j], shared); });
                        });
                    });
                };
                if (later.a == joint.a) add(later.rows.a, joint.rows.a, a);
                if (later.b == joint.a) add(later.rows.b, joint.rows.a, a);
                if (later.a == joint.b) add(later.rows.a, joint.rows.b, b);
                if (later.b == joint.b) add(later.rows.b, joint.rows.b, b);
            }
        });
    }
}

template <typename Own, typename Later>
void EliminateLink(JointForest& forest, const TreeJoint& joint, int at, Own n, Later rows) {
    TreeLink& link = forest.links[ToSize(at)];
    TreeJoint& later = forest.joints[ToSize(link.later)];
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
    // The later joint is coupled with all that follow it here, in the same order, and maybe with more.
    int target = later.linkBegin;
    for (int r = at + 1; r < joint.linkEnd; ++r, ++target) {
        const TreeLink& with = forest.links[ToSize(r)];
        while (forest.links[ToSize(target)].later != with.later) ++target;
        WithCount(forest.joints[ToSize(with.later)].rows.count,
                  [&](auto count) { reduce(with, count, forest.links[ToSize(target)].block); });
    }
    Unroll(rows, [&](int i) { Unroll(n, [&](int j) { link.block[i][j] = row[i][j]; }); });
}

void Eliminate(JointForest& forest) {
    for (TreeJoint& joint : forest.joints) {
        WithCount(joint.rows.count, [&](auto n) {
            // The diagonal before anything is subtracted from it.
            double scale[maxTreeRows] = {};
            const TreeBody& bodyA = forest.bodies[ToSize(joint.a)];
            const TreeBody& bodyB = forest.bodies[ToSize(joint.b)];
            Unroll(n, [&](int i) {
                const double(&a)[3] = joint.rows.a[i];
                const double(&b)[3] = joint.rows.b[i];
                scale[i] = bodyA.invMass * (a[0] * a[0] + a[1] * a[1]) + bodyA.steadyInvI * a[2] * a[2] +
                           bodyB.invMass * (b[0] * b[0] + b[1] * b[1]) + bodyB.steadyInvI * b[2] * b[2];
            });
            Invert(joint.inverse, n, scale);
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                WithCount(forest.joints[ToSize(forest.links[ToSize(l)].later)].rows.count,
                          [&](auto rows) { EliminateLink(forest, joint, l, n, rows); });
            }
        });
    }
}

/// Right sides → impulses.
void Solve(JointForest& forest) {
    for (const TreeJoint& joint : forest.joints) {
        WithCount(joint.rows.count, [&](auto n) {
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                const TreeLink& link = forest.links[ToSize(l)];
                TreeJoint& later = forest.joints[ToSize(link.later)];
                WithCount(later.rows.count, [&](auto rows) {
                    Unroll(rows,
                           [&](int i) { Unroll(n, [&](int j) { later.rhs[i] -= link.block[i][j] * joint.rhs[j]; }); });
                });
            }
        });
    }
    for (size_t at = forest.joints.size(); at-- > 0;) {
        TreeJoint& joint = forest.joints[at];
        WithCount(joint.rows.count, [&](auto n) {
            double impulse[maxTreeRows];
            Unroll(n, [&](int i) {
                impulse[i] = 0.0;
                Unroll(n, [&](int j) { impulse[i] += joint.inverse[i][j] * joint.rhs[j]; });
            });
            for (int l = joint.linkBegin; l < joint.linkEnd; ++l) {
                const TreeLink& link = forest.links[ToSize(l)];
                const TreeJoint& later = forest.joints[ToSize(link.later)];
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
void ApplyImpulses(JointForest& forest) {
    for (TreeJoint& joint : forest.joints) {
        TreeBody& a = forest.bodies[ToSize(joint.a)];
        TreeBody& b = forest.bodies[ToSize(joint.b)];
        WithCount(joint.rows.count, [&](auto n) {
            Unroll(n, [&](int i) {
                const double impulse = joint.rhs[i];
                joint.total[i] += impulse;
                joint.recent[i] += impulse;
                for (int k = 0; k < 2; ++k) {
                    a.v[k] += a.invMass * impulse * joint.rows.a[i][k];
                    b.v[k] += b.invMass * impulse * joint.rows.b[i][k];
                }
                a.v[2] += a.steadyInvI * impulse * joint.rows.a[i][2];
                b.v[2] += b.steadyInvI * impulse * joint.rows.b[i][2];
            });
        });
    }
}

}  // namespace

void InvertRows(double (&m)[maxTreeRows][maxTreeRows], int count, const double (&scale)[maxTreeRows]) {
    WithCount(count, [&](auto n) { Invert(m, n, scale); });
}

void FactorizeForest(JointForest& forest, double compliance) {
    FillMatrix(forest, compliance);
    Eliminate(forest);
}

void SolveForest(JointForest& forest) {
    Solve(forest);
    ApplyImpulses(forest);
}

}  // namespace scree
