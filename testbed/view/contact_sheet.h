// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Many pictures on one: a grid of small copies, each with a line of text under it.

#pragma once

#include <string>
#include <vector>

#include "testbed/picture/image.h"
#include "testbed/picture/theme.h"

namespace testbed {

/// Each pixel the mean of those it covers, in integers; both sides at least 1 and at most the picture's.
[[nodiscard]] Image ShrinkImage(const Image& image, int width, int height);

class ContactSheet {
public:
    /// Least width of a small picture, pixels; Fits tells whether `count` pictures get it on a sheet of `width`.
    static constexpr int minThumbnail = 96;
    [[nodiscard]] static bool Fits(int count, int width);

    /// For `count` ≥ 1 pictures on a sheet `width` pixels wide; std::invalid_argument when they do not fit.
    ContactSheet(int count, int width, Theme theme);

    /// The first picture decides the height of all cells; further ones are of its size.
    void Add(const Image& image, const std::string& label);
    /// As high as the rows in use need.
    [[nodiscard]] Image Make() const;

private:
    struct Cell {
        Image image;
        std::string label;
    };
    int m_columns, m_width, m_thumbnailWidth;
    Theme m_theme;
    std::vector<Cell> m_cells;
};

}  // namespace testbed
