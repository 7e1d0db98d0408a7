// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree merge FILE…`: the JSON lines of the shards of one run, joined as an unsharded run would have written them.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "testbed/base/case_lines.h"
#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/output.h"
#include "testbed/base/standard_error.h"
#include "testbed/cli/commands.h"

namespace testbed {

namespace {

struct MergeArguments {
    std::vector<std::string> files;
    std::string output;
};

int RunMerge(const MergeArguments& arguments) {
    std::vector<CaseFile> files;
    for (const std::string& name : arguments.files)
        files.push_back({name, ReadText(name, "give one that --json wrote")});
    const MergedLines merged = MergeCaseLines(files);
    if (arguments.output.empty()) {
        std::fwrite(merged.text.data(), 1, merged.text.size(), stdout);
    } else {
        WriteTextFile(arguments.output, merged.text);
    }
    if (merged.missing.empty()) return exitDone;
    PrintError("scree: {} of {} cases are in no file, the first is case {}: did every shard finish?\n",
               merged.missing.size(), merged.caseCount, merged.missing.front());
    return exitDiffers;
}

}  // namespace

void AddMergeCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("merge", "Join the --json files of the shards of one run");
    auto arguments = std::make_shared<MergeArguments>();
    command->add_option("FILE", arguments->files, "Files of JSON lines, in any order")->required();
    command->add_option("-o,--output", arguments->output, "Write here instead of to stdout")->type_name("FILE");
    command->footer("Exits with 1 when cases are missing, with 4 when the files are not of one run.");
    command->callback([&request, arguments] { request.action = [arguments] { return RunMerge(*arguments); }; });
}

}  // namespace testbed
