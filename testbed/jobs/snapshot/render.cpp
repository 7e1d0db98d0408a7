// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Makes the pictures of the snapshot catalogue.

#include "testbed/jobs/snapshot/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "scenes/catalog.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_run.h"
#include "testbed/jobs/snapshot/structure.h"
#include "testbed/view/layers.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

PictureOptions MakeOptions(const SnapshotCase& snapshotCase) {
    PictureOptions options;
    options.width = snapshotCase.width;
    options.height = snapshotCase.height;
    options.theme = ParseTheme(snapshotCase.theme);
    options.supersampling = 1;  // few colours: a palette, and files of a few kilobytes
    if (snapshotCase.kind == "overlap") {
        options.layers = Layers{};  // the counts alone
        options.style = Style::heat;
        options.nodes = ParseNodeSelection(snapshotCase.layers);
    } else {
        options.layers = ParseLayers(snapshotCase.layers);
        options.nodes = ParseNodeSelection("internal");
    }
    return options;
}

Json DescribeSidecar(const SnapshotCase& snapshotCase, const Snapshot& snapshot, const PictureMaker& maker) {
    Json sidecar = DescribeCase(snapshotCase);
    sidecar.update({{"backend", GetBackendName(maker.GetBackend())},
                    {"gl_renderer", maker.GetRendererName()},
                    {"engine", snapshot.engine},
                    {"broad_phase", snapshot.broadPhase},
                    {"touching", snapshot.touchingCount},
                    {"state_hash", FormatHash(snapshot.stateHash)}});
    return sidecar;
}

SnapshotPicture MakePicture(const SnapshotCase& snapshotCase, const Snapshot& snapshot, PictureMaker& maker) {
    const Clock::time_point start = Clock::now();
    PictureOptions options = MakeOptions(snapshotCase);
    const PaneInput input{&snapshot, {}};
    SnapshotPicture picture;
    picture.sidecar = DescribeSidecar(snapshotCase, snapshot, maker);
    if (snapshotCase.kind == "overlap") {
        // A scale that ends at the largest count would recolour the whole picture when that count changes by one.
        const Camera camera = ChooseCamera(std::array<const Snapshot*, 1>{&snapshot}, options);
        options.scaleMax = std::bit_ceil(CountOverlap(snapshot, camera, options).stats.max);
        OverlapResult result = maker.MakeOverlap(std::span(&input, 1), options);
        const OverlapStats& stats = result.panes[0].count.stats;
        picture.sidecar["overlap"] = {{"max", stats.max},
                                      {"mean", stats.mean},
                                      {"p99", stats.p99},
                                      {"nodes_drawn", stats.nodesDrawn},
                                      {"scale_max", *options.scaleMax}};
        picture.image = std::move(result.panes[0].image);
    } else {
        picture.image = maker.MakeRender(input, options);
    }
    // References have the catalogue's, which most have none of.
    if (!snapshot.settings.empty()) picture.sidecar["settings"] = snapshot.settings;
    picture.sidecar["structure"] = DescribeStructure(snapshot);
    picture.renderMs = MillisecondsSince(start);
    return picture;
}

}  // namespace

Json DescribeCase(const SnapshotCase& snapshotCase) {
    return {{"schema", 1},
            {"kind", snapshotCase.kind},
            {"scene", snapshotCase.scene},
            {"name", snapshotCase.name},
            {"size", snapshotCase.size},
            {"step", snapshotCase.step},
            {"layers", snapshotCase.layers},
            {"theme", snapshotCase.theme}};
}

void RenderSnapshots(std::span<const SnapshotCase> cases, const SnapshotMaking& making, PictureMaker& maker,
                     const std::function<void(const SnapshotCase&, SnapshotPicture)>& take) {
    if (cases.empty()) return;
    const SnapshotCase& one = cases.front();
    RunStart begin = one.input != nullptr ? one.input->Start() : RunStart(scenes::Build(one.scene, one.size));
    if (making.perturb) making.perturb(begin.scene);
    const bool hasSwept = std::ranges::any_of(
        cases, [](const SnapshotCase& c) { return c.kind == "render" && ParseLayers(c.layers).Has(Layer::swept); });
    RunSpec spec = making.spec;
    ApplySettings(spec, one.settings);
    const std::unique_ptr<EngineRun> engine =
        begin.motion != nullptr ? MakeFollower(begin, spec)
                                : std::unique_ptr<EngineRun>(MakeRun(begin, spec, {.sweptBoxes = hasSwept}));
    Snapshot snapshot;
    const bool isReference = making.spec == SnapshotMaking{}.spec;
    const std::string settings = isReference ? one.settings : PrintSettings(spec);
    for (const SnapshotCase& snapshotCase : cases) {
        const Clock::time_point start = Clock::now();
        const bool isNew = engine->GetStep() < snapshotCase.step || snapshot.step != snapshotCase.step;
        while (engine->GetStep() < snapshotCase.step) engine->Step();
        if (isNew) engine->Capture(snapshot);
        snapshot.settings = settings;
        const double simulateMs = MillisecondsSince(start);
        SnapshotPicture picture = MakePicture(snapshotCase, snapshot, maker);
        picture.simulateMs = simulateMs;
        take(snapshotCase, std::move(picture));
    }
}

int SupportedThreads(int wanted) {
    const scenes::Scene empty;
    for (RunSpec spec{.threads = wanted}; spec.threads > 1; --spec.threads) {
        try {
            (void)MakeScreeRun(empty, spec);
            return spec.threads;
        } catch (const std::invalid_argument&) {  // the engine's way to refuse a number of threads
        }
    }
    return 1;
}

std::vector<std::span<const SnapshotCase>> GroupByScene(std::span<const SnapshotCase> cases) {
    std::vector<std::span<const SnapshotCase>> groups;
    for (std::size_t begin = 0; begin < cases.size();) {
        std::size_t end = begin;
        const auto isSame = [&](const SnapshotCase& c) {
            return c.scene == cases[begin].scene && c.settings == cases[begin].settings;
        };
        while (end < cases.size() && isSame(cases[end])) ++end;
        groups.push_back(cases.subspan(begin, end - begin));
        begin = end;
    }
    return groups;
}

}  // namespace testbed
