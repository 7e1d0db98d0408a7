#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# tests/format/check.sh ROOT: is every source file of the tree ROOT formatted as .clang-format says? Names each line
# that is not. The cure is `clang-format-14 -i FILE`.

set -euo pipefail
cd "$1"
find engine scenes testbed tests -name '*.h' -o -name '*.cpp' | sort | xargs clang-format-14 --dry-run --Werror
