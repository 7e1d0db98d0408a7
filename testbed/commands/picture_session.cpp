// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What `overlap` and `render` hold while they make pictures.

#include "testbed/commands/picture_session.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "testbed/commands/exit_code.h"

namespace testbed {

void PictureSession::Save(const std::filesystem::path& stem, const Image& image, const PictureRecord& record) {
    output.WriteImage(stem.string() + ".png", image, MakePngText(origin, record));
    output.WriteText(stem.string() + ".json", WriteSidecar(origin, options, record));
}

PictureSession MakePictureSession(const SessionRequest& request, const ContextOptions& contextOptions) {
    const Backend backend = CheckedBackend(request.picture);
    OutputFolder output(request.run.output);
    PictureMaker maker(backend, contextOptions);
    PictureOrigin origin{request.command, request.run.poses, GetBackendName(maker.GetBackend()),
                         maker.GetRendererName(), maker.GetVersion()};
    return {std::move(output), std::move(maker), request.options, std::move(origin)};
}

int SkipMissingBackend(const PictureArguments& arguments, const std::function<int()>& action) {
    try {
        return action();
    } catch (const BackendError& error) {
        if (!arguments.skipMissingBackend) throw;
        fmt::print(stderr, "scree: skipped: {}\n", error.what());
        return exitSkipped;
    }
}

}  // namespace testbed
