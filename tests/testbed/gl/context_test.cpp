// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contexts: each backend of this machine starts without a screen, any number of times, and one that is missing says
// which Debian package to install.

#include "testbed/gl/context.h"

#include <gtest/gtest.h>

#include <string>

namespace testbed {
namespace {

ContextOptions MissingLibraries() {
    ContextOptions options;
    options.osmesaLibrary = "libscree-no-such-osmesa.so";
    options.eglLibrary = "libscree-no-such-egl.so";
    return options;
}

std::string GetProblem(Backend backend, const ContextOptions& options) {
    try {
        (void)MakeContext(backend, options);
    } catch (const BackendError& error) {
        return error.what();
    }
    return "";
}

TEST(Context, MissingLibraryNamesItsPackage) {
    EXPECT_NE(GetProblem(Backend::osmesa, MissingLibraries()).find("libosmesa6"), std::string::npos);
    EXPECT_NE(GetProblem(Backend::egl, MissingLibraries()).find("libegl1 libgl1-mesa-dri"), std::string::npos);
    const std::string both = GetProblem(Backend::automatic, MissingLibraries());
    EXPECT_NE(both.find("libosmesa6"), std::string::npos);
    EXPECT_NE(both.find("libegl1 libgl1-mesa-dri"), std::string::npos);
    EXPECT_NE(both.find("--backend cpu"), std::string::npos);
}

TEST(Context, LibraryWithoutTheSymbolsIsAnErrorNotACrash) {
    ContextOptions options;
    options.osmesaLibrary = "libc.so.6";
    EXPECT_NE(GetProblem(Backend::osmesa, options).find("OSMesaCreateContextAttribs"), std::string::npos);
}

TEST(Context, AutomaticFallsBackToEgl) {
    ContextOptions options;
    options.osmesaLibrary = "libscree-no-such-osmesa.so";
    EXPECT_EQ(MakeContext(Backend::automatic, options)->GetBackend(), Backend::egl);
    EXPECT_EQ(MakeContext(Backend::automatic)->GetBackend(), Backend::osmesa);
}

TEST(Context, ProbeReportsEveryBackend) {
    const std::vector<BackendReport> reports = ProbeBackends();
    ASSERT_EQ(reports.size(), 3u);
    for (const BackendReport& report : reports) {
        EXPECT_TRUE(report.works) << GetBackendName(report.backend) << ": " << report.problem;
        EXPECT_FALSE(report.renderer.empty());
    }
    const std::vector<BackendReport> missing = ProbeBackends(MissingLibraries());
    EXPECT_FALSE(missing[0].works);
    EXPECT_NE(missing[0].problem.find("libosmesa6"), std::string::npos);
    EXPECT_FALSE(missing[1].works);
    EXPECT_TRUE(missing[2].works);
}

TEST(Context, BothKindsLiveTogetherAndCanBeMadeAgain) {
    for (int round = 0; round < 3; ++round) {
        const auto osmesa = MakeContext(Backend::osmesa);
        const auto egl = MakeContext(Backend::egl);
        osmesa->MakeCurrent();
        egl->MakeCurrent();
        EXPECT_NE(osmesa->GetFunction("glReadPixels"), nullptr);
        EXPECT_NE(egl->GetFunction("glReadPixels"), nullptr);
    }
}

TEST(Context, BackendNamesReadBack) {
    for (const Backend backend : {Backend::automatic, Backend::osmesa, Backend::egl, Backend::cpu}) {
        EXPECT_EQ(ParseBackend(GetBackendName(backend)), backend);
    }
    EXPECT_THROW((void)ParseBackend("vulkan"), std::invalid_argument);
    EXPECT_THROW((void)MakeContext(Backend::cpu), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
