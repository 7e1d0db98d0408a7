// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Triangles are sorted into bands by counting, which keeps their order; each band is then drawn on its own.

#include "testbed/picture/layer_bands.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "testbed/picture/composite.h"
#include "testbed/picture/rasterizer.h"

namespace testbed {

namespace {

constexpr int bandSamples = 64;  // rows; 1 MB of samples at 3840 across

struct Bins {
    std::vector<size_t> starts;       // by band, and the end
    std::vector<uint32_t> triangles;  // indices, ascending within a band
};

Bins SortIntoBands(const std::vector<Triangle>& triangles, int bands) {
    constexpr int32_t bandHeight = bandSamples * fixedPointOne;
    const auto first = [](const Triangle& t) { return std::min({t.a.y, t.b.y, t.c.y}) / bandHeight; };
    const auto last = [bands](const Triangle& t) {
        return std::min<int32_t>(std::max({t.a.y, t.b.y, t.c.y}) / bandHeight, bands - 1);
    };
    Bins bins{std::vector<size_t>(static_cast<size_t>(bands) + 1, 0), {}};
    for (const Triangle& t : triangles) {
        for (int32_t band = first(t); band <= last(t); ++band) ++bins.starts[static_cast<size_t>(band) + 1];
    }
    for (size_t band = 0; band < static_cast<size_t>(bands); ++band) bins.starts[band + 1] += bins.starts[band];
    bins.triangles.resize(bins.starts.back());
    std::vector<size_t> next(bins.starts.begin(), bins.starts.end() - 1);
    for (size_t i = 0; i < triangles.size(); ++i) {
        for (int32_t band = first(triangles[i]); band <= last(triangles[i]); ++band) {
            bins.triangles[next[static_cast<size_t>(band)]++] = static_cast<uint32_t>(i);
        }
    }
    return bins;
}

/// What one thread needs for its bands.
struct BandScratch {
    Image samples;
    std::vector<Triangle> triangles;
};

void DrawBand(const DrawList& list, const Bins& bins, int band, BandScratch& scratch, Image& picture) {
    const auto index = static_cast<size_t>(band);
    if (bins.starts[index] == bins.starts[index + 1]) return;
    const int factor = list.supersampling;
    const int top = band * bandSamples / factor;
    const int rows = std::min(bandSamples / factor, picture.height - top);
    scratch.triangles.clear();
    for (size_t i = bins.starts[index]; i < bins.starts[index + 1]; ++i) {
        Triangle triangle = list.triangles[bins.triangles[i]];
        for (FixedPoint* corner : {&triangle.a, &triangle.b, &triangle.c}) corner->y -= top * factor * fixedPointOne;
        scratch.triangles.push_back(triangle);
    }
    scratch.samples.width = picture.width * factor;
    scratch.samples.height = rows * factor;
    scratch.samples.pixels.assign(static_cast<size_t>(scratch.samples.width) * static_cast<size_t>(rows * factor),
                                  Color{0, 0, 0, 0});
    RasterizeTriangles(scratch.triangles, scratch.samples);
    CompositeRows(scratch.samples, factor, picture, top);
}

}  // namespace

void DrawInBands(const DrawList& list, int threads, Image& picture) {
    if (picture.width != list.width || picture.height != list.height) {
        throw std::invalid_argument("a layer does not fit its picture");
    }
    if (list.triangles.empty()) return;
    const int bands = (list.height * list.supersampling + bandSamples - 1) / bandSamples;
    const Bins bins = SortIntoBands(list.triangles, bands);
    std::atomic<int> next{0};
    const auto work = [&] {
        BandScratch scratch;
        for (int band = next++; band < bands; band = next++) DrawBand(list, bins, band, scratch, picture);
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < std::min(threads, bands); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
}

}  // namespace testbed
