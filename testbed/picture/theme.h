// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The colours of pictures, for dark and for light backgrounds: `--theme dark|light`. The common forms of colour
// blindness keep these hues apart; some are lightened on dark. They are the eight of Okabe and Ito, "Color universal
// design: how to make figures and presentations that are friendly to colorblind people", 2008
// (jfly.uni-koeln.de/color).

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "testbed/picture/image.h"

namespace testbed {

enum class Theme : uint8_t { dark, light };

/// "dark" or "light"; throws std::invalid_argument naming them for anything else.
[[nodiscard]] Theme ParseTheme(std::string_view text);
[[nodiscard]] const char* GetThemeName(Theme theme);

/// Of a fixture: what fills it and its edge. Both are translucent, so that counts under bodies are seen.
struct Look {
    Color fill, border;
};

struct ThemeColors {
    Color background;
    Color strip, text, faintText;  ///< of labels
    Look awake, sleeping, isStatic, kinematic, bullet, sensor;
    Color contact, normal, impulse, joint, velocity, tightBox, sweptBox, fattenedBox, label;
    /// What has no order or no end takes these in turn: islands, levels, solver colours.
    std::array<Color, 7> cycle;
};

[[nodiscard]] const ThemeColors& GetTheme(Theme theme);

}  // namespace testbed
