// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Durations as people read them.

#include "testbed/base/progress.h"

#include <gtest/gtest.h>

namespace testbed {
namespace {

TEST(Duration, HasHoursOnlyWhenNeeded) {
    EXPECT_EQ(FormatDuration(0), "0:00");
    EXPECT_EQ(FormatDuration(65.4), "1:05");
    EXPECT_EQ(FormatDuration(7265), "2:01:05");
    EXPECT_EQ(FormatDuration(-3), "0:00");
}

}  // namespace
}  // namespace testbed
