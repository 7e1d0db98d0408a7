// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text and files as they stand in an HTML page.

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace testbed {

/// For text between tags and in quoted attributes.
[[nodiscard]] std::string EscapeHtml(std::string_view text);

/// Paragraphs at empty lines, code in back quotes; escaped. Empty text: nothing.
[[nodiscard]] std::string MakeParagraphs(std::string_view text);

/// RFC 4648, with padding.
[[nodiscard]] std::string EncodeBase64(std::span<const unsigned char> bytes);

/// "data:image/png;base64,…" of a .png or .svg file. Throws FileError for one that cannot be read or is neither.
[[nodiscard]] std::string MakeDataUri(const std::filesystem::path& file);

/// "data:image/svg+xml;base64,…".
[[nodiscard]] std::string MakeSvgUri(std::string_view svg);

/// An SVG document with data of a plot inside, in an element that viewers pass over.
[[nodiscard]] std::string PutPlotData(std::string svg, std::string_view json);
/// Takes such data out of the document again; empty: there are none.
[[nodiscard]] std::string TakePlotData(std::string& svg);

/// JSON that may stand in a script element: no "</" or "<!--" is left in it.
[[nodiscard]] std::string ProtectJson(std::string json);

}  // namespace testbed
