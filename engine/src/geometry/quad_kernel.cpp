// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_QUAD_NAME(kernel) kernel##Base
#include "geometry/quad_kernel.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
void CollideQuadsAvx2(const QuadPairs& pairs, QuadContacts& contacts);
void CollideQuadDisksAvx2(const QuadDiskPairs& pairs, QuadDiskContacts& contacts);
#endif

QuadKernels GetQuadKernels() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return {&CollideQuadsAvx2, &CollideQuadDisksAvx2};
#endif
    return GetBaseQuadKernels();
}

QuadKernels GetBaseQuadKernels() { return {&CollideQuadsBase, &CollideQuadDisksBase}; }

}  // namespace scree
