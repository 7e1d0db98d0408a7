// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The order of the work: camera, counts, colours, layers, words.

#include "testbed/view/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "testbed/base/text.h"
#include "testbed/gl/renderer.h"
#include "testbed/picture/font.h"
#include "testbed/view/annotate.h"
#include "testbed/view/labels.h"
#include "testbed/view/legend.h"
#include "testbed/view/scene_layers.h"

namespace testbed {

namespace {

constexpr int minSize = 64, maxSize = 8192;       // pixels
constexpr int maxSamples = 16384;                 // the largest texture that Mesa's software rasteriser takes
constexpr uint32_t maxScale = uint32_t{1} << 24;  // counts are exact up to here

/// Adds the time from its birth to its end to a total, ms.
class Timer {
public:
    explicit Timer(double& total) : m_total(total), m_start(std::chrono::steady_clock::now()) {}
    ~Timer() {
        m_total += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start).count();
    }
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

private:
    double& m_total;
    std::chrono::steady_clock::time_point m_start;
};

std::vector<PixelRect> ProjectNodes(const Snapshot& snapshot, const Camera& camera, const PictureOptions& options) {
    std::vector<PixelRect> rects;
    for (const Box& box : SelectBoxes(snapshot, options.nodes)) {
        rects.push_back(ProjectBox(box, options.querySize * 0.5, camera));
    }
    return rects;
}

/// Above a strip of `stripHeight` pixels, in letters as large as the other labels'.
void AddScaleBar(Image& image, const Camera& camera, int stripHeight, const PictureOptions& options) {
    if (!options.labels) return;
    DrawScaleBar(image, camera.pixelsPerMetre, image.height - stripHeight, GetLabelScale(options.width), options.theme);
}

}  // namespace

void CheckOptions(const PictureOptions& options) {
    const auto check = [](bool isGood, const std::string& message) {
        if (!isGood) throw std::invalid_argument(message);
    };
    check(
        options.width >= minSize && options.width <= maxSize && options.height >= minSize && options.height <= maxSize,
        fmt::format("--image {}x{}: each side is {} to {} pixels", options.width, options.height, minSize, maxSize));
    check(!options.opacity || (*options.opacity > 0 && *options.opacity <= 1),
          fmt::format("--opacity {}: auto, or more than 0 and at most 1", options.opacity.value_or(0)));
    check(!options.scaleMax || (*options.scaleMax >= 1 && *options.scaleMax <= maxScale),
          fmt::format("--scale-max {}: auto, or 1 to {}", options.scaleMax.value_or(0), maxScale));
    check(std::isfinite(options.querySize) && options.querySize >= 0,
          fmt::format("--query-size {}: metres, 0 or more", options.querySize));
    check(!options.camera || (options.camera->across > 0 && std::isfinite(options.camera->across)),
          "--camera X,Y,M: M, the metres across, is more than 0");
    const int factor = options.supersampling;
    check(factor == 1 || factor == 2 || factor == 4, fmt::format("supersampling {}: 1, 2 or 4", factor));
    check(std::max(options.width, options.height) * factor <= maxSamples,
          fmt::format("--image {}x{} with supersampling {}: at most {} samples on a side", options.width,
                      options.height, factor, maxSamples));
}

double GetOpacity(const PictureOptions& options, uint32_t scaleMax) {
    // The usual one up to the count at which it leaves 2 % of the background: 0.96^95.
    constexpr double logarithm = -3.912023;  // of 2 %
    constexpr uint32_t mostUsual = 95;
    if (options.opacity) return *options.opacity;
    if (scaleMax <= mostUsual) return usualOpacity;
    // 1 − (2 %)^(1/n) by its series: std::exp may differ in the last bit between libraries. Three digits can be typed.
    const double exponent = logarithm / scaleMax;
    const double opacity = -exponent * (1 + exponent / 2 * (1 + exponent / 3 * (1 + exponent / 4)));
    return *ParseNumber<double>(fmt::format("{:.3g}", opacity));
}

DifferenceStats MeasureDifference(const CountImage& first, const CountImage& second) {
    DifferenceStats stats;
    int64_t sum = 0;
    for (size_t i = 0; i < first.counts.size(); ++i) {
        const int64_t value = static_cast<int64_t>(first.counts[i]) - static_cast<int64_t>(second.counts[i]);
        stats.min = std::min(stats.min, value);
        stats.max = std::max(stats.max, value);
        sum += value;
    }
    if (!first.counts.empty()) stats.mean = static_cast<double>(sum) / static_cast<double>(first.counts.size());
    return stats;
}

