// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Moments of a session that matter, and the conditions that find them. A condition looks at one step after the other;
// whoever steps (a command, a window, a timeline) shows it each.

#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/snapshot.h"

namespace testbed {

/// Something that was found.
struct Moment {
    std::string condition;    ///< its name: "tunnel"
    int step = 0;             ///< at which it began
    double time = 0;          ///< of that step since the start, s
    int lastStep = 0;         ///< at which it still was so
    std::vector<int> bodies;  ///< indices into the bodies of the scene; empty: the whole step
    double size = 0;          ///< the largest while it lasted
    std::string unit;         ///< of `size`; empty: none
    std::string what;         ///< a sentence without the bodies
};

/// A step as conditions see it.
struct Frame {
    const Snapshot& now;     ///< with fixtures, contacts and joints
    const Snapshot* before;  ///< the step before; null: there is none
    double time = 0;         ///< s
    double timeStep = 0;     ///< s
    /// By index of a body in the scene: where it is in `now` and in `before`; −1: it is not.
    std::span<const int> placeNow, placeBefore;
    const scenes::Scene& scene;  ///< what the indices mean; filters of its fixtures
};

class Condition {
public:
    virtual ~Condition() = default;
    /// Steps come in order. Adds what is certain by now; what goes on is added when it is over.
    virtual void Look(const Frame& frame, std::vector<Moment>& found) = 0;
    /// What goes on in the step that was looked at last: what Finish would add after it, as long as it lasts.
    virtual void AddOngoing(std::vector<Moment>&) const {}
    /// After the last step.
    virtual void Finish(std::vector<Moment>& found) = 0;

    Condition() = default;
    Condition(const Condition&) = delete;
    Condition& operator=(const Condition&) = delete;
};

using Conditions = std::vector<std::unique_ptr<Condition>>;

/// Steps shown one by one to all conditions: keeps what Frame needs of the step before.
class Watch {
public:
    /// `time`: of the first frame, s.
    Watch(const scenes::Scene& scene, Conditions conditions, double time = 0.0);
    /// `timeStep` is that of the step that led here; the first frame is the start and takes none.
    void Show(Snapshot&& now, double timeStep);
    /// What began since the last call, also what goes on, each once: for whoever stops there.
    [[nodiscard]] std::vector<Moment> TakeNew();
    /// All moments by step; after it nothing more is shown.
    [[nodiscard]] std::vector<Moment> Finish();

private:
    const scenes::Scene& m_scene;
    Conditions m_conditions;
    std::vector<Moment> m_found;
    std::size_t m_toldCount = 0;                                      ///< of m_found, by TakeNew
    std::set<std::tuple<std::string, int, std::vector<int>>> m_told;  ///< condition, step and bodies
    Snapshot m_now, m_before;
    std::vector<int> m_placeNow, m_placeBefore;
    bool m_hasBefore = false;
    double m_time;
};

}  // namespace testbed
