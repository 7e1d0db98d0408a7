// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Glyphs are rasterised once, by stb_truetype, when they are first used. It computes in floats without contraction, and
// the coverage is rounded to 16 steps: a picture keeps few colours, and its file stays small.

#include "testbed/picture/font.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "testbed/base/text.h"
#include "testbed/picture/composite.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

extern "C" {
extern const unsigned char screeFontBytes[];  // the file of the font
}

namespace testbed {

namespace {

/// Of one size: coverage 0…255 per pixel, the box's place from the pen at the baseline, and how far the pen moves.
struct Glyph {
    int left = 0, top = 0, width = 0, height = 0, advance = 0;
    std::vector<uint8_t> coverage;
};

constexpr int coverageSteps = 15;

uint8_t RoundCoverage(uint8_t coverage) {
    return static_cast<uint8_t>((coverage * coverageSteps + 127) / 255 * (255 / coverageSteps));
}

/// Leaves out empty rows and columns at the edges.
void TrimGlyph(Glyph& glyph) {
    int x0 = glyph.width, y0 = glyph.height, x1 = 0, y1 = 0;
    const auto at = [&glyph](int x, int y) { return glyph.coverage[static_cast<size_t>(y * glyph.width + x)]; };
    for (int y = 0; y < glyph.height; ++y) {
        for (int x = 0; x < glyph.width; ++x) {
            if (at(x, y) == 0) continue;
            x0 = std::min(x0, x), y0 = std::min(y0, y);
            x1 = std::max(x1, x + 1), y1 = std::max(y1, y + 1);
        }
    }
    Glyph trimmed{glyph.left + x0, glyph.top + y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0), glyph.advance, {}};
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) trimmed.coverage.push_back(at(x, y));
    }
    glyph = std::move(trimmed);
}

/// Sum of the squares of the coverage over its sum: the larger, the fewer pixels are half covered.
double MeasureSharpness(const std::vector<uint8_t>& coverage) {
    double sum = 0, squares = 0;
    for (const uint8_t value : coverage) {
        sum += value;
        squares += value * value;
    }
    return sum > 0 ? squares / sum : 0;
}

class Font {
public:
    Font() {
        if (stbtt_InitFont(&m_info, screeFontBytes, stbtt_GetFontOffsetForIndex(screeFontBytes, 0)) == 0)
            throw std::logic_error("the font in the program is damaged");
        m_capital = static_cast<float>(GetBox(stbtt_FindGlyphIndex(&m_info, 'H')).y1);
    }

    /// Valid as long as the font.
    const Glyph& Find(char32_t character, int scale) {
        const int index = stbtt_FindGlyphIndex(&m_info, static_cast<int>(character));
        const auto [place, isNew] = m_glyphs.try_emplace({index, scale});
        if (isNew) place->second = Rasterize(index, scale);
        return place->second;
    }

private:
    /// Of a few positions between pixels, the one at which stems meet the pixels best.
    Glyph Rasterize(int index, int scale) const {
        const float size = static_cast<float>(capHeight * scale) / m_capital;
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&m_info, index, &advance, &bearing);
        // What stands on the baseline stays there; a dash need not.
        const bool isRaised = static_cast<float>(GetBox(index).y0) > m_capital / 10;
        Glyph best;
        double bestSharpness = -1;
        for (const int up : {0, -1, 1, -2, 2, -3, 3, 4}) {
            if (up != 0 && !isRaised) break;
            for (const int right : {0, -1, 1, -2, 2, -3, 3, 4}) {
                Glyph glyph = RasterizeAt(index, size, static_cast<float>(right) / 8, static_cast<float>(up) / 8);
                const double sharpness = MeasureSharpness(glyph.coverage);
                if (sharpness <= bestSharpness) continue;
                bestSharpness = sharpness;
                best = std::move(glyph);
            }
        }
        best.advance = static_cast<int>(std::lround(static_cast<float>(advance) * size));
        for (uint8_t& value : best.coverage) value = RoundCoverage(value);
        TrimGlyph(best);
        return best;
    }

    [[nodiscard]] Glyph RasterizeAt(int index, float size, float shiftX, float shiftY) const {
        Glyph glyph;
        int right = 0, bottom = 0;
        stbtt_GetGlyphBitmapBoxSubpixel(&m_info, index, size, size, shiftX, shiftY, &glyph.left, &glyph.top, &right,
                                        &bottom);
        glyph.width = right - glyph.left;
        glyph.height = bottom - glyph.top;
        glyph.coverage.resize(static_cast<size_t>(glyph.width) * static_cast<size_t>(glyph.height));
        if (!glyph.coverage.empty()) {
            stbtt_MakeGlyphBitmapSubpixel(&m_info, glyph.coverage.data(), glyph.width, glyph.height, glyph.width, size,
                                          size, shiftX, shiftY, index);
        }
        return glyph;
    }

    /// In the font's units, y up.
    [[nodiscard]] PixelBox GetBox(int index) const {
        PixelBox box{0, 0, 0, 0};
        stbtt_GetGlyphBox(&m_info, index, &box.x0, &box.y0, &box.x1, &box.y1);
        return box;
    }

    stbtt_fontinfo m_info{};
    float m_capital = 1;                            ///< height of capitals in the font's units
    std::map<std::pair<int, int>, Glyph> m_glyphs;  ///< by index in the font and scale
};

