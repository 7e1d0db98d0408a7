// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Steps that took much longer than others, with the stage that grew most and the bodies that may be why.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "testbed/moments/conditions.h"

namespace testbed {
namespace {

constexpr std::array<std::pair<std::string_view, double StepTimes::*>, 4> stages{{
    {"broad phase", &StepTimes::broadPhase},
    {"narrow phase", &StepTimes::narrowPhase},
    {"solver", &StepTimes::solver},
    {"continuous collision", &StepTimes::continuous},
}};
constexpr std::size_t leastSteps = 30;  // for a median that means something while a run goes on

double MedianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The body that has most of something; −1: none has any.
struct Leader {
    int body = -1;
    double size = 0;
};

/// What may have made a step long.
struct Causes {
    Leader pairs, box, contacts;
    Vec2 boxSize{};           ///< of the largest box
    bool hasAllPairs = true;  ///< pairs that do not touch are known, too
};

/// Of numbers by index of a body; of equal ones the first.
Leader FindLeader(const std::map<int, int>& counts) {
    Leader leader;
    for (const auto& [body, count] : counts) {
        if (count > leader.size) leader = {body, static_cast<double>(count)};
    }
    return leader;
}

const BodyState& BodyOf(const Snapshot& snapshot, int fixture) {
    return snapshot.bodies[static_cast<std::size_t>(snapshot.fixtures[static_cast<std::size_t>(fixture)].body)];
}

/// The two children of fixtures that a contact is of, whatever else there is.
using Pair = std::array<int, 4>;
Pair PairOf(const Snapshot& snapshot, const ContactState& contact) {
    const FixtureState& a = snapshot.fixtures[static_cast<std::size_t>(contact.fixtureA)];
    const FixtureState& b = snapshot.fixtures[static_cast<std::size_t>(contact.fixtureB)];
    const std::pair first{a.fixture, a.child}, second{b.fixture, b.child};
    const auto [low, high] = std::minmax(first, second);
    return {low.first, low.second, high.first, high.second};
}

/// Bodies that move, with the pairs that they did not have before, and with the contacts that touch.
void CountContacts(const Frame& frame, Causes& causes) {
    std::set<Pair> before;
    for (const ContactState& contact : frame.before->contacts) before.insert(PairOf(*frame.before, contact));
    std::map<int, int> pairs, contacts;
    for (const ContactState& contact : frame.now.contacts) {
        const bool isNew = !before.contains(PairOf(frame.now, contact));
        for (const int fixture : {contact.fixtureA, contact.fixtureB}) {
            const BodyState& body = BodyOf(frame.now, fixture);
            if (body.type == scenes::BodyType::isStatic) continue;
            pairs[body.index] += isNew ? 1 : 0;
            contacts[body.index] += contact.touching ? 1 : 0;
        }
    }
    causes.pairs = FindLeader(pairs);
    causes.contacts = FindLeader(contacts);
    causes.hasAllPairs = frame.now.contactCount <= static_cast<int>(frame.now.contacts.size());
}

/// The largest box, around all fixtures of a body that moves, before the step and after it.
void FindLargestBox(const Frame& frame, Causes& causes) {
    std::map<int, Box> boxes;
    for (const Snapshot* snapshot : {frame.before, &frame.now}) {
        for (std::size_t i = 0; i < snapshot->fixtures.size(); ++i) {
            const BodyState& body = BodyOf(*snapshot, static_cast<int>(i));
            if (body.type == scenes::BodyType::isStatic) continue;
            const auto [at, isFirst] = boxes.try_emplace(body.index, snapshot->fixtures[i].tight);
            if (!isFirst) at->second = Join(at->second, snapshot->fixtures[i].tight);
        }
    }
    for (const auto& [body, box] : boxes) {
        const Vec2 size{box.upper.x - box.lower.x, box.upper.y - box.lower.y};
        const double sides = double{size.x} + size.y;
        if (!(sides > causes.box.size)) continue;
        causes.box = {body, sides};
        causes.boxSize = size;
    }
}

class Spike final : public Condition {
public:
    Spike(double factor, bool hasContacts) : m_factor(factor), m_hasContacts(hasContacts) {}

