// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Version, memory, log, dump file, timer.

#include "../box2d/b2_settings.h"

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "../box2d/b2_timer.h"

// What the library of 2.4.1 says of itself.
b2Version b2_version = {2, 4, 0};

#ifndef B2_USER_SETTINGS

void* b2Alloc_Default(int32 size) { return size > 0 ? std::malloc(static_cast<size_t>(size)) : nullptr; }
void b2Free_Default(void* mem) { std::free(mem); }
void b2Log_Default(const char* string, va_list args) { std::vprintf(string, args); }

#endif

namespace {

/// b2OpenDump has no handle to give back, so the file lives here.
FILE* dumpFile = nullptr;

long long Now() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

void b2OpenDump(const char* fileName) {
    b2CloseDump();
    dumpFile = std::fopen(fileName, "w");
}

void b2Dump(const char* string, ...) {
    if (dumpFile == nullptr) return;
    va_list args;
    va_start(args, string);
    std::vfprintf(dumpFile, string, args);
    va_end(args);
}

void b2CloseDump() {
    if (dumpFile != nullptr) std::fclose(dumpFile);
    dumpFile = nullptr;
}

b2Timer::b2Timer() : m_start(Now()) {}
void b2Timer::Reset() { m_start = Now(); }
float b2Timer::GetMilliseconds() const { return 1e-6f * static_cast<float>(Now() - m_start); }
