// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Where the results of a comparison go.

#include "testbed/jobs/snapshot/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/output.h"
#include "testbed/jobs/snapshot/page.h"
#include "testbed/picture/image_compare.h"
#include "testbed/picture/png.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// The five characters that XML reserves.
std::string EscapeXml(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&apos;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

/// What the runner's commands reserve in a message.
std::string EscapeAnnotation(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '%':
                escaped += "%25";
                break;
            case '\r':
                escaped += "%0D";
                break;
            case '\n':
                escaped += "%0A";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

SnapshotSide WriteSide(OutputFolder& output, const std::string& stem, const Image& image, const std::string& sidecar) {
    SnapshotSide side{stem + ".png", {}, image.width, image.height};
    WriteImage(output, side.image, image);
    if (!sidecar.empty()) {
        side.sidecar = stem + ".json";
        output.WriteText(side.sidecar, sidecar);
    }
    return side;
}

std::string FolderOf(const SnapshotResult& result) {
    return result.scene.empty() ? fs::path(result.id).parent_path().generic_string() : result.scene;
}

}  // namespace

SnapshotReport::SnapshotReport(fs::path folder) : m_folder(std::move(folder)) {
    const OutputFolder probe(m_folder);
    if (!fs::exists(m_folder / resultsName)) return;
    for (const char* name : {"actual", "expected", "diff"}) {
        std::error_code error;
        fs::remove_all(m_folder / name, error);
        if (error) throw FileError(fmt::format("cannot remove {}: {}", (m_folder / name).string(), error.message()));
    }
}

void SnapshotReport::Add(SnapshotResult& result, const ReportedPair& pair) {
    if (result.status == SnapshotStatus::equal && !result.isStateChanged) return;
    OutputFolder output(m_folder);
    if (pair.expected != nullptr) {
        result.expected = WriteSide(output, "expected/" + result.id, *pair.expected, pair.expectedSidecar);
    }
    if (pair.actual != nullptr) {
        result.actual = WriteSide(output, "actual/" + result.id, *pair.actual, pair.actualSidecar);
    }
    if (result.status != SnapshotStatus::changed) return;
    result.difference = "diff/" + result.id + ".png";
    WriteImage(output, result.difference, MakeDifferencePicture(*pair.expected, *pair.actual, result.rule));
}

void SnapshotReport::Copy(const SnapshotResult& result, const fs::path& from) {
    OutputFolder output(m_folder);
    const auto copy = [&](const std::string& name) {
        if (!name.empty()) output.WriteText(name, ReadText(from / name, "copy the whole report again"));
    };
    for (const std::optional<SnapshotSide>& side : {result.expected, result.actual}) {
        if (!side) continue;
        copy(side->image);
        copy(side->sidecar);
    }
    copy(result.difference);
}

fs::path SnapshotReport::Finish(const SnapshotOrigin& origin, std::span<const SnapshotResult> results) {
    WriteTextFile(m_folder / resultsName, WriteResults(origin, results));
    return WriteSnapshotPage(m_folder, origin, results);
}

std::string WriteJunit(const std::string& suite, std::span<const SnapshotResult> results) {
    const auto failures =
        std::ranges::count_if(results, [](const auto& r) { return r.status != SnapshotStatus::equal; });
    double total = 0;
    std::string cases;
    for (const SnapshotResult& result : results) {
        const double seconds = (result.simulateMs + result.renderMs + result.compareMs) / 1000;
        total += seconds;
        cases += fmt::format(R"(  <testcase classname="{}" name="{}" time="{:.4f}")", EscapeXml(FolderOf(result)),
                             EscapeXml(result.id), seconds);
        if (result.status == SnapshotStatus::equal) {
            cases += "/>\n";
            continue;
        }
        cases += fmt::format(">\n    <failure type=\"{}\" message=\"{}\">{}</failure>\n  </testcase>\n",
                             GetStatusName(result.status), EscapeXml(result.message), EscapeXml(result.update));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" time=\"{:.4f}\">\n{}</testsuite>\n",
        EscapeXml(suite), results.size(), failures, total, cases);
}

std::string FormatAnnotations(std::span<const SnapshotResult> results, const std::string& folder) {
    std::string text;
    for (const SnapshotResult& result : results) {
        if (result.status == SnapshotStatus::equal) continue;
        const std::string cure = result.update.empty() ? "" : "; to accept: " + result.update;
        text += fmt::format("::error file={}/{}.png,title=snapshot {}::{}\n", folder, result.id,
                            GetStatusName(result.status), EscapeAnnotation(result.id + ": " + result.message + cure));
    }
    return text;
}

std::string FormatResult(const SnapshotResult& result) {
    std::string text = fmt::format("{:<8} {}: {}\n", GetStatusName(result.status), result.id, result.message);
    if (!result.update.empty()) text += fmt::format("         to accept: {}\n", result.update);
    return text;
}

std::string FormatCounts(std::span<const SnapshotResult> results) {
    std::array<int, snapshotStatusNames.size()> counts{};
    for (const SnapshotResult& result : results) ++counts[static_cast<std::size_t>(result.status)];
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[i], snapshotStatusNames[i]);
    }
    return text.empty() ? "nothing compared" : text;
}

std::string DescribePixels(const SnapshotResult& result) {
    const PixelDifference& pixels = result.pixels;
    const PixelArea& box = pixels.box;
    std::string text = pixels.changed == 0 ? std::string("no pixel differs")
                                           : fmt::format("{} {} by up to {}, in x {}..{}, y {}..{}", pixels.changed,
                                                         pixels.changed == 1 ? "pixel differs" : "pixels differ",
                                                         pixels.maxDifference, box.x0, box.x1 - 1, box.y0, box.y1 - 1);
    if (pixels.tolerated > 0) text += fmt::format("; {} within tolerance {}", pixels.tolerated, result.rule.tolerance);
    if (pixels.masked > 0) text += fmt::format("; {} under the mask", pixels.masked);
    if (result.rule.source != "default")
        text += fmt::format(" (rule of {}: {})", result.rule.source, result.rule.reason);
    return text;
}

}  // namespace testbed
