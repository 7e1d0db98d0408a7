// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Reports for tests of the pages.

#include "tests/testbed/page/sample_pages.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "scenes/catalog.h"
#include "testbed/base/output.h"
#include "testbed/engines/engine_run.h"
#include "testbed/page/page_markup.h"
#include "testbed/page/plot.h"
#include "testbed/picture/png.h"
#include "testbed/view/picture.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr int width = 480, height = 300;

Snapshot RunSample(float gravity) {
    scenes::Scene scene = scenes::Build("tumbler", 200);
    scene.gravity.y = gravity;
    const std::unique_ptr<EngineRun> run = MakeRun(scene, MakeSpec("scree", likeBox2dPreset));
    while (run->GetStep() < 120) run->Step();
    Snapshot snapshot;
    run->Capture(snapshot);
    return snapshot;
}

struct SamplePicture {
    Image image;
    CountImage counts;  ///< of an overlap picture
    Json sidecar;
};

SamplePicture DrawSample(PictureMaker& maker, const Snapshot& snapshot, const char* layers) {
    PictureOptions options;
    options.width = width;
    options.height = height;
    options.supersampling = 1;
    options.style = Style::heat;
    options.camera = CameraRequest{0, 10, 50};
    SamplePicture picture;
    picture.sidecar = {{"schema", 1},
                       {"kind", layers == nullptr ? "overlap" : "render"},
                       {"backend", GetBackendName(maker.GetBackend())},
                       {"gl_renderer", maker.GetRendererName()},
                       {"engine", snapshot.engine},
                       {"broad_phase", snapshot.broadPhase},
                       {"structure", Json::object()},
                       {"touching", snapshot.touchingCount},
                       {"state_hash", fmt::format("{:016x}", snapshot.stateHash)}};
    const PaneInput input{&snapshot, {}};
    if (layers != nullptr) {
        options.layers = ParseLayers(layers);
        picture.image = maker.MakeRender(input, options);
        return picture;
    }
    options.layers = Layers{};
    options.scaleMax = 32;
    OverlapResult result = maker.MakeOverlap(std::span(&input, 1), options);
    picture.sidecar["overlap"] = {
        {"max", result.panes[0].count.stats.max}, {"mean", result.panes[0].count.stats.mean}, {"scale_max", 32}};
    picture.image = std::move(result.panes[0].image);
    picture.counts = std::move(result.panes[0].count.counts);
    return picture;
}

SnapshotSide SaveSide(OutputFolder& folder, const std::string& id, const char* side, const SamplePicture& picture) {
    SnapshotSide saved{fmt::format("{}/{}.png", side, id), fmt::format("{}/{}.json", side, id), picture.image.width,
                       picture.image.height};
    WriteImage(folder, saved.image, picture.image);
    folder.WriteText(saved.sidecar, picture.sidecar.dump());
    return saved;
}

Image MarkDifference(const Image& a, const Image& b, PixelDifference& pixels) {
    Image image(a.width, a.height, {40, 40, 40});
    PixelArea box{a.width, a.height, 0, 0};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (a.At(x, y) == b.At(x, y)) continue;
            image.At(x, y) = {255, 160, 40};
            ++pixels.changed;
            box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), std::max(box.y1, y + 1)};
        }
    }
    pixels.box = box;
    pixels.maxDifference = 204;
    return image;
}

