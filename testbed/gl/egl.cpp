// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An EGL context on Mesa's surfaceless platform (EGL_MESA_platform_surfaceless, EGL_KHR_surfaceless_context,
// EGL_KHR_no_config_context): no display server, no window. Software by default, so that pictures agree everywhere.

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>

#include "testbed/gl/backends.h"

namespace testbed {

namespace {

constexpr const char* eglPackages = "libegl1 libgl1-mesa-dri";

struct EglFunctions {
    decltype(&eglGetPlatformDisplay) getPlatformDisplay = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    decltype(&eglGetProcAddress) getFunction = nullptr;

    explicit EglFunctions(const Library& library) {
        library.Load(getPlatformDisplay, "eglGetPlatformDisplay");
        library.Load(initialize, "eglInitialize");
        library.Load(bindApi, "eglBindAPI");
        library.Load(createContext, "eglCreateContext");
        library.Load(destroyContext, "eglDestroyContext");
        library.Load(makeCurrent, "eglMakeCurrent");
        library.Load(getFunction, "eglGetProcAddress");
    }
};

class EglContext final : public Context {
public:
    explicit EglContext(const std::string& libraryName) : m_functions(Library(libraryName, eglPackages)) {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);  // the user's setting wins: =0 asks for the graphics card
        m_display = m_functions.getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (m_display == EGL_NO_DISPLAY || m_functions.initialize(m_display, nullptr, nullptr) != EGL_TRUE) {
            throw BackendError(libraryName + " has no surfaceless platform: install " + eglPackages);
        }
        try {
            CreateContext(libraryName);
        } catch (...) {
            Release();  // the destructor does not run when a constructor throws
            throw;
        }
    }

    ~EglContext() override { Release(); }

    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void MakeCurrent() override {
        // The API is bound per thread.
        if (m_functions.bindApi(EGL_OPENGL_API) != EGL_TRUE ||
            m_functions.makeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context) != EGL_TRUE) {
            throw BackendError("EGL refuses to make its context current");
        }
    }

    [[nodiscard]] Function GetFunction(const char* name) const override { return m_functions.getFunction(name); }
    [[nodiscard]] Backend GetBackend() const override { return Backend::egl; }

private:
    void CreateContext(const std::string& libraryName) {
        constexpr std::array<EGLint, 7> attributes{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        m_functions.bindApi(EGL_OPENGL_API);
        m_context = m_functions.createContext(m_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        if (m_context == EGL_NO_CONTEXT) {
            throw BackendError(libraryName + " offers no OpenGL 3.3 core context: install " + eglPackages);
        }
        MakeCurrent();
    }

    /// The display stays open: the process has one, other contexts may use it, and closing it would unload the driver.
    void Release() {
        m_functions.makeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (m_context != EGL_NO_CONTEXT) m_functions.destroyContext(m_display, m_context);
    }

    EglFunctions m_functions;
    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> MakeEglContext(const ContextOptions& options) {
    return std::make_unique<EglContext>(options.eglLibrary);
}

}  // namespace testbed
