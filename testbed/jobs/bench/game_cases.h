// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The cases of `scree bench --games`: a scene as data, and what a game does in each frame.

#pragma once

#include <functional>
#include <span>
#include <string>

#include "scenes/scene.h"
#include "testbed/engines/lab.h"

namespace testbed {

/// What is timed of a case.
enum class GameTiming {
    frame,      ///< the edits of a frame and its step, µs
    queries,    ///< what a frame asks of a world that stands still, µs
    creation,   ///< making the world, ms
    firstStep,  ///< ms
};

struct GameCase {
    std::string name, what;
    std::function<scenes::Scene()> build;
    /// Before the step with this number: the same in every engine. Null: nothing.
    std::function<void(LabWorld&, int frame)> play{};
    bool sleeping = true;
    bool listens = false;
    int warmUp = 120;  ///< frames that are not timed
    int frames = 200;
    int worlds = 1;  ///< stepped in turn; the time is that of one
    GameTiming timing = GameTiming::frame;
    bool isFresh = false;  ///< worlds are made in memory that the program did not have before
};

[[nodiscard]] std::span<const GameCase> GetGameCases();

}  // namespace testbed
