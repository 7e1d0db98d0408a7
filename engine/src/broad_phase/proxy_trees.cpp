// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which trees there are, and when they are due.

#include "broad_phase/proxy_trees.h"

namespace scree::broadphase {

void ProxyTrees::Choose() {
    const float limit = m_staticShareThreshold * static_cast<float>(m_store.Size());
    const bool apart = static_cast<float>(m_store.StaticCount()) > limit;
    if (apart == m_areStaticsApart) return;
    m_areStaticsApart = apart;
    moverEdits.Forget(true);
    staticEdits.Forget(true);
    statics.Reset(0);
}

void ProxyTrees::NoteMainBuilt() {
    moverEdits.Forget(false);
    if (!m_areStaticsApart) staticEdits.Forget(false);
}

void ProxyTrees::RefuseEdits() {
    if (moverEdits.Count() > 0) moverEdits.Forget(true);
    if (staticEdits.Count() > 0) staticEdits.Forget(true);
}

size_t ProxyTrees::GetMemoryBytes() const {
    return main.GetMemoryBytes() + statics.GetMemoryBytes() + moverEdits.GetMemoryBytes() +
           staticEdits.GetMemoryBytes();
}

}  // namespace scree::broadphase
