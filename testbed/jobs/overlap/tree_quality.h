// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How good a broad-phase tree is: nodes of a Snapshot in, figures out. All areas are perimeters P, the 2D counterpart
// of surface area. P / P(root) is the chance that a random line (or, nearly, a box) that meets the root also meets the
// node.
//
//   height           edges on the longest way from the root to a leaf
//   max_balance      largest difference in height of two siblings
//   area_ratio       Σ P(n) / P(root) over all nodes (Box2D's GetTreeQuality)
//   sah_cost         (1.2 Σ_internal P(n) + 1 Σ_leaves P(n)) / P(root): expected work of a query. Goldsmith, Salmon:
//                    "Automatic creation of object hierarchies for ray tracing", IEEE CG&A 7(5), 1987, with the
//                    constants of the paper below
//   sibling_overlap  Σ_internal A(child1 ∩ child2) / A(root): how often a point query goes down both ways
//   epo              Σ_n C(n) · L(n) / L: the work of visiting nodes for nothing. C = 1.2 for internal nodes and 1 for
//                    leaves. L = length of the outlines of all fixtures' tight boxes. L(n) = length of those outlines
//                    that lies inside n but belongs to fixtures outside n's subtree. Aila, Karras, Laine: "On quality
//                    metrics of bounding volume hierarchies", HPG 2013, with outlines in place of surfaces

#pragma once

#include <span>

#include "testbed/engines/snapshot.h"

namespace testbed {

struct TreeQuality {
    int nodes = 0;  ///< internal nodes and leaves
    int height = 0;
    int maxBalance = 0;
    double areaRatio = 0;
    double sahCost = 0;
    double siblingOverlap = 0;
    double epo = 0;
};

/// Relative costs of visiting a node in sah_cost and epo.
inline constexpr double internalNodeCost = 1.2;
inline constexpr double leafNodeCost = 1.0;

/// All zero for an empty tree; ratios to a root of no extent are 0. Children must come after their parents. Time grows
/// with n log n plus the overlap that epo reports.
[[nodiscard]] TreeQuality MeasureTree(std::span<const NodeState> nodes, std::span<const FixtureState> fixtures);

/// 2·(width + height), m.
[[nodiscard]] double Perimeter(const Box& box);
/// Length of the outline of `box` that lies inside (or on the border of) `window`, m. An outline of no width counts
/// both of its sides.
[[nodiscard]] double OutlineInside(const Box& box, const Box& window);

}  // namespace testbed
