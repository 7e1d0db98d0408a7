// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `overlap` and `render` hold while they make pictures.

#include "testbed/jobs/overlap/picture_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/stopwatch.h"
#include "testbed/picture/png.h"

namespace testbed {

namespace {

constexpr std::size_t waitingPictures = 4;  // those of one step of two engines

}  // namespace

void PictureSession::Begin(int steps) {
    pictures = 0;
    pictureTime = 0;
    sharedCamera.reset();
    options = asked;
    sequences.Begin(steps);
}

void PictureSession::Share(const StepVisits& steps, std::optional<std::size_t> baseline) {
    FitArea area;
    Peaks peaks;
    const bool hasArrows = options.layers.Has(Layer::velocities) || options.layers.Has(Layer::impulses);
    const auto measure = [&](std::span<const Snapshot> snapshots) {
        std::vector<const Snapshot*> pointers;
        for (const Snapshot& snapshot : snapshots) {
            pointers.push_back(&snapshot);
            peaks = JoinPeaks(peaks, FindPeaks(snapshot));
        }
        AddStep(area, pointers);
    };
    if (!options.camera || hasArrows) steps(measure);
    const Camera camera = testbed::ChooseCamera(area, options);
    sharedCamera = camera;
    if (hasArrows) options.peaks = peaks;
    if (!baseline) return;
    uint32_t largest = 1;
    int64_t difference = 1;
    steps([&](std::span<const Snapshot> snapshots) {
        std::vector<OverlapCount> counts;
        for (const Snapshot& snapshot : snapshots) counts.push_back(CountOverlap(snapshot, camera, options));
        for (const OverlapCount& count : counts) {
            largest = std::max(largest, count.stats.max);
            const DifferenceStats stats = MeasureDifference(count.counts, counts[*baseline].counts);
            difference = std::max({difference, stats.max, -stats.min});
        }
    });
    if (!options.scaleMax) options.scaleMax = largest;
    options.differenceMax = difference;
}

void PictureSession::Make(const std::function<void()>& make) {
    const Stopwatch watch;
    make();
    pictureTime += watch.GetMilliseconds();
}

Camera PictureSession::ChooseCamera(std::span<const Snapshot* const> snapshots) {
    if (sharedCamera) return *sharedCamera;
    return testbed::ChooseCamera(snapshots, options);
}

void PictureSession::Save(const std::string& name, Image image, const PictureRecord& record) {
    ++pictures;
    const Snapshot& first = *record.snapshots.front();
    FrameInfo frame{std::filesystem::path(first.scene) / name, fmt::format("step {}", first.step),
                    MakePngText(origin, record)};
    const std::string stem = (StepFolder(first) / name).string();
    // A job is copied on its way, a picture should not be.
    queue->Add([this, stem, frame = std::move(frame), picture = std::make_shared<Image>(std::move(image)),
                sidecar = WriteSidecar(origin, options, record)] {
        if (sequences.Add(output, frame, *picture)) return;
        WriteImage(output, stem + ".png", *picture, frame.text);
        output.WriteText(stem + ".json", sidecar);
    });
}

void PictureSession::Finish() {
    Make([this] {
        queue->Add([this] { sequences.Finish(output); });
        queue->Wait();
    });
}

std::string PictureSession::Describe(int steps, int shown) const {
    return fmt::format("{} steps, {} shown, {} pictures at {:.0f} ms", steps, shown, pictures,
                       pictureTime / std::max(pictures, 1));
}

PictureSession MakePictureSession(const SessionRequest& request, const ContextOptions& contextOptions) {
    const Backend backend = CheckedBackend(request.picture);
    const SequenceOptions sequence =
        MakeSequenceOptions(request.sequence, request.options.width, request.options.theme);
    OutputFolder output(request.run.output);
    PictureMaker maker(backend, contextOptions);
    PictureOrigin origin{request.command, "", GetBackendName(maker.GetBackend()), maker.GetRendererName(),
                         maker.GetVersion()};
    return {
        std::move(output), std::move(maker),           request.options, request.options,
        std::move(origin), PictureSequences(sequence), std::nullopt,    std::make_unique<WriteQueue>(waitingPictures)};
}

}  // namespace testbed
