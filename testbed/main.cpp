// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Entry point of `scree`.

#include "testbed/base/new_file.h"
#include "testbed/cli/command_line.h"

int main(int argc, char** argv) {
    testbed::HoldStandardFiles();
    testbed::RemoveUnfinishedFilesOnSignals();
    return testbed::RunCommandLine({argv + 1, argv + argc});
}
