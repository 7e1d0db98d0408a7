#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# check.sh SOURCE WORK COMPILER SCREE LIBRARY: writes the header of a scene's features, builds a program with it and
# compares its state hashes with those of a world with everything on; sees that the program does not compile when it
# uses anything else; and that SCREE_FEATURES is understood and the kernels compile with it.

set -euo pipefail
readonly source=$1 work=$2 compiler=$3 scree=$4 library=$5
readonly program=$source/tests/architecture/features/program.cpp
readonly flags=(-std=c++20 -O0 -Wall -Wextra "-I$source/engine/include" "-I$work")

rm -rf "$work"
mkdir -p "$work"

echo "== a program with the features of a scene"
"$scree" requires box-stack 2 --quick --steps 30 --continuous --header "$work/box_stack_features.h"
"$compiler" "${flags[@]}" "$program" "$library" -lpthread -o "$work/program"
"$work/program"

echo "== a use of another feature does not compile"
for use in USE_DAMPING USE_FORCES USE_JOINTS USE_EVENTS; do
    if "$compiler" "${flags[@]}" "-D$use" -fsyntax-only "$program" 2>"$work/$use.txt"; then
        echo "$use compiles"
        exit 1
    fi
    grep -q 'constraints not satisfied\|no matching' "$work/$use.txt"
done

echo "== a build with few features"
for file in solve_islands solve_soft; do
    "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -DSCREE_COMPILED_FEATURES=1u "-I$source/engine/include" \
        "-I$source/engine/src" "$source/engine/src/pipeline/$file.cpp"
done
configure=(cmake -S "$source" -B "$work/few" -G Ninja "-DCMAKE_CXX_COMPILER=$compiler" -DSCREE_BUILD_TESTBED=OFF
    -DSCREE_BUILD_TESTS=OFF)
"${configure[@]}" "-DSCREE_FEATURES=rotation;friction" >/dev/null
grep -q 'SCREE_COMPILED_FEATURES=3u' "$work/few/build.ninja"
if "${configure[@]}" "-DSCREE_FEATURES=wings" >/dev/null 2>"$work/wings.txt"; then exit 1; fi
grep -q "no feature 'wings'" "$work/wings.txt"
