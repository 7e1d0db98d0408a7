// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What becomes of the pictures of many steps together: an animation, a video, a contact sheet. Shared by the commands
// that draw steps.

#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "testbed/base/output.h"
#include "testbed/picture/png.h"
#include "testbed/picture/theme.h"

namespace testbed {

/// As typed.
struct SequenceArguments {
    std::string animate;
    int framesPerSecond = 20;
    bool contactSheet = false;
};
void AddSequenceOptions(CLI::App& app, SequenceArguments& arguments);

enum class Animation { none, apng, mp4 };

struct SequenceOptions {
    Animation animation = Animation::none;
    int framesPerSecond = 20;
    bool contactSheet = false;
    int sheetWidth = 1920;  ///< pixels
    Theme theme = Theme::dark;

    [[nodiscard]] bool IsUsed() const { return animation != Animation::none || contactSheet; }
};
/// Throws UsageError; ToolError when ffmpeg is wanted and not installed.
[[nodiscard]] SequenceOptions MakeSequenceOptions(const SequenceArguments& arguments, int sheetWidth, Theme theme);

/// UsageError unless a contact sheet of this many pictures, if one is wanted, has room for them.
void CheckSheet(const SequenceOptions& options, int pictures);

struct FrameInfo {
    std::filesystem::path stem;  ///< of the sequence's files: <scene>/<picture's name>
    std::string label;           ///< "step 20"
    std::vector<PngText> text;
};

/// Collects pictures by stem and writes <stem>.apng, <stem>.mp4 and <stem>-sheet.png.
class PictureSequences {
public:
    explicit PictureSequences(const SequenceOptions& options);
    ~PictureSequences();

    [[nodiscard]] const SequenceOptions& GetOptions() const { return m_options; }
    /// How many pictures each following sequence will have at most.
    void Begin(int pictures) { m_expected = pictures; }
    /// True: the picture is part of an animation and needs no file of its own.
    bool Add(OutputFolder& output, const FrameInfo& frame, const Image& image);
    /// Ends and writes all sequences, by name.
    void Finish(OutputFolder& output);

private:
    struct Sequence;
    SequenceOptions m_options;
    int m_expected = 1;
    std::map<std::filesystem::path, std::unique_ptr<Sequence>> m_sequences;
};

}  // namespace testbed
