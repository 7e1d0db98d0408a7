// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text and files as they stand in an HTML page.

#include "testbed/page/page_markup.h"
#include "testbed/base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <vector>

namespace testbed {

namespace {

constexpr std::string_view dataBegin = "<metadata id=\"scree-plot\">", dataEnd = "</metadata>\n";

}  // namespace

namespace {

/// One paragraph's text: every second piece between back quotes is code.
std::string MakeInline(std::string_view text) {
    std::string html;
    bool isCode = false;
    for (;;) {
        const std::size_t quote = text.find('`');
        html += EscapeHtml(text.substr(0, quote));
        if (quote == std::string_view::npos) break;
        html += isCode ? "</code>" : "<code>";
        isCode = !isCode;
        text.remove_prefix(quote + 1);
    }
    return isCode ? html + "</code>" : html;
}

}  // namespace

std::string EscapeHtml(std::string_view text) {
    std::string html;
    html.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string MakeParagraphs(std::string_view text) {
    std::string html;
    while (!text.empty()) {
        const std::size_t end = text.find("\n\n");
        const std::string_view paragraph = text.substr(0, end);
        if (!paragraph.empty()) html += "<p>" + MakeInline(paragraph) + "</p>\n";
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    }
    return html;
}

std::string EncodeBase64(std::span<const unsigned char> bytes) {
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string MakeDataUri(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending != ".png" && ending != ".svg") {
        throw FileError(fmt::format("cannot embed {}: only .png and .svg pictures are known", file.string()));
    }
    std::ifstream stream(file, std::ios::binary);
    const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream || bytes.empty()) throw FileError(fmt::format("cannot read {} to embed it in a page", file.string()));
    return (ending == ".png" ? "data:image/png;base64," : "data:image/svg+xml;base64,") + EncodeBase64(bytes);
}

std::string MakeSvgUri(std::string_view svg) {
    return "data:image/svg+xml;base64," + EncodeBase64(std::vector<unsigned char>(svg.begin(), svg.end()));
}

std::string PutPlotData(std::string svg, std::string_view json) {
    std::string data(dataBegin);
    for (const char c : json) {
        // Only strings have these, and any character of a string may be written so.
        if (c == '<' || c == '>' || c == '&') {
            data += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            data += c;
        }
    }
    const std::size_t end = svg.rfind("</svg>");
    if (end != std::string::npos) svg.insert(end, data + std::string(dataEnd));
    return svg;
}

std::string TakePlotData(std::string& svg) {
    const std::size_t begin = svg.find(dataBegin);
    const std::size_t end = begin == std::string::npos ? begin : svg.find(dataEnd, begin);
    if (end == std::string::npos) return {};
    const std::string json = svg.substr(begin + dataBegin.size(), end - begin - dataBegin.size());
    svg.erase(begin, end + dataEnd.size() - begin);
    return json;
}

std::string ProtectJson(std::string json) {
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at)) {
        json.replace(at, 1, "\\u003c");
    }
    return json;
}

}  // namespace testbed
