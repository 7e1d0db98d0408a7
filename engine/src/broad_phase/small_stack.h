// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The stack of a tree walk: inline storage that no balanced tree exceeds, and the heap behind it so that no tree can
// overflow it.

#pragma once

#include <cstdint>
#include <vector>

namespace scree::broadphase {

class SmallStack {
public:
    void Push(uint32_t value) {
        if (m_size < inlineSize) {
            m_inline[m_size] = value;
        } else {
            m_more.push_back(value);
        }
        ++m_size;
    }

    uint32_t Pop() {
        --m_size;
        if (m_size < inlineSize) return m_inline[m_size];
        const uint32_t value = m_more.back();
        m_more.pop_back();
        return value;
    }

    [[nodiscard]] bool Empty() const { return m_size == 0; }

private:
    static constexpr uint32_t inlineSize = 128;
    uint32_t m_inline[inlineSize];
    uint32_t m_size = 0;
    std::vector<uint32_t> m_more;
};

}  // namespace scree::broadphase
