// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An OSMesa context: Mesa's software rasteriser drawing into memory of ours. Pictures go to framebuffer objects, so
// the buffer that OSMesa demands is one pixel.

#include <GL/osmesa.h>

#include <array>
#include <cstdint>

#include "testbed/gl/backends.h"

namespace testbed {

namespace {

constexpr const char* osmesaPackage = "libosmesa6";

struct OsmesaFunctions {
    decltype(&OSMesaCreateContextAttribs) createContext = nullptr;
    decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
    decltype(&OSMesaDestroyContext) destroyContext = nullptr;
    decltype(&OSMesaGetProcAddress) getFunction = nullptr;

    explicit OsmesaFunctions(const Library& library) {
        library.Load(createContext, "OSMesaCreateContextAttribs");
        library.Load(makeCurrent, "OSMesaMakeCurrent");
        library.Load(destroyContext, "OSMesaDestroyContext");
        library.Load(getFunction, "OSMesaGetProcAddress");
    }
};

class OsmesaContext final : public Context {
public:
    explicit OsmesaContext(const std::string& libraryName) : m_functions(Library(libraryName, osmesaPackage)) {
        const std::array<int, 9> attributes{OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            0};
        m_context = m_functions.createContext(attributes.data(), nullptr);
        if (m_context == nullptr) {
            throw BackendError(libraryName + " offers no OpenGL 3.3 core context: install " + osmesaPackage +
                               " 18 or newer");
        }
        try {
            OsmesaContext::MakeCurrent();
        } catch (...) {
            m_functions.destroyContext(m_context);  // the destructor does not run when a constructor throws
            throw;
        }
    }

    ~OsmesaContext() override {
        m_functions.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        m_functions.destroyContext(m_context);
    }

    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    void MakeCurrent() override {
        if (m_functions.makeCurrent(m_context, m_buffer.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
            throw BackendError("OSMesa refuses to make its context current");
        }
    }

    [[nodiscard]] Function GetFunction(const char* name) const override { return m_functions.getFunction(name); }
    [[nodiscard]] Backend GetBackend() const override { return Backend::osmesa; }

private:
    OsmesaFunctions m_functions;
    OSMesaContext m_context = nullptr;
    std::array<uint8_t, 4> m_buffer{};
};

}  // namespace

std::unique_ptr<Context> MakeOsmesaContext(const ContextOptions& options) {
    return std::make_unique<OsmesaContext>(options.osmesaLibrary);
}

}  // namespace testbed
