// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `overlap` and `render` hold while they make pictures: the output folder, the picture maker, the look, what
// every picture says about its origin, and the thread that writes.

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "testbed/base/output.h"
#include "testbed/base/write_queue.h"
#include "testbed/gl/context.h"
#include "testbed/jobs/overlap/sequences.h"
#include "testbed/jobs/overlap/show_steps.h"
#include "testbed/jobs/overlap/sidecar.h"
#include "testbed/options/options.h"
#include "testbed/view/picture.h"

namespace testbed {

struct PictureSession {
    OutputFolder output;
    PictureMaker maker;
    PictureOptions asked;    ///< for
    PictureOptions options;  ///< with what the pictures of a sequence share
    PictureOrigin origin;
    PictureSequences sequences;
    std::optional<Camera> sharedCamera;  ///< of all pictures of a sequence
    /// Encodes and writes while the next picture is made. Its jobs hold this session's address: last, so that it ends
    /// first, and no session is moved once it has saved anything.
    std::unique_ptr<WriteQueue> queue;
    int pictures = 0;        ///< saved since Begin
    double pictureTime = 0;  ///< spent on them, waiting for the queue included, ms

    /// Before the first picture of a scene of which `steps` are shown.
    void Begin(int steps);
    /// Chooses one camera and one of each scale for all steps of a sequence. With counts the steps are visited twice;
    /// their differences are those from the pane `baseline`.
    void Share(const StepVisits& steps, std::optional<std::size_t> baseline);
    /// Does `make`, which makes and saves pictures, and takes its time.
    void Make(const std::function<void()>& make);
    /// A fit of these snapshots; of a sequence that of all its steps.
    [[nodiscard]] Camera ChooseCamera(std::span<const Snapshot* const> snapshots);
    /// <scene>/step-<NNNN>/<name>.png and .json beside it, or a frame of <scene>/<name>.apng or .mp4. Written in the
    /// background: an error is thrown by a later call, at the latest by Finish.
    void Save(const std::string& name, Image image, const PictureRecord& record);
    /// After the last picture of a scene: all files are written. Before it nothing else may use `output`.
    void Finish();
    /// "3 steps, 1 shown, 4 pictures at 25 ms".
    [[nodiscard]] std::string Describe(int steps, int shown) const;
};

struct SessionRequest {
    const PictureArguments& picture;
    const SceneArguments& run;
    const SequenceArguments& sequence;
    const PictureOptions& options;
    std::string command;
};

/// Opens the folder, then the backend: both fail before any step is made. Throws FileError, BackendError, UsageError.
[[nodiscard]] PictureSession MakePictureSession(const SessionRequest& request, const ContextOptions& contextOptions);

}  // namespace testbed
