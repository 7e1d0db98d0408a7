// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Counts every operator new of a test program; linking allocation_counter.cpp is all it takes.

#pragma once

namespace scree::test {

/// Allocations since the program began.
long AllocationCount();

}  // namespace scree::test
