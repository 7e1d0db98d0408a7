// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A report as one HTML file that needs nothing beside it. A Page is filled with sections of text, key figures, tables,
// figures and notes; WritePage makes the file, with its style, script and pictures inside. Every report has the look of
// page.css: light and dark, and colours that do not depend on telling red from green.
//
//     Page page{.title = "Bench", .intro = "All scenes, both engines, one thread."};
//     PageTable table{.columns = {{.name = "scene"}, {.name = "total", .unit = "ms", .numeric = true}}};
//     table.rows.push_back({"tiles", PageCell::Number(312.4, 1)});
//     page.sections.push_back({.title = "Totals", .blocks = {table}});
//     WritePage(folder / "index.html", page);

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace testbed {

// Every member has a default, so that a designated initialiser names only what it needs. All text is plain UTF-8 and
// escaped on the way out. In intro, text and note: `back quotes` set code, an empty line begins a new paragraph.

/// How a value is to be taken. Shown by colour and by a sign, never by colour alone.
enum class PageTone { plain, good, bad, warning, muted };

struct PageCell {
    std::string text{};             ///< as shown
    std::optional<double> value{};  ///< what a numeric column sorts by; none: empty or not a number, sorted last
    PageTone tone = PageTone::plain;
    std::string hint{};  ///< shown on hover
    std::string link{};  ///< "#id" of a section or a path relative to the page

    PageCell() = default;
    PageCell(std::string shown) : text(std::move(shown)) {}  // NOLINT: rows are written as lists of words
    PageCell(const char* shown) : text(shown) {}             // NOLINT

    /// "1,234.5": fixed decimals, thousands separated. Not finite: "–", sorted last.
    [[nodiscard]] static PageCell Number(double number, int decimals = 0, PageTone tone = PageTone::plain);
};

struct PageColumn {
    std::string name{};
    std::string unit{};    ///< under the name: "ms", "×"
    bool numeric = false;  ///< right-aligned, tabular digits, sorted by PageCell::value
    std::string hint{};    ///< what it means, on hover of the head
    std::string group{};   ///< neighbours of one group stand under a common head: "Box2D", "scree"
};

/// Sortable by a click on (or Enter in) a column's head; the order of `rows` is the first one.
struct PageTable {
    std::string title{};
    std::string caption{};  ///< under the table, small
    std::vector<PageColumn> columns{};
    std::vector<std::vector<PageCell>> rows{};  ///< each as long as `columns`
    bool filter = false;                        ///< a field above it that hides the rows without the typed words
};

/// A plot or a picture; figures that stand in one PageFigures share the width.
struct PageFigure {
    std::string title{};
    std::string caption{};
    std::string svg{};             ///< a whole <svg> document such as gnuplot's; its lightness is inverted in the dark
    std::filesystem::path file{};  ///< or: a .png or .svg file, embedded
    std::string alternative{};     ///< what it shows, for those who cannot see it; empty: the title
};

struct PageFigures {
    std::vector<PageFigure> figures{};
    int columns = 0;  ///< at most so many side by side; 0: as many as fit at a readable size
};

/// One key figure.
struct PageTile {
    std::string label{};
    std::string value{};
    std::string unit{};
    std::string note{};  ///< small, below: what it is compared with
    PageTone tone = PageTone::plain;
};

struct PageTiles {
    std::vector<PageTile> tiles{};
};

/// What a reader must know, set apart from the text.
struct PageNote {
    std::string text{};
    PageTone tone = PageTone::plain;
};

struct PageText {
    std::string text{};
};

/// A command or program text, in a box with a button that copies it.
struct PageCode {
    std::string text{};
};

/// Finished markup, for reports that have a script of their own. The only block that is not escaped.
struct PageHtml {
    std::string html{};
};

using PageBlock = std::variant<PageText, PageTiles, PageTable, PageFigures, PageNote, PageCode, PageHtml>;

struct PageSection {
    std::string title{};  ///< empty: no head and no entry in the list of contents
    std::string intro{};
    std::vector<PageBlock> blocks{};
    bool folded = false;  ///< behind its title, for long details
};

/// How the report came about: "command", "machine", "commit".
struct PageFact {
    std::string name{}, value{};
};

struct Page {
    std::string title{};
    std::string intro{};
    std::vector<PageFact> facts{};  ///< at the foot
    std::vector<PageSection> sections{};
    std::string style{}, script{};  ///< added to those of every page; may not contain "</"
};

/// The page as text. Throws FileError for a figure's file that cannot be read. Throws std::invalid_argument for a row
/// that is not as long as its columns, a figure with neither svg nor file, and a style or script with "</".
[[nodiscard]] std::string MakePage(const Page& page);

/// Writes it whole (temporary name, then rename). Throws FileError, and what MakePage throws.
void WritePage(const std::filesystem::path& path, const Page& page);

}  // namespace testbed
