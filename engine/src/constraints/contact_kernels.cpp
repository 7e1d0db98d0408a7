// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact kernels for the instruction set that the whole library is compiled for, and the choice of the best set.

#define SCREE_KERNEL_SET baseContactKernels
#include "constraints/contact_kernels.inc"

namespace scree {

#if defined(SCREE_HAS_AVX2_KERNELS)
extern const ContactKernels avx2ContactKernels;
#endif

const ContactKernels& GetContactKernels() {
#if defined(SCREE_HAS_AVX2_KERNELS)
    static const bool hasAvx2 = HasAvx2();
    if (hasAvx2) return avx2ContactKernels;
#endif
    return baseContactKernels;
}

}  // namespace scree
