// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Entry point of the micro-benchmarks. Options are Google Benchmark's: --benchmark_filter=REGEX,
// --benchmark_list_tests.

#include "tests/bench/micro.h"

int main(int argc, char** argv) {
    scree::bench::RegisterBroadPhase();
    scree::bench::RegisterCollide();
    scree::bench::RegisterStages();
    scree::bench::RegisterJoints();
    scree::bench::RegisterQueries();
    scree::bench::RegisterRollback();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
