// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box filter and grid.

#include "testbed/view/contact_sheet.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "testbed/picture/font.h"
#include "testbed/view/annotate.h"

namespace testbed {

namespace {

constexpr int gap = 6;  // pixels around a small picture

/// As many columns as rows, or one more.
int GetColumns(int count) {
    int columns = 1;
    while (columns * columns < count) ++columns;
    return columns;
}

int GetThumbnailWidth(int columns, int width) { return (width - gap * (columns + 1)) / columns; }

Color MeanOf(const Image& image, const PixelBox& box) {
    std::array<uint64_t, 4> sums{};
    for (int y = box.y0; y < box.y1; ++y) {
        for (int x = box.x0; x < box.x1; ++x) {
            const Color& color = image.At(x, y);
            sums[0] += color.r;
            sums[1] += color.g;
            sums[2] += color.b;
            sums[3] += color.a;
        }
    }
    const auto count = static_cast<uint64_t>(box.x1 - box.x0) * static_cast<uint64_t>(box.y1 - box.y0);
    const auto mean = [count](uint64_t sum) { return static_cast<uint8_t>((sum + count / 2) / count); };
    return {mean(sums[0]), mean(sums[1]), mean(sums[2]), mean(sums[3])};
}

}  // namespace

Image ShrinkImage(const Image& image, int width, int height) {
    if (width < 1 || height < 1 || width > image.width || height > image.height) {
        throw std::invalid_argument("a picture is shrunk to at least one pixel and at most its own size");
    }
    const auto split = [](int i, int parts, int whole) {
        return static_cast<int32_t>(static_cast<int64_t>(i) * whole / parts);
    };
    Image small(width, height, {});
    for (int y = 0; y < height; ++y) {
        const int32_t y0 = split(y, height, image.height), y1 = split(y + 1, height, image.height);
        for (int x = 0; x < width; ++x) {
            small.At(x, y) = MeanOf(image, {split(x, width, image.width), y0, split(x + 1, width, image.width), y1});
        }
    }
    return small;
}

bool ContactSheet::Fits(int count, int width) { return GetThumbnailWidth(GetColumns(count), width) >= minThumbnail; }

ContactSheet::ContactSheet(int count, int width, Theme theme)
    : m_columns(GetColumns(count)),
      m_width(width),
      m_thumbnailWidth(GetThumbnailWidth(m_columns, width)),
      m_theme(theme) {
    if (count < 1 || !Fits(count, width)) throw std::invalid_argument("too many pictures for one sheet");
}

void ContactSheet::Add(const Image& image, const std::string& label) {
    const int width = std::min(m_thumbnailWidth, image.width);
    const int height = m_cells.empty() ? std::max(1, image.height * width / image.width) : m_cells[0].image.height;
    m_cells.push_back({ShrinkImage(image, width, height), label});
}

Image ContactSheet::Make() const {
    if (m_cells.empty()) throw std::logic_error("a sheet without pictures");
    const ThemeColors& colors = GetTheme(m_theme);
    const int scale = GetLabelScale(2 * m_thumbnailWidth), labelHeight = GetStripHeight(1, scale);
    const int cellHeight = m_cells[0].image.height + labelHeight + gap;
    const int rows = (static_cast<int>(m_cells.size()) + m_columns - 1) / m_columns;
    Image sheet(m_width, gap + rows * cellHeight, colors.strip);
    for (int i = 0; i < static_cast<int>(m_cells.size()); ++i) {
        const Cell& cell = m_cells[static_cast<size_t>(i)];
        const int x = gap + i % m_columns * (m_thumbnailWidth + gap);
        const int y = gap + i / m_columns * cellHeight;
        for (int row = 0; row < cell.image.height; ++row) {
            std::copy_n(&cell.image.At(0, row), cell.image.width, &sheet.At(x, y + row));
        }
        const int textScale = FitScale(cell.label, scale, m_thumbnailWidth);
        DrawText(sheet, x, y + cell.image.height + 3 * scale, CutText(cell.label, textScale, m_thumbnailWidth),
                 textScale, colors.text);
    }
    return sheet;
}

}  // namespace testbed
