#!/usr/bin/env bash
# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# embedded.sh SOURCE WORK COMPILER: the engine as a part of another CMake project, by add_subdirectory and by FetchContent.
# Nothing leaks: no flag, definition or standard reaches the project's own targets, no variable changes, no target, test,
# install rule or language comes along but the libraries. Configures, and compiles the project's own file.

set -euo pipefail
readonly source=$1 work=$2 compiler=$3

rm -rf "$work"
mkdir -p "$work"
cat >"$work/own.cpp" <<'END'
#include "scree/scree.h"
#if defined(SCREE_SHARED) || defined(SCREE_HAS_AVX2_KERNELS) || defined(SCREE_NO_THREADS) || defined(NDEBUG)
#error "a definition has leaked"
#endif
int main() { return scree::World(scree::Vec2{0.0f, -10.0f}).GetBodyCount(); }
END

Project() {  # NAME, lines that take the engine in on stdin
    mkdir -p "$work/$1"
    cp "$work/own.cpp" "$work/$1"
    {
        cat <<'END'
cmake_minimum_required(VERSION 3.25)
project(game LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# All variables but those that CMake and FetchContent set for themselves, and those that carry our name.
macro(Remember result)
  get_directory_property(variable_names VARIABLES)
  list(FILTER variable_names EXCLUDE REGEX
    "^(CMAKE_CURRENT_|CMAKE_INSTALL_|CMAKE_PROJECT_VERSION|FETCHCONTENT_|FetchContent|_|ARG|engine_|SCREE_|scree_|variable_|text_)")
  set(text_${result} "")
  foreach(variable_name IN LISTS variable_names)
    string(APPEND text_${result} "${variable_name}=${${variable_name}}\n")
  endforeach()
endmacro()
Remember(before)
END
        cat
        cat <<'END'
Remember(after)
file(WRITE ${CMAKE_BINARY_DIR}/before "${text_before}")
file(WRITE ${CMAKE_BINARY_DIR}/after "${text_after}")
if(text_before STREQUAL "" OR NOT text_before STREQUAL text_after)
  message(FATAL_ERROR "variables have changed")
endif()
get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(NOT languages STREQUAL "CXX")
  message(FATAL_ERROR "languages: ${languages}")
endif()
add_executable(own own.cpp)
target_link_libraries(own PRIVATE scree::scree)
END
    } >"$work/$1/CMakeLists.txt"
    echo "== $1"
    cmake -G Ninja -S "$work/$1" -B "$work/$1/build" "-DCMAKE_CXX_COMPILER=$compiler" >"$work/$1/log" 2>&1 ||
        { cat "$work/$1/log"; diff "$work/$1"/build/{before,after} || true; exit 1; }
    # Only the headers and the standard that they need.
    local command
    command=$(ninja -C "$work/$1/build" -t commands own | grep -F -- "-c $work/$1/own.cpp")
    ! grep -oE -- ' -(W[a-z]|f[a-z]|m[a-z]|D|O)[^ ]*' <<<"$command" || { echo "flags have leaked"; exit 1; }
    grep -qE -- '-std=(c|gnu)\+\+20' <<<"$command"
    # Beside the libraries and the project's own program there is what CMake makes for every project.
    ! ninja -C "$work/$1/build" -t targets all | sed -n 's/^\([a-z_0-9]*\): phony$/\1/p' |
        grep -vxE 'cmake_object_order_depends_.*|own|scree|scree_box2d|all|codegen|edit_cache|rebuild_cache|list_install_components|engine' ||
        { echo "targets have leaked"; exit 1; }
    ! find "$work/$1/build" -name cmake_install.cmake -exec grep -lE 'libscree|include/scree' {} + |
        grep . || { echo "rules of installation have leaked"; exit 1; }
    ninja -C "$work/$1/build" CMakeFiles/own.dir/own.cpp.o
}

Project add_subdirectory <<END
add_subdirectory("$source" engine EXCLUDE_FROM_ALL)
END
Project FetchContent <<END
include(FetchContent)
FetchContent_Declare(engine SOURCE_DIR "$source")
FetchContent_MakeAvailable(engine)
END
