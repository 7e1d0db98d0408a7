// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The condition of conditions.h that somebody wrote as an expression.

#include <fmt/format.h>

#include <utility>

#include "testbed/moments/conditions.h"
#include "testbed/moments/lasting.h"

namespace testbed {
namespace {

class When final : public Condition {
public:
    When(const std::string& name, Expression expression)
        : m_expression(std::move(expression)),
          m_lasting(name, "", 0.0, [text = m_expression.GetText()](double) { return fmt::format("{} holds", text); }) {}

    void Look(const Frame& frame, std::vector<Moment>& found) override {
        if (m_expression.Holds(frame)) m_lasting.Note(frame, m_expression.GetBodies(), 0.0);
        m_lasting.EndStep(frame, found);
    }
    void AddOngoing(std::vector<Moment>& found) const override { m_lasting.AddOngoing(found); }
    void Finish(std::vector<Moment>& found) override { m_lasting.Finish(found); }

private:
    Expression m_expression;
    Lasting m_lasting;
};

}  // namespace

std::unique_ptr<Condition> MakeWhenCondition(const std::string& name, Expression expression) {
    return std::make_unique<When>(name, std::move(expression));
}

}  // namespace testbed
