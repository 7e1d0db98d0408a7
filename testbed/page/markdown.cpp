// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of markdown.h.

#include "testbed/page/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <variant>

#include "testbed/base/hash.h"
#include "testbed/base/new_file.h"

namespace testbed {

namespace {

constexpr std::string_view digestMark = "<!-- digest ";

std::string MakeDigestLine(std::string_view text) {
    Fnv1a<std::uint64_t> hash;
    hash.Add(text);
    return fmt::format("{}{:016x} -->\n", digestMark, hash.Get());
}

/// A cell of a table: what would end it is escaped.
std::string Escape(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c == '\n' ? ' ' : c;
    }
    return escaped;
}

std::string NameColumn(const PageColumn& column) {
    std::string name = column.group.empty() ? column.name : column.group + ": " + column.name;
    if (!column.unit.empty()) name += ", " + column.unit;
    return Escape(name);
}

struct BlockPrinter {
    std::string& text;

    void operator()(const PageText& block) const { text += block.text + "\n\n"; }
    void operator()(const PageNote& block) const { text += "> " + block.text + "\n\n"; }
    void operator()(const PageCode& block) const { text += "```\n" + block.text + "\n```\n\n"; }
    void operator()(const PageHtml&) const {}     // belongs to a script
    void operator()(const PageFigures&) const {}  // stand beside the page
    void operator()(const PageTiles& block) const {
        for (const PageTile& tile : block.tiles) {
            fmt::format_to(std::back_inserter(text), "- {}: **{}{}**{}\n", tile.label, tile.value, tile.unit,
                           tile.note.empty() ? "" : " (" + tile.note + ")");
        }
        text += '\n';
    }
    void operator()(const PageTable& block) const {
        if (!block.title.empty()) text += "### " + block.title + "\n\n";
        std::string head = "|", line = "|";
        for (const PageColumn& column : block.columns) {
            head += " " + NameColumn(column) + " |";
            line += column.numeric ? "---:|" : "---|";
        }
        text += head + "\n" + line + "\n";
        for (const std::vector<PageCell>& row : block.rows) {
            text += "|";
            for (const PageCell& cell : row) text += " " + Escape(cell.text) + " |";
            text += "\n";
        }
        text += "\n";
        if (!block.caption.empty()) text += block.caption + "\n\n";
    }
};

/// Only a page shows what such a section has.
bool HasOnlyFigures(const PageSection& section) {
    return !section.blocks.empty() && std::ranges::all_of(section.blocks, [](const PageBlock& block) {
        return std::holds_alternative<PageFigures>(block) || std::holds_alternative<PageHtml>(block);
    });
}

}  // namespace

std::string MakeMarkdown(const Page& page) {
    std::string text = fmt::format("# {}\n\n", page.title);
    if (!page.intro.empty()) text += page.intro + "\n\n";
    for (const PageFact& fact : page.facts) {
        const bool isCommand = fact.name == "command";
        text += fmt::format("- {}: {}\n", fact.name, isCommand ? "`" + fact.value + "`" : fact.value);
    }
    if (!page.facts.empty()) text += "\n";
    for (const PageSection& section : page.sections) {
        if (section.folded || HasOnlyFigures(section)) continue;
        if (!section.title.empty()) text += "## " + section.title + "\n\n";
        if (!section.intro.empty()) text += section.intro + "\n\n";
        for (const PageBlock& block : section.blocks) std::visit(BlockPrinter{text}, block);
    }
    text += "This file was written by the command above; a test finds changes by hand.\n";
    return text + MakeDigestLine(text);
}

void WriteMarkdown(const std::filesystem::path& path, const Page& page) { WriteTextFile(path, MakeMarkdown(page)); }

bool IsUnedited(std::string_view markdown) {
    const std::size_t mark = markdown.rfind(digestMark);
    return mark != std::string_view::npos && markdown.substr(mark) == MakeDigestLine(markdown.substr(0, mark));
}

}  // namespace testbed
