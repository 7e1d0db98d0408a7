// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One forked process per way; it sends a line per case through a pipe.

#include "testbed/jobs/snapshot/verify.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "testbed/base/errors.h"
#include "testbed/base/progress.h"
#include "testbed/picture/image.h"

namespace testbed {

namespace {

/// FNV-1a, 64 bits, over size and pixels.
uint64_t HashImage(const Image& image) {
    uint64_t hash = 14695981039346656037ull;
    const auto add = [&hash](uint32_t value) { hash = (hash ^ value) * 1099511628211ull; };
    add(static_cast<uint32_t>(image.width));
    add(static_cast<uint32_t>(image.height));
    for (const Color& color : image.pixels) {
        add(color.r | uint32_t{color.g} << 8 | uint32_t{color.b} << 16 | uint32_t{color.a} << 24);
    }
    return hash;
}

/// In the child: makes all pictures, a line each. Never returns to the caller's code.
[[noreturn]] void RunChild(std::span<const SnapshotCase> cases, const VerifyWay& way, ContextOptions options,
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
                text += fmt::format("{:016x} {}\n", HashImage(picture.image),
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
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = write(out, text.data() + sent, text.size() - sent);
        if (count <= 0) _exit(exitIo);
        sent += static_cast<std::size_t>(count);
    }
    _exit(code);  // no exit handlers: they belong to the parent
}

/// A running child.
struct Child {
    pid_t process = -1;
    int pipe = -1;
};

Child StartChild(std::span<const SnapshotCase> cases, const VerifyWay& way, const ContextOptions& options,
                 const Distortion& distortion, const SnapshotMaking& making) {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) throw FileError("cannot open a pipe");
    std::fflush(nullptr);  // what is buffered would be written twice
    const pid_t process = fork();
    if (process < 0) throw FileError("cannot start a process");
    if (process == 0) {
        close(ends[0]);
        RunChild(cases, way, options, distortion, making, ends[1]);
    }
    close(ends[1]);
    return {process, ends[0]};
}

VerifyRun FinishChild(const Child& child, const VerifyWay& way, std::size_t caseCount) {
    std::string text;
    char buffer[4096];
    for (ssize_t count = 0; (count = read(child.pipe, buffer, sizeof buffer)) > 0;) {
        text.append(buffer, static_cast<std::size_t>(count));
    }
    close(child.pipe);
    int status = 0;
    waitpid(child.process, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    VerifyRun run{.way = way, .hashes = {}, .problem = {}, .isBackendMissing = code == exitNoBackend};
    if (code != exitDone) {
        run.problem = text.empty() ? fmt::format("the process ended with status {}", status) : text;
        return run;
    }
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        run.hashes.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
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
