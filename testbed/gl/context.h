// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// OpenGL 3.3 core contexts without a screen: OSMesa or EGL on Mesa's surfaceless platform. They are opened at run time
// with dlopen, so that the program starts on a machine that has neither, and says what is missing. Nothing here draws.

#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace testbed {

/// What makes the pixels. `cpu` needs no library and gives the same pixels as the others.
enum class Backend { automatic, osmesa, egl, cpu };

/// "auto", "osmesa", "egl" or "cpu"; throws std::invalid_argument naming the four for anything else.
[[nodiscard]] Backend ParseBackend(std::string_view text);
[[nodiscard]] const char* GetBackendName(Backend backend);

/// No usable GL backend; the message names the Debian package that would provide one. The CLI exits 3.
class BackendError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// How to open a context. The library names are parameters so that a test can ask for ones that do not exist.
struct ContextOptions {
    int threads = 2;  ///< rasteriser threads of Mesa's llvmpipe, set before the first context
    std::string osmesaLibrary = "libOSMesa.so.8";
    std::string eglLibrary = "libEGL.so.1";
};

/// A context that is current on the calling thread between MakeCurrent calls of others. Destroy it before main ends.
class Context {
public:
    using Function = void (*)();

    virtual ~Context() = default;
    /// Makes this context current on the calling thread. Throws BackendError when the driver refuses.
    virtual void MakeCurrent() = 0;
    /// Address of a GL function, null when the library lacks it; the shape that glad's user loader wants.
    [[nodiscard]] virtual Function GetFunction(const char* name) const = 0;
    [[nodiscard]] virtual Backend GetBackend() const = 0;
};

/// Finds a GL function for a `user`, null when there is none: the shape in which renderers take a context or a window.
using FindFunction = Context::Function (*)(void* user, const char* name);

/// Opens a context and makes it current. `automatic` tries OSMesa, then EGL. Throws BackendError; `cpu` has no context
/// and is a std::invalid_argument.
[[nodiscard]] std::unique_ptr<Context> MakeContext(Backend backend, const ContextOptions& options = {});

/// One backend as found on this machine.
struct BackendReport {
    Backend backend;
    bool works;
    std::string renderer;  ///< GL_RENDERER, or "built in" for cpu; empty when it does not work
    std::string version;   ///< GL_VERSION
    std::string problem;   ///< why it does not work, else empty
};

/// Tries osmesa, egl and cpu, in this order: for `scree env` and for tests that must say what they skip.
[[nodiscard]] std::vector<BackendReport> ProbeBackends(const ContextOptions& options = {});

}  // namespace testbed
