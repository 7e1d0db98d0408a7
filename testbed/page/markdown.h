// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A report's page as Markdown, for documents: its text, key figures, tables and notes without the pictures and what is
// folded away. The last line holds a digest of all before it, so that numbers which were typed instead of measured are
// seen.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "testbed/page/page.h"

namespace testbed {

[[nodiscard]] std::string MakeMarkdown(const Page& page);
/// Writes it whole. Throws FileError.
void WriteMarkdown(const std::filesystem::path& path, const Page& page);

/// Whether a text is as MakeMarkdown made it.
[[nodiscard]] bool IsUnedited(std::string_view markdown);

}  // namespace testbed
