// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of heap_meter.h on glibc's mallinfo2.

#include "testbed/adapters/heap_meter.h"

#include <malloc.h>

namespace testbed {

int64_t HeapBytesInUse() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<int64_t>(info.uordblks + info.hblkhd);
}

}  // namespace testbed
