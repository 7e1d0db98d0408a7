// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT

#include "tests/fuzz/calls.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    fuzz::Input input(data, size);
    fuzz::Calls(input).Run();
    return 0;
}
