// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whole pictures: every backend makes the same bytes, the numbers belong to the pixels, sizes are as promised, the
// difference has the right sign, and bad options are named.

#include "testbed/view/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "testbed/picture/image.h"
#include "tests/testbed/view/sample_snapshot.h"

namespace testbed {
namespace {

PictureOptions SmallOptions() {
    PictureOptions options;
    options.width = 640;
    options.height = 400;
    return options;
}

Snapshot MakeOtherSnapshot() {
    // Every node box is larger: the second engine covers more.
    Snapshot snapshot = MakeSampleSnapshot(8, 4, "box2d");
    for (NodeState& node : snapshot.nodes)
        node.box = {{node.box.lower.x - 0.5f, node.box.lower.y}, {node.box.upper.x + 3, node.box.upper.y}};
    return snapshot;
}

TEST(Picture, EveryBackendMakesTheSamePixels) {
    const Snapshot first = MakeSampleSnapshot(8, 4, "scree"), second = MakeOtherSnapshot();
    const PaneInput inputs[]{{&first, "note"}, {&second, ""}};
    PictureMaker cpu(Backend::cpu);
    for (const Backend backend : {Backend::osmesa, Backend::egl}) {
        PictureMaker gl(backend);
        EXPECT_EQ(gl.GetBackend(), backend);
        for (const Style style : {Style::alpha, Style::heat, Style::bands, Style::log}) {
            PictureOptions options = SmallOptions();
            options.style = style;
            const OverlapResult expected = cpu.MakeOverlap(inputs, options);
            const OverlapResult actual = gl.MakeOverlap(inputs, options);
            EXPECT_EQ(actual.panes[0].count.counts.counts, expected.panes[0].count.counts.counts);
            EXPECT_TRUE(actual.panes[0].image.pixels == expected.panes[0].image.pixels);
            EXPECT_TRUE(actual.panes[1].image.pixels == expected.panes[1].image.pixels);
            EXPECT_TRUE(actual.compare.pixels == expected.compare.pixels);
            EXPECT_TRUE(actual.differences[0].image.pixels == expected.differences[0].image.pixels);
        }
        PictureOptions options = SmallOptions();
        options.legend = true;
        options.layers = ParseLayers("islands,partitions,velocities,contacts,normals,impulses,joints,aabbs,bvh,labels");
        EXPECT_TRUE(gl.MakeRender(inputs[0], options).pixels == cpu.MakeRender(inputs[0], options).pixels);
    }
}

TEST(Picture, SizesAreAsPromised) {
    const Snapshot first = MakeSampleSnapshot(8, 4, "scree"), second = MakeOtherSnapshot();
    const PaneInput inputs[]{{&first, ""}, {&second, ""}};
    PictureMaker maker(Backend::cpu);
    for (const auto& [width, height] :
         {std::pair{640, 400}, std::pair{1921, 1080}, std::pair{64, 64}, std::pair{100, 300}}) {
        PictureOptions options;
        options.width = width;
        options.height = height;
        const OverlapResult result = maker.MakeOverlap(inputs, options);
        ASSERT_EQ(result.panes.size(), 2u);
        for (const Image* image : {&result.panes[0].image, &result.panes[1].image, &result.differences[0].image}) {
            EXPECT_EQ(image->width, width);
            EXPECT_EQ(image->height, height);
        }
        EXPECT_EQ(result.compare.width, width);
        EXPECT_EQ(result.panes[0].count.counts.width, width);
    }
    const OverlapResult alone = maker.MakeOverlap(std::span(inputs, 1), SmallOptions());
    EXPECT_EQ(alone.compare.width, 0);
    EXPECT_TRUE(alone.differences.empty());
}

TEST(Picture, NumbersBelongToThePixels) {
    const Snapshot first = MakeSampleSnapshot(8, 4, "scree"), second = MakeOtherSnapshot();
    const PaneInput inputs[]{{&first, ""}, {&second, ""}};
    PictureMaker maker(Backend::cpu);
    const OverlapResult result = maker.MakeOverlap(inputs, SmallOptions());
    for (const OverlapPane& pane : result.panes) {
        std::vector<uint32_t> counts = pane.count.counts.counts;
        std::sort(counts.begin(), counts.end());
        double sum = 0;
        for (const uint32_t count : counts) sum += count;
        EXPECT_EQ(pane.count.stats.max, counts.back());
        EXPECT_DOUBLE_EQ(pane.count.stats.mean, sum / static_cast<double>(counts.size()));
        EXPECT_EQ(pane.count.stats.p99, counts[(counts.size() * 99 + 99) / 100 - 1]);
        EXPECT_EQ(pane.count.stats.nodesDrawn, 31);
    }
    EXPECT_EQ(result.scaleMax, std::max(result.panes[0].count.stats.max, result.panes[1].count.stats.max));
    const OverlapCount alone = CountOverlap(first, result.camera, SmallOptions());
    EXPECT_EQ(alone.counts.counts, result.panes[0].count.counts.counts);
    EXPECT_EQ(alone.stats.mean, result.panes[0].count.stats.mean);
}

TEST(Picture, StatsOfKnownCounts) {
    CountImage counts{10, 20, std::vector<uint32_t>(200, 0u)};
    counts.counts[5] = 7;
    counts.counts[6] = 9;
    OverlapStats stats = MeasureCounts(counts, 3);
    EXPECT_EQ(stats.max, 9u);
    EXPECT_DOUBLE_EQ(stats.mean, 0.08);
    EXPECT_EQ(stats.p99, 0u) << "198 of 200 pixels are 99 %";
    counts.counts[7] = 4;
    stats = MeasureCounts(counts, 3);
    EXPECT_EQ(stats.p99, 4u);
    EXPECT_EQ(stats.nodesDrawn, 3);
    EXPECT_EQ(MeasureCounts({0, 0, {}}, 0).max, 0u);
}

TEST(Picture, DifferenceIsFirstMinusSecond) {
    const Snapshot first = MakeSampleSnapshot(8, 4, "scree"), second = MakeOtherSnapshot();
    const PaneInput inputs[]{{&first, ""}, {&second, ""}};
    PictureOptions options = SmallOptions();
    options.labels = false;
    const OverlapResult result = PictureMaker(Backend::cpu).MakeOverlap(inputs, options);
    EXPECT_EQ(result.differences[0].stats.max, 0);
    EXPECT_LT(result.differences[0].stats.min, 0);
    EXPECT_NEAR(result.differences[0].stats.mean, result.panes[0].count.stats.mean - result.panes[1].count.stats.mean,
                1e-12)
        << "sums of whole numbers, two divisions";
    for (const Color& color : result.differences[0].image.pixels) {
        ASSERT_TRUE(color == backgroundColor || color.b > color.r) << "the second counts more: blue";
    }
}

TEST(Picture, QuerySizeRaisesTheCounts) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    PictureOptions options = SmallOptions();
    const Snapshot* const pointer = &snapshot;
    const Camera camera = ChooseCamera(std::span(&pointer, 1), options);
    const OverlapCount plain = CountOverlap(snapshot, camera, options);
    options.querySize = 1;
    EXPECT_GT(CountOverlap(snapshot, camera, options).stats.mean, plain.stats.mean);
}

TEST(Picture, BodiesAreDrawnOverTheCounts) {
    const Snapshot snapshot = MakeSampleSnapshot(8, 4, "scree");
    const PaneInput input{&snapshot, ""};
    PictureMaker maker(Backend::cpu);
    PictureOptions options = SmallOptions();
    const Image with = maker.MakeOverlap(std::span(&input, 1), options).panes[0].image;
    options.layers = {};
    const Image without = maker.MakeOverlap(std::span(&input, 1), options).panes[0].image;
    EXPECT_FALSE(with.pixels == without.pixels);
}

TEST(Picture, ASnapshotWithNothingInItIsBackground) {
    const Snapshot empty;
    PictureOptions options = SmallOptions();
    options.labels = false;
    const PaneInput inputs[]{{&empty, ""}, {&empty, ""}};
    const OverlapResult result = PictureMaker(Backend::cpu).MakeOverlap(inputs, options);
    for (const Color& color : result.panes[0].image.pixels) ASSERT_EQ(color, backgroundColor);
    for (const Color& color : result.differences[0].image.pixels) ASSERT_EQ(color, backgroundColor);
}

// A scale whose upper half is one colour tells nothing about the places that matter most.
TEST(Picture, TheHighestCountsStayApartWithoutAnOpacity) {
    for (const uint32_t end : {1u, 10u, 95u, 96u, 148u, 400u, 3000u, 100'000u}) {
        const PictureOptions options;
        const double opacity = GetOpacity(options, end);
        EXPECT_GT(opacity, 0);
        EXPECT_LE(opacity, 0.04);
        const std::vector<Color> palette = MakePalette(Style::alpha, opacity, end);
        // Places of half the highest count, of three quarters and of all of it: the red of the background is 51.
        const int half = palette[end / 2].g, most = palette[end * 3 / 4].g, all = palette[end].g;
        if (end > 2) {
            EXPECT_GE(half - all, 5) << end;
        }
        if (end > 10) {
            EXPECT_GE(most - all, 1) << end;
        }
    }
    for (const uint32_t end : {1u, 50u, 95u}) EXPECT_EQ(GetOpacity({}, end), 0.04) << end;
    for (uint32_t end = 96; end < 2000; ++end) {
        // Three digits are within 0.5 %, and so the power within 2 %.
        EXPECT_NEAR(std::pow(1 - GetOpacity({}, end), end), 0.02, 0.02 * 0.02) << end;
        EXPECT_LE(GetOpacity({}, end), GetOpacity({}, end - 1)) << end;
    }
    PictureOptions typed;
    typed.opacity = 0.3;
    EXPECT_EQ(GetOpacity(typed, 1000), 0.3);
}

TEST(Picture, BadOptionsAreNamed) {
    const auto expectProblem = [](const auto& change, const std::string& name) {
        PictureOptions options;
        change(options);
        try {
            CheckOptions(options);
            ADD_FAILURE() << name << " accepted";
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
    };
    EXPECT_NO_THROW(CheckOptions({}));
    expectProblem([](PictureOptions& o) { o.width = 63; }, "--image");
    expectProblem([](PictureOptions& o) { o.height = 9000; }, "--image");
    expectProblem([](PictureOptions& o) { o.width = 8192, o.supersampling = 4; }, "--image");
    expectProblem([](PictureOptions& o) { o.opacity = 0; }, "--opacity");
    expectProblem([](PictureOptions& o) { o.opacity = 1.5; }, "--opacity");
    expectProblem([](PictureOptions& o) { o.scaleMax = 0; }, "--scale-max");
    expectProblem([](PictureOptions& o) { o.querySize = -1; }, "--query-size");
    expectProblem([](PictureOptions& o) { o.camera = CameraRequest{0, 0, 0}; }, "--camera");
    expectProblem([](PictureOptions& o) { o.supersampling = 3; }, "supersampling");
    PictureMaker maker(Backend::cpu);
    EXPECT_THROW((void)maker.MakeOverlap({}, {}), std::invalid_argument);
}

TEST(Picture, MissingBackendNamesThePackage) {
    ContextOptions options;
    options.osmesaLibrary = "libscree-no-such-osmesa.so";
    options.eglLibrary = "libscree-no-such-egl.so";
    EXPECT_THROW(PictureMaker(Backend::automatic, options), BackendError);
    EXPECT_NO_THROW(PictureMaker(Backend::cpu, options));
}

}  // namespace
}  // namespace testbed
