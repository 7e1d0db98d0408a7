// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Progress of long work on stderr.

#include "testbed/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "testbed/base/standard_error.h"

namespace testbed {

namespace {

constexpr int barWidth = 30;
constexpr const char* clearLine = "\r\x1b[K";

double SecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string FormatDuration(double seconds) {
    const long whole = std::lround(std::max(0.0, seconds));
    const long hours = whole / 3600, minutes = whole / 60 % 60;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
    return fmt::format("{}:{:02}", minutes, whole % 60);
}

Progress::Progress(std::string title, double total)
    : m_title(std::move(title)), m_total(total), m_terminal(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (m_drawn) PrintError("{}", clearLine);
}

void Progress::Advance(double amount) {
    m_done += amount;
    // Ten times a second is smooth to the eye and costs nothing beside a step.
    if (m_terminal && Clock::now() - m_lastDraw >= std::chrono::milliseconds(100)) Draw();
}

void Progress::Draw() {
    m_lastDraw = Clock::now();
    m_drawn = true;
    const double share = std::clamp(m_done / m_total, 0.0, 1.0);
    const int filled = static_cast<int>(share * barWidth);
    const double elapsed = SecondsSince(m_start);
    const std::string left = share > 0 ? FormatDuration(elapsed / share - elapsed) + " left" : std::string();
    PrintError("{}{} [{:#<{}}{:.<{}}] {:3.0f} % {}", clearLine, m_title, "", filled, "", barWidth - filled, 100 * share,
               left);
    std::fflush(stderr);
}

void Progress::Finish(const std::string& summary) {
    if (m_drawn) PrintError("{}", clearLine);
    m_drawn = false;
    PrintError("{}: {}, {:.1f} s\n", m_title, summary, SecondsSince(m_start));
}

}  // namespace testbed
