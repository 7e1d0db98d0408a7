# SPDX-FileCopyrightText: the Scree authors
# SPDX-License-Identifier: MIT
#
# What testbed/run and tests/run share: the Debian 12 packages, their installation, and building a preset. To be sourced
# by bash after `set -euo pipefail`, with SCREE_ROOT set to the checkout. Everything is quiet unless it fails; what was
# said goes to build/<preset>.log.

readonly SCREE_BUILD_PACKAGES=(
    g++ cmake ninja-build pkg-config                      # tools
    libbox2d-dev                                          # the engine to compare with
    libosmesa6-dev libegl-dev libgl1-mesa-dri             # OpenGL without a screen, in software
    python3-glad                                          # generates the OpenGL loader at build time
    zlib1g-dev libstb-dev                                 # PNG, written and read
    fonts-dejavu-core                                     # the letters of pictures, embedded at build time
    libcli11-dev nlohmann-json3-dev libfmt-dev            # command line, JSON, text
    gnuplot-nox                                           # timing plots
    libjs-chart.js                                        # interactive figures of pages
    libglfw3-dev libimgui-dev                             # the window
    libbenchmark-dev                                      # micro-benchmarks
    libgtest-dev librapidcheck-dev                        # small; the presets configure the tests along
)
readonly SCREE_TEST_PACKAGES=(
    clang-format-14 clang
    xvfb xauth xdotool                                    # the window without a screen, with real events
    chromium chromium-driver python3                      # drives the report page
    python3-jsonschema                                    # holds scene files to their schema
    man-db dpkg-dev                                       # read manual pages, find what a package depends on
    parallel                                              # shards side by side
    doxygen                                               # the reference, without warnings
)

# Die CODE MESSAGE
Die() {
    printf 'scree: %s\n' "$2" >&2
    exit "$1"
}

# InstallMissing PACKAGE…: installs by apt those that dpkg does not report as installed.
InstallMissing() {
    command -v dpkg-query >/dev/null || return 0  # not Debian: CMake will name what it does not find
    local installed missing=() package
    installed=" $(dpkg-query -W -f='${db:Status-Status}=${Package} ' "$@" 2>/dev/null || true)"
    for package in "$@"; do
        [[ $installed == *" installed=$package "* ]] || missing+=("$package")
    done
    ((${#missing[@]})) || return 0

    local -a asRoot=(env DEBIAN_FRONTEND=noninteractive)
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null; then
            Die 4 "these packages are missing; install them, then run this again:
  sudo apt-get update && sudo apt-get install --no-install-recommends ${missing[*]}"
        fi
        asRoot=(sudo -n "${asRoot[@]}")
    fi

    local log=$SCREE_ROOT/build/packages.log
    mkdir -p "$SCREE_ROOT/build" || Die 4 "cannot write to $SCREE_ROOT/build"
    printf 'scree: installing %s\n' "${missing[*]}" >&2
    # The package lists are fetched only when the installation fails without them: they may be absent or out of date.
    local -a install=(apt-get install -y --no-install-recommends -o Dpkg::Use-Pty=0 "${missing[@]}")
    if ! "${asRoot[@]}" "${install[@]}" >"$log" 2>&1; then
        if ! { "${asRoot[@]}" apt-get update && "${asRoot[@]}" "${install[@]}"; } >>"$log" 2>&1; then
            tail -n 20 "$log" >&2
            Die 4 "installing ${missing[*]} failed; the whole log is $log"
        fi
    fi
}

# BuildPreset PRESET [TARGET]: configures when needed, then builds.
BuildPreset() {
    local preset=$1 folder=$SCREE_ROOT/build/$1 log=$SCREE_ROOT/build/$1.log
    local -a target=()
    [[ -z ${2:-} ]] || target=(--target "$2")
    mkdir -p "$SCREE_ROOT/build" || Die 4 "cannot write to $SCREE_ROOT/build"

    [[ -f $folder/build.ninja ]] ||
        printf 'scree: building preset %s for the first time; this takes some minutes\n' "$preset" >&2
    exec {lock}>"$folder.lock"  # two launchers at once must not build in one folder
    flock "$lock"
    if ! { ConfigurePreset "$preset" "$folder" &&
        cd "$SCREE_ROOT" && cmake --build --preset "$preset" "${target[@]}"; } >"$log" 2>&1; then
        { grep -E -A 6 -m 8 'error|Error|FAILED' "$log" || tail -n 30 "$log"; } >&2
        Die 4 "building preset $preset failed; the whole log is $log"
    fi
    exec {lock}>&-
}

# ConfigurePreset PRESET FOLDER: also when the folder was configured for a checkout at another place.
ConfigurePreset() {
    if [[ -f $2/build.ninja ]] && grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$SCREE_ROOT" "$2/CMakeCache.txt"; then
        return 0
    fi
    (cd "$SCREE_ROOT" && cmake --fresh --preset "$1")
}
