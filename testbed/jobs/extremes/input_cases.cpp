// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bad input, rough handling, unusual floating-point modes; and the hidden cases by which the command tests itself.

#include <cfenv>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/extremes/extreme_case.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace testbed {
namespace {

void FlushDenormals() {
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, denormals are zero
#endif
}

scenes::Scene MakePile() {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 30.0, {0.0, 0.6});
    for (int r = 0; r < 5; ++r) {
        for (int i = 0; i < 5 - r; ++i) {
            AddDynamic(scene, {1.125 * (i - 0.5 * (4 - r)), 0.5 + boxGap + (1.0 + boxGap) * r}, scenes::Box(0.5, 0.5),
                       {1.0, 0.6});
        }
    }
    return scene;
}

ExtremeCase MakeMode(const std::string& name, const std::string& what, std::function<void()> prepare) {
    return {.name = name,
            .group = "floating-point modes",
            .what = "a pyramid of base 5, " + what,
            .make = MakePile,
            .quickSeconds = 5.0,
            .demands = {.bounds = Bounds{{-15.0, 0.0}, {15.0, 10.0}}, .overlap = 0.02, .restSpeed = 0.05},
            .prepare = std::move(prepare)};
}

ExtremeCase MakeAbuse(const std::string& name, const std::string& group, const std::string& what, Abuse abuse,
                      bool hidden = false) {
    ExtremeCase one;
    one.name = name;
    one.group = group;
    one.what = what;
    one.abuse = abuse;
    one.hidden = hidden;
    return one;
}

}  // namespace

std::vector<ExtremeCase> MakeInputCases() {
    const std::string input = "bad input", handling = "rough handling";
    return {
        MakeMode("mode-flush", "denormals flushed to zero by the host", FlushDenormals),
        MakeMode("mode-up", "rounding upward set by the host", [] { std::fesetround(FE_UPWARD); }),
        MakeMode("mode-down", "rounding downward set by the host", [] { std::fesetround(FE_DOWNWARD); }),
        MakeMode("mode-zero", "rounding toward zero set by the host", [] { std::fesetround(FE_TOWARDZERO); }),
        MakeAbuse("nan-body", input, "NaN and infinity in every field and setter of a body", Abuse::nonFiniteBody),
        MakeAbuse("nan-fixture", input, "NaN and infinity in every field of fixtures and shapes",
                  Abuse::nonFiniteFixture),
        MakeAbuse("nan-joint", input, "NaN and infinity in every field of every kind of joint", Abuse::nonFiniteJoint),
        MakeAbuse("nan-query", input, "NaN and infinity in boxes and rays of queries", Abuse::nonFiniteQuery),
        MakeAbuse("nan-step", input, "NaN, infinity and negative numbers in step and gravity", Abuse::nonFiniteStep),
        MakeAbuse("denormals", input, "the smallest numbers in every field", Abuse::denormals),
        MakeAbuse("huge", input, "the largest finite numbers in every field", Abuse::huge),
        MakeAbuse("bad-polygons", input, "degenerate, spiked, clockwise, crossing, near-duplicate polygons",
                  Abuse::badPolygons),
        MakeAbuse("bad-density", input, "negative and zero density", Abuse::badDensity),
        MakeAbuse("churn-1e4", handling, "10,000 bodies added and removed in every step", Abuse::churn),
        MakeAbuse("destroy-touching", handling, "bodies destroyed while they touch", Abuse::destroyTouching),
        MakeAbuse("destroy-in-callback", handling, "bodies destroyed inside of contact callbacks",
                  Abuse::destroyInCallback),
        MakeAbuse("handle-reuse", handling, "a slot used again 70,000 times", Abuse::handleReuse),
        MakeAbuse("test-crash", "test", "ends by a signal", Abuse::crash, true),
        MakeAbuse("test-hang", "test", "never ends", Abuse::hang, true),
        MakeAbuse("test-chatter", "test", "writes a line of its own", Abuse::chatter, true),
    };
}

std::span<const ExtremeCase> GetExtremeCases() {
    static const std::vector<ExtremeCase> cases = [] {
        std::vector<ExtremeCase> all;
        for (auto make : {MakePileCases, MakeBuiltCases, MakeJointCases, MakeHoldingCases, MakePlaceCases,
                          MakeMotionCases, MakeInputCases}) {
            for (ExtremeCase& one : make()) all.push_back(std::move(one));
        }
        return all;
    }();
    return cases;
}

}  // namespace testbed
