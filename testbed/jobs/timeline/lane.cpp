// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of lane.h.

#include "testbed/jobs/timeline/lane.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/progress.h"
#include "testbed/options/options.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

/// Curves of the world; what a motion was recorded without is left out.
class Series {
public:
    Series(bool hasTimes, bool hasContacts) : m_hasTimes(hasTimes), m_hasContacts(hasContacts) {}

    void Add(const Snapshot& snapshot, const BodyRows& bodies) {
        const StepTimes& times = snapshot.times;
        if (m_hasTimes) {
            Put("step", times.step);
            Put("broadPhase", times.broadPhase);
            Put("narrowPhase", times.narrowPhase);
            Put("solver", times.solver);
            Put("continuous", times.continuous);
        }
        if (m_hasContacts) Put("contacts", snapshot.touchingCount);
        Put("awake", static_cast<double>(std::ranges::count_if(snapshot.bodies, &BodyState::awake)));
        double energy = 0, overlap = 0;
        for (const BodyState& body : snapshot.bodies) {
            const BodyMass& mass = bodies.GetMass(body.index);
            const Vec2 v = body.linearVelocity;
            const double spin = body.angularVelocity;
            energy += 0.5 * (mass.mass * (double{v.x} * v.x + double{v.y} * v.y) + mass.inertia * spin * spin);
        }
        Put("energy", energy);
        for (const ContactState& contact : snapshot.contacts) {
            const bool isSensor = snapshot.fixtures[static_cast<std::size_t>(contact.fixtureA)].sensor ||
                                  snapshot.fixtures[static_cast<std::size_t>(contact.fixtureB)].sensor;
            if (!contact.touching || isSensor) continue;
            for (int i = 0; i < contact.pointCount; ++i) overlap = std::max(overlap, -double{contact.separations[i]});
        }
        if (m_hasContacts) Put("overlap", overlap);
        m_next = 0;
    }
    [[nodiscard]] Json GetNames() const {
        Json names = Json::array();
        for (const Curve& curve : m_curves) names.push_back(curve.name);
        return names;
    }
    [[nodiscard]] std::string Pack() const {
        ByteStream stream;
        for (const Curve& curve : m_curves) {
            for (const float value : curve.values) stream.PutFloat(value);
        }
        return stream.Pack();
    }

private:
    struct Curve {
        const char* name;
        std::vector<float> values;
    };
    /// Curves come in the same order in every step.
    void Put(const char* name, double value) {
        if (m_next == m_curves.size()) m_curves.push_back({name, {}});
        m_curves[m_next++].values.push_back(static_cast<float>(value));
    }

    bool m_hasTimes, m_hasContacts;
    std::size_t m_next = 0;
    std::vector<Curve> m_curves;
};

/// Trees of the steps that were asked for; of the slowest, those so far.
class Trees {
public:
    Trees(const KeptTrees& kept, const Grid& grid) : m_kept(kept), m_grid(grid) {}

    [[nodiscard]] bool Wants(int step, double milliseconds) const {
        if (m_kept.every > 0) return step % m_kept.every == 0;
        if (m_kept.worst == 0) return std::ranges::binary_search(m_kept.steps, step);
        if (step == 0) return false;
        return static_cast<int>(m_trees.size()) < m_kept.worst || milliseconds > m_trees[FindFastest()].milliseconds;
    }
    void Keep(const Snapshot& snapshot, double milliseconds) {
        if (m_kept.worst > 0 && static_cast<int>(m_trees.size()) == m_kept.worst) {
            m_trees.erase(m_trees.begin() + static_cast<std::ptrdiff_t>(FindFastest()));
        }
        m_trees.push_back({snapshot.step, milliseconds, PutNodes(snapshot, m_grid)});
    }
    [[nodiscard]] Json GetSteps() const {
        Json steps = Json::array();
        for (const Tree& tree : m_trees) steps.push_back(tree.step);
        return steps;
    }
    [[nodiscard]] std::string Pack() const {
        ByteStream all;
        for (const Tree& tree : m_trees) all.Append(tree.nodes);
        return all.Pack();
    }

private:
    struct Tree {
        int step = 0;
        double milliseconds = 0;
        ByteStream nodes;
    };
    [[nodiscard]] std::size_t FindFastest() const {
        return static_cast<std::size_t>(std::ranges::min_element(m_trees, {}, &Tree::milliseconds) - m_trees.begin());
    }