OverlapStats MeasureCounts(const CountImage& counts, int nodesDrawn) {
    OverlapStats stats;
    stats.nodesDrawn = nodesDrawn;
    if (counts.counts.empty()) return stats;
    stats.max = *std::max_element(counts.counts.begin(), counts.counts.end());
    std::vector<size_t> histogram(static_cast<size_t>(stats.max) + 1, 0);
    uint64_t sum = 0;
    for (const uint32_t count : counts.counts) {
        ++histogram[count];
        sum += count;
    }
    const size_t pixels = counts.counts.size();
    stats.mean = static_cast<double>(sum) / static_cast<double>(pixels);
    const size_t wanted = pixels - pixels / 100;  // at least 99 % of the pixels
    size_t reached = 0;
    while ((reached += histogram[stats.p99]) < wanted) ++stats.p99;
    return stats;
}

Camera ChooseCamera(const FitArea& area, const PictureOptions& options) {
    if (options.camera) return MakeCamera(*options.camera, options.width, options.height);
    return FitCamera(GetFitBoxes(area), options.width, options.height, GetPictureMargins(options));
}

Camera ChooseCamera(std::span<const Snapshot* const> snapshots, const PictureOptions& options) {
    FitArea area;
    AddStep(area, snapshots);
    return ChooseCamera(area, options);
}

OverlapCount CountOverlap(const Snapshot& snapshot, const Camera& camera, const PictureOptions& options) {
    const std::vector<PixelRect> rects = ProjectNodes(snapshot, camera, options);
    OverlapCount result{CountRects(rects, camera.width, camera.height), {}};
    result.stats = MeasureCounts(result.counts, static_cast<int>(rects.size()));
    return result;
}

struct PictureMaker::Implementation {
    std::unique_ptr<Renderer> renderer;
    PictureTimes times;

    CountImage Count(const Snapshot& snapshot, const Camera& camera, const PictureOptions& options) {
        const Timer timer(times.counts);
        return renderer->Count(ProjectNodes(snapshot, camera, options), camera.width, camera.height);
    }

    void AddLayers(const Snapshot& snapshot, const Camera& camera, const PictureOptions& options, bool isOverCounts,
                   Image& picture) {
        const Timer timer(times.layers);
        const DrawList list = BuildDrawList(
            snapshot, camera,
            {options.layers, options.nodes, options.supersampling, options.theme, isOverCounts, options.peaks});
        renderer->DrawOver(list, picture);
        for (const TextItem& text : list.texts) DrawText(picture, text.x, text.y, text.text, text.scale, text.color);
    }

    Image ColorPane(const Snapshot& snapshot, const CountImage& counts, const std::vector<Color>& palette,
                    const Camera& camera, const PictureOptions& options) {
        Image image;
        {
            const Timer timer(times.colours);
            image = ColorCounts(counts, palette);
        }
        AddLayers(snapshot, camera, options, true, image);
        return image;
    }

    void AddCompare(std::span<const PaneInput> inputs, const std::vector<Color>& palette, const PictureOptions& options,
                    OverlapResult& result);
    /// The pane minus the baseline.
    void AddDifference(std::span<const PaneInput> inputs, std::size_t pane, std::size_t baseline,
                       const PictureOptions& options, OverlapResult& result);
};

void PictureMaker::Implementation::AddCompare(std::span<const PaneInput> inputs, const std::vector<Color>& palette,
                                              const PictureOptions& options, OverlapResult& result) {
    const int columns = GetCompareColumns(inputs.size());
    const int paneWidth = std::max(1, (options.width - (columns - 1) * compareGap) / columns);
    const int paneHeight = std::max(1, (options.height * paneWidth + options.width / 2) / options.width);
    const Camera camera = ScaleCamera(result.camera, paneWidth, paneHeight);
    std::vector<Image> pictures;
    for (const PaneInput& input : inputs) {
        const CountImage counts = Count(*input.snapshot, camera, options);
        pictures.push_back(ColorPane(*input.snapshot, counts, palette, camera, options));
        if (!options.labels) continue;
        DrawScaleBar(pictures.back(), camera.pixelsPerMetre, paneHeight, GetCompareScale(paneWidth), options.theme);
    }
    const Timer timer(times.colours);
    result.compare = MakeCompare(inputs, result.panes, pictures, result.scaleMax, options);
}

