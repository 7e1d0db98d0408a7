// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One forked process per way; it sends a line per case through a pipe.

#include "testbed/jobs/snapshot/verify.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <span>

#include "testbed/base/errors.h"
#include "testbed/base/hash.h"
#include "testbed/base/process.h"
#include "testbed/base/progress.h"
#include "testbed/base/text.h"
#include "testbed/picture/image.h"

namespace testbed {

namespace {

/// Of size and pixels.
uint64_t HashImage(const Image& image) {
    Fnv1a<uint64_t> hash;
    hash.Add(static_cast<uint64_t>(image.width));
    hash.Add(static_cast<uint64_t>(image.height));
    for (const Color& color : image.pixels) {
        hash.Add(color.r | uint64_t{color.g} << 8 | uint64_t{color.b} << 16 | uint64_t{color.a} << 24);
    }
    return hash.Get();
}

/// In the child: makes all pictures, a line each; its exit code.
int RunChild(std::span<const SnapshotCase> cases, const VerifyWay& way, ContextOptions options,
             const Distortion& distortion, SnapshotMaking making, int out) {
    int code = exitDone;
    std::string text;
    try {
        options.threads = way.threads;
        setenv("LP_NUM_THREADS", fmt::format("{}", way.threads).c_str(), 1);  // also over the user's own
        PictureMaker maker(way.backend, options);
        making.spec.threads = SupportedThreads(way.threads);
        for (const std::span<const SnapshotCase> scene : GroupByScene(cases)) {
            RenderSnapshots(scene, making, maker, [&](const SnapshotCase& snapshotCase, SnapshotPicture picture) {
                if (distortion) distortion(way, snapshotCase, picture);
                text += fmt::format("{} {}\n", FormatHash(HashImage(picture.image)),
                                    picture.sidecar.at("state_hash").get<std::string>());
            });
        }
    } catch (const BackendError& error) {
        code = exitNoBackend;
        text = error.what();
    } catch (const std::exception& error) {
        code = exitIo;
        text = error.what();
    }
    return WriteAll(out, std::as_bytes(std::span(text))) ? code : exitIo;
}

/// A running child.
struct Child {
    Descriptor pipe;
    Process process;
};

Child StartChild(std::span<const SnapshotCase> cases, const VerifyWay& way, const ContextOptions& options,
                 const Distortion& distortion, const SnapshotMaking& making) {
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) throw FileError("cannot open a pipe");
    Child child{Descriptor(ends[0]), {}};
    const Descriptor out(ends[1]);
    const std::error_code error = child.process.Fork([&] {
        child.pipe.Close();
        return RunChild(cases, way, options, distortion, making, out.Get());
    });
    if (error) throw FileError("cannot start a process: " + error.message());
    return child;
}

VerifyRun FinishChild(Child& child, const VerifyWay& way, std::size_t caseCount) {
    const std::string text = ReadAll(child.pipe.Get());
    const ProcessEnd end = child.process.Wait();
    const int code = end.GetExitCode();
    VerifyRun run{.way = way, .hashes = {}, .problem = {}, .isBackendMissing = code == exitNoBackend};
    if (code != exitDone) {
        run.problem = text.empty() ? fmt::format("the process ended with status {}", end.status) : text;
        return run;
    }
    ForEachLine(text, [&](std::size_t, std::string_view line) { run.hashes.emplace_back(line); });
    if (run.hashes.size() != caseCount) {
        run.problem = fmt::format("{} pictures instead of {}", run.hashes.size(), caseCount);
        run.hashes.clear();
    }
    return run;
}

}  // namespace

std::string VerifyWay::GetName() const {
    return fmt::format("{}, {} thread{}{}", GetBackendName(backend), threads, threads == 1 ? "" : "s",
                       isAgain ? ", again" : "");
}

std::vector<VerifyWay> GetVerifyWays() {
    return {{Backend::cpu, 1},    {Backend::cpu, 1, true}, {Backend::cpu, 2}, {Backend::osmesa, 1},
            {Backend::osmesa, 2}, {Backend::egl, 1},       {Backend::egl, 2}};
}

std::vector<VerifyRun> VerifySnapshots(std::span<const SnapshotCase> cases, std::span<const VerifyWay> ways,
                                       const ContextOptions& contextOptions, int jobs, const Distortion& distortion,
                                       const SnapshotMaking& making) {
    std::vector<Child> children;
    std::vector<VerifyRun> runs;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        while (children.size() < ways.size() && children.size() < i + static_cast<std::size_t>(std::max(jobs, 1))) {
            children.push_back(StartChild(cases, ways[children.size()], contextOptions, distortion, making));
        }
        Progress progress(ways[i].GetName(), 1);
        runs.push_back(FinishChild(children[i], ways[i], cases.size()));
        const VerifyRun& run = runs.back();
        progress.Finish(run.problem.empty() ? fmt::format("{} pictures", run.hashes.size()) : run.problem);
    }
    return runs;
}

std::vector<std::string> FindDeviants(std::span<const VerifyRun> runs, std::size_t caseIndex) {
    std::vector<std::string> deviants;
    for (const VerifyRun& run : runs) {
        if (!run.hashes.empty() && run.hashes[caseIndex] != runs.front().hashes[caseIndex]) {
            deviants.push_back(run.way.GetName());
        }
    }
    return deviants;
}

}  // namespace testbed