/// The field "structure" as results.json has it: bodies compared here, nodes and contacts as short lists.
std::string CompareSamples(const Snapshot& expected, const Snapshot& actual) {
    const auto describe = [](const BodyState& body) {
        const auto round = [](double value) { return std::round(value * 1000) / 1000; };
        return Json{{"x", round(body.position.x)},
                    {"y", round(body.position.y)},
                    {"angle", round(body.angle)},
                    {"awake", body.awake}};
    };
    Json list = Json::array();
    std::size_t changed = 0;
    for (std::size_t i = 0; i < expected.bodies.size(); ++i) {
        if (expected.bodies[i].position == actual.bodies[i].position) continue;
        ++changed;
        if (list.size() < maxListed) {
            list.push_back({{"index", i},
                            {"change", "changed"},
                            {"expected", describe(expected.bodies[i])},
                            {"actual", describe(actual.bodies[i])}});
        }
    }
    const Json structure = {
        {"equal", false},
        {"bodies",
         {{"expected", expected.bodies.size()},
          {"actual", actual.bodies.size()},
          {"changed", changed},
          {"added", 0},
          {"removed", 0},
          {"list", list}}},
        {"nodes",
         {{"expected", expected.nodes.size()},
          {"actual", actual.nodes.size()},
          {"changed", 1},
          {"added", 0},
          {"removed", 0},
          {"list", {{{"index", 3}, {"change", "changed"}, {"expected", nullptr}, {"actual", nullptr}}}}}},
        {"contacts",
         {{"expected", expected.contacts.size()},
          {"actual", actual.contacts.size()},
          {"changed", 0},
          {"added", 1},
          {"removed", 1},
          {"list",
           {{{"bodies", {3, 7}},
             {"fixtures", {3, 8}},
             {"change", "added"},
             {"expected", nullptr},
             {"actual", {{"touching", true}, {"points", 2}}}},
            {{"bodies", {4, 9}},
             {"fixtures", {4, 10}},
             {"change", "removed"},
             {"expected", {{"touching", false}, {"points", 0}}},
             {"actual", nullptr}}}}}}};
    return structure.dump();
}

SnapshotResult MakeResult(const std::string& id, SnapshotStatus status, const std::string& message) {
    SnapshotResult result;
    result.id = id;
    result.scene = id.substr(0, id.find('/'));
    result.name = id.substr(id.find('/') + 1);
    result.kind = id.ends_with("overlap") ? "overlap" : "render";
    result.layers = result.kind == "overlap" ? "internal" : "bodies,contacts";
    result.size = 200;
    result.step = 120;
    result.status = status;
    result.message = message;
    result.simulateMs = 12.5;
    result.renderMs = 3.1;
    result.compareMs = 0.4;
    if (status != SnapshotStatus::equal) result.update = fmt::format("scree snapshot update -g '^{}$'", id);
    return result;
}

SnapshotResult CompareSamplePictures(OutputFolder& folder, const std::string& id, const SamplePicture& expected,
                                     const SamplePicture& actual) {
    SnapshotResult result = MakeResult(id, SnapshotStatus::changed, "");
    const Image difference = MarkDifference(expected.image, actual.image, result.pixels);
    result.message =
        fmt::format("{} pixels differ; look at `diff/{}.png`, then accept or repair", result.pixels.changed, id);
    result.expected = SaveSide(folder, id, "expected", expected);
    result.actual = SaveSide(folder, id, "actual", actual);
    result.difference = fmt::format("diff/{}.png", id);
    WriteImage(folder, result.difference, difference);
    return result;
}

/// The pixels where the count grows most, falls most, and is largest among those that stay.
std::vector<SampleCount> PickCounts(const CountImage& expected, const CountImage& actual) {
    SampleCount grown{}, fallen{}, kept{};
    // Labels stand in the outer 40 rows.
    for (int y = 40; y < height - 40; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto at = static_cast<std::size_t>(y * width + x);
            const SampleCount here{x, y, expected.counts[at], actual.counts[at]};
            const auto change = [](const SampleCount& c) {
                return static_cast<int>(c.actual) - static_cast<int>(c.expected);
            };
            if (change(here) > change(grown)) grown = here;
            if (change(here) < change(fallen)) fallen = here;
            if (change(here) == 0 && here.actual > kept.actual) kept = here;
        }
    }
    return {grown, fallen, kept};
}

/// A picture that carries its data.
std::string MakeSampleCurves() {
    Plot plot{.title = "Data", .xLabel = "cost [ns]", .yLabel = "error", .logarithmic = true};
    plot.curves.push_back({"<ours> & theirs", ourLooks[0], {{10, 0.5}, {100, 0.01}, {1000, 0.002, true}}});
    plot.curves.back().names = {"draft", "game </script>", "fine"};
    return PutPlotData("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\"><path d=\"M0 9L9 0\"/></svg>",
                       MakePlotData(plot));
}

}  // namespace