void PictureMaker::Implementation::AddDifference(std::span<const PaneInput> inputs, std::size_t pane,
                                                 std::size_t baseline, const PictureOptions& options,
                                                 OverlapResult& result) {
    const Timer timer(times.colours);
    const OverlapPane &first = result.panes[pane], &second = result.panes[baseline];
    OverlapDifference& difference = result.differences.emplace_back();
    difference.pane = pane;
    difference.stats = MeasureDifference(first.count.counts, second.count.counts);
    const DifferenceStats& stats = difference.stats;
    const int64_t end = options.differenceMax.value_or(std::max<int64_t>({-stats.min, stats.max, 1}));
    difference.image = ColorDifference(first.count.counts, second.count.counts, end, options.theme);
    if (!options.labels) return;
    DrawHeader(difference.image, MakeTitle(*inputs[pane].snapshot),
               fmt::format("{} minus {}, {} nodes", first.name, second.name, GetNodeSelectionName(options.nodes)),
               options.theme);
    DrawDifferenceFooter(difference.image, stats, end, first.name, second.name, options.theme);
    AddScaleBar(difference.image, result.camera, GetFooterHeight(options.width), options);
}

PictureMaker::PictureMaker(Backend backend, const ContextOptions& contextOptions)
    : m_implementation(std::make_unique<Implementation>()) {
    m_implementation->renderer = MakeRenderer(backend, contextOptions);
}

PictureMaker::~PictureMaker() = default;
PictureMaker::PictureMaker(PictureMaker&&) noexcept = default;
PictureMaker& PictureMaker::operator=(PictureMaker&&) noexcept = default;

Backend PictureMaker::GetBackend() const { return m_implementation->renderer->GetBackend(); }
std::string PictureMaker::GetRendererName() const { return m_implementation->renderer->GetName(); }
std::string PictureMaker::GetVersion() const { return m_implementation->renderer->GetVersion(); }
const PictureTimes& PictureMaker::GetTimes() const { return m_implementation->times; }

OverlapResult PictureMaker::MakeOverlap(std::span<const PaneInput> inputs, const PictureOptions& options,
                                        const std::optional<Camera>& camera, std::optional<std::size_t> baseline) {
    CheckOptions(options);
    if (inputs.empty()) throw std::invalid_argument("an overlap picture shows one pane or more");
    const std::size_t compared = baseline.value_or(inputs.size() - 1);
    if (compared >= inputs.size())
        throw std::invalid_argument("the baseline of an overlap picture is one of its panes");
    Implementation& implementation = *m_implementation;
    OverlapResult result;
    std::vector<const Snapshot*> snapshots;
    for (const PaneInput& input : inputs) snapshots.push_back(input.snapshot);
    result.camera = camera ? *camera : ChooseCamera(snapshots, options);
    for (const PaneInput& input : inputs) {
        OverlapPane pane;
        pane.name = input.snapshot->GetName();
        pane.count.counts = implementation.Count(*input.snapshot, result.camera, options);
        const auto nodes = SelectBoxes(*input.snapshot, options.nodes).size();
        pane.count.stats = MeasureCounts(pane.count.counts, static_cast<int>(nodes));
        result.scaleMax = std::max(result.scaleMax, pane.count.stats.max);
        result.panes.push_back(std::move(pane));
    }
    result.scaleMax = options.scaleMax.value_or(std::max(result.scaleMax, 1u));
    const std::vector<Color> palette =
        MakePalette(options.style, GetOpacity(options, result.scaleMax), result.scaleMax, options.theme);
    for (size_t i = 0; i < inputs.size(); ++i) {
        OverlapPane& pane = result.panes[i];
        const Snapshot& snapshot = *inputs[i].snapshot;
        pane.image = implementation.ColorPane(snapshot, pane.count.counts, palette, result.camera, options);
        AddScaleBar(pane.image, result.camera, GetFooterHeight(options.width), options);
    }
    if (options.labels) DrawPaneLabels(inputs, result.panes, result.scaleMax, options);
    if (inputs.size() == 1) return result;
    implementation.AddCompare(inputs, palette, options, result);
    for (size_t i = 0; i < inputs.size(); ++i) {
        if (i != compared) implementation.AddDifference(inputs, i, compared, options, result);
    }
    return result;
}

Image PictureMaker::MakeRender(const PaneInput& input, const PictureOptions& options,
                               const std::optional<Camera>& camera) {
    CheckOptions(options);
    const Snapshot* const snapshot = input.snapshot;
    const Camera chosen = camera ? *camera : ChooseCamera(std::span(&snapshot, 1), options);
    Image image(chosen.width, chosen.height, GetTheme(options.theme).background);
    m_implementation->AddLayers(*snapshot, chosen, options, false, image);
    if (options.labels) {
        const std::string note = input.note.empty() ? "" : "   " + input.note;
        DrawHeader(image, MakeTitle(*snapshot), MakeEngineText(*snapshot) + note, options.theme);
        if (options.legend)
            DrawLegend(image, MakeLegend(*snapshot, options.layers, options.theme, options.peaks, options.nodes),
                       options.theme);
        AddScaleBar(image, chosen, options.legend ? GetLegendHeight(options.layers, image.width) : 0, options);
    }
    return image;
}

}  // namespace testbed
