// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Expressions over a step of a session, as `scree find --when` takes them:
//
//     body("player").y < -5 and not body("player").awake
//     contacts("player", "lava") > 0 or abs(body(3).spin) > 20
//
//   comparisons   < <= > >= == !=, joined by and, or, not and parentheses (also && || !)
//   numbers       1.5, 2e-3, + - * /, abs(a), min(a, b), max(a, b)
//   names         between " or ', where \" is a quote, \' another one and \\ a backslash
//   a body        body(NAME) or body(INDEX), and of it .x .y (position, m) .angle (rad) .vx .vy .speed (m/s) .spin
//                 (rad/s) .left .bottom .right .top (of its box, m) .awake .there (true or false)
//   contacts      contacts(): all that touch; contacts(BODY): of one body; contacts(BODY, BODY): between two;
//                 depth(BODY, BODY): how deep these are in each other, m; impulse(BODY, BODY): along the normal, N·s
//   the step      step, time (s), bodies, awake (their numbers)
//
// A comparison with a body that is not there, or with what is no number, is false.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/moments/moment.h"

namespace testbed {

class Expression {
public:
    /// Reads the text. `names` has the name of each body by index, empty: it has none. Throws UsageError that begins
    /// with the character, counted from 1, at which the fault is: "character 6, 'playr': no body is called …".
    Expression(std::string_view text, std::span<const std::string> names);

    /// Whether it holds after a step.
    [[nodiscard]] bool Holds(const Frame& frame) const;
    [[nodiscard]] const std::string& GetText() const { return m_text; }
    /// Indices of the bodies that it names, growing, each once.
    [[nodiscard]] const std::vector<int>& GetBodies() const { return m_bodies; }
    /// It asks for contacts, which not every motion has.
    [[nodiscard]] bool NeedsContacts() const { return m_needsContacts; }

    /// What an instruction does to the stack of values; true is 1 and false 0.
    enum class Action : std::uint8_t {
        number,
        step,
        time,
        bodies,
        awakeBodies,  // push
        x,
        y,
        angle,
        vx,
        vy,
        speed,
        spin,
        left,
        bottom,
        right,
        top,
        awake,
        there,  // push, of body a
        contacts,
        contactsOf,
        contactsBetween,
        depth,
        impulse,  // push, of bodies a and b
        negate,
        absolute,
        invert,  // one value
        add,
        subtract,
        multiply,
        divide,
        least,
        largest,  // two values
        less,
        lessEqual,
        greater,
        greaterEqual,
        equal,
        unequal,
        both,
        either,
    };
    struct Instruction {
        Action action = Action::number;
        int a = 0, b = 0;  ///< indices of bodies
        double number = 0;
    };

private:
    std::string m_text;
    std::vector<Instruction> m_program;  ///< in the order in which it runs
    std::size_t m_stackSize = 0;
    std::vector<int> m_bodies;
    bool m_needsContacts = false;
};

}  // namespace testbed
