// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// dlopen and dlsym with errors that name the package.

#include <dlfcn.h>

#include "testbed/gl/backends.h"

namespace testbed {

Library::Library(const std::string& name, const char* package)
    : m_name(name), m_package(package), m_handle(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (m_handle == nullptr) throw BackendError(name + " cannot be opened: install " + package);
}

void* Library::Find(const char* symbol) const {
    void* address = dlsym(m_handle, symbol);
    if (address == nullptr) throw BackendError(m_name + " lacks " + symbol + ": reinstall " + m_package);
    return address;
}

}  // namespace testbed

#if defined(__SANITIZE_ADDRESS__)
/// Blocks that Mesa itself never frees are no leaks of ours; read by the leak checker when the process ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\nleak:libEGL\nleak:libglapi\nleak:swrast_dri\n";
}
#endif
