// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Choosing a backend: names, the order of `automatic`, and what each one answers on this machine.

#include "testbed/gl/context.h"

#include <cstdlib>

#include "testbed/gl/backends.h"

namespace testbed {

namespace {

constexpr unsigned glRenderer = 0x1F01;  // GL_RENDERER and GL_VERSION of the GL 1.0 specification: no GL header here
constexpr unsigned glVersion = 0x1F02;

std::string QueryString(const Context& context, unsigned name) {
    using GetString = const unsigned char* (*)(unsigned);
    const auto getString = reinterpret_cast<GetString>(context.GetFunction("glGetString"));
    const unsigned char* text = getString != nullptr ? getString(name) : nullptr;
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

BackendReport Probe(Backend backend, const ContextOptions& options) {
    try {
        const std::unique_ptr<Context> context = MakeContext(backend, options);
        return {backend, true, QueryString(*context, glRenderer), QueryString(*context, glVersion), ""};
    } catch (const BackendError& error) {
        return {backend, false, "", "", error.what()};
    }
}

}  // namespace

Backend ParseBackend(std::string_view text) {
    for (const Backend backend : {Backend::automatic, Backend::osmesa, Backend::egl, Backend::cpu}) {
        if (text == GetBackendName(backend)) return backend;
    }
    throw std::invalid_argument("unknown backend '" + std::string(text) + "': use auto, osmesa, egl or cpu");
}

const char* GetBackendName(Backend backend) {
    switch (backend) {
        case Backend::automatic:
            return "auto";
        case Backend::osmesa:
            return "osmesa";
        case Backend::egl:
            return "egl";
        case Backend::cpu:
            return "cpu";
    }
    return "";
}

std::unique_ptr<Context> MakeContext(Backend backend, const ContextOptions& options) {
    // Mesa reads this once per process, when its first context starts the rasteriser's threads. The user's wins.
    setenv("LP_NUM_THREADS", std::to_string(options.threads).c_str(), 0);
    switch (backend) {
        case Backend::osmesa:
            return MakeOsmesaContext(options);
        case Backend::egl:
            return MakeEglContext(options);
        case Backend::cpu:
            throw std::invalid_argument("the cpu backend has no GL context");
        case Backend::automatic:
            break;
    }
    std::string problems;
    try {
        return MakeOsmesaContext(options);
    } catch (const BackendError& error) {
        problems = error.what();
    }
    try {
        return MakeEglContext(options);
    } catch (const BackendError& error) {
        throw BackendError("no usable OpenGL backend: " + problems + "; " + error.what() +
                           "; or use --backend cpu, which needs neither");
    }
}

std::vector<BackendReport> ProbeBackends(const ContextOptions& options) {
    return {Probe(Backend::osmesa, options), Probe(Backend::egl, options),
            BackendReport{Backend::cpu, true, "built in", "", ""}};
}

}  // namespace testbed
