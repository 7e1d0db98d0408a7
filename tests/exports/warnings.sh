#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# warnings.sh SOURCE COMPILER: the public headers give no warning of a strict set, with and without exceptions and type
# information.

set -euo pipefail
readonly source=$1 compiler=$2
set=(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual
    -Wdouble-promotion -Wcast-qual -Wformat=2 -Wundef -Wextra-semi)
headers=$(cd "$source/engine/include" && printf '#include "%s"\n' scree/*.h)
for mode in '' '-fno-exceptions -fno-rtti'; do
    # shellcheck disable=SC2086
    "$compiler" -std=c++20 -fsyntax-only -Werror "${set[@]}" $mode "-I$source/engine/include" -x c++ - <<<"$headers"
done
