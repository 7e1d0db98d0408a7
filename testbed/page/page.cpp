// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A Page as one HTML file: every kind of block becomes markup, and the sections stand within page.html, page.css and
// page.js.

#include "testbed/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "testbed/base/input.h"
#include "testbed/base/output.h"
#include "testbed/page/page_markup.h"
#include "testbed_generated/page_sources.h"

namespace testbed {

namespace {

std::string_view GetToneName(PageTone tone) {
    switch (tone) {
        case PageTone::good:
            return "good";
        case PageTone::bad:
            return "bad";
        case PageTone::warning:
            return "warning";
        case PageTone::muted:
            return "muted";
        case PageTone::plain:
            break;
    }
    return "";
}

/// What stands before a coloured value, for those who do not see the colour.
std::string_view GetSign(PageTone tone) {
    switch (tone) {
        case PageTone::good:
            return R"(<span class="sign" role="img" aria-label="good">✓</span>)";
        case PageTone::bad:
            return R"(<span class="sign" role="img" aria-label="bad">✗</span>)";
        case PageTone::warning:
            return R"(<span class="sign" role="img" aria-label="warning">!</span>)";
        default:
            return "";
    }
}

/// ` class="a b"`, empty words left out.
std::string MakeClass(std::initializer_list<std::string_view> names) {
    std::string text;
    for (const std::string_view name : names) {
        if (!name.empty()) text += (text.empty() ? "" : " ") + std::string(name);
    }
    return text.empty() ? "" : " class=\"" + text + "\"";
}

std::string MakeElement(std::string_view name, std::string_view className, std::string_view text) {
    if (text.empty()) return "";
    return fmt::format("<{0}{1}>{2}</{0}>\n", name, MakeClass({className}), EscapeHtml(text));
}

std::string MakeTitleAttribute(std::string_view hint) {
    return hint.empty() ? "" : " title=\"" + EscapeHtml(hint) + "\"";
}

/// Markup of blocks. Keeps the names that are used up, because ids must differ within a page.
class BlockWriter {
public:
    /// Lower-case letters and digits of the title, joined by hyphens; numbered when taken.
    std::string MakeId(std::string_view title) {
        std::string stem;
        for (const char c : title) {
            const auto byte = static_cast<unsigned char>(c);
            if (std::isalnum(byte) != 0 && byte < 128) {
                stem += static_cast<char>(std::tolower(byte));
            } else if (!stem.empty() && stem.back() != '-') {
                stem += '-';
            }
        }
        while (!stem.empty() && stem.back() == '-') stem.pop_back();
        if (stem.empty()) stem = "part";
        std::string id = stem;
        for (int number = 2; !m_ids.insert(id).second; ++number) id = fmt::format("{}-{}", stem, number);
        return id;
    }

    std::string operator()(const PageText& block) { return MakeParagraphs(block.text); }
    std::string operator()(const PageHtml& block) { return block.html + "\n"; }

    std::string operator()(const PageNote& block) {
        return fmt::format("<div{} role=\"note\">{}</div>\n", MakeClass({"remark", GetToneName(block.tone)}),
                           MakeParagraphs(block.text));
    }

    std::string operator()(const PageCode& block) {
        return fmt::format("<div class=\"code\"><pre>{}</pre><button type=\"button\">Copy</button></div>\n",
                           EscapeHtml(block.text));
    }

    std::string operator()(const PageTiles& block) {
        std::string html = "<div class=\"tiles\">\n";
        for (const PageTile& tile : block.tiles) {
            html += fmt::format("<div{}>", MakeClass({"tile", GetToneName(tile.tone)}));
            html += fmt::format("<div class=\"label\">{}</div>", EscapeHtml(tile.label));
            html += fmt::format("<div class=\"value\">{}{}", GetSign(tile.tone), EscapeHtml(tile.value));
            if (!tile.unit.empty()) html += fmt::format("<span class=\"unit\">{}</span>", EscapeHtml(tile.unit));
            html += "</div>";
            if (!tile.note.empty()) html += fmt::format("<div class=\"note\">{}</div>", EscapeHtml(tile.note));
            html += "</div>\n";
        }
        return html + "</div>\n";
    }

