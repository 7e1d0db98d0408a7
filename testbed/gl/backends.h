// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The two ways to a context, for context.cpp alone, and what they share: a library opened at run time.

#pragma once

#include <memory>
#include <string>

#include "testbed/gl/context.h"

namespace testbed {

/// Each makes its context current. Throws BackendError with the package to install.
[[nodiscard]] std::unique_ptr<Context> MakeOsmesaContext(const ContextOptions& options);
[[nodiscard]] std::unique_ptr<Context> MakeEglContext(const ContextOptions& options);

/// A shared library, opened with RTLD_LOCAL: libOSMesa and libGL both export every gl… symbol, so neither may become
/// visible to the rest of the process. Never closed: Mesa keeps thread-local state and exit handlers in its code.
class Library {
public:
    /// Throws BackendError "<name> cannot be opened: install <package>".
    Library(const std::string& name, const char* package);

    /// Sets a function pointer; throws BackendError when the library lacks the symbol.
    template <typename Pointer>
    void Load(Pointer& pointer, const char* symbol) const {
        pointer = reinterpret_cast<Pointer>(Find(symbol));
    }

private:
    [[nodiscard]] void* Find(const char* symbol) const;

    std::string m_name;
    const char* m_package;
    void* m_handle;
};

}  // namespace testbed
