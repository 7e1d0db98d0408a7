// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whether the program keeps the memory that it frees. The allocator decides by itself, otherwise, and a run that gets
// the memory of the run before is spared the page faults of one that does not. With glibc only; else nothing happens.

#pragma once

namespace testbed {

/// From now on what is freed is used again, by whatever comes next.
void KeepFreedMemory();

/// Gives what is free back to the system, so that what comes next begins in fresh memory.
void ReturnFreedMemory();

}  // namespace testbed