    void Look(const Frame& frame, std::vector<Moment>&) override {
        if (frame.before == nullptr || !(frame.now.times.step > 0.0)) return;
        m_steps.push_back({frame.now.step, frame.now.contactCount, frame.time, frame.now.times, {}});
        // Who caused it is only known now, and only worth knowing of long steps.
        if (m_steps.size() < 2 || frame.now.times.step > m_longest) {
            m_longest = frame.now.times.step;
            FindCauses(frame, m_steps.back());
        } else if (frame.now.times.step > m_factor * m_typical) {
            FindCauses(frame, m_steps.back());
        }
        m_typical += 0.05 * (std::min(frame.now.times.step, 4.0 * m_typical + 1e-3) - m_typical);
    }
    /// The last step alone, against the median so far.
    void AddOngoing(std::vector<Moment>& found) const override {
        if (m_steps.size() >= leastSteps) AddFrom(m_steps.size() - 1, found);
    }
    void Finish(std::vector<Moment>& found) override { AddFrom(0, found); }

private:
    void AddFrom(std::size_t first, std::vector<Moment>& found) const {
        if (m_steps.empty()) return;
        const double median = MedianOf(Collect(&StepTimes::step));
        for (std::size_t i = first; i < m_steps.size(); ++i) {
            const Step& step = m_steps[i];
            if (!(step.times.step > m_factor * median)) continue;
            std::string_view stage;
            double growth = 0.0;
            for (const auto& [name, member] : stages) {
                const double grown = step.times.*member - MedianOf(Collect(member));
                if (grown > growth) growth = grown, stage = name;
            }
            const int more = i > 0 ? step.contacts - m_steps[i - 1].contacts : 0;
            // What finds pairs and impacts works for boxes, the rest for contacts.
            const Causes& c = step.causes;
            const bool isOfBoxes = stage == stages[0].first || stage == stages[3].first;
            found.push_back(
                {"spike", step.step, step.time, step.step,
                 isOfBoxes ? ListBodies({c.pairs, c.box, c.contacts}) : ListBodies({c.contacts, c.pairs, c.box}),
                 step.times.step / median, "times the median",
                 fmt::format("{:.4g} ms, {:.4g} times the median{}{}{}{}", step.times.step, step.times.step / median,
                             stage.empty() ? "" : ", and what grew most is the ", stage,
                             more > 0 ? fmt::format(", {} more contacts than before", more) : "", Describe(c))});
        }
    }
    /// Each once.
    static std::vector<int> ListBodies(std::initializer_list<Leader> leaders) {
        std::vector<int> bodies;
        for (const Leader& leader : leaders) {
            if (leader.body >= 0 && std::ranges::find(bodies, leader.body) == bodies.end()) {
                bodies.push_back(leader.body);
            }
        }
        return bodies;
    }
    [[nodiscard]] std::string Describe(const Causes& causes) const {
        std::string text;
        if (causes.pairs.body >= 0) {
            text += fmt::format("; most new {}: body {} ({})", causes.hasAllPairs ? "pairs" : "contacts",
                                causes.pairs.body, causes.pairs.size);
        }
        if (causes.box.body >= 0) {
            text += fmt::format("; largest box: body {} ({:.3g} x {:.3g} m)", causes.box.body, causes.boxSize.x,
                                causes.boxSize.y);
        }
        if (causes.contacts.body >= 0) {
            text += fmt::format("; most contacts: body {} ({})", causes.contacts.body, causes.contacts.size);
        }
        if (!m_hasContacts) return text + "; pairs and contacts were not recorded";
        return text + (causes.hasAllPairs ? "" : "; pairs that do not touch were not recorded");
    }

    struct Step {
        int step = 0, contacts = 0;
        double time = 0;
        StepTimes times;
        Causes causes;
    };
    [[nodiscard]] std::vector<double> Collect(double StepTimes::*member) const {
        std::vector<double> values;
        for (const Step& step : m_steps) values.push_back(step.times.*member);
        return values;
    }
    static void FindCauses(const Frame& frame, Step& step) {
        CountContacts(frame, step.causes);
        FindLargestBox(frame, step.causes);
    }

    double m_factor, m_longest = 0, m_typical = 0;
    bool m_hasContacts;
    std::vector<Step> m_steps;
};

}  // namespace

std::unique_ptr<Condition> MakeSpikeCondition(double factor, bool hasContacts) {
    return std::make_unique<Spike>(factor, hasContacts);
}

}  // namespace testbed
