// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A track that a run writes by the capture header of its engine.

#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "testbed/capture/scree_capture_track.h"
#include "testbed/engines/run_spec.h"

namespace testbed {

template <typename Track, typename World>
class TrackOutput {
public:
    void Begin(World& world, const std::string& path, const RunSpec& spec) {
        scree_capture::Options options;
        options.contacts = true;
        options.memory = std::size_t{1} << 40;  // no step is left out
        if (const auto* si = std::get_if<SequentialImpulses>(&spec.solver); si != nullptr && si->iterations) {
            options.velocityIterations = si->iterations->velocity;
            options.positionIterations = si->iterations->position;
        }
        m_track = std::make_unique<Track>(world, path, options);
    }
    void Step(float timeStep) {
        if (m_track) m_track->Step(timeStep);
    }
    void End() {
        if (!m_track) return;
        m_track->Close();
        const std::string error = m_track->GetError();
        m_track.reset();
        if (!error.empty()) throw std::runtime_error(error);
    }

private:
    std::unique_ptr<Track> m_track;
};

}  // namespace testbed
