// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A stopwatch for profiling.

#pragma once

#include "b2_api.h"
#include "b2_settings.h"

/// Runs from its construction or the last Reset.
class B2_API b2Timer {
public:
    b2Timer();

    void Reset();
    /// ms
    float GetMilliseconds() const;

private:
    long long m_start;  ///< ns of a monotonic clock
};
