// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The program `scree`.

#include "testbed/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/base/new_file.h"
#include "testbed/base/standard_error.h"
#include "testbed/cli/commands.h"
#include "testbed/engines/provenance.h"
#include "testbed/engines/run_spec.h"
#include "testbed/jobs/bench/commands.h"
#include "testbed/jobs/extremes/commands.h"
#include "testbed/jobs/files/commands.h"
#include "testbed/jobs/find/commands.h"
#include "testbed/jobs/overlap/commands.h"
#include "testbed/jobs/requires/commands.h"
#include "testbed/jobs/snapshot/commands.h"
#include "testbed/jobs/timeline/commands.h"
#include "testbed/jobs/tradeoff/commands.h"
#include "testbed/jobs/window/commands.h"
#include "testbed/page/gnuplot.h"

namespace testbed {

namespace {

int Fail(int code, std::string_view message) {
    PrintError("scree: {}\n", message);
    return code;
}

/// The subcommand that was parsed, else the program itself.
const CLI::App& ChosenApp(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? app : *chosen.front();
}

/// An option that is a key of --set, where there is one: "; did you mean '--set KEY=VALUE'?", or nothing.
std::string SuggestSetting(const std::vector<std::string>& known, const std::string& option) {
    if (std::ranges::find(known, "--set") == known.end()) return {};
    for (const SettingKey& key : GetSettingKeys()) {
        if ("--" + std::string(key.name) == option) return fmt::format("; did you mean '--set {}=VALUE'?", key.name);
    }
    return {};
}

/// What is wrong with words that the parser could not place.
std::string DescribeExtras(const CLI::App& app) {
    const std::vector<std::string> extras = app.remaining(true);
    const CLI::App& chosen = ChosenApp(app);
    for (const std::string& word : extras) {
        if (!word.starts_with('-') || word == "-") continue;
        const std::string name = word.substr(0, word.find('='));
        std::vector<std::string> names;
        for (const CLI::Option* option : chosen.get_options()) {
            for (const std::string& known : option->get_lnames()) names.push_back("--" + known);
        }
        const std::vector<std::string_view> views(names.begin(), names.end());
        std::string suggestion = SuggestSetting(names, name);
        if (suggestion.empty()) suggestion = SuggestName(name, views);
        return fmt::format("unknown option '{}'{} `{} --help` shows all", name, suggestion.empty() ? ";" : suggestion,
                           &chosen == &app ? "scree" : "scree " + chosen.get_name());
    }
    if (&chosen != &app) return fmt::format("scree {}: too many arguments: {}", chosen.get_name(), extras.front());
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return DescribeUnknown("command", extras.front(), std::vector<std::string_view>(names.begin(), names.end()));
}

/// What is wrong with a value that its option could not read.
std::string DescribeNoNumber(const CLI::App& chosen, const CLI::ConversionError& error) {
    for (const CLI::Option* option : chosen.get_options()) {
        if (std::string_view(error.what()) !=
            fmt::format("Could not convert: {} = {}", option->get_name(), fmt::join(option->results(), ","))) {
            continue;
        }
        return fmt::format("{} {}: that is not a {}", option->get_name(), fmt::join(option->results(), " "),
                           option->get_type_name() == "FLOAT" ? "number" : "whole number, or too large");
    }
    return error.what();
}

/// Whether an option or an argument asks for a file on standard output.
bool NamesStandardOutput(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (option->results() == std::vector<std::string>{"-"}) return true;
    }
    return std::ranges::any_of(app.get_subcommands(),
                               [](const CLI::App* chosen) { return NamesStandardOutput(*chosen); });
}

/// One line for every kind of failure; each kind has its exit code.
int RunAction(const Request& request) {
    try {
        const int code = request.action();
        CheckStandardOutput();
        return code;
    } catch (const BackendError& error) {
        return Fail(exitNoBackend, error.what());
    } catch (const FileError& error) {
        return Fail(exitIo, error.what());
    } catch (const ToolError& error) {
        return Fail(exitIo, error.what());
    } catch (const UsageError& error) {
        return Fail(exitUsage, error.what());
    } catch (const std::invalid_argument& error) {
        return Fail(exitUsage, error.what());
    } catch (const std::out_of_range& error) {
        return Fail(exitUsage, error.what());
    } catch (const std::bad_alloc&) {
        return Fail(exitIo, "out of memory; choose a smaller --size or --image");
    } catch (const std::system_error& error) {
        if (std::ferror(stdout) == 0) return Fail(exitIo, error.what());
        return Fail(exitIo, "cannot write to standard output: " + error.code().message());
    } catch (const std::exception& error) {
        return Fail(exitIo, error.what());
    }
}

/// A command that says more about its exit codes says it before what all commands share.
void CompleteFooters(CLI::App& app) {
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
        if (command->get_footer() != app.get_footer()) {
            command->footer(command->get_footer() + "\n\n" + app.get_footer());
        }
    }
}

void Parse(CLI::App& app, const std::vector<std::string>& arguments) {
    // CLI11 takes the words last first.
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
}

}  // namespace

int RunCommandLine(const std::vector<std::string>& arguments, const ContextOptions& contextOptions) {
    CLI::App app("scree: physics engines side by side, without a screen", "scree");
    app.set_version_flag("--version", [] {
        const Provenance provenance = FindProvenance();
        return fmt::format("scree {}, commit {}", SCREE_VERSION, provenance.commit);
    });
    app.require_subcommand(0, 1);
    app.footer(
        "Exit codes: 0 done, 1 something differs, was missed or was found, 2 wrong usage, 3 no usable GL backend\n"
        "or display, 4 a file or folder failed, 77 no backend with --skip-missing-backend.");
    Request request{arguments, contextOptions, {}};
    AddListCommand(app, request);
    AddInfoCommand(app, request);
    AddConvertCommand(app, request);
    AddFindCommand(app, request);
    AddTimelineCommand(app, request);
    AddOverlapCommand(app, request);
    AddRenderCommand(app, request);
    AddMetricsCommand(app, request);
    AddBenchCommand(app, request);
    AddSnapshotCommand(app, request);
    AddDiffCommand(app, request);
    AddMergeCommand(app, request);
    AddViewCommand(app, request);
    AddTradeoffCommand(app, request);
    AddExtremesCommand(app, request);
    AddRequiresCommand(app, request);
    AddEnvCommand(app, request);
    AddManCommand(app, request);
    CompleteFooters(app);
    try {
        Parse(app, arguments);
    } catch (const CLI::Success& success) {  // --help, --version
        std::ostringstream text;
        const int code = app.exit(success, text, text);
        return RunAction({arguments, contextOptions, [&] {
                              fmt::print("{}", text.str());
                              return code;
                          }});
    } catch (const CLI::ExtrasError&) {
        return Fail(exitUsage, DescribeExtras(app));
    } catch (const CLI::ConversionError& error) {
        return Fail(exitUsage, DescribeNoNumber(ChosenApp(app), error));
    } catch (const CLI::ParseError& error) {
        return Fail(exitUsage, error.what());
    }
    if (!request.action) {
        PrintError("{}", app.help());
        return exitUsage;
    }
    if (NamesStandardOutput(app)) GiveStandardOutputToFiles();
    return RunAction(request);
}

}  // namespace testbed
