// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT

#include "testbed/base/memory.h"

#if defined(__GLIBC__)
#include <malloc.h>

#include <limits>
#endif

namespace testbed {

#if defined(__GLIBC__)

void KeepFreedMemory() {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

void ReturnFreedMemory() { malloc_trim(0); }

#else

void KeepFreedMemory() {}
void ReturnFreedMemory() {}

#endif

}  // namespace testbed
