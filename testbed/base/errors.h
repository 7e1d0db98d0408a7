// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `scree` returns to the shell, and the exceptions that end in it: wrong usage, a file, a program of others.

#pragma once

#include <stdexcept>

namespace testbed {

enum ExitCode : int {
    exitDone = 0,
    exitDiffers = 1,    ///< images or bounds differ
    exitUsage = 2,      ///< the command line is wrong
    exitNoBackend = 3,  ///< no usable GL backend
    exitIo = 4,         ///< a file, a folder or a helper program failed
    exitSkipped = 77,   ///< no backend, and --skip-missing-backend was given
};

/// A command line that cannot be meant; the message says what, where and the cure. Exit code 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A file that cannot be read or written; the message names it. Exit code 4.
class FileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A program that the testbed runs is not installed or failed; the message says what to do. Exit code 4.
class ToolError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace testbed
