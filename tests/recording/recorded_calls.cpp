// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Prints the calls that recordings hold, a line each, for mutators.py.

#include <cstdio>

#include "scree/recording.h"

int main() {
    for (const std::string_view call : scree::GetRecordedCalls()) {
        std::printf("%.*s\n", static_cast<int>(call.size()), call.data());
    }
}