Page MakeSamplePage(const fs::path& folder) {
    OutputFolder output(folder);
    WriteImage(output, "picture.png", Image(16, 8, {200, 30, 30}));
    PageTable table{
        .title = "Totals",
        .caption = "Caption of the table.",
        .columns = {{.name = "scene"},
                    {.name = "time", .unit = "ms", .numeric = true, .hint = "lower is better", .group = "scree"},
                    {.name = "verdict"}},
        .filter = true};
    table.rows = {{"tiles", PageCell::Number(1312.4, 1), "met"},
                  {"scene-10", PageCell::Number(9.5, 1, PageTone::good), "met"},
                  {"scene-9", PageCell::Number(-20.5, 1, PageTone::bad), "missed"},
                  {"<none> & \"quoted\"", PageCell::Number(NAN), "void"}};
    Page page{.title = "Sample & <report>", .intro = "First paragraph with `code`.\n\nSecond."};
    page.sections.push_back(
        {.title = "At a glance",
         .blocks = {PageTiles{{{.label = "met", .value = "2", .unit = "of 3", .note = "note", .tone = PageTone::good}}},
                    PageNote{.text = "Mind `this`.", .tone = PageTone::warning}}});
    page.sections.push_back({.title = "Numbers", .intro = "Intro.", .blocks = {table, PageCode{"testbed/run list"}}});
    page.sections.push_back(
        {.title = "Figures",
         .blocks = {PageFigures{.figures = {{.title = "Plot",
                                             .svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 "
                                                    "10 10\"><path d=\"M0 0L9 9\"/></svg>"},
                                            {.title = "Picture", .file = folder / "picture.png"},
                                            {.title = "Data", .svg = MakeSampleCurves()}},
                                .columns = 2}}});
    page.sections.push_back({.title = "Numbers", .blocks = {PageText{"Folded text."}}, .folded = true});
    page.facts = {{"command", "scree sample"}};
    return page;
}

SampleComparison MakeSampleComparison(const fs::path& folder) {
    OutputFolder output(folder);
    PictureMaker maker(Backend::cpu);
    const Snapshot before = RunSample(-10), after = RunSample(-9.5f);
    const SamplePicture overlap = DrawSample(maker, before, nullptr), overlapNow = DrawSample(maker, after, nullptr);
    const SamplePicture bodies = DrawSample(maker, before, "bodies,contacts"),
                        bodiesNow = DrawSample(maker, after, "bodies,contacts");

    SampleComparison sample;
    sample.origin = {"scree snapshot check --report out", "cpu", "built in", ""};
    sample.counts = PickCounts(overlap.counts, overlapNow.counts);
    sample.results.push_back(MakeResult("diagonal/step-0030-overlap", SnapshotStatus::equal, "equal"));

    sample.results.push_back(CompareSamplePictures(output, sampleOverlapId, overlap, overlapNow));
    sample.results.back().structure = CompareSamples(before, after);

    sample.results.push_back(CompareSamplePictures(output, "tumbler/step-0120-contacts", bodies, bodiesNow));
    SnapshotResult& ruled = sample.results.back();
    ruled.rule = {
        2, {{0, 0, width, 24}}, "tests/snapshots/tumbler/step-0120-contacts.json", "the title names the machine"};
    ruled.pixels.masked = 31;
    ruled.pixels.tolerated = 4;

    sample.results.push_back(MakeResult("pyramid/step-0120-joints", SnapshotStatus::missing,
                                        "no reference picture; accept it with `scree snapshot update`"));
    sample.results.back().actual = SaveSide(output, "pyramid/step-0120-joints", "actual", bodiesNow);

    SamplePicture small = bodies;
    small.image = Image(240, 150, {90, 90, 90});
    sample.results.push_back(
        MakeResult("pyramid/step-0040-contacts", SnapshotStatus::size, "240×150 pixels became 480×300"));
    sample.results.back().expected = SaveSide(output, "pyramid/step-0040-contacts", "expected", small);
    sample.results.back().actual = SaveSide(output, "pyramid/step-0040-contacts", "actual", bodiesNow);

    for (int i = 0; i < 20; ++i) {
        sample.results.push_back(MakeResult(fmt::format("tiles/step-{:04}-bodies", i), SnapshotStatus::equal, "equal"));
        sample.results.back().simulateMs = i;
    }
    return sample;
}

}  // namespace testbed
