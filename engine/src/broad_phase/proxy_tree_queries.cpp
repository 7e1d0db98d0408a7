// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Queries over trees and edited proxies together: what a tree says about an edited proxy is ignored, and the list of
// edited ones is scanned.

#include "broad_phase/proxy_trees.h"

namespace scree::broadphase {

bool ProxyTrees::IsCurrent(uint32_t fixture, const FlatTree& from) const {
    const uint32_t slot = m_store.Find(fixture);
    if (slot == noSlot || m_store.Pending(slot) != notPending) return false;
    // A fixture removed and inserted again with another motion type can be in both trees.
    return !m_areStaticsApart || m_store.IsStatic(slot) == (&from == &statics);
}

/// Visits what a tree holds and is still current; false if the visitor ended it.
bool ProxyTrees::QueryTree(const FlatTree& tree, const AABB& box, uint64_t& boxTests, const Visitor& visit) {
    const bool edited = IsEdited();
    return tree.Query(box, boxTests,
                      [&](ItemId id) { return (edited && !IsCurrent(id.fixture, tree)) || visit(id.fixture); });
}

/// Visits edited proxies; false if the visitor ended it.
bool ProxyTrees::QueryEdits(const TreeEdits& edits, const AABB& box, uint64_t& boxTests, const Visitor& visit) {
    boxTests += edits.Pending().size();
    for (const uint32_t fixture : edits.Pending()) {
        if (TestOverlap(m_store.Box(m_store.Find(fixture)), box) && !visit(fixture)) return false;
    }
    return true;
}

void ProxyTrees::Query(const AABB& box, uint64_t& boxTests, const Visitor& visit) {
    (void)(QueryTree(main, box, boxTests, visit) && QueryTree(statics, box, boxTests, visit) &&
           QueryEdits(moverEdits, box, boxTests, visit) && QueryEdits(staticEdits, box, boxTests, visit));
}

void ProxyTrees::QueryStatics(const AABB& box, uint64_t& boxTests, const Visitor& visit) {
    (void)(QueryTree(statics, box, boxTests, visit) && QueryEdits(staticEdits, box, boxTests, visit));
}

void ProxyTrees::RayCast(const RayCastInput& input, uint64_t& boxTests, const RayVisitor& visit) {
    const bool edited = IsEdited();
    RayProbe ray(input);
    for (const FlatTree* tree : {&main, &statics}) {
        const auto check = [&](ItemId id) {
            return edited && !IsCurrent(id.fixture, *tree) ? RayStep::goOn : ray.Visit(visit, id.fixture);
        };
        if (tree->RayCast(ray, boxTests, check) == RayStep::stop) return;
    }
    for (const TreeEdits* edits : {&moverEdits, &staticEdits}) {
        boxTests += edits->Pending().size();
        for (const uint32_t fixture : edits->Pending()) {
            if (!ray.MayHitLeaf(m_store.Box(m_store.Find(fixture)))) continue;
            if (ray.Visit(visit, fixture) == RayStep::stop) return;
        }
    }
}

}  // namespace scree::broadphase
