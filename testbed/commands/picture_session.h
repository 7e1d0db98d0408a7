// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `overlap` and `render` hold while they make pictures: the output folder, the picture maker, the look, and what
// every picture says about its origin.

#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "testbed/commands/arguments.h"
#include "testbed/context/context.h"
#include "testbed/report/output.h"
#include "testbed/report/sidecar.h"
#include "testbed/view/picture.h"

namespace testbed {

struct PictureSession {
    OutputFolder output;
    PictureMaker maker;
    PictureOptions options;
    PictureOrigin origin;

    /// Writes <stem>.png and, beside it, <stem>.json.
    void Save(const std::filesystem::path& stem, const Image& image, const PictureRecord& record);
};

struct SessionRequest {
    const PictureArguments& picture;
    const RunArguments& run;
    const PictureOptions& options;
    std::string command;
};

/// Opens the folder, then the backend: both fail before any step is made. Throws FileError, BackendError, UsageError.
[[nodiscard]] PictureSession MakePictureSession(const SessionRequest& request, const ContextOptions& contextOptions);

/// Runs `action`; with --skip-missing-backend a BackendError becomes a line on stderr and exit code 77.
[[nodiscard]] int SkipMissingBackend(const PictureArguments& arguments, const std::function<int()>& action);

}  // namespace testbed
