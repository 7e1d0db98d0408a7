// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a tree no longer describes: the proxies of one part of a store that were edited since it was built. Edits do not
// touch the tree. They go to a short list that queries scan beside it, and what the tree still says about them is
// ignored. When there are more than a few √n of them the tree counts as stale and the next query rebuilds it: n edits
// interleaved with n queries cost O(n^1.5), not O(n²) (Tsamis 2020, §3.7.2).

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/proxy_store.h"

namespace scree::broadphase {

class TreeEdits {
public:
    explicit TreeEdits(ProxyStore& store) : m_store(store) {}

    /// The tree is of no use any more, and nothing need be noted.
    [[nodiscard]] bool IsStale() const { return m_stale; }
    /// Proxies edited or removed.
    [[nodiscard]] uint32_t Count() const { return m_count; }
    /// Fixtures whose boxes must be scanned beside the tree; none if it is stale.
    [[nodiscard]] std::span<const uint32_t> Pending() const { return m_pending; }

    /// The proxy in this slot is new or has a new box.
    void Mark(uint32_t slot);
    /// So many proxies will be marked: more than can be left aside make the tree stale at once.
    void Expect(size_t count) {
        if (!m_stale && count > m_limit) Forget(true);
    }
    /// Takes the proxy in this slot out of the store.
    void Remove(uint32_t slot);
    /// The tree describes all proxies (stale: none).
    void Forget(bool stale);

    [[nodiscard]] size_t GetMemoryBytes() const { return m_pending.capacity() * sizeof(uint32_t); }

private:
    void CountOne();

    ProxyStore& m_store;
    std::vector<uint32_t> m_pending;
    uint32_t m_count = 0;
    uint32_t m_limit = 0;
    bool m_stale = true;
};

}  // namespace scree::broadphase
