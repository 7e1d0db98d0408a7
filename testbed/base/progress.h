// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Progress of long work on stderr: a bar with the time left when it is a terminal, one line per finished case when not.

#pragma once

#include <chrono>
#include <string>

namespace testbed {

class Progress {
public:
    /// `title` names the case, e.g. "tiles"; `total` is the amount of work in any unit, ≥ 1.
    Progress(std::string title, double total);
    /// Removes the bar if the case did not finish.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void Advance(double amount);
    /// The case is done; `summary` follows its name on the line.
    void Finish(const std::string& summary);

private:
    using Clock = std::chrono::steady_clock;

    void Draw();

    std::string m_title;
    double m_total;
    double m_done = 0;
    bool m_terminal;
    bool m_drawn = false;
    Clock::time_point m_start = Clock::now();
    Clock::time_point m_lastDraw = m_start;
};

/// "1:05" or "2:00:00": minutes and seconds, hours when there are any.
[[nodiscard]] std::string FormatDuration(double seconds);

}  // namespace testbed
