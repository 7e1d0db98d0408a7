// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What standard C++20 cannot say to a compiler or a processor. That is inlining by force, no inlining, fetching ahead,
// and the pause of a waiting loop. It is also which vector instructions there are, whether there are threads and
// exceptions, and where virtual functions stand. Outside base/ nothing names a compiler.

#pragma once

#include <cfloat>

#if defined(__FAST_MATH__)
#error "Scree is exact to the bit: compile it without -ffast-math."
#endif
#if FLT_EVAL_METHOD != 0
#error "Scree is exact to the bit: floats must be computed as floats. On 32-bit x86: -msse2 -mfpmath=sse."
#endif

#if defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#endif

#if defined(__GNUC__)
/// Inlined whatever the compiler thinks of it.
#define SCREE_INLINE [[gnu::always_inline]] inline
#define SCREE_NOINLINE [[gnu::noinline]]
#elif defined(_MSC_VER)
#define SCREE_INLINE __forceinline
#define SCREE_NOINLINE __declspec(noinline)
#else
#define SCREE_INLINE inline
#define SCREE_NOINLINE
#endif

/// A function that files for several instruction sets share: inlined, or a copy of the file's own. No copy made for one
/// set may be called from a file for another.
#define SCREE_KERNEL SCREE_INLINE static

/// x86 with SSE2, which x86-64 always has; MSVC does not say so by __SSE2__.
#if defined(__SSE2__) || defined(_M_X64)
#define SCREE_HAS_SSE2
#include <immintrin.h>
#endif

/// Whether a program can have several threads, and the standard library what they need.
#if !(defined(__wasm__) && !defined(__wasm_atomics__))
#define SCREE_HAS_MUTEXES
#endif

/// Whether the engine may make threads. Without them a world's loops run on the thread that calls, or as tasks of the
/// program; results are the same.
#if defined(SCREE_HAS_MUTEXES) && !defined(SCREE_NO_THREADS)
#define SCREE_HAS_THREADS
#endif

/// The first word of an object with virtual functions points to their addresses, in the order of declaration. That is
/// the Itanium C++ ABI: GCC and Clang but on Windows, where pointers are not signed.
#if defined(__GXX_ABI_VERSION) && !defined(_MSC_VER) && !defined(__Fuchsia__) && !defined(__arm64e__)
#define SCREE_HAS_PLAIN_VIRTUAL_TABLES
#endif

/// try and catch of what would be refused with -fno-exceptions: nothing is thrown there, and nothing caught.
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define SCREE_HAS_EXCEPTIONS
#define SCREE_TRY try
#define SCREE_CATCH(declaration) catch (declaration)
#else
#define SCREE_TRY if (true)
#define SCREE_CATCH(declaration) else
#endif

namespace scree {

/// Asks for a cache line that will be read soon. Any address may be given.
SCREE_KERNEL void Prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
    __asm__ volatile("");  // GCC leaves out calls of functions that do nothing but this
#elif defined(SCREE_HAS_SSE2)
    _mm_prefetch(static_cast<const char*>(address), _MM_HINT_T0);
#endif
}

/// The same for a line that will be written.
SCREE_KERNEL void PrefetchToWrite([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address, 1);
    __asm__ volatile("");
#else
    Prefetch(address);
#endif
}

/// A count that rises at a steady rate and is read in a few nanoseconds.
#if defined(SCREE_HAS_SSE2)
#define SCREE_HAS_TICKS
SCREE_KERNEL unsigned long long CountTicks() { return __rdtsc(); }
#endif

/// Tells the processor that this thread only waits.
SCREE_KERNEL void PauseSpinning() {
#if defined(SCREE_HAS_SSE2)
    _mm_pause();
#endif
}

/// Whether this processor, and the system that runs on it, has AVX2.
SCREE_KERNEL bool HasAvx2() {
#if defined(SCREE_HAS_SSE2) && defined(__GNUC__)
    return __builtin_cpu_supports("avx2") != 0;
#elif defined(SCREE_HAS_SSE2) && defined(_MSC_VER)
    int leaf1[4], leaf7[4];
    __cpuid(leaf1, 1);
    const bool savesRegisters = (leaf1[2] & (1 << 27)) != 0 && (_xgetbv(0) & 6) == 6;
    __cpuidex(leaf7, 7, 0);
    return savesRegisters && (leaf7[1] & (1 << 5)) != 0;
#else
    return false;
#endif
}

/// Of two kernels, or tables of kernels, the one for the widest instructions that the processor has. The second one is
/// compiled for AVX2, and is not there where the compiler cannot do that.
#if defined(SCREE_HAS_AVX2_KERNELS)
SCREE_KERNEL bool UsesAvx2() {
    static const bool hasAvx2 = HasAvx2();
    return hasAvx2;
}
#define SCREE_WIDEST(base, avx2) (UsesAvx2() ? (avx2) : (base))
#else
#define SCREE_WIDEST(base, avx2) (base)
#endif

}  // namespace scree
