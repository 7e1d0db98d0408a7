// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree snapshot verify` makes every picture several times: with 1 and 2 threads (of the engine and of the software
// rasteriser) and by every backend. All must have equal pixels and an equal state.

#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "testbed/gl/context.h"
#include "testbed/jobs/snapshot/catalog.h"
#include "testbed/jobs/snapshot/render.h"

namespace testbed {

/// One way to make all pictures; a process of its own, since Mesa reads the number of threads once.
struct VerifyWay {
    Backend backend = Backend::cpu;
    int threads = 1;
    bool isAgain = false;  ///< the same as an earlier way: what is left over from nothing but chance

    [[nodiscard]] std::string GetName() const;
};

/// cpu once and again, then every backend with 1 and 2 threads.
[[nodiscard]] std::vector<VerifyWay> GetVerifyWays();

/// What one way made of the cases: "pixel hash, state hash" each, or why it could not.
struct VerifyRun {
    VerifyWay way;
    std::vector<std::string> hashes;  ///< by case; empty when it failed
    std::string problem;
    bool isBackendMissing = false;
};

/// What a test may do to the pictures of one way, to see that it is found out.
using Distortion = std::function<void(const VerifyWay&, const SnapshotCase&, SnapshotPicture&)>;

/// Runs every way over the cases, with its number of threads, `jobs` processes at a time. Call it before any context is
/// open.
[[nodiscard]] std::vector<VerifyRun> VerifySnapshots(std::span<const SnapshotCase> cases,
                                                     std::span<const VerifyWay> ways,
                                                     const ContextOptions& contextOptions, int jobs,
                                                     const Distortion& distortion = {},
                                                     const SnapshotMaking& making = {});

/// Names of the ways whose picture or state of a case is another than the first way's.
[[nodiscard]] std::vector<std::string> FindDeviants(std::span<const VerifyRun> runs, std::size_t caseIndex);

}  // namespace testbed
