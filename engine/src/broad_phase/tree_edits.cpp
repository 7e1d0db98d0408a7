// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The list of edited proxies; the store keeps the place of each in it.

#include "broad_phase/tree_edits.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace scree::broadphase {
namespace {

/// A scanned box costs about a fortieth of a rebuilt one, which makes √(40·n) edits per rebuild the cheapest.
uint32_t EditLimit(uint32_t proxies) {
    return std::max(64u, static_cast<uint32_t>(std::sqrt(40.0f * static_cast<float>(proxies))));
}

}  // namespace

void TreeEdits::Forget(bool stale) {
    for (const uint32_t fixture : m_pending) m_store.Pending(m_store.Find(fixture)) = notPending;
    m_pending.clear();
    m_count = 0;
    m_limit = EditLimit(m_store.Size());
    m_stale = stale;
}

void TreeEdits::CountOne() {
    if (!m_stale && ++m_count > m_limit) Forget(true);
}

void TreeEdits::Mark(uint32_t slot) {
    if (m_stale || m_store.Pending(slot) != notPending) return;
    CountOne();
    if (m_stale) return;
    try {
        m_pending.push_back(m_store.Id(slot).fixture);
    } catch (const std::bad_alloc&) {
        return Forget(true);  // no room for the list: the tree is to be rebuilt
    }
    m_store.Pending(slot) = static_cast<uint32_t>(m_pending.size() - 1);
}

void TreeEdits::Remove(uint32_t slot) {
    if (const uint32_t at = m_store.Pending(slot); at != notPending) {
        m_pending[at] = m_pending.back();
        m_store.Pending(m_store.Find(m_pending[at])) = at;
        m_pending.pop_back();
    }
    m_store.Remove(slot);
    CountOne();
}

}  // namespace scree::broadphase