struct PlacedGlyph {
    const Glyph* glyph;
    int x;  ///< of its first column, from the line's first
};

struct TextLine {
    std::vector<PlacedGlyph> glyphs;
    int width = 0;
};

/// The one place where glyphs are put beside each other.
TextLine PlaceGlyphs(std::string_view text, int scale) {
    static std::mutex mutex;
    static Font font;
    const std::lock_guard lock(mutex);
    TextLine line;
    int pen = 0, begin = std::numeric_limits<int>::max(), end = std::numeric_limits<int>::min();
    while (!text.empty()) {
        const Glyph& glyph = font.Find(TakeUtf8(text), scale);
        if (glyph.width > 0) {
            line.glyphs.push_back({&glyph, pen + glyph.left});
            begin = std::min(begin, pen + glyph.left);
            end = std::max(end, pen + glyph.left + glyph.width);
        }
        pen += glyph.advance;
    }
    for (PlacedGlyph& placed : line.glyphs) placed.x -= begin;
    if (!line.glyphs.empty()) line.width = end - begin;
    return line;
}

void DrawGlyph(Image& image, int x, int y, const Glyph& glyph, Color color) {
    const uint8_t* coverage = glyph.coverage.data();
    for (int row = y; row < y + glyph.height; ++row) {
        for (int column = x; column < x + glyph.width; ++column, ++coverage) {
            const bool isInside = column >= 0 && column < image.width && row >= 0 && row < image.height;
            if (isInside && *coverage > 0) BlendPixel(image.At(column, row), color, *coverage);
        }
    }
}

}  // namespace

int GetTextWidth(std::string_view text, int scale) { return PlaceGlyphs(text, scale).width; }

void DrawText(Image& image, int x, int y, std::string_view text, int scale, Color color) {
    for (const PlacedGlyph& placed : PlaceGlyphs(text, scale).glyphs) {
        DrawGlyph(image, x + placed.x, y + capHeight * scale + placed.glyph->top, *placed.glyph, color);
    }
}

std::string CutText(std::string_view text, int scale, int width) {
    if (GetTextWidth(text, scale) <= width) return std::string(text);
    std::vector<std::string_view> beginnings{text.substr(0, 0)};
    for (std::string_view rest = text; !rest.empty();) {
        (void)TakeUtf8(rest);
        beginnings.push_back(text.substr(0, text.size() - rest.size()));
    }
    for (; !beginnings.empty(); beginnings.pop_back()) {
        std::string cut(beginnings.back());
        while (cut.ends_with(' ')) cut.pop_back();
        cut += "…";
        if (GetTextWidth(cut, scale) <= width) return cut;
    }
    return {};
}

}  // namespace testbed
