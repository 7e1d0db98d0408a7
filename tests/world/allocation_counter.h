// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Counts every operator new of a test program, and lets one fail; linking allocation_counter.cpp is all it takes.

#pragma once

namespace scree::test {

/// Allocations since the program began.
long AllocationCount();
/// Bytes that are allocated now.
long AllocatedBytes();
/// After `count` more allocations one throws std::bad_alloc, once; a negative number: none does.
void FailAllocation(long count);

}  // namespace scree::test
