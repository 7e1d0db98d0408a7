// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a shared library of the engine exports: what is marked here, and nothing else.

#pragma once

#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "Scree needs C++20: compile with -std=c++20."
#endif

/// Stands before every public class with members, and every public function, that the library defines. A program for
/// Windows defines SCREE_SHARED if it links the library as a DLL; CMake does so by itself.
#if defined(_WIN32) && defined(SCREE_SHARED) && defined(SCREE_EXPORTS)
#define SCREE_API __declspec(dllexport)
#elif defined(_WIN32) && defined(SCREE_SHARED)
#define SCREE_API __declspec(dllimport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define SCREE_API __attribute__((visibility("default")))
#else
#define SCREE_API
#endif
