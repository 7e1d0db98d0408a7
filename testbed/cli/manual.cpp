// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of manual.h.

#include "testbed/cli/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace testbed {

namespace {

/// Text as roff shows it: no character of it is a command.
std::string Escape(std::string_view text) {
    std::string escaped;
    bool isLineStart = true;
    for (const char c : text) {
        if (isLineStart && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\') {
            escaped += "\\e";
        } else if (c == '-') {
            escaped += "\\-";
        } else {
            escaped += c;
        }
        isLineStart = c == '\n';
    }
    return escaped;
}

std::string Heading(const std::string& page, const std::string& version) {
    std::string capitals = page;
    std::ranges::transform(capitals, capitals.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
    // No date: the page of one version is always the same.
    return fmt::format(".TH \"{}\" 1 \"\" \"scree {}\" \"scree\"\n", Escape(capitals), Escape(version));
}

std::string Name(const std::string& page, const std::string& what) {
    return fmt::format(".SH NAME\n{} \\- {}\n", Escape(page), Escape(what));
}

/// One option or argument, in the words of --help.
std::string Describe(const CLI::Option& option, bool isArgument) {
    const CLI::Formatter formatter;
    return fmt::format(".TP\n.B {}{}\n{}\n", Escape(formatter.make_option_name(&option, isArgument)),
                       Escape(formatter.make_option_opts(&option)), Escape(formatter.make_option_desc(&option)));
}

std::string DescribeOptions(const CLI::App& app) {
    std::string text;
    for (const std::string& group : app.get_groups()) {
        const auto options = app.get_options([&](const CLI::Option* option) {
            return option->get_group() == group && option->nonpositional() && !group.empty();
        });
        if (options.empty()) continue;
        text += group == "Options" ? ".SH OPTIONS\n" : fmt::format(".SH \"{}\"\n", Escape(group));
        for (const CLI::Option* option : options) text += Describe(*option, false);
    }
    return text;
}

std::string DescribeArguments(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* one) { return one->get_positional(); })) {
        text += Describe(*option, true);
    }
    return text.empty() ? text : ".SH ARGUMENTS\n" + text;
}

std::string Footer(const CLI::App& app) { return ".SH \"EXIT STATUS\"\n" + Escape(app.get_footer()) + "\n"; }

ManualPage PageOfCommand(const CLI::App& program, const CLI::App& command, const std::string& version) {
    const std::string page = program.get_name() + "-" + command.get_name();
    std::string synopsis = fmt::format("{} {}", program.get_name(), command.get_name());
    for (const CLI::Option* option :
         command.get_options([](const CLI::Option* one) { return one->get_positional(); })) {
        const std::string name = option->get_name(true);
        synopsis += option->get_required() ? " " + name : " [" + name + "]";
    }
    return {page + ".1", Heading(page, version) + Name(page, command.get_description()) +
                             fmt::format(".SH SYNOPSIS\n.B {} [OPTIONS]\n", Escape(synopsis)) +
                             DescribeArguments(command) + DescribeOptions(command) + Footer(command) +
                             fmt::format(".SH \"SEE ALSO\"\n.BR {} (1)\n", Escape(program.get_name()))};
}

}  // namespace

std::vector<ManualPage> MakeManual(const CLI::App& program, const std::string& version) {
    std::string commands;
    std::vector<ManualPage> pages(1);
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        commands += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", Escape(program.get_name()), Escape(command->get_name()),
                                Escape(command->get_description()));
        pages.push_back(PageOfCommand(program, *command, version));
    }
    const std::string name = program.get_name();
    std::string what = program.get_description();
    if (what.starts_with(name + ": ")) what.erase(0, name.size() + 2);
    pages.front() = {name + ".1", Heading(name, version) + Name(name, what) +
                                      fmt::format(".SH SYNOPSIS\n.B {} COMMAND [OPTIONS]\n", Escape(name)) +
                                      ".SH COMMANDS\n" + commands + DescribeOptions(program) + Footer(program)};
    return pages;
}

}  // namespace testbed
