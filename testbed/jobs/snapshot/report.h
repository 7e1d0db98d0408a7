// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where the results of a comparison go: the report folder (actual/, expected/, diff/, results.json and index.html),
// JUnit XML,
// `::error` annotations for CI, and lines for a reader.

#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "testbed/jobs/snapshot/result.h"
#include "testbed/picture/image.h"

namespace testbed {

/// The file of all results in a report.
inline constexpr const char* resultsName = "results.json";

/// One comparison as files: what is left of it in the report folder.
struct ReportedPair {
    const Image* expected = nullptr;  ///< null: there is none
    const Image* actual = nullptr;
    std::string expectedSidecar, actualSidecar;  ///< empty: none
};

class SnapshotReport {
public:
    /// Creates the folder; actual/, expected/ and diff/ of an earlier report in it (it has a results.json) are removed.
    /// Throws FileError.
    explicit SnapshotReport(std::filesystem::path folder);

    /// Writes the files of a result that is not equal or whose state changed, and enters their names into it.
    void Add(SnapshotResult& result, const ReportedPair& pair);
    /// Copies the files of a result of another report.
    void Copy(const SnapshotResult& result, const std::filesystem::path& from);
    /// Writes results.json and the page that shows all this; returns the page's path.
    std::filesystem::path Finish(const SnapshotOrigin& origin, std::span<const SnapshotResult> results);
    [[nodiscard]] const std::filesystem::path& GetFolder() const { return m_folder; }

private:
    std::filesystem::path m_folder;
};

/// One test case per picture, grouped by scene.
[[nodiscard]] std::string WriteJunit(const std::string& suite, std::span<const SnapshotResult> results);

/// A line `::error file=…,title=…::message` per result that is not equal; `folder` holds the references.
[[nodiscard]] std::string FormatAnnotations(std::span<const SnapshotResult> results, const std::string& folder);

/// "changed  tiles/step-0090-bvh: 12 pixels …", a line with the cure below when there is one.
[[nodiscard]] std::string FormatResult(const SnapshotResult& result);

/// "170 equal, 1 changed, 1 missing": only what there is.
[[nodiscard]] std::string FormatCounts(std::span<const SnapshotResult> results);

/// What a comparison of pixels says in words: "12 pixels differ by up to 255, in x 10..29, y 20..39".
[[nodiscard]] std::string DescribePixels(const SnapshotResult& result);

}  // namespace testbed