    const KeptTrees& m_kept;
    const Grid& m_grid;
    std::vector<Tree> m_trees;  ///< by step
};

}  // namespace

KeptTrees ParseKeptTrees(std::string_view text) {
    KeptTrees kept;
    if (text.empty()) return kept;
    const std::string takes = "every:N, worst:K or at:STEP,STEP with whole numbers from 1 on";
    const std::string_view kind = text.substr(0, text.find(':'));
    const bool isKnown = kind == "every" || kind == "worst" || kind == "at";
    if (!isKnown || kind.size() == text.size()) {
        throw UsageError(fmt::format("--nodes {}: give {}", text, takes));
    }
    const std::vector<int> numbers = ParseIntList("--nodes", text.substr(kind.size() + 1), takes);
    if (std::ranges::any_of(numbers, [](int n) { return n < 1 || n > maxStep; }) ||
        (kind != "at" && numbers.size() > 1)) {
        throw UsageError(fmt::format("--nodes {}: give {}", text, takes));
    }
    if (kind == "every") kept.every = numbers.front();
    if (kind == "worst") kept.worst = numbers.front();
    if (kind == "at") kept.steps = numbers;
    std::ranges::sort(kept.steps);
    return kept;
}

LaneData RecordLane(Session& session, const std::string& name, Conditions conditions, const Grid& grid,
                    BodyRows& bodies, const LaneOptions& options) {
    for (const int step : options.trees.steps) {
        if (step >= session.GetStep() && step <= session.GetLastStep()) continue;
        throw UsageError(fmt::format("--nodes at:{}: give some of the steps {} to {}", step, session.GetStep(),
                                     session.GetLastStep()));
    }
    const bool hasContacts = options.contacts && session.HasContacts();
    Watch watch(session.GetScene(), std::move(conditions), session.GetTime());
    MotionData motion(session.GetScene().bodies.size(), grid, options.exact);
    ContactData contacts;
    JointData joints;
    Series series(session.HasTimes(), session.HasContacts());
    Trees trees(options.trees, grid);
    Json steps = Json::array(), times = Json::array();
    double timeStep = 0.0;
    Progress progress(name, std::max(1, session.GetLastStep() - session.GetStep()));
    for (bool goesOn = true; goesOn; goesOn = session.Step()) {
        if (!steps.empty()) {
            timeStep = session.GetTimeStep();
            progress.Advance(1);
        }
        const double milliseconds = session.GetStepMilliseconds();
        const bool wantsTree = options.trees.IsAsked() && trees.Wants(session.GetStep(), milliseconds);
        Snapshot snapshot = session.Capture(wantsTree);
        bodies.Note(snapshot);
        motion.Add(snapshot);
        if (hasContacts) contacts.Add(snapshot, grid, motion);
        joints.Add(snapshot);
        series.Add(snapshot, bodies);
        if (wantsTree) trees.Keep(snapshot, milliseconds);
        steps.push_back(session.GetStep());
        times.push_back(std::round(session.GetTime() * 1e6) / 1e6);
        watch.Show(std::move(snapshot), timeStep);
    }
    LaneData lane;
    lane.changes = motion.GetChangeCount();
    lane.moments = watch.Finish();
    lane.told = {{"name", name},
                 {"steps", steps},
                 {"times", times},
                 {"joints", joints.GetRows()},
                 {"seriesNames", series.GetNames()}};
    lane.streams.emplace_back("motion", motion.GetStream().Pack());
    lane.streams.emplace_back("series", series.Pack());
    if (hasContacts) lane.streams.emplace_back("contacts", contacts.GetStream().Pack());
    if (!lane.told["joints"].empty()) lane.streams.emplace_back("joints", joints.GetStream().Pack());
    if (options.trees.IsAsked()) {
        lane.told["nodeSteps"] = trees.GetSteps();
        lane.streams.emplace_back("nodes", trees.Pack());
    }
    return lane;
}

}  // namespace testbed