    std::string operator()(const PageFigures& block) {
        std::string html = "<div class=\"figures\"";
        if (block.columns > 0) html += fmt::format(" style=\"--columns: {}\"", block.columns);
        html += ">\n";
        for (const PageFigure& figure : block.figures) html += MakeFigure(figure);
        return html + "</div>\n";
    }

    std::string operator()(const PageTable& block) {
        const std::string id = MakeId(block.title.empty() ? "table" : block.title);
        std::string html = MakeElement("h3", "block-title", block.title);
        if (block.filter) {
            html += fmt::format(
                "<div class=\"filter\"><input type=\"search\" placeholder=\"Filter rows\" aria-label=\"Filter rows\" "
                "aria-controls=\"{0}\"><output>{1} of {1}</output></div>\n",
                id, block.rows.size());
        }
        html +=
            fmt::format("<div class=\"table-box\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table id=\"{}\">\n",
                        EscapeHtml(block.title.empty() ? "table" : block.title), id);
        html += MakeHead(block) + "<tbody>\n";
        for (const std::vector<PageCell>& row : block.rows) {
            if (row.size() != block.columns.size()) {
                throw std::invalid_argument(
                    fmt::format("table {}: a row of {} cells under {} columns", id, row.size(), block.columns.size()));
            }
            html += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i) html += MakeCell(row[i], block.columns[i]);
            html += "</tr>\n";
        }
        html += "</tbody></table></div>\n";
        return html + MakeElement("p", "caption", block.caption);
    }

    /// Whether a figure came with its data.
    [[nodiscard]] bool HasPlots() const { return m_hasPlots; }

private:
    std::string MakeFigure(const PageFigure& figure) {
        const std::string alternative = EscapeHtml(figure.alternative.empty() ? figure.title : figure.alternative);
        if (figure.svg.empty() && figure.file.empty()) {
            throw std::invalid_argument(fmt::format("figure {}: neither svg nor file", figure.title));
        }
        std::string picture;
        if (const bool isFile = figure.svg.empty(); isFile && figure.file.extension() != ".svg") {
            picture = fmt::format("<img src=\"{}\" alt=\"{}\">", MakeDataUri(figure.file), alternative);
        } else {
            std::string svg = isFile ? ReadText(figure.file, "draw it again") : figure.svg;
            const std::string data = TakePlotData(svg);
            picture = fmt::format("<img class=\"plot\" src=\"{}\" alt=\"{}\">", MakeSvgUri(svg), alternative);
            if (!data.empty()) picture += fmt::format("<script type=\"application/json\">{}</script>", data);
            m_hasPlots = m_hasPlots || !data.empty();
        }
        return fmt::format("<figure>{}{}\n{}</figure>\n", MakeElement("h3", "", figure.title), picture,
                           MakeElement("figcaption", "caption", figure.caption));
    }

    static std::string MakeHead(const PageTable& table) {
        std::string groups, names;
        bool hasGroups = false;
        for (std::size_t i = 0; i < table.columns.size();) {
            std::size_t end = i + 1;
            const std::string& group = table.columns[i].group;
            while (end < table.columns.size() && table.columns[end].group == group) ++end;
            hasGroups = hasGroups || !group.empty();
            groups += fmt::format("<th class=\"group\" colspan=\"{}\">{}</th>", end - i, EscapeHtml(group));
            i = end;
        }
        for (const PageColumn& column : table.columns) {
            names += fmt::format("<th scope=\"col\" aria-sort=\"none\"{}{}><button type=\"button\">{}",
                                 MakeClass({column.numeric ? "number" : ""}), MakeTitleAttribute(column.hint),
                                 EscapeHtml(column.name));
            if (!column.unit.empty()) names += fmt::format("<span class=\"unit\">{}</span>", EscapeHtml(column.unit));
            names += "</button></th>";
        }
        return fmt::format("<thead>{}<tr>{}</tr></thead>\n", hasGroups ? "<tr>" + groups + "</tr>" : "", names);
    }

