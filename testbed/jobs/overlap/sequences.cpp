// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sequences of pictures. An animation grows under a temporary name and gets its own when it is whole.

#include "testbed/jobs/overlap/sequences.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/picture/apng.h"
#include "testbed/picture/png.h"
#include "testbed/picture/video.h"
#include "testbed/view/contact_sheet.h"

namespace testbed {

namespace {

constexpr std::array<std::string_view, 2> animationNames = {"apng", "mp4"};
constexpr int mostFramesPerSecond = 120;

const char* GetEnding(Animation animation) { return animation == Animation::apng ? ".apng" : ".mp4"; }

}  // namespace

struct PictureSequences::Sequence {
    std::optional<NewFile> file;  ///< of the animation
    std::unique_ptr<ApngWriter> apng;
    std::unique_ptr<VideoWriter> video;
    std::optional<ContactSheet> sheet;
    std::vector<PngText> text;
};

void AddSequenceOptions(CLI::App& app, SequenceArguments& arguments) {
    app.add_option("--animate", arguments.animate,
                   "One animation of all steps shown instead of single pictures: apng, or mp4 (needs ffmpeg)")
        ->type_name("apng|mp4");
    app.add_option("--fps", arguments.framesPerSecond, "Frames per second of --animate, 1 to 120")
        ->capture_default_str();
    app.add_flag("--contact-sheet", arguments.contactSheet, "Also all steps shown as a grid of small pictures");
}

SequenceOptions MakeSequenceOptions(const SequenceArguments& arguments, int sheetWidth, Theme theme) {
    SequenceOptions options;
    if (!arguments.animate.empty()) {
        if (arguments.animate != animationNames[0] && arguments.animate != animationNames[1]) {
            throw UsageError(DescribeUnknown("kind for --animate", arguments.animate, animationNames));
        }
        options.animation = arguments.animate == "apng" ? Animation::apng : Animation::mp4;
    }
    if (arguments.framesPerSecond < 1 || arguments.framesPerSecond > mostFramesPerSecond) {
        throw UsageError(fmt::format("--fps {}: legal from 1 to {}", arguments.framesPerSecond, mostFramesPerSecond));
    }
    options.framesPerSecond = arguments.framesPerSecond;
    options.contactSheet = arguments.contactSheet;
    options.sheetWidth = sheetWidth;
    options.theme = theme;
    if (options.animation == Animation::mp4) CheckFfmpeg();
    return options;
}

void CheckSheet(const SequenceOptions& options, int pictures) {
    if (!options.contactSheet || ContactSheet::Fits(pictures, options.sheetWidth)) return;
    throw UsageError(fmt::format(
        "--contact-sheet: {} pictures do not fit on a sheet {} pixels wide; show fewer with --steps first:last:stride, "
        "or take a wider --image",
        pictures, options.sheetWidth));
}

PictureSequences::PictureSequences(const SequenceOptions& options) : m_options(options) {}
PictureSequences::~PictureSequences() = default;

bool PictureSequences::Add(OutputFolder& output, const FrameInfo& frame, const Image& image) {
    if (!m_options.IsUsed()) return false;
    std::unique_ptr<Sequence>& sequence = m_sequences[frame.stem];
    if (sequence == nullptr) {
        sequence = std::make_unique<Sequence>();
        sequence->text = frame.text;
        if (m_options.contactSheet) sequence->sheet.emplace(m_expected, m_options.sheetWidth, m_options.theme);
        if (m_options.animation != Animation::none) {
            sequence->file.emplace(output.Begin(frame.stem.string() + GetEnding(m_options.animation)));
        }
        if (m_options.animation == Animation::apng) {
            sequence->apng =
                std::make_unique<ApngWriter>(sequence->file->GetPlace(), m_options.framesPerSecond, frame.text);
        }
        if (m_options.animation == Animation::mp4) {
            sequence->video = std::make_unique<VideoWriter>(sequence->file->GetPlace(), m_options.framesPerSecond);
        }
    }
    if (sequence->sheet) sequence->sheet->Add(image, frame.label);
    if (sequence->apng) sequence->apng->Add(image);
    if (sequence->video) sequence->video->Add(image);
    return m_options.animation != Animation::none;
}

void PictureSequences::Finish(OutputFolder& output) {
    for (const auto& [stem, sequence] : m_sequences) {
        if (sequence->apng) sequence->apng->Finish();
        if (sequence->video) sequence->video->Finish();
        if (sequence->file) output.Finish(*sequence->file);
        if (sequence->sheet) WriteImage(output, stem.string() + "-sheet.png", sequence->sheet->Make(), sequence->text);
    }
    m_sequences.clear();
}

}  // namespace testbed
