// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scenes as worlds that a test records, and what a track must then say: the same bits of every body after every step.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "scenes/build.h"
#include "scenes/catalog.h"
#include "testbed/input/track_file.h"

namespace testbed {

/// Pose, velocity and whether it is awake, as bits.
struct BodyBits {
    std::uint32_t bits[6];
    bool awake;

    friend bool operator==(const BodyBits&, const BodyBits&) = default;
};

inline BodyBits BitsOf(const TrackState& state) {
    const float values[6] = {state.position.x,       state.position.y,       state.angle,
                             state.linearVelocity.x, state.linearVelocity.y, state.angularVelocity};
    BodyBits bits{.bits = {}, .awake = state.awake};
    std::transform(std::begin(values), std::end(values), bits.bits,
                   [](float value) { return std::bit_cast<std::uint32_t>(value); });
    return bits;
}

/// Of a body of either engine.
template <typename Body>
BodyBits BitsOf(const Body& body, bool isStatic) {
    const TrackState state{.isThere = true,
                           .awake = !isStatic && body.IsAwake(),
                           .position = {body.GetPosition().x, body.GetPosition().y},
                           .angle = body.GetAngle(),
                           .linearVelocity = {body.GetLinearVelocity().x, body.GetLinearVelocity().y},
                           .angularVelocity = body.GetAngularVelocity()};
    return BitsOf(state);
}

inline std::string ReadBytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Bytes of a track without its header: those of steps.
inline double CountStepBytes(const std::filesystem::path& path) {
    const std::string bytes = ReadBytes(path);
    std::uint32_t header = 0;
    std::memcpy(&header, bytes.data() + 8, sizeof header);
    return static_cast<double>(bytes.size()) - 16.0 - header;
}

/// Steps of a body that changed: what the size of a track is measured by.
inline std::int64_t CountMoves(const std::vector<std::vector<BodyBits>>& history) {
    std::int64_t moves = 0;
    for (std::size_t step = 1; step < history.size(); ++step) {
        for (std::size_t i = 0; i < history[step - 1].size(); ++i) moves += history[step][i] != history[step - 1][i];
    }
    return moves;
}

/// A size of a scene that has at most about some hundred bodies, so that all scenes can be run.
inline scenes::Scene BuildSmall(const scenes::SceneInfo& info) {
    for (int size = info.defaultSize; size > info.minSize; size = std::max(size / 2, info.minSize)) {
        scenes::Scene scene = scenes::Build(info.name, size);
        if (scene.bodies.size() <= 400 && scene.fixtures.size() <= 1000) return scene;
    }
    return scenes::Build(info.name, info.minSize);
}

}  // namespace testbed
