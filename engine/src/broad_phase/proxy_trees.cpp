// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which trees there are, and when they are due.

#include "broad_phase/proxy_trees.h"

namespace scree::broadphase {

void ProxyTrees::Choose() {
    const float limit = m_restingShareThreshold * static_cast<float>(m_store.Size());
    const bool apart = static_cast<float>(m_store.Resting().count) > limit;
    if (apart == m_isRestingApart) return;
    m_isRestingApart = apart;
    mainEdits.Lose();
    restingEdits.Lose();
    resting.Reset(0, 0);
}

void ProxyTrees::SetResting(uint32_t slot, bool isResting) {
    if (!m_isRestingApart) {
        m_store.SetResting(slot, isResting);
        return;
    }
    EditsOf(slot).Leave(slot);
    slot = m_store.SetResting(slot, isResting);
    EditsOf(slot).Add(slot);
}

void ProxyTrees::RefuseEdits() {
    if (mainEdits.Count() > 0) mainEdits.Lose();
    if (restingEdits.Count() > 0) restingEdits.Lose();
}

size_t ProxyTrees::GetMemoryBytes() const {
    return main.GetMemoryBytes() + resting.GetMemoryBytes() + mainEdits.GetMemoryBytes() +
           restingEdits.GetMemoryBytes();
}

}  // namespace scree::broadphase
