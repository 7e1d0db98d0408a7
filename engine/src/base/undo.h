// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What to take back if a function ends early because memory has run out. No try and no catch, so that the engine also
// compiles with -fno-exceptions.

#pragma once

#include <utility>

namespace scree {

/// Calls `action` at its end unless it was dismissed.
template <typename Action>
class Undo {
public:
    explicit Undo(Action action) : m_action(std::move(action)) {}
    ~Undo() {
        if (m_isArmed) m_action();
    }
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;

    void Dismiss() { m_isArmed = false; }

private:
    Action m_action;
    bool m_isArmed = true;
};

}  // namespace scree
