// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Snapshots in, finished pictures out: what `scree overlap`, `scree render` and `scree metrics` call. Overlap is
// counted first (how many selected tree nodes cover each pixel) and coloured after, so that a picture and its numbers
// come from one pass. Includes no GL; the renderers behind it are chosen by Backend and agree pixel for pixel.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/engines/snapshot.h"
#include "testbed/gl/context.h"
#include "testbed/picture/image.h"
#include "testbed/picture/palette.h"
#include "testbed/picture/theme.h"
#include "testbed/view/camera.h"
#include "testbed/view/layers.h"
#include "testbed/view/nodes.h"
#include "testbed/view/scene_layers.h"

namespace testbed {

struct PictureOptions {
    int width = 1920, height = 1080;  ///< of a pane picture, 64…8192 pixels
    NodeSelection nodes;
    Style style = Style::alpha;
    std::optional<double> opacity;         ///< of one layer in the alpha style, 0 < a ≤ 1; none: as scaleMax needs it
    std::optional<uint32_t> scaleMax;      ///< count at the colour scale's end; none: the largest of all panes
    std::optional<int64_t> differenceMax;  ///< where the colours of differences end; none: the largest of each picture
    double querySize = 0;                  ///< every node grows by half of it on each side, m, ≥ 0
    std::optional<CameraRequest> camera;   ///< none: fit
    std::optional<Peaks> peaks;            ///< what lines and arrows are in proportion to; none: those of each picture
    Layers layers = Layers::Bodies();      ///< drawn over the counts
    Theme theme = Theme::dark;
    int supersampling = 2;  ///< samples along a pixel's edge for the layers: 1, 2 or 4
    bool labels = true;     ///< title, numbers and colour bar
    bool legend = false;    ///< of a render: what the layers' colours mean, with `labels`
};

/// Throws std::invalid_argument with the option's command-line name for a value outside its range.
void CheckOptions(const PictureOptions& options);

/// Opacity of one layer in the alpha style: the one of the options, else chosen so that the highest count is told from
/// those below it. The same on every machine.
[[nodiscard]] double GetOpacity(const PictureOptions& options, uint32_t scaleMax);

/// Numbers of one count picture, over all its pixels.
struct OverlapStats {
    uint32_t max = 0;
    double mean = 0;
    uint32_t p99 = 0;    ///< smallest count that at least 99 % of the pixels do not exceed
    int nodesDrawn = 0;  ///< selected nodes, those outside the picture included
};

/// Numbers of any counts; O(pixels + largest count).
[[nodiscard]] OverlapStats MeasureCounts(const CountImage& counts, int nodesDrawn);

struct OverlapCount {
    CountImage counts;
    OverlapStats stats;
};

/// The camera of a picture of these snapshots, or of an area: `options.camera`, else fitted, with room for the labels.
[[nodiscard]] Camera ChooseCamera(std::span<const Snapshot* const> snapshots, const PictureOptions& options);
[[nodiscard]] Camera ChooseCamera(const FitArea& area, const PictureOptions& options);

/// Counts on the CPU, no GL: O(nodes + pixels). The same counts as PictureMaker's.
[[nodiscard]] OverlapCount CountOverlap(const Snapshot& snapshot, const Camera& camera, const PictureOptions& options);

/// A snapshot to draw and what its label adds to scene, size, step, engine, broad phase, node count and overlap.
struct PaneInput {
    const Snapshot* snapshot = nullptr;
    std::string note;  ///< for example "sibling overlap 0.012"; UTF-8
};

struct OverlapPane {
    std::string name;  ///< Snapshot::GetName
    OverlapCount count;
    Image image;  ///< width × height of the options
};

/// Signed difference of two panes: first minus second.
struct DifferenceStats {
    int64_t min = 0, max = 0;
    double mean = 0;
};
/// first − second, pixel by pixel; both of one size.
[[nodiscard]] DifferenceStats MeasureDifference(const CountImage& first, const CountImage& second);

/// One pane minus the baseline's: blue negative, red positive.
struct OverlapDifference {
    std::size_t pane = 0;
    Image image;
    DifferenceStats stats;
};

struct OverlapResult {
    Camera camera;
    uint32_t scaleMax = 0;           ///< count at the end of the one scale of all panes
    std::vector<OverlapPane> panes;  ///< in the order of the input
    Image compare;                   ///< panes beside each other, as wide as one pane picture; empty with one pane
    std::vector<OverlapDifference> differences;  ///< of every pane but the baseline, in their order
};

/// Wall time of each stage of the calls so far, ms.
struct PictureTimes {
    double counts = 0, layers = 0, colours = 0;
};

/// Owns a context and its renderers. Make one per process and use it for all pictures.
class PictureMaker {
public:
    /// Throws BackendError.
    explicit PictureMaker(Backend backend, const ContextOptions& contextOptions = {});
    ~PictureMaker();
    PictureMaker(PictureMaker&&) noexcept;
    PictureMaker& operator=(PictureMaker&&) noexcept;

    /// Backend in use (never `automatic`) and its GL strings ("built in" and "" for cpu).
    [[nodiscard]] Backend GetBackend() const;
    [[nodiscard]] std::string GetRendererName() const;
    [[nodiscard]] std::string GetVersion() const;

    /// One or more panes at one step. For all pictures: an optional camera overrides the fit (for animations, whose
    /// frames must share one). The others are compared with the pane `baseline`, the last one if not given.
    /// Throws std::invalid_argument for no pane, for a baseline that is none, or bad options.
    [[nodiscard]] OverlapResult MakeOverlap(std::span<const PaneInput> inputs, const PictureOptions& options,
                                            const std::optional<Camera>& camera = std::nullopt,
                                            std::optional<std::size_t> baseline = std::nullopt);

    /// The scene itself, no counts: `options.layers` over the plain background.
    [[nodiscard]] Image MakeRender(const PaneInput& input, const PictureOptions& options,
                                   const std::optional<Camera>& camera = std::nullopt);

    [[nodiscard]] const PictureTimes& GetTimes() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

}  // namespace testbed
