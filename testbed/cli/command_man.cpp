// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree man`: the manual pages of the program and of all commands, as files for man(1), or one page of Markdown.

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"
#include "testbed/cli/commands.h"
#include "testbed/cli/manual.h"
#include "testbed/cli/reference.h"

namespace testbed {

void AddManCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("man", "The manual pages of all commands, as files for man(1)");
    auto folder = std::make_shared<std::string>("man1");
    command->add_option("-o,--output", *folder, "Folder for the pages")->capture_default_str()->type_name("DIR");
    auto reference = std::make_shared<std::string>();
    command->add_option("--reference", *reference, "Write one page of Markdown about all commands instead")
        ->type_name("FILE");
    command->callback([&app, &request, folder, reference] {
        request.action = [&app, folder, reference] {
            if (!reference->empty()) {
                WriteTextFile(*reference, MakeCommandReference(app));
                return exitDone;
            }
            OutputFolder output(*folder);
            for (const ManualPage& page : MakeManual(app, SCREE_VERSION)) output.WriteText(page.file, page.text);
            fmt::print("{} pages: man {}/scree.1\n", output.GetFiles().size(), *folder);
            return exitDone;
        };
    });
}

}  // namespace testbed
