// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Storage of the flat tree.

#include "broad_phase/flat_tree.h"

namespace scree::broadphase {

void FlatTree::Reset(uint32_t positions, uint32_t most) {
    nodes.clear();
    m_size = positions;
    if (m_ids.size() < most) m_ids.resize(most);
    // Rows of four may read past the end. The odd part keeps the four arrays from starting at one page offset, where
    // their cache lines would evict each other.
    constexpr size_t page = 1024, odd = 208, slack = 4;
    if (most + slack <= m_stride) return;
    m_stride = (most + slack + page - 1) / page * page + odd;
    m_block.resize(4 * m_stride);
}

size_t FlatTree::GetMemoryBytes() const {
    return nodes.capacity() * sizeof(TreeNode) + m_block.capacity() * sizeof(float) + m_ids.capacity() * sizeof(ItemId);
}

}  // namespace scree::broadphase
