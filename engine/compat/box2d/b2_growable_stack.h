// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A stack of plain values that starts in place and moves to the heap when it outgrows N.

#pragma once

#include <string.h>

#include "b2_settings.h"

template <typename T, int32 N>
class b2GrowableStack {
public:
    b2GrowableStack() : m_data(m_inline), m_count(0), m_capacity(N) {}
    ~b2GrowableStack() {
        if (m_data != m_inline) b2Free(m_data);
    }
    b2GrowableStack(const b2GrowableStack&) = delete;
    b2GrowableStack& operator=(const b2GrowableStack&) = delete;

    void Push(const T& element) {
        const T copy = element;
        if (m_count == m_capacity) Grow();
        m_data[m_count++] = copy;
    }
    /// Precondition: not empty.
    T Pop() { return m_data[--m_count]; }
    int32 GetCount() { return m_count; }

private:
    void Grow() {
        m_capacity *= 2;
        T* larger = static_cast<T*>(b2Alloc(m_capacity * static_cast<int32>(sizeof(T))));
        memcpy(larger, m_data, static_cast<size_t>(m_count) * sizeof(T));
        if (m_data != m_inline) b2Free(m_data);
        m_data = larger;
    }

    T* m_data;
    T m_inline[N];
    int32 m_count;
    int32 m_capacity;
};
