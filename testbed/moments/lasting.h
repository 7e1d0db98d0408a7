// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Something that lasts for several steps, such as two bodies deep in each other or a body too fast, as one moment. It
// has a beginning, a duration and the largest value.

#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "testbed/moments/moment.h"

namespace testbed {

/// By key: the bodies that it is about.
class Lasting {
public:
    using Key = std::vector<int>;

    /// `what` makes the sentence of what lasted. Shorter than `least` seconds counts for nothing.
    Lasting(std::string condition, std::string unit, double least, std::function<std::string(double size)> what)
        : m_condition(std::move(condition)), m_unit(std::move(unit)), m_least(least), m_what(std::move(what)) {}

    /// It is so in this step.
    void Note(const Frame& frame, const Key& bodies, double size) {
        const auto [at, isNew] = m_open.try_emplace(bodies);
        Run& run = at->second;
        if (isNew) run = {frame.now.step, frame.now.step, frame.time, frame.time, size};
        run.lastStep = frame.now.step;
        run.lastTime = frame.time;
        run.size = std::max(run.size, size);
    }
    /// After all notes of a step: what was not noted in it is over.
    void EndStep(const Frame& frame, std::vector<Moment>& found) {
        std::erase_if(m_open, [&](const auto& one) {
            if (one.second.lastStep == frame.now.step) return false;
            Add(one.first, one.second, found);
            return true;
        });
    }
    void AddOngoing(std::vector<Moment>& found) const {
        for (const auto& [bodies, run] : m_open) Add(bodies, run, found);
    }
    void Finish(std::vector<Moment>& found) {
        for (const auto& [bodies, run] : m_open) Add(bodies, run, found);
        m_open.clear();
    }

private:
    struct Run {
        int step = 0, lastStep = 0;
        double time = 0, lastTime = 0, size = 0;
    };
    void Add(const Key& bodies, const Run& run, std::vector<Moment>& found) const {
        if (run.lastTime - run.time < m_least) return;
        found.push_back({m_condition, run.step, run.time, run.lastStep, bodies, run.size, m_unit, m_what(run.size)});
    }

    std::string m_condition, m_unit;
    double m_least;
    std::function<std::string(double)> m_what;
    std::map<Key, Run> m_open;
};

}  // namespace testbed
