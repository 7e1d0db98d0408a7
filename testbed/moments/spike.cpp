// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Steps that took much longer than others, with the stage that grew most and the bodies that may be why.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
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
constexpr std::size_t culprits = 3;
constexpr std::size_t leastSteps = 30;  // for a median that means something while a run goes on

double MedianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class Spike final : public Condition {
public:
    explicit Spike(double factor) : m_factor(factor) {}

    void Look(const Frame& frame, std::vector<Moment>&) override {
        if (frame.before == nullptr || !(frame.now.times.step > 0.0)) return;
        m_steps.push_back({frame.now.step, frame.now.contactCount, frame.time, frame.now.times, {}});
        // Who had the most contacts is only known now, and only worth knowing of long steps.
        if (m_steps.size() < 2 || frame.now.times.step > m_longest) {
            m_longest = frame.now.times.step;
            FindBodies(frame, m_steps.back());
        } else if (frame.now.times.step > m_factor * m_typical) {
            FindBodies(frame, m_steps.back());
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
            found.push_back({"spike", step.step, step.time, step.step, step.bodies, step.times.step / median,
                             "times the median",
                             fmt::format("{:.4g} ms, {:.4g} times the median{}{}{}", step.times.step,
                                         step.times.step / median, stage.empty() ? "" : ", and what grew most is the ",
                                         stage, more > 0 ? fmt::format(", {} more contacts than before", more) : "")});
        }
    }

    struct Step {
        int step = 0, contacts = 0;
        double time = 0;
        StepTimes times;
        std::vector<int> bodies;
    };
    [[nodiscard]] std::vector<double> Collect(double StepTimes::*member) const {
        std::vector<double> values;
        for (const Step& step : m_steps) values.push_back(step.times.*member);
        return values;
    }
    static void FindBodies(const Frame& frame, Step& step) {
        std::map<int, int> counts;
        for (const ContactState& contact : frame.now.contacts) {
            for (const int fixture : {contact.fixtureA, contact.fixtureB}) {
                const int place = frame.now.fixtures[static_cast<std::size_t>(fixture)].body;
                const BodyState& body = frame.now.bodies[static_cast<std::size_t>(place)];
                if (body.type != scenes::BodyType::isStatic) ++counts[body.index];
            }
        }
        std::vector<std::pair<int, int>> most;
        for (const auto& [body, count] : counts) most.emplace_back(-count, body);
        std::ranges::sort(most);
        for (const auto& [count, body] : most) {
            if (step.bodies.size() < culprits) step.bodies.push_back(body);
        }
    }

    double m_factor, m_longest = 0, m_typical = 0;
    std::vector<Step> m_steps;
};

}  // namespace

std::unique_ptr<Condition> MakeSpikeCondition(double factor) { return std::make_unique<Spike>(factor); }

}  // namespace testbed
