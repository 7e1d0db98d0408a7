// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Input from a file instead of a person: text in, the events of each frame out. Documented in testbed/docs/window.md.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "testbed/jobs/window/gui.h"
#include "testbed/jobs/window/input_event.h"
#include "testbed/jobs/window/viewer.h"

namespace testbed {

struct ScriptLine {
    int number = 0;  ///< in the file, from 1
    int frame = 0;   ///< from 0
    std::string verb;
    std::vector<std::string> words;
};

/// Lines "FRAME VERB WORDS", in the order of the frames; # begins a comment. Throws std::invalid_argument with the
/// line's number for what cannot be meant.
[[nodiscard]] std::vector<ScriptLine> ParseScript(std::string_view text);

/// A file that a script asks for, after its frame was drawn.
struct ScriptOutput {
    bool isPicture = false;  ///< else the state as JSON
    std::string path;
};

/// What a frame's lines ask for. A click or a key is pressed here and released in the next frame.
struct ScriptFrame {
    std::vector<InputEvent> events;
    std::vector<ScriptOutput> outputs;
};

/// Plays a script, frame by frame.
class ScriptPlayer {
public:
    explicit ScriptPlayer(std::vector<ScriptLine> lines) : m_lines(std::move(lines)) {}

    /// Call it once for each frame, in order. Places are those of the frame before. Throws std::invalid_argument for a
    /// widget or body that is not there.
    [[nodiscard]] ScriptFrame Play(int frame, const Viewer& viewer, const Items& items);
    /// The frame after which nothing is left to do; −1 for an empty script.
    [[nodiscard]] int GetLastFrame() const;

private:
    void PlayLine(const ScriptLine& line, const Viewer& viewer, const Items& items, ScriptFrame& frame);

    std::vector<ScriptLine> m_lines;
    std::vector<InputEvent> m_releases;  ///< for the next frame
    size_t m_next = 0;
};

}  // namespace testbed