    static std::string MakeCell(const PageCell& cell, const PageColumn& column) {
        std::string text = EscapeHtml(cell.text);
        if (!cell.link.empty()) text = fmt::format("<a href=\"{}\">{}</a>", EscapeHtml(cell.link), text);
        const std::string value = cell.value.has_value() ? fmt::format(" data-v=\"{}\"", *cell.value) : "";
        return fmt::format("<td{}{}{}>{}{}</td>", MakeClass({column.numeric ? "number" : "", GetToneName(cell.tone)}),
                           value, MakeTitleAttribute(cell.hint), GetSign(cell.tone), text);
    }

    std::set<std::string> m_ids{"content"};
    bool m_hasPlots = false;
};

std::string MakeSection(const PageSection& section, const std::string& id, BlockWriter& writer) {
    std::string html;
    if (section.folded) {
        html += fmt::format("<details class=\"section\" id=\"{}\"><summary>{}</summary>\n", id,
                            EscapeHtml(section.title.empty() ? "Details" : section.title));
    } else {
        html += fmt::format("<section id=\"{}\">\n", id) + MakeElement("h2", "", section.title);
    }
    html += MakeParagraphs(section.intro);
    for (const PageBlock& block : section.blocks) html += std::visit(writer, block);
    return html + (section.folded ? "</details>\n" : "</section>\n");
}

std::string MakeFacts(const std::vector<PageFact>& facts) {
    if (facts.empty()) return "";
    std::string html = "<footer><dl>\n";
    for (const PageFact& fact : facts) {
        html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", EscapeHtml(fact.name), EscapeHtml(fact.value));
    }
    return html + "</dl></footer>\n";
}

/// The frame with its {{names}} filled in. One pass, so that a value that holds such a name stays as it is.
std::string FillFrame(std::string_view frame, const std::vector<std::pair<std::string_view, std::string>>& values) {
    std::string text;
    for (;;) {
        const std::size_t begin = frame.find("{{"), end = frame.find("}}", begin);
        text += frame.substr(0, begin);
        if (begin == std::string_view::npos) return text;
        const std::string_view name = frame.substr(begin + 2, end - begin - 2);
        for (const auto& [key, value] : values) {
            if (key == name) text += value;
        }
        frame.remove_prefix(end + 2);
    }
}

}  // namespace

PageCell PageCell::Number(double number, int decimals, PageTone tone) {
    PageCell cell;
    cell.tone = tone;
    if (!std::isfinite(number)) {
        cell.text = "–";
        return cell;
    }
    cell.value = number;
    cell.text = fmt::format("{:.{}f}", std::abs(number), decimals);
    const std::size_t point = std::min(cell.text.find('.'), cell.text.size());
    for (std::size_t at = point; at > 3; at -= 3) cell.text.insert(at - 3, ",");
    if (number < 0 && cell.text.find_first_not_of("0.,") != std::string::npos) cell.text.insert(0, "−");
    return cell;
}

std::string MakePage(const Page& page) {
    for (const std::string* source : {&page.style, &page.script}) {
        if (source->find("</") != std::string::npos) {
            throw std::invalid_argument(fmt::format("page {}: \"</\" would end its style or script", page.title));
        }
    }
    BlockWriter writer;
    std::string sections, contents;
    int titled = 0;
    for (const PageSection& section : page.sections) {
        const std::string id = writer.MakeId(section.title);
        sections += MakeSection(section, id, writer);
        if (section.title.empty()) continue;
        ++titled;
        contents += fmt::format("<a href=\"#{}\">{}</a>\n", id, EscapeHtml(section.title));
    }
    if (titled < 3) contents.clear();
    if (!contents.empty()) contents = "<nav class=\"contents\" aria-label=\"Contents\">\n" + contents + "</nav>\n";

    // The library only where it serves; with "use strict" behind it, it keeps its own rules.
    const std::string script =
        writer.HasPlots() ? std::string(page_sources::chartJs) + "\n" + page_sources::figureJs : "";
    return FillFrame(page_sources::pageHtml, {{"title", EscapeHtml(page.title)},
                                              {"style", page_sources::pageCss + page.style},
                                              {"intro", MakeParagraphs(page.intro)},
                                              {"contents", contents},
                                              {"sections", sections},
                                              {"facts", MakeFacts(page.facts)},
                                              {"script", script + page_sources::pageJs + page.script}});
}

void WritePage(const std::filesystem::path& path, const Page& page) { WriteTextFile(path, MakePage(page)); }

}  // namespace testbed
