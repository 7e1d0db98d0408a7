// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kernels for the instruction set that the whole library is compiled for, and the choice of the best one.

#define SCREE_QUAD_NAME(kernel) kernel##Base
#include "geometry/quad_kernel.inc"

namespace scree {

void CollideQuadsAvx2(const QuadPairs& pairs, QuadContacts& contacts);
void CollideQuadDisksAvx2(const QuadDiskPairs& pairs, QuadDiskContacts& contacts);
void CollideSegmentsAvx2(const QuadPairs& pairs, QuadContacts& contacts);
void CollideSegmentQuadsAvx2(const QuadPairs& pairs, QuadContacts& contacts);
void CollideQuadSegmentsAvx2(const QuadPairs& pairs, QuadContacts& contacts);
void CollideRoundQuadsAvx2(const QuadPairs& pairs, QuadContacts& contacts);

QuadKernels GetQuadKernels() {
    return SCREE_WIDEST(GetBaseQuadKernels(), (QuadKernels{&CollideQuadsAvx2,
                                                           &CollideQuadDisksAvx2,
                                                           {{&CollideSegmentsAvx2, &CollideSegmentQuadsAvx2},
                                                            {&CollideQuadSegmentsAvx2, &CollideRoundQuadsAvx2}}}));
}

QuadKernels GetBaseQuadKernels() {
    return {&CollideQuadsBase,
            &CollideQuadDisksBase,
            {{&CollideSegmentsBase, &CollideSegmentQuadsBase}, {&CollideQuadSegmentsBase, &CollideRoundQuadsBase}}};
}

}  // namespace scree
