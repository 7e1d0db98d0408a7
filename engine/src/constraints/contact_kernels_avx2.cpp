// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact kernels for processors with AVX2; compiled with the flags for it where the compiler targets x86-64.

#if defined(__AVX2__)
#define SCREE_KERNEL_SET avx2ContactKernels
#define SCREE_KERNEL_NAME "avx2"
#include "constraints/contact_kernels.inc"
#endif
