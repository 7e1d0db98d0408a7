// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of reference.h.

#include "testbed/cli/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "testbed/engines/run_spec.h"

namespace testbed {

namespace {

void Replace(std::string& text, std::string_view what, std::string_view with) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
}

/// Text in a cell of a table: outside of `code` nothing is markup.
std::string Cell(std::string text) {
    Replace(text, "\n" + DescribeSettingKeys(), " [how a scene is run](settings.md)");
    while (text.ends_with('\n')) text.pop_back();
    std::string cell;
    bool isCode = false;
    for (const char c : text) {
        if (c == '`') isCode = !isCode;
        if (c == '|' || (!isCode && (c == '*' || c == '_'))) cell += '\\';
        if (c == '\n') {
            cell += "<br>";
        } else if (c == '<' && !isCode) {
            cell += "&lt;";
        } else {
            cell += c;
        }
    }
    return cell;
}

std::string Code(const std::string& text) {
    std::string escaped = text;
    Replace(escaped, "|", "\\|");
    return escaped.empty() ? "" : "`" + escaped + "`";
}

/// An option's name and what it takes, without the default, which has a column of its own.
std::string NameAndValue(const CLI::Option& option, bool isArgument) {
    const CLI::Formatter formatter;
    std::string takes = formatter.make_option_opts(&option);
    const std::string usual = option.get_default_str();
    if (!usual.empty()) Replace(takes, "=" + usual, "");
    return formatter.make_option_name(&option, isArgument) + takes;
}

std::string Row(const CLI::Option& option, bool isArgument) {
    const CLI::Formatter formatter;
    return fmt::format("| {} | {} | {} |\n", Code(NameAndValue(option, isArgument)), Code(option.get_default_str()),
                       Cell(formatter.make_option_desc(&option)));
}

std::string Table(const std::string& title, const std::vector<const CLI::Option*>& options, bool areArguments) {
    if (options.empty()) return {};
    std::string text = fmt::format("\n| {} | default | what |\n|---|---|---|\n", title);
    for (const CLI::Option* option : options) text += Row(*option, areArguments);
    return text;
}

/// "Exit codes: 0 done, 1 ...": a row each.
std::string ExitCodes(std::string text) {
    Replace(text, "\n", " ");
    if (text.ends_with('.')) text.pop_back();
    std::string rows = "| exit code | meaning |\n|---|---|\n";
    for (auto at = text.find_first_of("0123456789"); at < text.size();) {
        auto end = at;
        do {
            end = std::min(text.find(", ", end + 1), text.size());
        } while (end + 2 < text.size() && (text[end + 2] < '0' || text[end + 2] > '9'));
        const auto space = text.find(' ', at);
        rows += fmt::format("| {} | {} |\n", text.substr(at, space - at), text.substr(space + 1, end - space - 1));
        at = end + 2;
    }
    return rows;
}

std::string DescribeCommand(const CLI::App& program, const CLI::App& command) {
    std::string usage = program.get_name() + " " + command.get_name() + " [OPTIONS]";
    const auto arguments = command.get_options([](const CLI::Option* option) { return option->get_positional(); });
    for (const CLI::Option* option : arguments) {
        const CLI::Formatter formatter;
        usage += " " + formatter.make_option_usage(option);
    }
    std::string text = fmt::format("\n## {} {}\n\n{}.\n\n```\n{}\n```\n", program.get_name(), command.get_name(),
                                   command.get_description(), usage);
    text += Table("argument", arguments, true);
    for (const std::string& group : command.get_groups()) {
        if (group.empty()) continue;
        text += Table(group == "Options" ? "option" : group, command.get_options([&](const CLI::Option* option) {
            return option->get_group() == group && option->nonpositional();
        }),
                      false);
    }
    const std::string& footer = command.get_footer();
    const auto own = footer.find("\n\n" + program.get_footer());
    return own == std::string::npos ? text : text + "\n" + footer.substr(0, own) + "\n";
}

}  // namespace

std::string MakeCommandReference(const CLI::App& program) {
    const std::string name = program.get_name();
    std::string text = fmt::format(
        "<!-- Written by `{0} man --reference FILE`; not edited by hand. -->\n\n# The command line\n\n"
        "`{0} COMMAND --help` prints the same. Settings that `--set` takes stand in [how a scene is "
        "run](settings.md).\n\n"
        "{1}\n| command | what |\n|---|---|\n",
        name, ExitCodes(program.get_footer()));
    const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* command : commands) {
        text +=
            fmt::format("| [{0} {1}](#{0}-{1}) | {2} |\n", name, command->get_name(), Cell(command->get_description()));
    }
    text += Table("option of the program", program.get_options([](const CLI::Option*) { return true; }), false);
    for (const CLI::App* command : commands) text += DescribeCommand(program, *command);
    return text;
}

}  // namespace testbed
