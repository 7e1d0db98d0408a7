// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree diff A B`: two pictures, or two folders of pictures, by the comparison that snapshots use.

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/json_print.h"
#include "testbed/jobs/snapshot/commands.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/jobs/snapshot/report.h"
#include "testbed/jobs/snapshot/structure.h"
#include "testbed/picture/image_compare.h"
#include "testbed/picture/png.h"

namespace testbed {

namespace {

namespace fs = std::filesystem;

struct DiffArguments {
    std::string first, second, output;
    int tolerance = -1;  ///< none given
};

/// One picture on each side; an empty path where there is none.
struct DiffPair {
    std::string id;
    fs::path first, second;
};

std::set<std::string> ListPictures(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || entry.path().extension() != ".png") continue;
        names.insert(fs::relative(entry.path(), folder).replace_extension().generic_string());
    }
    return names;
}

std::vector<DiffPair> FindPairs(const fs::path& first, const fs::path& second) {
    for (const fs::path& path : {first, second}) {
        if (!fs::exists(path)) throw FileError(fmt::format("{} does not exist", path.string()));
    }
    if (fs::is_directory(first) != fs::is_directory(second)) {
        throw UsageError(fmt::format("diff {} {}: give two pictures or two folders", first.string(), second.string()));
    }
    if (!fs::is_directory(first)) return {{first.stem().string(), first, second}};
    const std::set<std::string> firstNames = ListPictures(first), secondNames = ListPictures(second);
    std::set<std::string> all = firstNames;
    all.insert(secondNames.begin(), secondNames.end());
    std::vector<DiffPair> pairs;
    for (const std::string& name : all) {
        pairs.push_back({name, firstNames.contains(name) ? first / (name + ".png") : fs::path(),
                         secondNames.contains(name) ? second / (name + ".png") : fs::path()});
    }
    return pairs;
}

Reference ReadSide(const fs::path& picture) {
    if (picture.empty()) return {};
    // The name of a picture need not end in .png; its sidecar stands beside it as a reference's does.
    Reference side;
    if (picture.extension() == ".png") side = ReadReference(picture.parent_path(), picture.stem().string());
    if (!side.hasImage) side.image = ReadPng(picture);
    side.hasImage = true;
    return side;
}

void Judge(SnapshotResult& result, const Reference& first, const Reference& second, int tolerance) {
    result.rule = first.rule;
    if (tolerance >= 0) {
        result.rule.tolerance = tolerance;
        result.rule.source = "--tolerance";
        result.rule.reason = "as given";
    }
    if (first.sidecar.contains("structure") && second.sidecar.contains("structure")) {
        const auto change = CompareStructures(first.sidecar["structure"], second.sidecar["structure"]);
        if (!change["equal"].get<bool>()) result.structure = PrintJson(change);
    }
    const Image &a = first.image, &b = second.image;
    if (a.width != b.width || a.height != b.height) {
        result.status = SnapshotStatus::size;
        result.message = fmt::format("{}x{} against {}x{} pixels", a.width, a.height, b.width, b.height);
        return;
    }
    result.pixels = ComparePixels(a, b, result.rule);
    result.status = result.pixels.changed == 0 ? SnapshotStatus::equal : SnapshotStatus::changed;
    result.message = DescribePixels(result);
}

SnapshotResult ComparePair(const DiffPair& pair, int tolerance, std::optional<SnapshotReport>& report) {
    const auto start = std::chrono::steady_clock::now();
    SnapshotResult result;
    result.id = pair.id;
    const Reference first = ReadSide(pair.first), second = ReadSide(pair.second);
    if (pair.first.empty()) {
        result.status = SnapshotStatus::added;
        result.message = "only in the second folder";
    } else if (pair.second.empty()) {
        result.status = SnapshotStatus::deleted;
        result.message = "only in the first folder";
    } else {
        Judge(result, first, second, tolerance);
    }
    result.compareMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (report) {
        report->Add(result, {.expected = first.hasImage ? &first.image : nullptr,
                             .actual = second.hasImage ? &second.image : nullptr,
                             .expectedSidecar = first.hasSidecar ? FormatSidecar(first.sidecar) : "",
                             .actualSidecar = second.hasSidecar ? FormatSidecar(second.sidecar) : ""});
    }
    return result;
}

int RunDiff(const DiffArguments& arguments) {
    if (arguments.tolerance > 255) throw UsageError("--tolerance: 0 to 255");
    const std::vector<DiffPair> pairs = FindPairs(arguments.first, arguments.second);
    if (pairs.empty()) throw UsageError("diff: neither folder has a .png file");
    std::optional<SnapshotReport> report;
    if (!arguments.output.empty()) report.emplace(arguments.output);
    std::vector<SnapshotResult> results;
    for (const DiffPair& pair : pairs) {
        results.push_back(ComparePair(pair, arguments.tolerance, report));
        results.back().number = results.size() - 1;
        if (results.back().status != SnapshotStatus::equal || pairs.size() == 1) {
            fmt::print("{}", FormatResult(results.back()));
        }
    }
    std::filesystem::path page;
    if (report) page = report->Finish({"scree diff", "", "", "", pairs.size()}, results);
    if (pairs.size() > 1) fmt::print("{} pictures: {}\n", pairs.size(), FormatCounts(results));
    if (report) fmt::print("report: {}\n", page.string());
    return IsClean(results) ? exitDone : exitDiffers;
}

}  // namespace

void AddDiffCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("diff", "Compare two pictures or two folders of pictures, pixel by pixel");
    auto arguments = std::make_shared<DiffArguments>();
    command->add_option("A", arguments->first, "The expected picture (PNG), or a folder of them")->required();
    command->add_option("B", arguments->second, "The actual picture (PNG), or a folder of them")->required();
    command
        ->add_option("-o,--output", arguments->output,
                     "Folder for index.html, actual/, expected/, diff/ and results.json")
        ->type_name("DIR");
    command
        ->add_option(
            "--tolerance", arguments->tolerance,
            "Largest difference of a channel that does not count, 0..255; without it, the rule in A's sidecar, "
            "else 0")
        ->check(CLI::NonNegativeNumber);
    command->callback([&request, arguments] { request.action = [arguments] { return RunDiff(*arguments); }; });
}

}  // namespace testbed
