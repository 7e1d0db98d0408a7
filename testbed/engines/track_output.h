// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A track that a run writes by the capture header of its engine.

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "testbed/capture/scree_capture_track.h"
#include "testbed/engines/run_spec.h"
#include "testbed/engines/track_contents.h"

namespace testbed {

template <typename Track, typename World>
class TrackOutput {
public:
    /// `names`: of bodies by their index; empty for one without.
    void Begin(World& world, const std::string& path, const TrackContents& contents, const RunSpec& spec,
               std::vector<std::string> names) {
        scree_capture::Options options;
        options.contacts = true;
        options.tree = contents.tree;
        options.stages = contents.stages;
        options.memory = std::size_t{1} << 40;  // no step is left out
        if (const auto* si = std::get_if<SequentialImpulses>(&spec.solver); si != nullptr && si->iterations) {
            options.velocityIterations = si->iterations->velocity;
            options.positionIterations = si->iterations->position;
        }
        m_track = std::make_unique<Track>(world, path, options);
        m_names = std::move(names);
        m_namedCount = 0;
    }
    /// `bodies`: those that were created so far, by index.
    template <typename Body>
    void Step(float timeStep, const std::vector<Body*>& bodies) {
        if (!m_track) return;
        for (; m_namedCount < std::min(bodies.size(), m_names.size()); ++m_namedCount) {
            if (!m_names[m_namedCount].empty()) m_track->Name(bodies[m_namedCount], m_names[m_namedCount]);
        }
        m_track->Step(timeStep);
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
    std::vector<std::string> m_names;
    std::size_t m_namedCount = 0;  ///< bodies that have been named, if they have a name
};

}  // namespace testbed
