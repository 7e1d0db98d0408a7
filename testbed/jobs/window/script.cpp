// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of script.h.

#include "testbed/jobs/window/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "testbed/base/text.h"

namespace testbed {

namespace {

constexpr int maxFrame = 1'000'000;

constexpr std::array<std::string_view, 10> verbs = {"move", "press", "release", "click",      "scroll",
                                                    "key",  "hold",  "let",     "screenshot", "dump"};
constexpr std::array<std::pair<std::string_view, int>, 17> keyNames{{{"space", key::space},
                                                                     {"escape", key::escape},
                                                                     {"enter", key::enter},
                                                                     {"tab", key::tab},
                                                                     {"backspace", key::backspace},
                                                                     {"delete", key::del},
                                                                     {"left", key::left},
                                                                     {"right", key::right},
                                                                     {"up", key::up},
                                                                     {"down", key::down},
                                                                     {"home", key::home},
                                                                     {"end", key::end},
                                                                     {"f12", key::f12},
                                                                     {"shift", key::leftShift},
                                                                     {"control", key::leftControl},
                                                                     {"alt", key::leftAlt},
                                                                     {"super", key::leftSuper}}};
constexpr std::array<std::string_view, 3> buttonNames = {"left", "right", "middle"};

[[noreturn]] void Refuse(const ScriptLine& line, const std::string& problem) {
    throw std::invalid_argument(fmt::format("script line {}: {}", line.number, problem));
}

/// Nothing where the line is shorter.
std::string_view GetWord(const ScriptLine& line, size_t word) {
    return word < line.words.size() ? std::string_view(line.words[word]) : std::string_view();
}

float GetFloat(const ScriptLine& line, size_t word) {
    const Parsed<float> value = ParseNumber<float>(GetWord(line, word));
    if (!value) Refuse(line, fmt::format("'{}' needs a number as word {}: {}", line.verb, word + 1, value.problem));
    return *value;
}

int GetKey(const ScriptLine& line) {
    if (line.words.size() != 1) Refuse(line, fmt::format("'{}' needs the name of one key", line.verb));
    const std::string& name = line.words[0];
    if (name.size() == 1) return std::toupper(static_cast<unsigned char>(name[0]));
    for (const auto& [known, code] : keyNames) {
        if (name == known) return code;
    }
    std::string message = fmt::format("unknown key '{}': use a character, or", name);
    for (const auto& [known, code] : keyNames) message += " " + std::string(known);
    Refuse(line, message);
}

int GetButton(const ScriptLine& line) {
    if (line.words.empty()) return 0;
    const auto found = std::ranges::find(buttonNames, line.words[0]);
    if (found == buttonNames.end()) {
        Refuse(line, fmt::format("unknown button '{}': use left, right or middle", line.words[0]));
    }
    return static_cast<int>(found - buttonNames.begin());
}

InputEvent MakeMove(float x, float y) { return {InputEvent::Kind::move, x, y, 0, false}; }
InputEvent MakeButton(int button, bool isDown) { return {InputEvent::Kind::button, 0, 0, button, isDown}; }
InputEvent MakeKey(int code, bool isDown) { return {InputEvent::Kind::key, 0, 0, code, isDown}; }

const EnginePane& GetPane(const ScriptLine& line, const Viewer& viewer) {
    if (line.words.size() < 2) Refuse(line, "name a pane");
    for (const EnginePane& pane : viewer.panes) {
        if (pane.name == line.words[1]) return pane;
    }
    Refuse(line, fmt::format("pane '{}' is not shown", line.words[1]));
}

InputEvent MoveToWorld(const Viewer& viewer, const EnginePane& pane, double x, double y) {
    const Camera camera = GetCamera(viewer, pane);
    return MakeMove(static_cast<float>(camera.ToPixelX(x) + pane.area.x0),
                    static_cast<float>(camera.ToPixelY(y) + pane.area.y0));
}

/// "X Y", "item NAME [SHARE OF ITS WIDTH]", "world PANE X Y", "body PANE INDEX [DX DY]".
InputEvent ResolveMove(const ScriptLine& line, const Viewer& viewer, const Items& items) {
    if (line.words.empty()) Refuse(line, "'move' needs a place");
    const std::string& kind = line.words[0];
    if (kind == "item") {
        if (line.words.size() < 2) Refuse(line, "name an item");
        const auto found = items.find(line.words[1]);
        if (found == items.end()) Refuse(line, fmt::format("there is no item '{}' on the picture", line.words[1]));
        const ItemBox& box = found->second;
        const float share = line.words.size() > 2 ? GetFloat(line, 2) : 0.5f;
        return MakeMove(box.x0 + share * (box.x1 - box.x0), (box.y0 + box.y1) / 2);
    }
    if (kind == "world") {
        return MoveToWorld(viewer, GetPane(line, viewer), double{GetFloat(line, 2)}, double{GetFloat(line, 3)});
    }
    if (kind == "body") {
        const EnginePane& pane = GetPane(line, viewer);
        const Parsed<int> index = ParseNumber<int>(GetWord(line, 2));
        if (!index || *index < 0 || *index >= static_cast<int>(pane.snapshot.bodies.size())) {
            Refuse(line, "there is no body of that index");
        }
        const Vec2 at = pane.snapshot.bodies[static_cast<size_t>(*index)].position;
        const float dx = line.words.size() > 3 ? GetFloat(line, 3) : 0,
                    dy = line.words.size() > 3 ? GetFloat(line, 4) : 0;
        return MoveToWorld(viewer, pane, double{at.x + dx}, double{at.y + dy});
    }
    return MakeMove(GetFloat(line, 0), GetFloat(line, 1));
}

}  // namespace

std::vector<ScriptLine> ParseScript(std::string_view text) {
    std::vector<ScriptLine> lines;
    std::istringstream stream{std::string(text)};
    int number = 0;
    for (std::string row; std::getline(stream, row);) {
        ++number;
        std::istringstream words(row.substr(0, row.find('#')));
        ScriptLine line;
        line.number = number;
        std::string first;
        if (!(words >> first)) continue;
        const Parsed<int> frame = ParseNumber<int>(first);
        if (!frame) Refuse(line, "begin it with the number of a frame: " + frame.problem);
        if (*frame < 0 || *frame > maxFrame) Refuse(line, "begin it with the number of a frame");
        line.frame = *frame;
        if (!lines.empty() && line.frame < lines.back().frame)
            Refuse(line, "its frame comes before that of the last line");
        words >> line.verb;
        for (std::string word; words >> word;) line.words.push_back(word);
        if (line.verb != "text" && std::ranges::find(verbs, line.verb) == verbs.end()) {
            Refuse(line, fmt::format("unknown event '{}': use text, {}", line.verb, fmt::join(verbs, ", ")));
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

int ScriptPlayer::GetLastFrame() const { return m_lines.empty() ? -1 : m_lines.back().frame + 1; }

ScriptFrame ScriptPlayer::Play(int frame, const Viewer& viewer, const Items& items) {
    ScriptFrame result;
    result.events = std::exchange(m_releases, {});
    for (; m_next < m_lines.size() && m_lines[m_next].frame <= frame; ++m_next) {
        PlayLine(m_lines[m_next], viewer, items, result);
    }
    return result;
}

void ScriptPlayer::PlayLine(const ScriptLine& line, const Viewer& viewer, const Items& items, ScriptFrame& frame) {
    const auto add = [&](const InputEvent& event) { frame.events.push_back(event); };
    if (line.verb == "move") {
        add(ResolveMove(line, viewer, items));
    } else if (line.verb == "press" || line.verb == "release") {
        add(MakeButton(GetButton(line), line.verb == "press"));
    } else if (line.verb == "click") {
        add(MakeButton(GetButton(line), true));
        m_releases.push_back(MakeButton(GetButton(line), false));
    } else if (line.verb == "scroll") {
        add({InputEvent::Kind::scroll, 0, GetFloat(line, 0), 0, false});
    } else if (line.verb == "hold" || line.verb == "let") {
        add(MakeKey(GetKey(line), line.verb == "hold"));
    } else if (line.verb == "key") {
        add(MakeKey(GetKey(line), true));
        m_releases.push_back(MakeKey(GetKey(line), false));
    } else if (line.verb == "text") {
        for (const char c : fmt::format("{}", fmt::join(line.words, " "))) {
            add({InputEvent::Kind::text, 0, 0, static_cast<unsigned char>(c), false});
        }
    } else {
        if (line.words.size() != 1) Refuse(line, fmt::format("'{}' needs the name of one file", line.verb));
        frame.outputs.push_back({line.verb == "screenshot", line.words[0]});
    }
}

}  // namespace testbed
