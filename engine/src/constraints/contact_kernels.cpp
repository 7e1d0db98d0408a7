// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact kernels for the instruction set that the whole library is compiled for, and the choice of the best set.

#define SCREE_KERNEL_SET baseContactKernels
#include "constraints/contact_kernels.inc"

namespace scree {

extern const ContactKernels avx2ContactKernels;

const ContactKernels& GetContactKernels() { return SCREE_WIDEST(baseContactKernels, avx2ContactKernels); }

}  // namespace scree
