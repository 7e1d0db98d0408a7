// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Long and loaded chains, a large grid of joints.

#include <fmt/format.h>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {
namespace {

/// Swung from the horizontal; links of length 1, `load` times a link's mass at the end (0: none).
scenes::Scene MakeChain(int links, double load) {
    scenes::Scene scene = MakeEmptyScene();
    int before = AddAnchor(scene, {});
    for (int i = 0; i < links; ++i) {
        const int link = AddDynamic(scene, {i + 0.5, 0.0}, scenes::Box(0.5, 0.125));
        Hinge(scene, before, link, {1.0 * i, 0.0});
        before = link;
    }
    if (load > 0.0) {
        const int ball =
            AddDynamic(scene, {1.0 * links, 0.0}, scenes::Circle(0.5), {load * 0.25 / (scenes::pi * 0.25)});
        Hinge(scene, before, ball, {1.0 * links, 0.0});
    }
    // Links of one group never collide: this is about joints.
    for (scenes::Fixture& fixture : scene.fixtures) fixture.groupIndex = -1;
    return scene;
}

/// n × n balls, each hinged to its neighbours by rigid arms, hung on the top row.
scenes::Scene MakeGrid(int n) {
    scenes::Scene scene = MakeEmptyScene();
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const Point at{1.0 * x, -1.0 * y};
            if (y == 0) {
                AddAnchor(scene, at);
            } else {
                AddDynamic(scene, at, scenes::Circle(0.25));
                scene.fixtures.back().groupIndex = -1;
            }
            const int body = scenes::LastBody(scene);
            if (x > 0 && y > 0) Hinge(scene, body - 1, body, {x - 0.5, at.y});
            if (y > 0) Hinge(scene, body - n, body, {at.x, at.y + 0.5});
        }
    }
    return scene;
}

}  // namespace

std::vector<ExtremeCase> MakeJointCases() {
    std::vector<ExtremeCase> cases;
    for (const int links : {10, 100, 1000}) {
        for (const double load : {0.0, 1000.0}) {
            cases.push_back({.name = fmt::format("chain-{}{}", links, load > 0.0 ? "-loaded" : ""),
                             .group = "joints",
                             .what = fmt::format("a chain of {} links{}, swung from the horizontal", links,
                                                 load > 0.0 ? " with 1000 times a link's mass at its end" : ""),
                             .make = [=] { return MakeChain(links, load); },
                             .demands = {.bounds = Bounds{{-1.2 * links - 2.0, -1.2 * links - 2.0},
                                                          {1.2 * links + 2.0, 0.2 * links + 2.0}},
                                         .jointGap = 0.01}});
        }
    }
    cases.push_back({.name = "joint-grid-100",
                     .group = "joints",
                     .what = "a grid of 100 × 100 hinged balls, hung on its top row",
                     .make = [] { return MakeGrid(100); },
                     .seconds = 3.0,
                     .quickSeconds = 0.3,
                     .demands = {.bounds = Bounds{{-20.0, -150.0}, {120.0, 20.0}}, .jointGap = 0.01}});
    return cases;
}

}  // namespace testbed
